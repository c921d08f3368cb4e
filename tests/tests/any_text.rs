//! Whatever the bytes: both stages answer, every span lies inside the file, and a scene comes out unless there is an
//! error.

#![allow(clippy::unwrap_used, reason = "a test may stop at once")]

use proptest::prelude::*;
use scenec_interpret::analyse;
use scenec_syntax::{Content, line, parse};
use scenec_text::{Severity, SourceFile, Span};

/// Words that together reach every statement and most ways to spoil one.
const WORDS: &[&str] = &[
    "!",
    "?",
    "*",
    ":=",
    "?=",
    "*=",
    "+=",
    "<=",
    "#x=",
    "#y=",
    "#z=",
    "|",
    "&",
    "-",
    "+",
    "/",
    "\n",
    "\n",
    "\n",
    "\r\n",
    "\r",
    " ",
    "\t",
    "a",
    "b",
    "a",
    "b",
    "m",
    "é",
    "pi",
    "sphere",
    "hp",
    "width",
    "raydepth",
    "max_reflections",
    "up_y",
    "0",
    "1",
    "2.5",
    "1e999",
    "1e-999",
    "1.2.3",
    "2e",
    "3abc",
    "=",
    "#",
    ";",
    "\0",
    "\u{FEFF}",
    "\u{202E}",
    "𝄞",
    "!a := sphere\n",
    "!b := a | a\n",
    "!a += 1 0 0\n",
    "!a <=\n",
    "?m := 1 1 1 1 1 1 1 1 1 1\n",
    "!a ?= m\n",
];

fn inside(source: &SourceFile, span: Span) -> bool {
    let text = source.text();
    let boundary = |offset: u32| text.is_char_boundary(offset as usize);
    span.start <= span.end && boundary(span.start) && boundary(span.end)
}

/// Reads a file both ways and holds the promises of both stages against it.
fn check(bytes: Vec<u8>) {
    let (source, reading) = SourceFile::from_bytes("t", bytes).unwrap();
    let (lines, parsing) = parse(&source);
    let mut end = 0;
    for line in &lines {
        assert!(inside(&source, line.span) && line.span.start >= end, "{line:?}");
        end = line.span.end.max(line.comment.map_or(0, |comment| comment.end));
        assert!(line.comment.is_none_or(|comment| inside(&source, comment)), "{line:?}");
        if let Content::Statement(statement) = &line.content {
            assert!(
                inside(&source, statement.name()) && !statement.name().is_empty(),
                "{line:?}"
            );
            for value in statement.values() {
                assert!(
                    value.span.start >= line.span.start && value.span.end <= line.span.end,
                    "{line:?}"
                );
            }
        }
    }
    let again = (0..source.line_count()).filter_map(|number| line(&source, number));
    assert!(again.eq(lines.iter().cloned()), "{lines:?}");
    let broken = lines.iter().any(|line| matches!(line.content, Content::Broken(_)));
    let (interpretation, findings) = analyse(&source);
    let failed = |list: &[scenec_text::Diagnostic]| list.iter().any(|finding| finding.severity() == Severity::Error);
    assert_eq!(broken, failed(&parsing) || (broken && !reading.is_empty()));
    assert_eq!(interpretation.scene.is_none(), failed(&reading) || failed(&findings));
    for finding in reading.iter().chain(&findings) {
        assert!(!finding.labels.is_empty() && !finding.message.is_empty(), "{finding:?}");
        assert!(
            finding.labels.iter().all(|label| inside(&source, label.span)),
            "{finding:?}"
        );
    }
    assert!(findings.is_sorted_by_key(|finding| finding.span().start));
    let places = interpretation.symbols.occurrences();
    assert!(places.clone().is_sorted_by_key(|place| place.span.start));
    for place in places {
        let symbol = interpretation.symbols.symbols()[place.symbol.0 as usize];
        assert_eq!(symbol.name.of(source.text()), place.span.of(source.text()));
    }
}

proptest! {
    #[test]
    fn any_bytes(bytes in prop::collection::vec(any::<u8>(), 0..400)) {
        check(bytes);
    }

    #[test]
    fn any_text(text in ".{0,200}") {
        check(text.into_bytes());
    }

    #[test]
    fn any_words(
        words in prop::collection::vec((prop::sample::select(WORDS), any::<bool>()), 0..120),
    ) {
        let text: String = words.iter().flat_map(|(word, space)| [*word, if *space { " " } else { "" }]).collect();
        check(text.into_bytes());
    }
}
