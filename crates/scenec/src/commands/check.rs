//! `scenec check`

mod round;

use std::ops::ControlFlow;

use clap::Args;

use crate::config::ConfigOptions;
use crate::exit::Exit;
use crate::files::FileOptions;
use crate::jobs::Failures;
use crate::levels::LevelOptions;
use crate::output::OutputFormat;
use crate::report;
use crate::watch::watch;
use round::Round;
pub(crate) use round::write_diff;

/// Report everything that is wrong, quietly does nothing or will look wrong in scene files
///
/// Findings go to standard output. What they count as can be changed for each code, here or in a scenec.toml in the
/// file's folder or one above it.
#[derive(Args)]
#[command(after_help = AFTER_HELP)]
pub(crate) struct Check {
    #[command(flatten)]
    files: FileOptions,
    #[command(flatten)]
    config: ConfigOptions,
    /// Check again whenever a file changes, until Ctrl-C
    #[arg(long)]
    watch: bool,
    /// End with 0 even if there are findings
    #[arg(long)]
    exit_zero: bool,
    #[command(flatten)]
    levels: LevelOptions,
    #[command(flatten)]
    fixing: FixOptions,
    #[command(flatten)]
    talk: TalkOptions,
}

/// Arguments about repairs.
#[derive(Args, Debug)]
#[command(next_help_heading = "Repairs")]
struct FixOptions {
    /// Apply the repairs that are certain to leave the picture as it is
    #[arg(long)]
    fix: bool,
    /// Apply, or count, the other repairs as well
    #[arg(long)]
    unsafe_fixes: bool,
    /// Show what --fix would change, and change nothing
    #[arg(long)]
    diff: bool,
}

/// Arguments about what is said.
#[derive(Args, Debug)]
#[command(next_help_heading = "Reports")]
struct TalkOptions {
    /// How findings are written
    #[arg(long, value_enum, default_value_t = OutputFormat::Full, value_name = "FORMAT", hide_possible_values = true)]
    output_format: OutputFormat,
    /// Count the findings of each code instead of showing them
    #[arg(long)]
    statistics: bool,
    #[command(flatten)]
    voice: report::Voice,
}

const AFTER_HELP: &str = "\
Output formats:
  full        each finding with the lines that it is about
  concise     one line a finding
  json        one array            json-lines  one object a line
  sarif       SARIF 2.1.0          github      annotations of a workflow
  gitlab      code quality         junit       XML

Examples:
  scenec check
  scenec check scenes --deny warnings --allow W009
  scenec check old.rti --fix
  generate | scenec check - --stdin-filename generated.scene

Exit codes:
  0    no finding counts as an error; with --diff, nothing would change
  1    one does; with --diff, something would
  2    bad arguments or configuration, or a file that can't be read or written; the others are checked
  130  Ctrl-C";

impl Check {
    pub(crate) fn run(&self) -> Exit {
        if !self.watch {
            return self.once().0;
        }
        if self.files.standard() {
            let mut failures = Failures::default();
            failures.tell("standard input can't be watched".to_owned());
            return Exit::Unusable;
        }
        watch(&self.files, &self.config, || match self.once() {
            (_, true) => ControlFlow::Continue(()),
            (exit, false) => ControlFlow::Break(exit),
        })
    }

    /// Checks every file; how that went, and whether somebody still reads what is written.
    fn once(&self) -> (Exit, bool) {
        let (exit, read) = Round::new(self).run();
        let forgiven = self.exit_zero && exit == Exit::Errors;
        (if forgiven { Exit::Clean } else { exit }, read)
    }
}
