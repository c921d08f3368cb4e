//! All rules over one file, and the whole way from a text to its findings.

use std::panic::resume_unwind;
use std::thread;

use scenec_interpret::{Interpretation, Interpreter, interpret, interpret_ahead};
use scenec_syntax::{Line, Lines, parse_again, read_ahead};
use scenec_text::{Diagnostic, SourceFile};

use crate::context::Context;
use crate::findings::{self, Findings};
use crate::mend::mend;
use crate::rule::Rule;
use crate::rules::{EACH, SOLIDS, STATEMENTS, STEPS};
use crate::suppress::suppress;

/// In files of fewer bytes the rules are through before a thread has come to life.
const LARGE: usize = 1 << 16;

/// A line takes at least about so many bytes.
const BYTES_PER_LINE: usize = 16;

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
    let (read, findings) = interpret_ahead(source);
    judge(source, findings, read, apply)
}

/// The same without the rules about geometry, which take the longest, and on this thread alone.
#[must_use]
pub fn check_without_geometry(source: &SourceFile) -> Checked {
    let mut lines = Lines::new(source);
    let read = interpret(source, &mut lines);
    judge(source, lines.findings(), read, one_by_one)
}

/// A file as far as it is known before the rules about solids, which take the longest: for somebody who has use for the lines, and
/// can do with the rest later.
#[derive(Clone, Debug)]
pub struct Reading {
    /// The lines that are not blank, in order.
    pub lines: Vec<Line>,
    /// What they mean.
    pub interpretation: Interpretation,
    /// What was found so far; comments have not silenced anything yet.
    findings: Vec<Diagnostic>,
    /// Whether nothing was found on the lines themselves.
    sound: bool,
}

impl Reading {
    /// Reads and interprets a file and applies the rules that look at one statement or transform after the other.
    #[must_use]
    pub fn of(source: &SourceFile) -> Self {
        let mut interpreter = Interpreter::new(source);
        // Room for all, unless most lines are blank; a list that grows is copied again and again.
        let room = (source.line_count() as usize).min(source.text().len() / BYTES_PER_LINE);
        let mut kept = Vec::with_capacity(room);
        let findings = read_ahead(source, |lines| {
            interpreter.lines(&lines);
            kept.extend(lines);
        });
        Self::new(source, kept, findings, interpreter.finish())
    }

    /// The same for what became of a file by an edit: of most lines it is known what they say.
    #[must_use]
    pub fn after(&self, before: &SourceFile, source: &SourceFile) -> Self {
        if !self.sound {
            return Self::of(source);
        }
        let (lines, findings) = parse_again(before, &self.lines, source);
        let read = interpret(source, &lines);
        Self::new(source, lines, findings, read)
    }

    fn new(
        source: &SourceFile,
        lines: Vec<Line>,
        findings: Vec<Diagnostic>,
        read: (Interpretation, Vec<Diagnostic>),
    ) -> Self {
        let sound = findings.is_empty();
        let (interpretation, findings) = found(source, findings, read, one_by_one);
        Self {
            lines,
            interpretation,
            findings,
            sound,
        }
    }

    /// What the rules about solids find.
    #[must_use]
    pub fn solids(&self, source: &SourceFile) -> Vec<Diagnostic> {
        let context = Context::new(source, &self.interpretation);
        beside(&context, (&[], SOLIDS), (&[], EACH))
    }

    /// All findings, ordered by place, with those about solids as given; comments of the file have silenced theirs.
    #[must_use]
    pub fn all(&self, source: &SourceFile, solids: &[Diagnostic]) -> Vec<Diagnostic> {
        let mut all = [self.findings.as_slice(), solids].concat();
        findings::sort(&mut all);
        suppress(source, all)
    }
}

fn judge(
    source: &SourceFile,
    diagnostics: Vec<Diagnostic>,
    read: (Interpretation, Vec<Diagnostic>),
    rules: impl FnOnce(&Context<'_>) -> Vec<Diagnostic>,
) -> Checked {
    let (interpretation, mut diagnostics) = found(source, diagnostics, read, rules);
    findings::sort(&mut diagnostics);
    let diagnostics = suppress(source, diagnostics);
    Checked {
        interpretation,
        diagnostics,
    }
}

/// What the parser, the interpreter and some rules found, mended where that is mechanical, in no order.
fn found(
    source: &SourceFile,
    mut findings: Vec<Diagnostic>,
    (interpretation, more): (Interpretation, Vec<Diagnostic>),
    rules: impl FnOnce(&Context<'_>) -> Vec<Diagnostic>,
) -> (Interpretation, Vec<Diagnostic>) {
    findings.extend(more);
    let context = Context::new(source, &interpretation);
    mend(&context, &mut findings);
    findings.extend(rules(&context));
    (interpretation, findings)
}

/// Applies every rule to a file that has been interpreted. The findings are ordered by place; what the earlier stages
/// reported is not reported again.
#[must_use]
pub fn lint(source: &SourceFile, interpretation: &Interpretation) -> Vec<Diagnostic> {
    apply(&Context::new(source, interpretation))
}

/// The rules that look at one statement or transform after the other.
fn one_by_one(context: &Context<'_>) -> Vec<Diagnostic> {
    let mut findings = Findings::default();
    findings.apply(STATEMENTS, context);
    findings.apply(STEPS, context);
    findings.sorted()
}

/// Every rule.
fn apply(context: &Context<'_>) -> Vec<Diagnostic> {
    beside(context, (STEPS, SOLIDS), (STATEMENTS, EACH))
}

/// What the rules find; in a large file the first ones, which take longest, beside the others, with which they share little that
/// takes long to find out.
fn beside(context: &Context<'_>, long: (&[Rule], &[Rule]), others: (&[Rule], &[Rule])) -> Vec<Diagnostic> {
    let find = |(first, then): (&[Rule], &[Rule]), context: &Context<'_>| {
        let mut findings = Findings::default();
        findings.apply(first, context);
        findings.apply(then, context);
        findings
    };
    let Context {
        source, interpretation, ..
    } = *context;
    let mut findings;
    if source.text().len() < LARGE {
        findings = find(others, context);
        findings.extend(find(long, context).sorted());
    } else {
        findings = thread::scope(|scope| {
            let long = scope.spawn(|| find(long, &Context::new(source, interpretation)).sorted());
            let mut findings = find(others, context);
            findings.extend(long.join().unwrap_or_else(|panic| resume_unwind(panic)));
            findings
        });
    }
    findings.sorted()
}

#[cfg(test)]
mod tests {
    use scenec_interpret::analyse;
    use scenec_text::SourceFile;

    use super::{LARGE, Reading, check as check_file, lint};

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

    /// What is found in two goes is what is found in one.
    #[test]
    fn a_reading_and_its_solids_are_everything() {
        let text = format!(
            "{}!a := sphere\n!b := sphere / scenec: allow W040, W041\n!b *= 0.5 0.5 0.5\n!c := hp\n!u := a | b\n!u <=\n!a += 1 1 1\n",
            crate::PRELUDE
        );
        for text in [
            text.clone(),
            format!("{text}{}", "/ comment\n".repeat(LARGE / 10)),
            format!("{text}$\n"),
        ] {
            let source = SourceFile::new("t", text).unwrap();
            let reading = Reading::of(&source);
            let solids = reading.solids(&source);
            assert_eq!(solids.is_empty(), reading.interpretation.scene.is_none());
            let all = reading.all(&source, &solids);
            assert_eq!(all, check_file(&source).diagnostics);
            // And what is found after an edit, and after one that takes it back.
            let edited = SourceFile::new("t", source.text().replace("!b *= 0.5", "!b *= $ 0.5")).unwrap();
            let other = reading.after(&source, &edited);
            assert_eq!(
                other.all(&edited, &other.solids(&edited)),
                check_file(&edited).diagnostics
            );
            assert_eq!(other.after(&edited, &source).all(&source, &solids), all);
        }
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
