//! All rules over one file, and the whole way from a text to its findings.

use scenec_interpret::{Interpretation, interpret};
use scenec_syntax::{Line, read_ahead};
use scenec_text::{Diagnostic, SourceFile};

use crate::context::Context;
use crate::findings::{self, Findings};
use crate::mend::mend;
use crate::rules::RULES;
use crate::suppress::suppress;

/// A file that went all the way: what it means, and everything that was found.
#[derive(Clone, Debug)]
pub struct Checked {
    /// What its lines mean.
    pub interpretation: Interpretation,
    /// The findings of all stages, ordered by place; those of the file's reader are not among them.
    pub diagnostics: Vec<Diagnostic>,
}

/// Reads and interprets a file, applies every rule and obeys the comments that silence findings. Its lines are read one
/// after the other and not kept: they would take more memory than everything else.
#[must_use]
pub fn check(source: &SourceFile) -> Checked {
    let (read, findings) = read_ahead(source, |lines| interpret(source, lines));
    judge(source, findings, read)
}

/// The same for a file whose lines are there already, with what reading them has found.
#[must_use]
pub fn check_lines(source: &SourceFile, lines: &[Line], findings: Vec<Diagnostic>) -> Checked {
    judge(source, findings, interpret(source, lines))
}

fn judge(
    source: &SourceFile,
    mut diagnostics: Vec<Diagnostic>,
    (interpretation, more): (Interpretation, Vec<Diagnostic>),
) -> Checked {
    diagnostics.extend(more);
    let context = Context::new(source, &interpretation);
    mend(&context, &mut diagnostics);
    diagnostics.extend(apply(&context));
    findings::sort(&mut diagnostics);
    let diagnostics = suppress(source, diagnostics);
    Checked {
        interpretation,
        diagnostics,
    }
}

/// Applies every rule to a file that has been interpreted. The findings are ordered by place; what the earlier stages
/// reported is not reported again.
#[must_use]
pub fn lint(source: &SourceFile, interpretation: &Interpretation) -> Vec<Diagnostic> {
    apply(&Context::new(source, interpretation))
}

fn apply(context: &Context<'_>) -> Vec<Diagnostic> {
    let mut findings = Findings::default();
    for rule in RULES {
        (rule.check)(context, &mut findings);
    }
    findings.sorted()
}
