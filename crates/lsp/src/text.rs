//! The text of an open document while it is edited: a rope, so that one edit costs the same in a file of any size.
//!
//! It must not know who edits it, or what the text means.

use std::ops::Range;

use ropey::Rope;
use tower_lsp::lsp_types::{Position, TextDocumentContentChangeEvent};

use crate::abilities::Encoding;

/// What stands for half of a character.
const HALF: char = '\u{FFFD}';

/// A text under edit. Lines end in LF, and in CRLF; a lone CR is a character like any other, as editors have it.
#[derive(Clone, Debug)]
pub(crate) struct Text {
    rope: Rope,
}

/// A place between two characters, or within one that takes two columns.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
struct Place {
    /// The characters before it.
    character: usize,
    /// Whether it lies in the middle of the next one.
    within: bool,
}

impl Text {
    /// A text as it was opened.
    pub(crate) fn new(text: &str) -> Self {
        Self {
            rope: Rope::from_str(text),
        }
    }

    /// The whole text.
    pub(crate) fn whole(&self) -> String {
        self.rope.to_string()
    }

    /// Takes one change over: of a range, or of everything. A range that lies outside the text is brought back into it:
    /// to refuse it would leave the two copies of the text apart for good.
    pub(crate) fn change(&mut self, change: &TextDocumentContentChangeEvent, encoding: Encoding) {
        let Some(range) = change.range else {
            self.rope = Rope::from_str(&change.text);
            return;
        };
        let places = [range.start, range.end].map(|position| self.place(position, encoding));
        let (start, end) = (places[0].min(places[1]), places[0].max(places[1]));
        // Half a surrogate pair can't stand in a text; what takes its place is as wide.
        let kept = |half: bool| if half { String::from(HALF) } else { String::new() };
        let text = [&kept(start.within), change.text.as_str(), &kept(end.within)].concat();
        self.replace(start.character..end.character + usize::from(end.within), &text);
    }

    fn replace(&mut self, range: Range<usize>, text: &str) {
        let start = range.start;
        // Places are within the text, so neither can fail; an edit that did would better be lost than end the server.
        if self.rope.try_remove(range).is_ok() {
            self.rope.try_insert(start, text).unwrap_or_default();
        }
    }

    fn place(&self, position: Position, encoding: Encoding) -> Place {
        let whole = |character| Place {
            character,
            within: false,
        };
        let line = position.line as usize;
        if line >= self.rope.len_lines() {
            return whole(self.rope.len_chars());
        }
        let start = self.rope.line_to_char(line);
        let words = self.rope.line(line);
        let ends_in = |end: char, before: usize| {
            let last = words.len_chars().checked_sub(before + 1);
            last.and_then(|last| words.get_char(last)) == Some(end)
        };
        let feed = usize::from(ends_in('\n', 0));
        let end = words.len_chars() - feed;
        let words = words.slice(..end);
        let column = position.character as usize;
        let width = match encoding {
            Encoding::Utf8 => words.len_bytes(),
            Encoding::Utf16 => words.len_utf16_cu(),
        };
        if column > width {
            // Right behind the CR of a CRLF is a place that some editors mean; further on is the end of the words.
            let cr = usize::from(feed == 1 && ends_in('\r', 1));
            return whole(start + end - cr);
        }
        match encoding {
            Encoding::Utf8 => whole(start + words.byte_to_char(column)),
            Encoding::Utf16 => {
                let character = words.utf16_cu_to_char(column);
                Place {
                    character: start + character,
                    within: words.char_to_utf16_cu(character) != column,
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::{Just, Strategy, any, prop_oneof};
    use proptest::{collection, prop_assert_eq, proptest};
    use tower_lsp::lsp_types::{Position, Range, TextDocumentContentChangeEvent};

    use super::Text;
    use crate::abilities::Encoding;

    type Edit = ((u32, u32), (u32, u32), &'static str);

    fn change(((a, b), (c, d), text): Edit) -> TextDocumentContentChangeEvent {
        TextDocumentContentChangeEvent {
            range: Some(Range::new(Position::new(a, b), Position::new(c, d))),
            range_length: None,
            text: text.to_owned(),
        }
    }

    fn check(text: &str, encoding: Encoding, edit: Edit, expect: &str) {
        let mut edited = Text::new(text);
        edited.change(&change(edit), encoding);
        assert_eq!(edited.whole(), expect, "{text:?} {encoding:?} {edit:?}");
    }

    #[test]
    fn columns_are_counted_as_agreed() {
        check("é😀x", Encoding::Utf16, ((0, 3), (0, 4), "y"), "é😀y");
        check("é😀x", Encoding::Utf8, ((0, 6), (0, 7), "y"), "é😀y");
        check("é😀x", Encoding::Utf8, ((0, 4), (0, 7), "y"), "éy");
        check("a\r\nb\r\n", Encoding::Utf16, ((1, 0), (1, 1), "c"), "a\r\nc\r\n");
        check("a\r\nb", Encoding::Utf16, ((0, 1), (1, 0), "\n"), "a\nb");
    }

    #[test]
    fn places_outside_are_brought_back() {
        for encoding in [Encoding::Utf8, Encoding::Utf16] {
            check("ab\ncd", encoding, ((0, 99), (0, 99), "!"), "ab!\ncd");
            check("ab\r\ncd", encoding, ((0, 99), (0, 99), "!"), "ab!\r\ncd");
            check("ab\r\ncd", encoding, ((0, 3), (0, 3), "!"), "ab\r!\ncd");
            check("ab\ncd", encoding, ((1, u32::MAX), (1, u32::MAX), "!"), "ab\ncd!");
            check("ab\ncd", encoding, ((9, 1), (u32::MAX, 0), "!"), "ab\ncd!");
            check("ab\ncd", encoding, ((1, 1), (0, 1), "!"), "a!d");
            check("", encoding, ((0, 5), (7, 7), "!"), "!");
            check("a\rb", encoding, ((0, 2), (0, 3), "!"), "a\r!");
        }
    }

    #[test]
    fn half_a_pair_leaves_something_as_wide() {
        check("a😀b", Encoding::Utf16, ((0, 2), (0, 2), "-"), "a\u{FFFD}-\u{FFFD}b");
        check("a😀b", Encoding::Utf16, ((0, 1), (0, 2), ""), "a\u{FFFD}b");
        check("a😀b", Encoding::Utf16, ((0, 2), (0, 3), ""), "a\u{FFFD}b");
        check("😀😀", Encoding::Utf16, ((0, 1), (0, 3), ""), "\u{FFFD}\u{FFFD}");
    }

    #[test]
    fn a_change_without_a_range_is_of_everything() {
        let mut text = Text::new("abc");
        let everything = TextDocumentContentChangeEvent {
            range: None,
            range_length: None,
            text: "x\ny".to_owned(),
        };
        text.change(&everything, Encoding::Utf16);
        assert_eq!(text.whole(), "x\ny");
    }

    /// A text as JavaScript has it: code units, and lines that are looked for from the start each time.
    struct Model(Vec<u16>);

    impl Model {
        fn offset(&self, line: u32, column: u32) -> usize {
            let mut at = 0;
            for _ in 0..line {
                match self.0[at..].iter().position(|unit| *unit == u16::from(b'\n')) {
                    Some(feed) => at += feed + 1,
                    None => return self.0.len(),
                }
            }
            let rest = &self.0[at..];
            let feed = rest.iter().position(|unit| *unit == u16::from(b'\n'));
            let end = feed.unwrap_or(rest.len());
            if column as usize <= end {
                return at + column as usize;
            }
            let cr = feed.is_some() && end > 0 && rest[end - 1] == u16::from(b'\r');
            at + end - usize::from(cr)
        }

        fn change(&mut self, ((a, b), (c, d), text): Edit) {
            let (from, to) = (self.offset(a, b), self.offset(c, d));
            self.0.splice(from.min(to)..from.max(to), text.encode_utf16());
            // What no text can hold becomes what it is written as.
            self.0 = String::from_utf16_lossy(&self.0).encode_utf16().collect();
        }
    }

    fn words() -> impl Strategy<Value = &'static str> {
        prop_oneof![
            Just(""),
            Just("a"),
            Just("\n"),
            Just("\r\n"),
            Just("\r"),
            Just("😀"),
            Just("é"),
            Just("x := 1 / 🎈\r\ny"),
            Just("\u{2028}\u{85}\u{B}\u{C}"),
            Just("\u{FEFF}"),
        ]
    }

    fn edit() -> impl Strategy<Value = Edit> {
        let place = || (0..7_u32, prop_oneof![0..12_u32, any::<u32>()]);
        (place(), place(), words())
    }

    proptest! {
        #[test]
        fn edits_agree_with_a_text_of_code_units(start in collection::vec(words(), 0..12), edits in collection::vec(edit(), 0..40)) {
            let start = start.concat();
            let mut text = Text::new(&start);
            let mut model = Model(start.encode_utf16().collect());
            for edit in edits {
                text.change(&change(edit), Encoding::Utf16);
                model.change(edit);
                prop_assert_eq!(text.whole(), String::from_utf16_lossy(&model.0));
            }
        }
    }
}
