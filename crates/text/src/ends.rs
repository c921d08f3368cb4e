//! What an edit leaves alone.

/// How many bytes are compared at once.
const BLOCK: usize = 4096;

/// What two texts have in common at their ends, which do not overlap in either.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct CommonEnds {
    /// The first so many bytes are the same.
    pub head: u32,
    /// From here on they are the same: the offset in the one, and in the other text.
    pub tails: [u32; 2],
}

impl CommonEnds {
    /// Compares two texts, byte by byte: an end may begin inside a character.
    #[must_use]
    pub fn of(before: &str, after: &str) -> Self {
        let [before, after] = [before, after].map(str::as_bytes);
        let head = common(
            before,
            after,
            |text, at| text.get(at..at + BLOCK),
            |text, at| text.get(at),
        );
        let rest = [before, after].map(|text| text.get(head..).unwrap_or_default());
        let from_end = |text: &[u8], at: usize| text.len().checked_sub(at);
        let tail = common(
            rest[0],
            rest[1],
            |text, at| from_end(text, at).and_then(|end| text.get(end.checked_sub(BLOCK)?..end)),
            |text, at| from_end(text, at + 1).and_then(|at| text.get(at)),
        );
        let offset = |at: usize| u32::try_from(at).unwrap_or(u32::MAX);
        Self {
            head: offset(head),
            tails: [before, after].map(|text| offset(text.len() - tail)),
        }
    }
}

/// How many bytes two texts have in common from one end on: whole blocks first, then one by one.
fn common(
    a: &[u8],
    b: &[u8],
    block: impl for<'t> Fn(&'t [u8], usize) -> Option<&'t [u8]>,
    byte: impl for<'t> Fn(&'t [u8], usize) -> Option<&'t u8>,
) -> usize {
    let mut count = 0;
    while let Some(one) = block(a, count)
        && Some(one) == block(b, count)
    {
        count += BLOCK;
    }
    while let Some(one) = byte(a, count)
        && Some(one) == byte(b, count)
    {
        count += 1;
    }
    count
}

#[cfg(test)]
mod tests {
    use super::CommonEnds;

    fn check(before: &str, after: &str, head: u32, tails: [u32; 2]) {
        assert_eq!(CommonEnds::of(before, after), CommonEnds { head, tails });
        if before == after {
            return;
        }
        // And in the middle of what takes several blocks.
        let filled = "x\n".repeat(10_000);
        let [before, after] = [before, after].map(|text| format!("{filled}{text}{filled}"));
        let (head, tails) = (head + 20_000, tails.map(|tail| tail + 20_000));
        assert_eq!(CommonEnds::of(&before, &after), CommonEnds { head, tails });
    }

    #[test]
    fn ends_meet_and_do_not_overlap() {
        check("", "", 0, [0, 0]);
        check("abc", "abc", 3, [3, 3]);
        check("abc", "abd", 2, [3, 3]);
        check("abc", "dbc", 0, [1, 1]);
        check("aa", "aaa", 2, [2, 3]);
        check("aaa", "aa", 2, [3, 2]);
        check("a b c", "a beta c", 3, [3, 6]);
        check("a\u{e9}b", "a\u{e8}b", 2, [3, 3]);
    }
}
