//! Putting whole lines into a text, with its own line ends.

use scenec_scene::setting;
use scenec_syntax::{Content, Line, Statement};
use scenec_text::{Edit, Span};

use crate::Document;
use crate::names::statement;

/// The line end of the first line, which stands for all; LF where there is only one line.
pub(crate) fn line_end(document: &Document) -> &'static str {
    let text = document.text();
    let first = text.find('\n').and_then(|at| text.get(..at));
    if first.is_some_and(|first| first.ends_with('\r')) {
        "\r\n"
    } else {
        "\n"
    }
}

/// Puts lines before the line that holds `place`.
pub(crate) fn new_line_before(document: &Document, place: Span, lines: &str) -> Edit {
    let source = document.source();
    let row = source.line_span(source.line_of(place.start)).unwrap_or(place);
    Edit {
        span: Span::at(row.start),
        text: format!("{lines}{}", line_end(document)),
    }
}

/// Puts lines behind the line that holds `place`.
pub(crate) fn new_line_after(document: &Document, place: Span, lines: &str) -> Edit {
    let source = document.source();
    let row = source.line_span(source.line_of(place.start)).unwrap_or(place);
    Edit {
        span: Span::at(row.end),
        text: format!("{}{lines}", line_end(document)),
    }
}

/// Puts settings behind the last setting; where there is none, before the first statement, so that comments which speak
/// for the whole file stay above it.
pub(crate) fn new_settings(document: &Document, lines: &str) -> Edit {
    let text = document.text();
    let is_setting = |line: &&Line| match statement(line) {
        Some(Statement::Variable { name, .. }) => setting(name.of(text)).is_some(),
        _ => false,
    };
    let all = document.lines();
    if let Some(last) = all.iter().rev().find(is_setting) {
        return new_line_after(document, last.span, lines);
    }
    match (all.iter().find(|line| line.content != Content::Comment), all.last()) {
        (Some(first), _) => new_line_before(document, first.span, lines),
        (None, Some(last)) => new_line_after(document, last.span, lines),
        (None, None) => new_line_before(document, Span::default(), lines),
    }
}

/// A line with its end, or with the end of the line before it if it is the last one.
pub(crate) fn whole_line(document: &Document, place: Span) -> Span {
    let source = document.source();
    let number = source.line_of(place.start);
    let row = source.line_span(number).unwrap_or(place);
    let before = number.checked_sub(1).and_then(|before| source.line_span(before));
    match (source.line_span(number + 1), before) {
        (Some(next), _) => Span::new(row.start, next.start),
        (None, Some(before)) => Span::new(before.end, row.end),
        (None, None) => row,
    }
}
