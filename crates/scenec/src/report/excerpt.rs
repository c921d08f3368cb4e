//! The part of a long line that a finding is about.

use std::ops::Range;

use scenec_text::{Diagnostic, SourceFile};

use super::sanitise::sanitise;
use super::snap;

/// A line with more bytes than this is never shown whole.
const LONGEST: u32 = 240;
/// How many characters of a long line are shown before and after the start of the first label on it.
const BEFORE: usize = 40;
const AFTER: usize = 80;

/// A text in which only the lines that a finding names are filled, each at its own line number, long ones cut.
pub(super) struct Excerpt {
    pub(super) text: String,
    /// Where each label lies in it.
    pub(super) places: Vec<Range<usize>>,
    /// Line and column of the finding in the file, from 1.
    pub(super) line: u32,
    pub(super) column: u32,
    /// The column in the excerpt, from 1.
    pub(super) shown_column: usize,
}

impl Excerpt {
    /// The excerpt for a finding on a long line; `None` if every line that it names can be shown whole.
    pub(super) fn of(source: &SourceFile, finding: &Diagnostic) -> Option<Self> {
        let mut labels: Vec<_> = finding
            .labels
            .iter()
            .enumerate()
            .map(|(index, label)| (source.position(label.span.start).line, index, label.span))
            .collect();
        let long = |line: u32| source.line_span(line).is_some_and(|span| span.len() > LONGEST);
        if !labels.iter().any(|(line, ..)| long(*line)) {
            return None;
        }
        labels.sort_unstable();
        let primary = source.position(finding.span().start);
        let mut excerpt = Self {
            text: String::new(),
            places: vec![0..0; labels.len()],
            line: primary.line + 1,
            column: primary.chars + 1,
            shown_column: 1,
        };
        let mut at = 0;
        for group in labels.chunk_by(|a, b| a.0 == b.0) {
            let Some((line, _, first)) = group.first().copied() else {
                continue;
            };
            excerpt.text.extend(std::iter::repeat_n('\n', (line - at) as usize));
            at = line;
            let start = excerpt.text.len();
            let cut = Cut::around(source, line, first.start);
            excerpt.text.push_str(&cut.text);
            for (_, index, span) in group {
                let place = start + cut.place(source, span.start)..start + cut.place(source, span.end);
                if *index == 0 {
                    let before = excerpt.text.get(start..place.start).unwrap_or_default();
                    excerpt.shown_column = before.chars().count() + 1;
                }
                if let Some(slot) = excerpt.places.get_mut(*index) {
                    *slot = place;
                }
            }
        }
        excerpt.text.push(' ');
        Some(excerpt)
    }
}

/// A line, cut to a window.
struct Cut {
    text: String,
    /// The part of the file that it shows.
    window: Range<usize>,
    /// How many bytes stand before it: the mark of an omission.
    before: usize,
}

impl Cut {
    fn around(source: &SourceFile, line: u32, offset: u32) -> Self {
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
            text: format!("{left}{words}{right}"),
            before: left.len(),
            window,
        }
    }

    /// Where an offset of the file lies in the cut line; one outside it lies at its edge.
    fn place(&self, source: &SourceFile, offset: u32) -> usize {
        let at = snap(source.text(), offset as usize).clamp(self.window.start, self.window.end);
        at - self.window.start + self.before
    }
}
