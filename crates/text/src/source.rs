//! A source file in memory: valid UTF-8 whatever the bytes were, with a line index.

use crate::line_index::LineIndex;
use crate::{Code, Diagnostic, Span};

/// The largest file that is read: spans count bytes in 32 bits.
pub const MAX_FILE_BYTES: u64 = u32::MAX as u64 - 1;

/// What stands for a byte that was no UTF-8: one byte long, so that every offset stays true.
const HOLE: u8 = 0x1A;

/// A text with a name, and where its lines begin.
#[derive(Clone, Debug)]
pub struct SourceFile {
    name: String,
    text: String,
    lines: LineIndex,
    /// Runs of bytes that were not UTF-8, in order.
    holes: Vec<Span>,
}

/// A place as people and editors count it; all fields from 0.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug, Default)]
pub struct Position {
    /// Line number.
    pub line: u32,
    /// Bytes between the line's start and the place.
    pub utf8: u32,
    /// UTF-16 code units between the line's start and the place.
    pub utf16: u32,
    /// Unicode scalar values between the line's start and the place.
    pub chars: u32,
}

/// The file has more bytes than a span can count.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct TooLarge {
    /// How many bytes it has.
    pub bytes: u64,
}

impl SourceFile {
    /// A file of text that is known to be UTF-8, as an editor holds it.
    ///
    /// # Errors
    /// `TooLarge` above [`MAX_FILE_BYTES`].
    pub fn new(name: impl Into<String>, text: impl Into<String>) -> Result<Self, TooLarge> {
        Self::with_holes(name.into(), text.into(), Vec::new())
    }

    /// A file as it lies on disk. Bytes that are no UTF-8 are reported, a run at a time, and become holes that
    /// [`SourceFile::is_hole`] tells; every other offset means the byte at that offset of the file.
    ///
    /// # Errors
    /// `TooLarge` above [`MAX_FILE_BYTES`].
    pub fn from_bytes(name: impl Into<String>, bytes: Vec<u8>) -> Result<(Self, Vec<Diagnostic>), TooLarge> {
        let (text, holes) = decode(bytes);
        let diagnostics = holes
            .iter()
            .map(|hole| {
                let bytes = if hole.len() == 1 { "byte is" } else { "bytes are" };
                Diagnostic::new(
                    Code::InvalidUtf8,
                    format!("invalid UTF-8 at byte offset {}", hole.start),
                    *hole,
                    format!("{} {bytes} not UTF-8", hole.len()),
                )
                .help("save the file as UTF-8")
            })
            .collect();
        Ok((Self::with_holes(name.into(), text, holes)?, diagnostics))
    }

    fn with_holes(name: String, text: String, holes: Vec<Span>) -> Result<Self, TooLarge> {
        let bytes = text.len() as u64;
        if bytes > MAX_FILE_BYTES {
            return Err(TooLarge { bytes });
        }
        let lines = LineIndex::of(&text);
        Ok(Self {
            name,
            text,
            lines,
            holes,
        })
    }

    /// What the file is called: a path, or a phrase for standard input.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The whole text, a byte-order mark included.
    #[must_use]
    pub fn text(&self) -> &str {
        &self.text
    }

    /// How many lines there are; a text that ends in a line feed has an empty last one.
    #[must_use]
    pub fn line_count(&self) -> u32 {
        self.lines.count()
    }

    /// The words of a line without its end (LF or CRLF) and without a byte-order mark; `None` past the last line.
    #[must_use]
    pub fn line_span(&self, line: u32) -> Option<Span> {
        let start = self.start_of(line)?;
        let end = match self.start_of(line + 1) {
            Some(next) => next - 1,
            None => u32::try_from(self.text.len()).unwrap_or(u32::MAX),
        };
        let words = Span::new(start, end).of(&self.text);
        let cr = u32::from(words.ends_with('\r') && (line + 1) < self.line_count());
        Some(Span::new(start, end - cr))
    }

    /// The number of the line that an offset lies on, as in [`Position::line`], without counting what is before it there.
    #[must_use]
    pub fn line_of(&self, offset: u32) -> u32 {
        self.lines.line_of(&self.text, offset)
    }

    /// Where a line begins, behind a byte-order mark.
    fn start_of(&self, line: u32) -> Option<u32> {
        match line {
            0 if self.text.starts_with('\u{FEFF}') => Some(3),
            _ => self.lines.start_of(&self.text, line),
        }
    }

    /// Where an offset lies. One inside a character counts as that character's start, one past the end as the end,
    /// one in a byte-order mark as the start of the first line.
    #[must_use]
    pub fn position(&self, offset: u32) -> Position {
        let line = self.line_of(offset);
        let start = self.start_of(line).unwrap_or_default() as usize;
        let mut end = (offset as usize).clamp(start, self.text.len().max(start));
        while !self.text.is_char_boundary(end) {
            end -= 1;
        }
        let before = self.text.get(start..end).unwrap_or_default();
        let count = |n: usize| u32::try_from(n).unwrap_or(u32::MAX);
        Position {
            line,
            utf8: count(before.len()),
            utf16: count(before.chars().map(char::len_utf16).sum()),
            chars: count(before.chars().count()),
        }
    }

    /// Whether the byte at `offset` was no UTF-8 and has been reported already.
    #[must_use]
    pub fn is_hole(&self, offset: u32) -> bool {
        let after = self.holes.partition_point(|hole| hole.start <= offset);
        after > 0 && self.holes.get(after - 1).is_some_and(|hole| offset < hole.end)
    }

    /// The runs of bytes that were no UTF-8, in order.
    #[must_use]
    pub fn holes(&self) -> &[Span] {
        &self.holes
    }
}

fn decode(bytes: Vec<u8>) -> (String, Vec<Span>) {
    let mut bytes = match String::from_utf8(bytes) {
        Ok(text) => return (text, Vec::new()),
        Err(error) => error.into_bytes(),
    };
    let mut holes: Vec<Span> = Vec::new();
    let mut at = 0;
    while let Err(error) = std::str::from_utf8(bytes.get(at..).unwrap_or_default()) {
        let start = at + error.valid_up_to();
        let end = error.error_len().map_or(bytes.len(), |len| start + len);
        bytes[start..end].fill(HOLE);
        // An offset past 32 bits never leaves this module: such a file is refused as too large.
        let span = Span::new(start as u32, end as u32);
        match holes.last_mut() {
            Some(last) if last.end == span.start => last.end = span.end,
            _ => holes.push(span),
        }
        at = end;
    }
    // Every bad byte is a one-byte character now, so nothing is replaced here.
    (String::from_utf8_lossy(&bytes).into_owned(), holes)
}

#[cfg(test)]
mod tests {
    use super::{Position, SourceFile};
    use crate::Span;

    fn check(bytes: &[u8], offset: u32, expect: (u32, u32, u32, u32)) {
        let (file, _) = SourceFile::from_bytes("t", bytes.to_vec()).unwrap();
        let (line, utf8, utf16, chars) = expect;
        let expect = Position {
            line,
            utf8,
            utf16,
            chars,
        };
        assert_eq!(file.position(offset), expect, "{bytes:?} at {offset}");
    }

    #[test]
    fn positions_count_bytes_code_units_and_characters() {
        check(b"ab\ncd", 4, (1, 1, 1, 1));
        check("\u{FEFF}ab".as_bytes(), 4, (0, 1, 1, 1));
        check("\u{FEFF}ab".as_bytes(), 1, (0, 0, 0, 0));
        check("é𝄞x".as_bytes(), 6, (0, 6, 3, 2));
        check("é𝄞x".as_bytes(), 4, (0, 2, 1, 1));
        check(b"a\r\nb", 3, (1, 0, 0, 0));
        check(b"a", 99, (0, 1, 1, 1));
        check(b"", 0, (0, 0, 0, 0));
    }

    #[test]
    fn lines_end_at_lf_and_crlf_and_a_last_cr_stays() {
        let file = SourceFile::new("t", "\u{FEFF}a\r\nb\n\nc\r").unwrap();
        let lines: Vec<_> = (0..file.line_count())
            .filter_map(|line| file.line_span(line).map(|span| span.of(file.text())))
            .collect();
        assert_eq!(lines, ["a", "b", "", "c\r"]);
        assert_eq!(file.line_span(4), None);
    }

    #[test]
    fn bad_bytes_become_holes_and_offsets_stay() {
        let (file, diagnostics) = SourceFile::from_bytes("t", b"a\xFF\xFEb\xC3\n\x1A".to_vec()).unwrap();
        assert_eq!(file.holes(), [Span::new(1, 3), Span::new(4, 5)]);
        assert_eq!(diagnostics.len(), 2);
        assert_eq!(diagnostics[0].message, "invalid UTF-8 at byte offset 1");
        assert!(file.is_hole(1) && file.is_hole(2) && !file.is_hole(3) && !file.is_hole(6));
        assert_eq!(file.text().len(), 7);
    }
}
