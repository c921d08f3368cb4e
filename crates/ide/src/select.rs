//! Ever larger pieces of the text around the cursor.

use scenec_syntax::{Content, scan};
use scenec_text::Span;

use crate::Document;
use crate::fold::fold_around;
use crate::names::statement;

/// The pieces that hold `offset`, the smallest first: a word, a value with its sign, all values, the statement, the line
/// with its comment, the run of lines that belong together, the text. Each holds the one before it and is larger.
#[must_use]
pub fn selections(document: &Document, offset: u32) -> Vec<Span> {
    let text = document.text();
    let source = document.source();
    let length = u32::try_from(text.len()).unwrap_or(u32::MAX);
    let offset = offset.min(length);
    let number = source.line_of(offset);
    let mut found = vec![Span::at(offset)];
    if let Some(line) = document.line_at(offset) {
        let words = source.line_span(number).unwrap_or_default();
        found.extend(word_at(words, text, offset));
        if let Some(statement) = statement(line) {
            let values = statement.values();
            found.extend(values.iter().map(|value| value.span).find(|span| holds(*span, offset)));
            if let (Some(first), Some(last)) = (values.first(), values.last()) {
                found.push(first.span.to(last.span));
            }
        }
        if line.content != Content::Comment {
            found.push(line.span);
        }
        found.extend(line.comment);
        found.push(line.comment.map_or(line.span, |comment| line.span.to(comment)));
    }
    if let Some(fold) = fold_around(document, number) {
        let first = source.line_span(fold.first_line).unwrap_or_default();
        let last = source.line_span(fold.last_line).unwrap_or_default();
        found.push(first.to(last));
    }
    found.push(Span::new(0, length));
    nested(found, offset)
}

/// The pieces that hold the offset and all of the piece before.
fn nested(found: Vec<Span>, offset: u32) -> Vec<Span> {
    let mut nested: Vec<Span> = Vec::with_capacity(found.len());
    for span in found {
        let fits = match nested.last() {
            None => true,
            Some(inner) => span.start <= inner.start && inner.end <= span.end && span != *inner,
        };
        if fits && holds(span, offset) {
            nested.push(span);
        }
    }
    // A bare place is no piece, unless there is nothing else.
    if nested.len() > 1 && nested.first().is_some_and(|first| first.is_empty()) {
        nested.remove(0);
    }
    nested
}

const fn holds(span: Span, offset: u32) -> bool {
    span.start <= offset && offset <= span.end
}

/// The last word that the offset touches, so that between two words the one behind it counts.
fn word_at(line: Span, text: &str, offset: u32) -> Option<Span> {
    let words = scan(line.of(text)).map(|(_, word)| Span::new(line.start + word.start, line.start + word.end));
    words
        .take_while(|word| word.start <= offset)
        .filter(|word| holds(*word, offset))
        .last()
}

#[cfg(test)]
mod tests {
    use super::selections;
    use crate::marked::marked;

    fn check(text: &str, expect: &[&str]) {
        let (document, offset) = marked(text);
        let found: Vec<_> = selections(&document, offset)
            .iter()
            .map(|span| span.of(document.text()))
            .collect();
        assert_eq!(found, expect, "{text}");
    }

    #[test]
    fn pieces_grow_from_the_word_to_the_text() {
        check(
            "a := 1\n\n!s := hp\n!s += -$01 2 3 / up",
            &[
                "1",
                "-1",
                "-1 2 3",
                "!s += -1 2 3",
                "!s += -1 2 3 / up",
                "!s := hp\n!s += -1 2 3 / up",
                "a := 1\n\n!s := hp\n!s += -1 2 3 / up",
            ],
        );
        check("a $0", &["a "]);
        check("$0", &[""]);
        check("/ $0c\nb", &["/ c", "/ c\nb"]);
    }
}
