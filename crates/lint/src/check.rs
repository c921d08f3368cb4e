//! All rules over one file, and the whole way from a text to its findings.

use std::panic::resume_unwind;
use std::thread;

use scenec_interpret::{Interpretation, Interpreter, interpret};
use scenec_syntax::{Line, Lines, read_ahead};
use scenec_text::{Diagnostic, SourceFile};

use crate::context::Context;
use crate::findings::{self, Findings};
use crate::mend::mend;
use crate::rules::{EACH, SOLIDS, STATEMENTS, STEPS};
use crate::suppress::suppress;

/// In files of fewer bytes the rules are through before a thread has come to life.
const LARGE: usize = 1 << 16;

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
    judge(source, findings, read, apply)
}

/// The same without the rules about geometry, which take the longest, and on this thread alone.
#[must_use]
pub fn check_without_geometry(source: &SourceFile) -> Checked {
    let mut lines = Lines::new(source);
    let read = interpret(source, &mut lines);
    judge(source, lines.findings(), read, |context| {
        let mut findings = Findings::default();
        findings.apply(STATEMENTS, context);
        findings.apply(STEPS, context);
        findings.sorted()
    })
}

/// The same for somebody who has use for the lines: they are kept.
#[must_use]
pub fn check_keeping_lines(source: &SourceFile) -> (Vec<Line>, Checked) {
    let ((kept, read), findings) = read_ahead(source, |lines| {
        let mut interpreter = Interpreter::new(source);
        let mut kept = Vec::new();
        for line in lines {
            interpreter.line(&line);
            kept.push(line);
        }
        (kept, interpreter.finish())
    });
    (kept, judge(source, findings, read, apply))
}

fn judge(
    source: &SourceFile,
    mut diagnostics: Vec<Diagnostic>,
    (interpretation, more): (Interpretation, Vec<Diagnostic>),
    rules: impl FnOnce(&Context<'_>) -> Vec<Diagnostic>,
) -> Checked {
    diagnostics.extend(more);
    let context = Context::new(source, &interpretation);
    mend(&context, &mut diagnostics);
    diagnostics.extend(rules(&context));
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

/// Every rule; in a large file those that take longest beside the others, with which they share little that takes long to
/// find out.
fn apply(context: &Context<'_>) -> Vec<Diagnostic> {
    let mut findings = Findings::default();
    let Context {
        source, interpretation, ..
    } = *context;
    if source.text().len() < LARGE {
        for rules in [STATEMENTS, STEPS, EACH, SOLIDS] {
            findings.apply(rules, context);
        }
        return findings.sorted();
    }
    let solids = || {
        let mut findings = Findings::default();
        let context = Context::new(source, interpretation);
        findings.apply(STEPS, &context);
        findings.apply(SOLIDS, &context);
        findings.sorted()
    };
    thread::scope(|scope| {
        let solids = scope.spawn(solids);
        findings.apply(STATEMENTS, context);
        findings.apply(EACH, context);
        findings.extend(solids.join().unwrap_or_else(|panic| resume_unwind(panic)));
    });
    findings.sorted()
}

#[cfg(test)]
mod tests {
    use scenec_interpret::analyse;
    use scenec_text::SourceFile;

    use super::{LARGE, lint};

    /// What is found in a file is found, in the same order, where comments make it large.
    fn check(text: &str) {
        let findings = |text: String| {
            let source = SourceFile::new("t", text).unwrap();
            lint(&source, &analyse(&source).0)
        };
        let small = findings(text.to_owned());
        assert!(small.len() > 1, "{small:?}");
        assert_eq!(small, findings(format!("{text}{}", "/ comment\n".repeat(LARGE / 10))));
    }

    #[test]
    fn large_files_have_the_findings_of_small_ones() {
        let solids =
            "?m := 1 0 0 0.8 0.5 1.5 1 1 1 1\n!a := sphere\n!a ?= m\n!b := sphere\n!b *= 0.5 0.5 0.5\n!b #x= 90\n";
        check(&format!("{}{solids}!u := a | b\n!u <=\n", crate::PRELUDE));
        check(&format!(
            "{}{solids}!u := a - b\n!unused := hp\n!u *= 1 1 1\n",
            crate::PRELUDE
        ));
    }
}
