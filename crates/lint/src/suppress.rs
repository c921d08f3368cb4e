//! Comments that silence findings: `/ scenec: allow W012, W013`.
//!
//! At the end of a line such a comment stands for that line, on a line of its own for the next one, and before the first
//! statement for the whole file. Words after the last code are a reason and mean nothing.

mod allow;
mod remark;

use std::collections::HashMap;

use scenec_syntax::{Content, Line};
use scenec_text::{Code, Diagnostic, Severity, SourceFile, Span};

use crate::findings;
use allow::Allow;

/// Leaves out the warnings and hints that comments of the file silence, and reports what is useless in such comments.
/// Errors can't be silenced. The findings come ordered by place.
#[must_use]
pub fn suppress(source: &SourceFile, lines: &[Line], findings: Vec<Diagnostic>) -> Vec<Diagnostic> {
    let mut allows = Allows::gather(source, lines);
    if allows.list.is_empty() {
        return findings;
    }
    let mut left = allows.silence(source, findings);
    // Remarks about comments are findings too, but one about a comment that allows them is beyond its own reach.
    let remarks = allows.remarks(source, |code| code != Some(Code::UselessAllow));
    left.extend(allows.silence(source, remarks));
    left.extend(allows.remarks(source, |code| code == Some(Code::UselessAllow)));
    findings::sort(&mut left);
    left
}

/// The comments of a file that allow something.
struct Allows {
    list: Vec<Allow>,
    /// Which of them stand for a line; those under `None` stand for the file.
    by_line: HashMap<Option<u32>, Vec<usize>>,
}

impl Allows {
    fn gather(source: &SourceFile, lines: &[Line]) -> Self {
        let mut list = Vec::new();
        let mut by_line: HashMap<Option<u32>, Vec<usize>> = HashMap::new();
        let mut begun = false;
        for (index, line) in lines.iter().enumerate() {
            let own = matches!(line.content, Content::Comment);
            begun |= !own;
            let Some(allow) = line.comment.and_then(|comment| Allow::read(comment, source.text())) else {
                continue;
            };
            let target = match (begun, own) {
                (false, _) => None,
                (true, true) => Some(next(source, lines, index)),
                (true, false) => Some(source.line_of(line.span.start)),
            };
            by_line.entry(target).or_default().push(list.len());
            list.push(allow);
        }
        Self { list, by_line }
    }

    /// What is left of the findings; notes which codes silenced something.
    fn silence(&mut self, source: &SourceFile, mut findings: Vec<Diagnostic>) -> Vec<Diagnostic> {
        findings.retain(|finding| {
            let line = source.line_of(finding.span().start);
            let mut silenced = false;
            for target in [Some(line), None] {
                for index in self.by_line.get(&target).into_iter().flatten() {
                    let allow = self.list.get_mut(*index);
                    silenced |=
                        finding.severity() != Severity::Error && allow.is_some_and(|allow| allow.covers(finding.code));
                }
            }
            !silenced
        });
        findings
    }

    fn remarks(&self, source: &SourceFile, about: impl Fn(Option<Code>) -> bool) -> Vec<Diagnostic> {
        let remark = |allow| remark::remarks(source, allow, &about);
        self.list.iter().flat_map(remark).collect()
    }
}

/// The number of the line that a comment on a line of its own is about: the one below, past other comments.
fn next(source: &SourceFile, lines: &[Line], comment: usize) -> u32 {
    let number = |line: &Line| source.line_of(line.span.start);
    let mut expected = lines.get(comment).map_or(0, number);
    for line in lines.iter().skip(comment + 1) {
        expected += 1;
        if number(line) != expected || !matches!(line.content, Content::Comment) {
            break;
        }
    }
    expected
}

/// The place of `part`, which is a piece of the text at `whole`.
fn place(whole: Span, text: &str, part: &str) -> Span {
    let before = (part.as_ptr() as usize).saturating_sub(text.as_ptr() as usize);
    let start = whole.start + u32::try_from(before).unwrap_or_default();
    Span::new(start, start + u32::try_from(part.len()).unwrap_or_default())
}

#[cfg(test)]
mod tests;
