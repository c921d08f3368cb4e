//! Where the lines of a text begin.

/// Bytes of a piece; few enough for a count in one byte.
const PIECE: usize = 128;

/// How many line feeds stand before each piece of a text. A place for every line would take as much memory as a file of
/// short lines, and longer to fill; within a piece they are counted when somebody asks.
#[derive(Clone, Debug)]
pub(crate) struct LineIndex {
    before: Vec<u32>,
    /// Line feeds in all.
    feeds: u32,
}

impl LineIndex {
    /// The index of a text whose bytes can be counted in 32 bits.
    pub(crate) fn of(text: &str) -> Self {
        let mut feeds = 0;
        let count = |piece: &[u8]| {
            let before = feeds;
            feeds += u32::from(piece.iter().map(|byte| u8::from(*byte == b'\n')).sum::<u8>());
            before
        };
        let before = text.as_bytes().chunks(PIECE).map(count).collect();
        Self { before, feeds }
    }

    /// How many lines there are; a text that ends in a line feed has an empty last one.
    pub(crate) const fn count(&self) -> u32 {
        self.feeds + 1
    }

    /// The number of the line that an offset of the text lies on.
    pub(crate) fn line_of(&self, text: &str, offset: u32) -> u32 {
        let end = (offset as usize).min(text.len());
        let piece = end / PIECE;
        let Some(before) = self.before.get(piece) else {
            return self.feeds;
        };
        let inside = text.as_bytes().get(piece * PIECE..end).unwrap_or_default();
        // A piece has no more bytes than 32 bits can count.
        before + inside.iter().filter(|byte| **byte == b'\n').count() as u32
    }

    /// Where a line begins; `None` past the last one.
    pub(crate) fn start_of(&self, text: &str, line: u32) -> Option<u32> {
        let Some(feed) = line.checked_sub(1) else {
            return Some(0);
        };
        if line > self.feeds {
            return None;
        }
        // The last piece before which there are not too many already.
        let piece = self.before.partition_point(|before| *before <= feed).checked_sub(1)?;
        let skipped = feed - self.before.get(piece)?;
        let bytes = text.as_bytes().get(piece * PIECE..)?;
        let mut feeds = bytes.iter().enumerate().filter(|(_, byte)| **byte == b'\n');
        let (at, _) = feeds.nth(skipped as usize)?;
        u32::try_from(piece * PIECE + at + 1).ok()
    }
}

#[cfg(test)]
mod tests {
    use super::LineIndex;

    /// The index says what counting from the beginning says.
    fn check(text: &str) {
        let index = LineIndex::of(text);
        let starts: Vec<u32> = std::iter::once(0)
            .chain(
                (1..)
                    .zip(text.bytes())
                    .filter(|(_, byte)| *byte == b'\n')
                    .map(|(next, _)| next),
            )
            .collect();
        assert_eq!(index.count() as usize, starts.len());
        for (line, start) in (0..).zip(&starts) {
            assert_eq!(index.start_of(text, line), Some(*start), "line {line} of {text:?}");
        }
        assert_eq!(index.start_of(text, index.count()), None);
        for offset in 0..=text.len() as u32 + 1 {
            let expect = starts.iter().filter(|start| **start <= offset).count() as u32 - 1;
            assert_eq!(index.line_of(text, offset), expect, "offset {offset} of {text:?}");
        }
    }

    #[test]
    fn lines_are_found_wherever_the_pieces_end() {
        check("");
        check("a");
        check("\n");
        for length in [1, 2, 63, 64, 127, 128, 129, 300] {
            check(&"\n".repeat(length));
            check(&format!("{}\n", "a".repeat(length)).repeat(5));
            check(&format!("{}\n\n{}", "a".repeat(length), "b".repeat(200)));
        }
    }
}
