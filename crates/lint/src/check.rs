//! All rules over one file, and the whole way from a text to its findings.

use scenec_interpret::{Interpretation, interpret};
use scenec_syntax::{Line, parse};
use scenec_text::{Diagnostic, SourceFile};

use crate::context::Context;
use crate::findings::{self, Findings};
use crate::mend::mend;
use crate::rules::RULES;
use crate::suppress::suppress;

/// A file that went all the way: what each stage made of it, and everything that was found.
#[derive(Clone, Debug)]
pub struct Checked {
    /// What its lines say.
    pub lines: Vec<Line>,
    /// What they mean.
    pub interpretation: Interpretation,
    /// The findings of all stages, ordered by place; those of the file's reader are not among them.
    pub diagnostics: Vec<Diagnostic>,
}

/// Parses and interprets a file, applies every rule and obeys the comments that silence findings.
#[must_use]
pub fn check(source: &SourceFile) -> Checked {
    let (lines, mut diagnostics) = parse(source);
    let (interpretation, more) = interpret(source, &lines);
    diagnostics.extend(more);
    let context = Context::new(source, &lines, &interpretation);
    mend(&context, &mut diagnostics);
    diagnostics.extend(apply(&context));
    findings::sort(&mut diagnostics);
    let diagnostics = suppress(source, &lines, diagnostics);
    Checked {
        lines,
        interpretation,
        diagnostics,
    }
}

/// Applies every rule to a file that has been parsed and interpreted. The findings are ordered by place; what the
/// earlier stages reported is not reported again.
#[must_use]
pub fn lint(source: &SourceFile, lines: &[Line], interpretation: &Interpretation) -> Vec<Diagnostic> {
    apply(&Context::new(source, lines, interpretation))
}

fn apply(context: &Context<'_>) -> Vec<Diagnostic> {
    let mut findings = Findings::default();
    for rule in RULES {
        (rule.check)(context, &mut findings);
    }
    findings.sorted()
}
