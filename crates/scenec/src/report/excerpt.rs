//! The lines of a file that a finding is about, long ones cut.
//!
//! What is drawn is a text of these lines alone, and then their numbers in the file are put in place of those in that text: a
//! drawing of the whole file would look at each line between two labels, and a file may have millions.

use std::collections::BTreeMap;
use std::ops::Range;

use scenec_text::{Diagnostic, SourceFile, Span};

use super::sanitise::sanitise;
use super::snap;

/// A line with more bytes than this is never shown whole.
const LONGEST: u32 = 240;
/// How many characters of a long line are shown before and after the start of the first label on it.
const BEFORE: usize = 40;
const AFTER: usize = 80;

/// A text of the lines that a finding names, with an empty one for all that lie between two of them.
pub(super) struct Excerpt {
    pub(super) text: String,
    /// Where each label lies in it.
    pub(super) places: Vec<Range<usize>>,
    /// The numbers in the file of its lines, from 1.
    numbers: Vec<u32>,
    /// Line and column of the finding in the excerpt, from 1, ...
    shown: [usize; 2],
    /// ... and in the file.
    place: [u32; 2],
}

impl Excerpt {
    /// The excerpt for a finding.
    pub(super) fn of(source: &SourceFile, finding: &Diagnostic) -> Self {
        let mut firsts = BTreeMap::new();
        for offset in finding.labels.iter().flat_map(|label| ends(label.span)) {
            let first = firsts.entry(source.line_of(offset)).or_insert(offset);
            *first = offset.min(*first);
        }
        let (mut text, mut numbers, mut cuts) = (String::new(), Vec::new(), BTreeMap::new());
        for (line, first) in firsts {
            if let Some(last) = numbers.last().copied() {
                text.push('\n');
                if last < line {
                    text.push('\n');
                    numbers.push(line);
                }
            }
            numbers.push(line + 1);
            let cut = Cut::around(source, line, first, text.len());
            text.push_str(&cut.text);
            cuts.insert(line, cut);
        }
        // The space gives the end of the last line something to point at.
        text.push(' ');
        let place = |line: u32, offset: u32| cuts.get(&line).map_or(0, |cut| cut.place(source, offset));
        let within = |span: Span| {
            let [first, last] = ends(span).map(|offset| source.line_of(offset));
            let start = place(first, span.start);
            start..place(last, span.end).max(start)
        };
        let places: Vec<_> = finding.labels.iter().map(|label| within(label.span)).collect();
        let primary = source.position(finding.span().start);
        // The first label is where the finding is.
        let start = places.first().map_or(0, |place| place.start);
        let before = text.get(..start).unwrap_or_default();
        let column = before.rsplit('\n').next().unwrap_or_default().chars().count();
        Self {
            places,
            shown: [before.matches('\n').count() + 1, column + 1],
            place: [primary.line + 1, primary.chars + 1],
            text,
            numbers,
        }
    }

    /// A drawing of it under a name, with the lines and columns of the file.
    pub(super) fn numbered(&self, drawn: &str, name: &str) -> String {
        let [line, column] = self.shown;
        let shown = format!("{name}:{line}:{column}");
        let [line, column] = self.place;
        let place = format!("{name}:{line}:{column}");
        // A margin is as wide as the last number in it.
        let digits = |number: usize| number.to_string().len();
        let last = self.numbers.last().map_or(0, |last| *last as usize);
        let more = digits(last) - digits(self.numbers.len());
        // The place stands below the message.
        let numbered = |(number, line): (usize, &str)| match number {
            1 => self.widened(&line.replacen(&shown, &place, 1), more),
            _ => self.widened(line, more),
        };
        drawn.split_inclusive('\n').enumerate().map(numbered).collect()
    }

    /// A drawn line with so much more margin, if it has one; where a number stands there, the one that its line has in the file.
    fn widened(&self, line: &str, more: usize) -> String {
        let (colour, rest) = coloured(line);
        if rest.starts_with('─') {
            return format!("{colour}{}{rest}", "─".repeat(more));
        }
        let Some(line) = line.strip_prefix(' ') else {
            return line.to_owned();
        };
        let (colour, margin) = coloured(line);
        let unpadded = margin.trim_start_matches(' ');
        let end = unpadded.find(|c: char| !c.is_ascii_digit()).unwrap_or(unpadded.len());
        let (number, after) = unpadded.split_at(end);
        let number = number
            .parse()
            .ok()
            .and_then(|number: usize| self.numbers.get(number.wrapping_sub(1)));
        match number {
            Some(number) if after.starts_with(" │") => {
                let width = margin.len() - after.len() + more;
                format!(" {colour}{number:>width$}{after}")
            }
            _ => format!(" {colour}{}{margin}", " ".repeat(more)),
        }
    }
}

/// A drawn line's first change of colour, if it begins with one, and the rest.
fn coloured(line: &str) -> (&str, &str) {
    let end = line.find('m').filter(|_| line.starts_with('\u{1b}'));
    line.split_at(end.map_or(0, |end| end + 1))
}

/// Where the first and the last character of a span begin or end.
fn ends(span: Span) -> [u32; 2] {
    [span.start, span.end.saturating_sub(1).max(span.start)]
}

/// A line, cut to a window.
struct Cut {
    /// Where it stands in the excerpt.
    start: usize,
    text: String,
    /// The part of the file that it shows.
    window: Range<usize>,
    /// How many bytes stand before it: the mark of an omission.
    before: usize,
}

impl Cut {
    fn around(source: &SourceFile, line: u32, offset: u32, start: usize) -> Self {
        const OMITTED: &str = "…";
        let span = source.line_span(line).unwrap_or_default();
        let whole = span.range();
        let text = source.text();
        let at = snap(text, offset as usize).clamp(whole.start, whole.end);
        let window = if span.len() <= LONGEST {
            whole.clone()
        } else {
            let back = text
                .get(whole.start..at)
                .unwrap_or_default()
                .char_indices()
                .rev()
                .nth(BEFORE - 1);
            let forth = text.get(at..whole.end).unwrap_or_default().char_indices().nth(AFTER);
            back.map_or(whole.start, |(index, _)| whole.start + index)..forth.map_or(whole.end, |(index, _)| at + index)
        };
        let mark = |omitted: bool| if omitted { OMITTED } else { "" };
        let (left, right) = (mark(window.start > whole.start), mark(window.end < whole.end));
        let words = sanitise(text.get(window.clone()).unwrap_or_default());
        Self {
            start,
            text: format!("{left}{words}{right}"),
            before: left.len(),
            window,
        }
    }

    /// Where an offset of the file lies in the excerpt; one outside the cut line lies at its edge.
    fn place(&self, source: &SourceFile, offset: u32) -> usize {
        let at = snap(source.text(), offset as usize).clamp(self.window.start, self.window.end);
        self.start + self.before + at - self.window.start
    }
}
