//! Reading a file that was edited: only the lines that the edit touched.

use scenec_text::{CommonEnds, Diagnostic, SourceFile, Span};

use super::Lines;
use crate::Line;
use crate::token::Scanner;

/// The lines of a file, and what was found on those that had to be read: the others are taken from `lines`, which are all lines of
/// the text `before`, and on which nothing was found. They are those of [`crate::parse`].
#[must_use]
pub fn parse_again(before: &SourceFile, lines: &[Line], source: &SourceFile) -> (Vec<Line>, Vec<Diagnostic>) {
    let ends = CommonEnds::of(before.text(), source.text());
    let [last_before, last] = [before.line_of(ends.tails[0]), source.line_of(ends.tails[1])];
    // Lines in front of the one that the common beginning ends on, and behind the one that the common end begins on.
    let [first_before, first] = [before, source].map(|file| file.line_span(file.line_of(ends.head)));
    let start = |line: Option<Span>| line.map_or(u32::MAX, |line| line.start);
    let at = |offset: u32| lines.partition_point(|line| line.span.start < offset);
    let kept = lines.get(..at(start(first_before))).unwrap_or_default();
    let behind = lines
        .get(at(start(before.line_span(last_before + 1)))..)
        .unwrap_or_default();
    let touched = Span::new(start(first), source.line_span(last).map_or(u32::MAX, |line| line.end));
    let mut read = Lines::of(source, Scanner::within(source.text(), touched));
    let mut all = Vec::with_capacity(lines.len() + (last - last_before.min(last)) as usize + 1);
    all.extend_from_slice(kept);
    all.extend(read.by_ref());
    let by = ends.tails[1].wrapping_sub(ends.tails[0]);
    all.extend(behind.iter().map(|line| line.moved(by)));
    (all, read.findings())
}

#[cfg(test)]
mod tests {
    use proptest::prelude::{Just, Strategy, any};
    use proptest::sample::{Index, select};
    use proptest::{collection, prop_assert, prop_assert_eq, proptest};
    use scenec_text::SourceFile;

    use super::parse_again;
    use crate::parse;

    const PIECES: &[&str] = &[
        "\n",
        "\r\n",
        "/ comment",
        " / \u{e9} ",
        "width := 600",
        "!a := sphere",
        "!a := b | c",
        "!b ?= m",
        "!b *= 1 -x pi",
        "!\u{e9} #x= -y",
        "!b += 1 2 3",
        "!a <=",
        "*l := 1 2 3 4 5 x",
        "?m := 1 2 3 4 5 6 7 8 9 x",
        "\t",
        "\u{2028}",
    ];

    fn source(text: &str) -> SourceFile {
        SourceFile::new("t", text.to_owned()).unwrap()
    }

    /// Whole lines for the most part, so that mostly nothing is wrong with them.
    fn texts() -> impl Strategy<Value = String> {
        let line =
            (select(PIECES), select(&["\n", "\r\n", "\n\n"][..])).prop_map(|(words, end)| format!("{words}{end}"));
        let mark = proptest::prop_oneof![4 => Just(""), 1 => Just("\u{FEFF}")];
        (mark, collection::vec(line, 0..8), select(PIECES))
            .prop_map(|(mark, lines, last)| format!("{mark}{}{last}", lines.concat()))
    }

    fn edits() -> impl Strategy<Value = String> {
        let piece = proptest::prop_oneof![
            select(PIECES),
            select(&["", "$", "1", "a", "\r", "/", "!", "0x", "\u{FEFF}"][..])
        ];
        collection::vec(piece, 0..4).prop_map(|pieces| pieces.concat())
    }

    /// Reading again what became of `before` is reading it. Tells whether there was anything to take over.
    fn check(before: &str, after: &str) -> bool {
        let (before, after) = (source(before), source(after));
        let (lines, findings) = parse(&before);
        let clean = findings.is_empty();
        if clean {
            assert_eq!(
                parse_again(&before, &lines, &after),
                parse(&after),
                "{before:?} {after:?}"
            );
        }
        clean
    }

    #[test]
    fn lines_around_an_edit_are_kept() {
        let text = "a := 1\n\n!s := sphere / c\r\n!s <=\n";
        for (at, _) in text.char_indices() {
            for new in ["", "\n", "x", "\r", "/", "$"] {
                let after = format!("{}{new}{}", &text[..at], &text[at..]);
                assert!(check(text, &after) && check(text, &text[at..]) && check(text, &text[..at]));
                check(&after, text);
            }
        }
        assert!(check("", "") && check("", text) && check(text, "") && check(text, text));
    }

    proptest! {
        #[test]
        fn reading_again_is_reading(before in texts(), new in edits(), from in any::<Index>(), to in any::<Index>()) {
            let places: Vec<usize> = before.char_indices().map(|(at, _)| at).chain([before.len()]).collect();
            let (from, to) = (*from.get(&places), *to.get(&places));
            let after = format!("{}{new}{}", &before[..from.min(to)], &before[from.max(to)..]);
            let clean = check(&before, &after);
            prop_assert_eq!(clean, parse(&source(&before)).1.is_empty());
            prop_assert!(check(&after, &before) || !parse(&source(&after)).1.is_empty());
        }
    }
}
