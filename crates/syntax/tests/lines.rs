//! What a line becomes: the statement, or the report and what could be made out of the line.

#![allow(clippy::unwrap_used, reason = "a test may stop at once")]

use scenec_syntax::{Content, Form, Line, Space, Statement, parse};
use scenec_text::{Code, SourceFile};

fn read(text: &str) -> (Vec<Line>, Vec<scenec_text::Diagnostic>) {
    parse(&SourceFile::new("t", text).unwrap())
}

/// One line of text: its form, or the codes of its reports.
fn check(text: &str, expect: Result<Form, &[Code]>) {
    let (lines, findings) = read(text);
    let codes: Vec<_> = findings.iter().map(|finding| finding.code).collect();
    let [line] = lines.as_slice() else {
        panic!("{text:?} is not one line");
    };
    match (&line.content, expect) {
        (Content::Statement(statement), Ok(form)) => {
            assert_eq!(statement.form(), form, "{text:?}");
            assert!(codes.is_empty(), "{text:?}: {codes:?}");
        }
        (Content::Broken(_), Err(expect)) => assert_eq!(codes, expect, "{text:?}"),
        (content, _) => panic!("{text:?} became {content:?}"),
    }
}

#[test]
fn every_form_is_read() {
    check("x := -pi", Ok(Form::Variable));
    check("!x := sphere", Ok(Form::Object));
    check("! x := y-z / cut", Ok(Form::Combination));
    check("!x?=m", Ok(Form::MaterialSet));
    check("!x *= 1 -2 + y", Ok(Form::Scale));
    check("!x #z= pi", Ok(Form::Rotate));
    check("!x +=-1 .5 2.", Ok(Form::Translate));
    check("!x<=", Ok(Form::Submit));
    check("*l := 1 2 3 4 5 6", Ok(Form::Light));
    check("?m := 1 2 3 4 5 6 7 8 9 10", Ok(Form::Material));
    check("!pi := sphere", Ok(Form::Object));
}

#[test]
fn what_fits_no_statement_has_one_report() {
    use Code::{AssignedConstant, MalformedNumber, TooFewValues, TooManyValues, UnexpectedCharacter, UnexpectedToken};
    for text in [
        "5",
        "x",
        "x 5",
        "!",
        "!x",
        "!x sphere",
        "!x :=",
        "!x := 5",
        "!x := a b",
        "!x := a |",
        "!x ?= 5",
        "? := 1",
        "* 3",
        ":= 5",
        "x := -",
        "!x *= 1 - 2 |",
        "| a",
        "x := sphere |",
        "!x := -a",
        "!x := a | 3",
    ] {
        check(text, Err(&[UnexpectedToken]));
    }
    check("x :=", Err(&[TooFewValues]));
    check("!x *= 1 2", Err(&[TooFewValues]));
    check("x := 1 + 2", Err(&[TooManyValues]));
    check("!x <= y", Err(&[TooManyValues]));
    check("!x := a | b | c", Err(&[TooManyValues]));
    check("!x ?= m n", Err(&[TooManyValues]));
    check("pi := 3", Err(&[AssignedConstant]));
    check("!x = sphere", Err(&[UnexpectedCharacter]));
    check("!x #x 3", Err(&[UnexpectedCharacter]));
    check("!x += 1.2.3 2e 3", Err(&[MalformedNumber, MalformedNumber]));
    check("= = = = =", Err(&[UnexpectedCharacter; 3]));
}

#[test]
fn a_broken_line_tells_what_it_tried() {
    let (lines, _) = read("!ball := ; sphere\n?red = 1\nwidth := 1e\n!u <= now\n!!!");
    let tried: Vec<_> = lines
        .iter()
        .map(|line| match &line.content {
            Content::Broken(broken) => (broken.space, broken.form, broken.name.is_some(), broken.mentions.len()),
            other => panic!("{other:?}"),
        })
        .collect();
    assert_eq!(
        tried,
        [
            (Some(Space::Object), Some(Form::Object), true, 1),
            (Some(Space::Material), None, true, 0),
            (Some(Space::Variable), Some(Form::Variable), true, 0),
            (Some(Space::Object), Some(Form::Submit), true, 1),
            (Some(Space::Object), None, false, 0),
        ]
    );
}

#[test]
fn bytes_that_are_no_text_break_a_line_without_a_second_report() {
    let (source, findings) = SourceFile::from_bytes("t", b"!x := \xFFsphere / \xFF\nx := 1 / \xFF".to_vec()).unwrap();
    assert_eq!(findings.len(), 3);
    let (lines, findings) = parse(&source);
    assert_eq!(findings, []);
    assert!(matches!(lines[0].content, Content::Broken(_)));
    assert!(matches!(lines[1].content, Content::Statement(_)));
}

#[test]
fn comments_keep_their_place_and_lose_their_carriage_return() {
    let text = "/ one\r\n\r\n  x := 1 / two\r\n";
    let (lines, _) = read(text);
    let words: Vec<_> = lines
        .iter()
        .map(|line| (line.span.of(text), line.comment.map(|comment| comment.of(text))))
        .collect();
    assert_eq!(words, [("", Some("/ one")), ("x := 1", Some("/ two"))]);
}

#[test]
fn a_million_blank_and_comment_lines_need_no_stack() {
    let read_on_a_small_stack = || {
        let text = "\n".repeat(1_000_000) + &" \t \n/ c\n".repeat(500_000) + "x := 1";
        read(&text).0.len()
    };
    let lines = std::thread::Builder::new()
        .stack_size(256 * 1024)
        .spawn(read_on_a_small_stack)
        .unwrap()
        .join()
        .unwrap();
    assert_eq!(lines, 500_001);
}

/// The three values of a transform lie in the statement: whoever keeps lines copies them at every edit, and a block of memory for each
/// would take longer than the larger lines do. The six and ten of lights and materials, of which there are few, do not.
#[test]
fn lines_are_small() {
    assert!(size_of::<Statement>() <= 112, "{}", size_of::<Statement>());
    assert!(size_of::<Line>() <= 136, "{}", size_of::<Line>());
}
