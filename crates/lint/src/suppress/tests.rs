//! What is silenced and what is not.

use scenec_text::SourceFile;

use crate::check;

const SETTINGS: &str = "width := 6\nheight := 4\nraydepth := 0\nlookat_x := 0\nlookat_y := 0\nlookat_z := 0\n\
    eyepos_x := 0\neyepos_y := 1\neyepos_z := 5\nambient_r := 1\nambient_g := 1\nambient_b := 1\n\
    ambient_int_r := 1\nambient_int_g := 1\nambient_int_b := 1\n!x := sphere\n!x <=\n";

/// The codes that are left of a file, behind each the words of its place.
fn codes(text: &str) -> Vec<String> {
    let source = SourceFile::new("t", text).unwrap();
    let findings = check(&source).diagnostics;
    let show = |finding: &scenec_text::Diagnostic| format!("{} {}", finding.code.id(), finding.span().of(text));
    findings.iter().map(show).collect()
}

#[track_caller]
fn look(before: &str, after: &str, expect: &[&str]) {
    assert_eq!(codes(&format!("{before}{SETTINGS}{after}")), expect);
}

#[test]
fn an_allow_silences_its_line_or_the_next_or_the_file() {
    look("", "a := 1\n", &["W009 a := 1"]);
    look("", "a := 1 / scenec: allow W009\nb := 1\n", &["W009 b := 1"]);
    look("", "/ scenec: allow W009\na := 1\nb := 1\n", &["W009 b := 1"]);
    look("", "/scenec:allow W009 is meant for later\n/ It is.\r\na := 1\n", &[]);
    look("/ scenec: allow W009\n", "a := 1\nb := 1\n", &[]);
    look(
        "\n/ Notes.\n\n/ scenec: allow W009 , W025\n",
        "a := 1\n*l := 0 0 0 0 0 0\n",
        &[],
    );
}

#[test]
fn it_reaches_no_further() {
    look("", "/ scenec: allow W009\n\na := 1\n", &["I001 W009", "W009 a := 1"]);
    look("", "a := 1\n/ scenec: allow W009\n", &["W009 a := 1", "I001 W009"]);
    look("", "a := 1 / scenec: allow W012\n", &["W009 a := 1", "I001 W012"]);
    look("", "a := 1 / allow W009\n", &["W009 a := 1"]);
    look(
        "",
        "/ scenec: allow W009\n/ scenec: allow W009\na := 1\n",
        &["I001 W009"],
    );
    look("", "a := 1 2 / scenec: allow E007\n", &["E007 2", "I001 E007"]);
}

#[test]
fn a_useless_one_is_a_remark_that_can_be_allowed_itself() {
    look("/ scenec: allow W009, W10\n", "", &["I001 W009", "I001 W10"]);
    look("/ scenec: alow W009\n", "", &["I001 alow"]);
    look("/ scenec: allow\n", "", &["I001 allow"]);
    look("/ scenec: allow W009\n/ scenec: allow I001\n", "", &[]);
    look("/ scenec: allow I001\n", "", &["I001 I001"]);
}

#[test]
fn repairs_remove_what_is_useless_and_no_more() {
    let fixed = |after: &str| {
        let text = format!("{SETTINGS}{after}");
        let source = SourceFile::new("t", text.as_str()).unwrap();
        let findings = check(&source).diagnostics;
        let remark = findings.iter().find(|finding| finding.code.id() == "I001").unwrap();
        let edit = &remark.fix.as_ref().unwrap().edits[0];
        let mut text = text;
        text.replace_range(edit.span.range(), &edit.text);
        text[SETTINGS.len()..].to_owned()
    };
    assert_eq!(
        fixed("*l := 0 1 0 1 1 1  / scenec: allow W009\n"),
        "*l := 0 1 0 1 1 1\n"
    );
    assert_eq!(fixed("/ scenec: allow W009\n*l := 0 1 0 1 1 1"), "*l := 0 1 0 1 1 1");
    assert_eq!(
        fixed("a := 1 / scenec: allow W012, W009"),
        "a := 1 / scenec: allow W009"
    );
    assert_eq!(
        fixed("a := 1 / scenec: allow W009, W012 yes"),
        "a := 1 / scenec: allow W009 yes"
    );
}
