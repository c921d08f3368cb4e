//! From a scene file to a scene, with everything that is to be said about the file said.

use std::io::{self, Write};
use std::path::Path;

use scenec_interpret::analyse;
use scenec_lint::check;
use scenec_scene::Scene;
use scenec_text::{Severity, SourceFile};

use crate::failure::Failure;
use crate::input;
use crate::report::{self, Style, Tally};

/// A file, or standard input where the path is `-`, and the scene in it, after its findings have been shown: all of them, or
/// the errors alone if `quiet`. `lap` hears when a stage has ended.
///
/// # Errors
/// The file can't be read, or has errors.
pub(crate) fn open(
    path: &Path,
    quiet: bool,
    style: &Style,
    mut lap: impl FnMut(&'static str),
) -> Result<(SourceFile, Scene), Failure> {
    let (source, mut diagnostics) = input::read(path).map_err(Failure::Unusable)?;
    lap("read");
    // The rules find no errors, and of errors alone is to be told.
    let (interpretation, findings) = if quiet {
        analyse(&source)
    } else {
        let checked = check(&source);
        (checked.interpretation, checked.diagnostics)
    };
    lap("interpret");
    diagnostics.extend(findings);
    diagnostics.sort_by_key(|finding| finding.span().start);
    let tally = Tally::of(&diagnostics);
    if quiet {
        diagnostics.retain(|finding| finding.severity() == Severity::Error);
    }
    if !diagnostics.is_empty() {
        // The drawings are many small writes. With standard error gone there is nobody left to tell.
        let mut out = io::BufWriter::new(io::stderr().lock());
        report::print(&mut out, &source, &diagnostics, style)
            .and_then(|()| match tally.errors {
                0 => Ok(()),
                _ => report::summary(&mut out, &source, tally),
            })
            .and_then(|()| out.flush())
            .unwrap_or_default();
    }
    interpretation.scene.map(|scene| (source, scene)).ok_or(Failure::Errors)
}
