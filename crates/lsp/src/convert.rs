//! Between byte offsets and the client's lines and columns.

use scenec_ide::Document;
use scenec_text::Span;
use tower_lsp::lsp_types::Position;

use crate::abilities::Encoding;

/// A place that has been worked out, for the next one on its line to start from.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Known {
    offset: u32,
    position: Position,
}

/// The client's name for an offset; one inside a character counts as that character's start.
pub(crate) fn position(document: &Document, encoding: Encoding, offset: u32, known: Known) -> (Position, Known) {
    let (source, text) = (document.source(), document.text());
    let offset = boundary(text, offset);
    let line = source.line_of(offset);
    let line_start = line_start(document, line).unwrap_or_default();
    let near = known.position.line == line && (line_start..=offset).contains(&known.offset);
    let (from, column) = if near {
        (known.offset, known.position.character)
    } else {
        (line_start, 0)
    };
    let more = Span::new(from, offset).of(text);
    let more = match encoding {
        Encoding::Utf8 => offset - from,
        Encoding::Utf16 => more.chars().map(|one| encoding.width(one)).sum(),
    };
    let position = Position::new(line, column + more);
    (position, Known { offset, position })
}

/// The offset of the client's place; what lies past a line's words counts as their end, what lies past the text as its
/// end, the middle of a character as its start.
pub(crate) fn offset(document: &Document, encoding: Encoding, position: Position) -> u32 {
    let text = document.text();
    let (Some(start), Some(line)) = (
        line_start(document, position.line),
        document.source().line_span(position.line),
    ) else {
        return u32::try_from(text.len()).unwrap_or(u32::MAX);
    };
    let words = Span::new(start, line.end).of(text);
    match encoding {
        Encoding::Utf8 => boundary(text, start.saturating_add(position.character).min(line.end)),
        Encoding::Utf16 => {
            let (mut column, mut offset) = (0, start);
            for one in words.chars() {
                column += encoding.width(one);
                if column > position.character {
                    break;
                }
                offset += Encoding::Utf8.width(one);
            }
            offset
        }
    }
}

/// Where a line begins. A client counts a byte-order mark, if it sends one at all.
fn line_start(document: &Document, line: u32) -> Option<u32> {
    match line {
        0 => Some(0),
        _ => document.source().line_span(line).map(|span| span.start),
    }
}

fn boundary(text: &str, offset: u32) -> u32 {
    let mut offset = (offset as usize).min(text.len());
    while !text.is_char_boundary(offset) {
        offset -= 1;
    }
    u32::try_from(offset).unwrap_or(u32::MAX)
}

#[cfg(test)]
mod tests {
    use scenec_ide::Document;
    use scenec_text::SourceFile;
    use tower_lsp::lsp_types::Position;

    use super::{Known, offset, position};
    use crate::abilities::Encoding;

    fn document(text: &str) -> Document {
        Document::new(SourceFile::new("t", text).unwrap())
    }

    /// A place in both directions.
    fn check(text: &str, at: u32, utf8: (u32, u32), utf16: (u32, u32)) {
        let document = document(text);
        for (encoding, (line, column)) in [(Encoding::Utf8, utf8), (Encoding::Utf16, utf16)] {
            let place = Position::new(line, column);
            let (found, known) = position(&document, encoding, at, Known::default());
            assert_eq!(found, place, "{text:?} {encoding:?}");
            assert_eq!(position(&document, encoding, at, known).0, place);
            assert_eq!(offset(&document, encoding, place), at, "{text:?} {encoding:?}");
        }
    }

    #[test]
    fn places_are_the_same_both_ways() {
        check("", 0, (0, 0), (0, 0));
        check("ab\ncd", 4, (1, 1), (1, 1));
        check("/ é😀x\r\ny", 8, (0, 8), (0, 5));
        check("/ é😀x\r\ny", 11, (1, 0), (1, 0));
        check("\u{FEFF}ab", 4, (0, 4), (0, 2));
    }

    #[test]
    fn places_outside_are_brought_back() {
        let document = document("/ 😀\r\nb");
        for encoding in [Encoding::Utf8, Encoding::Utf16] {
            assert_eq!(offset(&document, encoding, Position::new(0, 99)), 6);
            assert_eq!(offset(&document, encoding, Position::new(0, 3)), 2);
            assert_eq!(offset(&document, encoding, Position::new(1, u32::MAX)), 9);
            assert_eq!(offset(&document, encoding, Position::new(7, 0)), 9);
            assert_eq!(
                position(&document, encoding, 99, Known::default()).0,
                Position::new(1, 1)
            );
            assert_eq!(
                position(&document, encoding, 4, Known::default()).0,
                Position::new(0, 2)
            );
        }
    }

    #[test]
    fn what_is_known_only_saves_work() {
        let text = "/ é😀é\n/ 😀\n😀";
        let document = document(text);
        let fresh = |at| position(&document, Encoding::Utf16, at, Known::default());
        for from in 0..text.len() as u32 {
            for to in 0..=text.len() as u32 {
                assert_eq!(position(&document, Encoding::Utf16, to, fresh(from).1).0, fresh(to).0);
            }
        }
    }
}
