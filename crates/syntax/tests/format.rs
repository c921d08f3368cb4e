//! The formatter: what it writes, and what it may never change.

#![allow(clippy::unwrap_used, reason = "a test may stop at once")]

use proptest::prelude::*;
use scenec_syntax::{Content, FormatStyle, Refused, format, parse};
use scenec_text::SourceFile;

fn formatted(text: &str, align: bool) -> Result<String, Refused> {
    let source = SourceFile::new("t", text).unwrap();
    format(&source, &parse(&source).0, FormatStyle { align })
}

fn check(text: &str, expect: &str) {
    assert_eq!(formatted(text, false).unwrap(), expect, "{text:?}");
    hold(text);
}

fn check_aligned(text: &str, expect: &str) {
    assert_eq!(formatted(text, true).unwrap(), expect, "{text:?}");
    hold(text);
}

/// What a file says, its white space left aside: each line's words without the spans, and its comment.
fn meaning(text: &str) -> Vec<(String, String)> {
    let source = SourceFile::new("t", text).unwrap();
    let words = |line: &scenec_syntax::Line| match &line.content {
        Content::Comment => String::new(),
        Content::Statement(statement) => {
            let values = statement.values().iter().map(|value| {
                let word: String = value.span.of(text).split_whitespace().collect();
                format!("{:?} {word}", value.sign)
            });
            let name = statement.name().of(text);
            let values: Vec<_> = values.collect();
            // What is neither the name nor a value: operators, and the names of operands.
            let rest: String = line.span.of(text).split_whitespace().collect();
            format!("{:?} {name} {values:?} {rest}", statement.form())
        }
        Content::Broken(broken) => format!("{broken:?}"),
    };
    let comment = |line: &scenec_syntax::Line| line.comment.unwrap_or_default().of(text).trim_end().to_owned();
    let lines = parse(&source).0;
    lines.iter().map(|line| (words(line), comment(line))).collect()
}

/// What is true of any text: the formatter refuses it, or keeps its meaning, and has nothing to add a second time.
fn hold(text: &str) {
    let broken = {
        let source = SourceFile::new("t", text).unwrap();
        let lines = parse(&source).0;
        lines.iter().any(|line| matches!(line.content, Content::Broken(_)))
    };
    for align in [false, true] {
        let Ok(once) = formatted(text, align) else {
            assert!(broken, "{text:?} is refused");
            continue;
        };
        assert!(!broken, "{text:?} is not refused");
        assert_eq!(meaning(&once), meaning(text), "{text:?}");
        assert_eq!(formatted(&once, align).unwrap(), once, "{text:?}");
        let ends = once.matches("\r\n").count();
        assert!(ends == 0 || ends == once.matches('\n').count(), "{once:?}");
        assert!(
            !once.contains("\n\n\n") && !once.starts_with(['\n', '\u{FEFF}']),
            "{once:?}"
        );
        assert!(
            once.is_empty() || once.ends_with('\n') && !once.ends_with("\n\n"),
            "{once:?}"
        );
        assert!(once.lines().all(|line| line.trim_end() == line), "{once:?}");
    }
}

#[test]
fn every_form_has_one_way_to_be_written() {
    check("x:=1", "x := 1\n");
    check("  x\t:=   - 1.50 ", "x := -1.50\n");
    check("!s:=sphere", "!s := sphere\n");
    check("! z := a-b", "!z := a - b\n");
    check("!z:=a|b\n!z:=a&b", "!z := a | b\n!z := a & b\n");
    check("!x?=m", "!x ?= m\n");
    check("!x*=1 +2 -pi", "!x *= 1 +2 -pi\n");
    check("!x#x=1\n!x#y=1\n!x#z=1", "!x #x= 1\n!x #y= 1\n!x #z= 1\n");
    check("!x+=-1 .5 2.", "!x += -1 .5 2.\n");
    check("!x<=", "!x <=\n");
    check("* l:=1 2 3 4 5 6e0", "*l := 1 2 3 4 5 6e0\n");
    check("?\u{3000}m:=1 2 3 4 5 6 7 8 9 10", "?m := 1 2 3 4 5 6 7 8 9 10\n");
}

#[test]
fn comments_and_single_blank_lines_stay() {
    check("", "");
    check("\n \n\t\n", "");
    check("\u{FEFF}", "");
    check("/", "/\n");
    check("  / one \t\n\n\n\n/two\n\n", "/ one\n\n/two\n");
    check("x := 1/ why\ny := 2 / so  ", "x := 1  / why\ny := 2  / so\n");
    check("\n\nx := 1\n/!x <=\n", "x := 1\n/!x <=\n");
    check("/ a\rb\r\r\n", "/ a\rb\r\n");
}

#[test]
fn line_ends_are_those_of_most_lines() {
    check("x := 1\r\n\r\n\r\ny := 2", "x := 1\r\n\r\ny := 2\r\n");
    check("x := 1\r\ny := 2\n", "x := 1\ny := 2\n");
    check("\u{FEFF}x := 1\r\ny := 2\r\nz := 3\n", "x := 1\r\ny := 2\r\nz := 3\r\n");
}

#[test]
fn like_statements_align_on_demand() {
    check_aligned(
        "width := 600\nup_y := -0.25\n\nw := 1 / alone\n",
        "width := 600\nup_y  :=  -0.25\n\nw := 1  / alone\n",
    );
    check_aligned(
        "!a += 1 10.5 lift / one\n!bc += -2.25 1e3 2 / two\n!bc #x= 1\n!b #y= -1\n",
        "!a  +=  1     10.5 lift  / one\n!bc += -2.25 1e3   2     / two\n!bc #x=  1\n!b  #y= -1\n",
    );
    check_aligned(
        "!été := sphere\n!b := hp / c\n",
        "!été := sphere\n!b   := hp      / c\n",
    );
    let long = "n".repeat(100);
    check_aligned(
        &format!("{long} := 1\na := 1\nbc := 1\n"),
        &format!("{long} := 1\na  := 1\nbc := 1\n"),
    );
}

#[test]
fn what_cannot_be_read_is_refused_with_its_place() {
    let refused = formatted("x := 1\n!ball := := sphere\n", false).unwrap_err();
    assert_eq!((refused.span.start, refused.span.end), (7, 25));
    let (source, _) = SourceFile::from_bytes("t", b"x := 1 / \xE9t\xE9\n".to_vec()).unwrap();
    let refused = format(&source, &parse(&source).0, FormatStyle::default()).unwrap_err();
    assert_eq!((refused.span.start, refused.span.end), (9, 10));
}

const NUMBERS: &[&str] = &["1", "+.5", "- 2.", "6.02e23", "-  pi", "pi", "+x", "lift", "1e-3", "0"];
const NAMES: &[&str] = &["a", "ball", "été", "_", "pi", "sphere"];
const SPACES: &[&str] = &["", " ", "\t ", "\u{3000}", "\u{2028}\u{B}"];
const ENDS: &[&str] = &["\n", "\r\n", "\n\n", "\n \t\n\n", " / why\n", "/\r\n", "\n  / alone \n"];

/// A statement whose words may or may not have space between them.
fn statement() -> impl Strategy<Value = String> {
    let name = || prop::sample::select(NAMES);
    let values = |count| prop::collection::vec(prop::sample::select(NUMBERS), count);
    let space = || prop::sample::select(SPACES);
    let transform = prop::sample::select(&["*=", "+="][..]);
    let rotation = prop::sample::select(&["#x=", "#y=", "#z="][..]);
    let words = prop_oneof![
        values(1).prop_map(|v| vec!["a_1".to_owned(), ":=".to_owned(), v.join(" ")]),
        (name(), name()).prop_map(|(a, b)| vec![format!("!{a}"), ":=".to_owned(), b.to_owned()]),
        (name(), name(), prop::sample::select(&["|", "&", "-"][..]), name()).prop_map(|(z, a, op, b)| [
            "!", z, ":=", a, op, b
        ]
        .map(str::to_owned)
        .to_vec()),
        (name(), name()).prop_map(|(a, m)| ["!", a, "?=", m].map(str::to_owned).to_vec()),
        (name(), transform, values(3)).prop_map(|(a, op, v)| vec![
            "!".to_owned(),
            a.to_owned(),
            op.to_owned(),
            v.join(" ")
        ]),
        (name(), rotation, values(1)).prop_map(|(a, op, v)| vec![
            "!".to_owned(),
            a.to_owned(),
            op.to_owned(),
            v.join("")
        ]),
        name().prop_map(|a| ["!", a, "<="].map(str::to_owned).to_vec()),
        (name(), values(6)).prop_map(|(a, v)| vec!["*".to_owned(), a.to_owned(), ":=".to_owned(), v.join(" ")]),
        (name(), values(10)).prop_map(|(a, v)| vec!["?".to_owned(), a.to_owned(), ":=".to_owned(), v.join("  ")]),
    ];
    (words, space(), space()).prop_map(|(words, between, first)| format!("{first}{}", words.join(between)))
}

proptest! {
    #[test]
    fn statements_keep_their_meaning(
        lines in prop::collection::vec((statement(), prop::sample::select(ENDS)), 0..12),
    ) {
        let text: String = lines.iter().flat_map(|(line, end)| [line.as_str(), end]).collect();
        prop_assert!(formatted(&text, false).is_ok(), "{:?}", text);
        hold(&text);
    }

    #[test]
    fn any_text_is_kept_or_refused(text in ".{0,80}", more in "[!?*:=+#xyz<|&/ 1.\r\n-]{0,120}") {
        hold(&text);
        hold(&more);
        hold(&format!("/{text}\n{more}"));
    }
}
