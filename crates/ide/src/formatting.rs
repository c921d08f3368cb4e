//! Formatting as the fewest edits, so that cursors and folds stay where they are.
//!
//! The formatter keeps every statement and comment in its order, so the lines of the text and those of its output pair
//! up, and only what differs within a pair or between two is an edit.

use scenec_syntax::{Content, FormatStyle, Line, Refused, Statement};
use scenec_text::{Edit, Span};

use crate::Document;
use crate::names::statement;

/// The edits that make the whole text canonical.
///
/// # Errors
/// The first place that fits no statement, since nothing that can't be read is touched.
pub fn format(document: &Document, style: FormatStyle) -> Result<Vec<Edit>, Refused> {
    let text = document.text();
    let written = scenec_syntax::format(document.source(), document.lines(), style)?;
    let mut pairs = Pairs::new(text, &written);
    let mut edits = Vec::new();
    for line in document.lines() {
        let Some((before, words)) = pairs.next(line) else {
            break;
        };
        edits.extend(trimmed(text, before.0, before.1));
        edits.extend(trimmed(text, words.0, words.1));
    }
    let (span, new) = pairs.rest();
    edits.extend(trimmed(text, span, new));
    Ok(edits)
}

/// The edits that make the lines from `first` to `last`, counted from 0, canonical, and the gaps between them. Lines that
/// fit no statement stay as they are.
#[must_use]
pub fn format_lines(document: &Document, first: u32, last: u32, style: FormatStyle) -> Vec<Edit> {
    let text = document.text();
    let lines = around(document, first, last, style);
    let readable: Vec<Line> = lines.iter().filter(|line| !is_broken(line)).cloned().collect();
    let Ok(written) = scenec_syntax::format(document.source(), &readable, style) else {
        return Vec::new();
    };
    let mut pairs = Pairs::new(text, &written);
    let mut edits = Vec::new();
    // White space at the end of the last line in the range, unless the gap to the next one takes it.
    let mut tail: Option<Span> = None;
    for line in lines {
        let pair = if is_broken(line) { None } else { pairs.next(line) };
        let number = line_number(document, line);
        let Some((gap, words)) = pair.filter(|_| (first..=last).contains(&number)) else {
            edits.extend(tail.take().and_then(|tail| trimmed(text, tail, "")));
            continue;
        };
        let row = document.source().line_span(number).unwrap_or(words.0);
        edits.extend(match tail {
            Some(_) => trimmed(text, gap.0, gap.1),
            None => trimmed(text, Span::new(row.start, words.0.start), ""),
        });
        edits.extend(trimmed(text, words.0, words.1));
        tail = Some(Span::new(words.0.end, row.end));
    }
    edits.extend(tail.and_then(|tail| trimmed(text, tail, "")));
    edits
}

/// The edits that make one line, counted from 0, canonical: for when it was just finished.
#[must_use]
pub fn format_line(document: &Document, line: u32, style: FormatStyle) -> Vec<Edit> {
    format_lines(document, line, line, style)
}

/// The lines of a range; where statements are aligned, with the like ones before and after them.
fn around(document: &Document, first: u32, last: u32, style: FormatStyle) -> &[Line] {
    let lines = document.lines();
    let mut start = lines.partition_point(|line| line_number(document, line) < first);
    let mut end = lines
        .partition_point(|line| line_number(document, line) <= last)
        .max(start);
    let like = |one: usize, two: usize| match (lines.get(one), lines.get(two)) {
        (Some(one), Some(two)) => {
            let forms = [one, two].map(|line| statement(line).map(Statement::form));
            forms[0].is_some() && forms[0] == forms[1] && line_number(document, one) + 1 == line_number(document, two)
        }
        _ => false,
    };
    if style.align {
        while start > 0 && like(start - 1, start) {
            start -= 1;
        }
        while end > start && like(end - 1, end) {
            end += 1;
        }
    }
    lines.get(start..end).unwrap_or_default()
}

const fn is_broken(line: &Line) -> bool {
    matches!(line.content, Content::Broken(_))
}

fn line_number(document: &Document, line: &Line) -> u32 {
    document.source().line_of(line.span.start)
}

/// A place of the text and what the formatter has there.
type Pair<'a> = (Span, &'a str);

/// Walks over the lines of a text and of the formatter's output side by side.
struct Pairs<'a> {
    length: u32,
    /// Where the last line of the text ended.
    at: u32,
    output: &'a str,
}

impl<'a> Pairs<'a> {
    fn new(text: &str, output: &'a str) -> Self {
        Self {
            length: u32::try_from(text.len()).unwrap_or(u32::MAX),
            at: 0,
            output,
        }
    }

    /// The gap before a line, and its words with the comment.
    fn next(&mut self, line: &Line) -> Option<(Pair<'a>, Pair<'a>)> {
        let blank = self.output.len() - self.output.trim_start_matches(['\r', '\n', ' ']).len();
        let (gap, rest) = self.output.split_at_checked(blank)?;
        let end = rest.find('\n').unwrap_or(rest.len());
        let words = rest.get(..end)?;
        let words = words.strip_suffix('\r').unwrap_or(words);
        self.output = rest.get(words.len()..)?;
        let old = line.comment.map_or(line.span, |comment| line.span.to(comment));
        let before = Span::new(self.at, old.start);
        self.at = old.end;
        Some(((before, gap), (old, words)))
    }

    /// What stands behind the last line.
    const fn rest(&self) -> Pair<'a> {
        (Span::new(self.at, self.length), self.output)
    }
}

/// The edit that turns the words at `span` into `new`, without what both begin and end with; `None` if they are the same.
/// It never parts a carriage return from its line feed, since editors take the two for one place.
fn trimmed(text: &str, span: Span, new: &str) -> Option<Edit> {
    let old = span.of(text);
    if old == new {
        return None;
    }
    let same = |(a, b): &(char, char)| a == b;
    let count = |n: char| n.len_utf8();
    let mut head: usize = old
        .chars()
        .zip(new.chars())
        .take_while(same)
        .map(|(c, _)| count(c))
        .sum();
    if old.get(..head).is_some_and(|head| head.ends_with('\r')) {
        head -= 1;
    }
    let (old_rest, new_rest) = (old.get(head..)?, new.get(head..)?);
    let pairs = old_rest.chars().rev().zip(new_rest.chars().rev());
    let mut tail: usize = pairs.take_while(same).map(|(c, _)| count(c)).sum();
    let parts = |rest: &str| {
        let cut = rest.len() - tail;
        rest.get(..cut).is_some_and(|kept| kept.ends_with('\r'))
            && rest.get(cut..).is_some_and(|cut| cut.starts_with('\n'))
    };
    if parts(old_rest) || parts(new_rest) {
        tail -= 1;
    }
    let end = u32::try_from(old.len() - tail).ok()?;
    let start = u32::try_from(head).ok()?;
    Some(Edit {
        span: Span::new(span.start + start, span.start + end),
        text: new_rest.get(..new_rest.len() - tail)?.to_owned(),
    })
}

#[cfg(test)]
mod tests {
    use scenec_text::{Span, apply};

    use super::{FormatStyle, format, format_line, format_lines};
    use crate::tests::document;

    fn check(text: &str, expect: &[(&str, &str)]) {
        let edits = format(&document(text), FormatStyle::default()).unwrap();
        let found: Vec<_> = edits
            .iter()
            .map(|edit| (edit.span.of(text), edit.text.as_str()))
            .collect();
        assert_eq!(found, expect, "{text:?}");
    }

    #[test]
    fn only_what_differs_is_an_edit() {
        check("a := 1\nb := 2\n", &[]);
        check("a := 1\nb:= 2\nc := 3\n", &[("", " ")]);
        check("a := 1\n\n\n\nb := 2", &[("\n\n", ""), ("", "\n")]);
        check("a := 1\r\nb := 2\r\nc := 3\nd := 4\r\n", &[("\n", "\r\n")]);
        check("  a := 1 / c  \n", &[("  ", ""), ("/ c  ", " / c")]);
    }

    #[test]
    fn a_range_leaves_the_rest_and_broken_lines_alone() {
        let text = " a:=1 \n b:=2 \n ?? \n c:=3 ";
        let document = document(text);
        let style = FormatStyle::default();
        assert_eq!(
            apply(text, &format_line(&document, 1, style)),
            " a:=1 \nb := 2\n ?? \n c:=3 "
        );
        assert_eq!(
            apply(text, &format_lines(&document, 1, 3, style)),
            " a:=1 \nb := 2\n ?? \nc := 3"
        );
        assert_eq!(format(&document, style).unwrap_err().span, Span::new(15, 17));
        assert_eq!(format_line(&document, 2, style), []);
    }

    #[test]
    fn a_line_keeps_the_columns_of_its_neighbours() {
        let text = "a := 1\nlonger := 10\nb := 2\n";
        let edits = format_line(&document(text), 2, FormatStyle { align: true });
        assert_eq!(apply(text, &edits), "a := 1\nlonger := 10\nb      :=  2\n");
    }
}
