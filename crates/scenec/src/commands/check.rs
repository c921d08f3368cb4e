//! `scenec check`

use std::io::{self, Write};
use std::path::{Path, PathBuf};

use clap::Args;
use scenec_interpret::analyse;

use crate::exit::Exit;
use crate::input;
use crate::report::{self, Tally};

/// Report everything that is wrong or suspicious in scene files
///
/// Reports go to standard error. The exit code is 0 if no file has an error (warnings are allowed), 1 if one has, and 2
/// if a file can't be read.
#[derive(Args)]
#[command(
    after_help = "Examples:\n  scenec check scenes/seed.scene\n  scenec check --max-diagnostics 5 *.scene\n  \
                        generate | scenec check -"
)]
pub(crate) struct Check {
    /// The files to check; `-` reads standard input
    #[arg(required = true, value_name = "FILE")]
    files: Vec<PathBuf>,
    #[command(flatten)]
    style: report::Style,
}

impl Check {
    pub(crate) fn run(&self) -> Exit {
        // The drawings are many small writes.
        let mut out = io::BufWriter::new(io::stderr().lock());
        let mut exit = Exit::Clean;
        for file in &self.files {
            let (found, written) = self.check(file, &mut out);
            exit = exit.max(found);
            if written.is_err() {
                // Whoever read the reports has gone away; what was found so far still counts.
                return exit;
            }
        }
        // As above: there is nobody left to tell.
        out.flush().unwrap_or_default();
        exit
    }

    /// How a file fared, and whether that could be written.
    fn check(&self, file: &Path, out: &mut impl Write) -> (Exit, io::Result<()>) {
        let (source, mut diagnostics) = match input::read(file) {
            Ok(read) => read,
            Err(message) => return (Exit::Unusable, report::failure(out, &message)),
        };
        diagnostics.extend(analyse(&source).1);
        diagnostics.sort_by_key(|finding| finding.span().start);
        let tally = Tally::of(&diagnostics);
        let written =
            report::print(out, &source, &diagnostics, &self.style).and_then(|()| report::summary(out, &source, tally));
        let exit = if tally.errors > 0 { Exit::Errors } else { Exit::Clean };
        (exit, written)
    }
}
