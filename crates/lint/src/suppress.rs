//! Comments that silence findings: `/ scenec: allow W012, W013`.
//!
//! At the end of a line such a comment stands for that line, on a line of its own for the next one, and before the first
//! statement for the whole file. Words after the last code are a reason and mean nothing.

mod allow;
mod remark;

use std::collections::HashMap;

use scenec_syntax::{Content, line};
use scenec_text::{Code, Diagnostic, Edit, Severity, SourceFile, Span};

use crate::findings;
use allow::Allow;

/// Leaves out the warnings and hints that comments of the file silence, and reports what is useless in such comments.
/// Errors can't be silenced. The findings come ordered by place.
#[must_use]
pub fn suppress(source: &SourceFile, findings: Vec<Diagnostic>) -> Vec<Diagnostic> {
    let mut allows = Allows::gather(source);
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

/// The edit by which a comment that allows something allows one more code; `None` for any other comment.
#[must_use]
pub fn allow_also(comment: Span, text: &str, code: Code) -> Option<Edit> {
    let allow = Allow::read(comment, text).filter(|allow| allow.verb.of(text) == "allow")?;
    let (end, separator) = match allow.named.last() {
        Some(last) => (last.span.end, ", "),
        None => (allow.verb.end, " "),
    };
    Some(Edit {
        span: Span::at(end),
        text: format!("{separator}{}", code.id()),
    })
}

/// The comments of a file that allow something.
struct Allows {
    list: Vec<Allow>,
    /// Which comment allows a code, and as which of its words, on a line or, under `None`, in the whole file. Of several
    /// that do, the first counts and the others are useless.
    places: HashMap<(Option<u32>, Code), (usize, usize)>,
}

impl Allows {
    fn gather(source: &SourceFile) -> Self {
        let mut allows = Self {
            list: Vec::new(),
            places: HashMap::new(),
        };
        let mut begun = None;
        // The line after the last row of comments that was looked at.
        let mut behind = 0;
        let mut places = source.text().match_indices(allow::MARK).peekable();
        while let Some((offset, _)) = places.next() {
            let number = source.line_of(u32::try_from(offset).unwrap_or(u32::MAX));
            // One look at a line is enough.
            let next = source.line_span(number + 1).map_or(u32::MAX, |next| next.start);
            while places.next_if(|(offset, _)| *offset < next as usize).is_some() {}
            let Some(line) = line(source, number) else { continue };
            let Some(allow) = line.comment.and_then(|comment| Allow::read(comment, source.text())) else {
                continue;
            };
            allows.list.push(allow);
            let begun = *begun.get_or_insert_with(|| end_of_comments(source, 0, true));
            let own = matches!(line.content, Content::Comment);
            let target = match (number < begun, own) {
                (true, _) => None,
                (false, false) => Some(number),
                (false, true) => {
                    if behind <= number {
                        behind = end_of_comments(source, number, false);
                    }
                    Some(behind)
                }
            };
            allows.aim(allows.list.len() - 1, target);
        }
        allows
    }

    /// Settles what a comment stands for.
    fn aim(&mut self, index: usize, target: Option<u32>) {
        let named = self
            .list
            .get(index)
            .map(|allow| allow.named.as_slice())
            .unwrap_or_default();
        for (word, named) in named.iter().enumerate() {
            if let Some(code) = named.code.filter(|code| code.severity() != Severity::Error) {
                self.places.entry((target, code)).or_insert((index, word));
            }
        }
    }

    /// What is left of the findings; notes which codes silenced something.
    fn silence(&mut self, source: &SourceFile, mut findings: Vec<Diagnostic>) -> Vec<Diagnostic> {
        findings.retain(|finding| {
            let line = source.line_of(finding.span().start);
            let mut silenced = false;
            for target in [Some(line), None] {
                if let Some(&(index, word)) = self.places.get(&(target, finding.code))
                    && let Some(named) = self.list.get_mut(index).and_then(|allow| allow.named.get_mut(word))
                {
                    named.used = true;
                    silenced = true;
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

/// The number of the first line from `number` on that is no comment; blank ones may be passed over as well.
fn end_of_comments(source: &SourceFile, number: u32, over_blank: bool) -> u32 {
    let passed = |number: u32| match line(source, number) {
        Some(line) => matches!(line.content, Content::Comment),
        None => over_blank,
    };
    let mut numbers = number..source.line_count();
    numbers.find(|number| !passed(*number)).unwrap_or(source.line_count())
}

/// The place of `part`, which is a piece of the text at `whole`.
fn place(whole: Span, text: &str, part: &str) -> Span {
    let before = (part.as_ptr() as usize).saturating_sub(text.as_ptr() as usize);
    let start = whole.start + u32::try_from(before).unwrap_or_default();
    Span::new(start, start + u32::try_from(part.len()).unwrap_or_default())
}

#[cfg(test)]
mod tests;
