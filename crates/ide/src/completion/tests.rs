//! What is offered at a mark in a text.

use scenec_syntax::FORMS;
use scenec_text::{Diagnostic, Severity, Span};

use super::{CompletionKind, MOST_NAMES, completions};
use crate::marked::marked;

/// Compares what is offered: for each item the words it replaces, an arrow, and what it writes.
fn check(text: &str, expect: &[&str]) {
    let (document, offset) = marked(text);
    let list = completions(&document, offset);
    let found: Vec<_> = list
        .iter()
        .map(|item| format!("{}→{}", item.replace.of(document.text()), item.insert))
        .collect();
    assert_eq!(found, expect, "{text:?}");
    for (order, item) in (0..).zip(&list) {
        assert_eq!(item.order, order);
        assert!(item.replace.start <= offset && offset <= item.replace.end, "{item:?}");
    }
}

/// Whether something among much else is offered.
fn offers(text: &str, insert: &str) -> bool {
    let (document, offset) = marked(text);
    completions(&document, offset).iter().any(|item| item.insert == insert)
}

const SCENE: &str = "ball := 2\n!ball := sphere\n!wall := hp\n?clay := 0 0 0 0 0 1 0 0 0 0\n*lamp := 0 0 0 1 1 1\n";

fn after(line: &str, expect: &[&str]) {
    check(&format!("{SCENE}{line}\n!late := sphere\nlate := 1"), expect);
}

#[test]
fn names_are_those_of_the_place_bound_before() {
    after("!u := $0", &["→sphere", "→hp", "→wall", "→ball"]);
    after("!u := ba$0", &["ba→sphere", "ba→hp", "ba→wall", "ba→ball"]);
    after(
        "!u := b$0all | wall",
        &["ball→sphere", "ball→hp", "ball→wall", "ball→ball"],
    );
    after("!u := ball $0", &["→|", "→&", "→-"]);
    after("!u := sphere $0", &[]);
    after("!u := ball | $0", &["→wall", "→ball"]);
    after("!u := ball -$0", &["→wall", "→ball"]);
    after("!u := ball | wall $0", &[]);
    after("!ball ?= $0", &["→clay"]);
    after("!ball ?=$0", &["→clay"]);
    after("!ball += $0", &["→ball", "→pi"]);
    after("!ball += 1 -$0", &["→ball", "→pi"]);
    after("!ball += 1 2 -$0", &["→ball", "→pi"]);
    after("!ball += 1 2 3 $0", &[]);
    after("!ball #x= p$0", &["p→ball", "p→pi"]);
    after("x := $0", &["→ball", "→pi"]);
    after("raydepth := $0", &["→4", "→ball", "→pi"]);
    after("fov := $0", &["→1.5707963267948966", "→ball", "→pi"]);
    after("!ball += 1$0", &[]);
    after("!ball <= $0", &[]);
    after("/ $0", &[]);
    after("x := 1 / !$0", &[]);
}

#[test]
fn operators_bring_the_rest_of_their_statement() {
    let all = |typed: &str| {
        [
            ":= ${1|sphere,hp|}",
            ":= ${1:x} ${2|\\|,&,-|} ${3:y}",
            "?= ${1:m}",
            "*= ${1:1} ${2:1} ${3:1}",
            "#x= ${1:pi}",
            "#y= ${1:pi}",
            "#z= ${1:pi}",
            "+= ${1:0} ${2:0} ${3:0}",
            "<=",
        ]
        .map(|rest| format!("{typed}→{rest}"))
    };
    for (line, typed) in [
        ("!ball $0", ""),
        ("!ball :$0", ":"),
        ("!ball ?$0", "?"),
        ("!ball *$0", "*"),
        ("!ball +$0", "+"),
        ("!ball <$0", "<"),
        ("!ball #x$0", "#x"),
    ] {
        after(line, &all(typed).each_ref().map(String::as_str));
    }
    after("*lamp $0", &["→:= ${1:0} ${2:5} ${3:5} ${4:1} ${5:1} ${6:1}"]);
    after("x $0", &["→:= ${1:0}"]);
    after(
        "!ball $0 1 2 3",
        &["→:=", "→?=", "→*=", "→#x=", "→#y=", "→#z=", "→+=", "→<="],
    );
    after("x + $0", &[]);
}

#[test]
fn a_line_begins_with_a_setting_a_statement_or_a_name() {
    assert!(offers("wi$0", "width := ${1:600}"));
    assert!(offers("width := 1\n$0", "height := ${1:400}"));
    assert!(!offers("width := 1\n$0", "width := ${1:600}"));
    assert!(!offers("max_reflections := 1\n$0", "raydepth := ${1:4}"));
    assert!(offers("$0", "!${1:x} #${2|x,y,z|}= ${3:pi}"));
    assert!(offers("x := 1\n$0", "x"));
    assert!(offers("$0 := 600", "width"));
    let (document, offset) = marked("height := 1\n$0\nwidth := 1");
    let all = completions(&document, offset).remove(0);
    assert_eq!(all.insert.lines().count(), 13, "{}", all.insert);
    assert!(
        all.insert.starts_with("lookat_x := ${1:0}\nlookat_y := ${2:0}"),
        "{}",
        all.insert
    );
    after(
        "*$0",
        &["→lamp", "*→*${1:x} := ${2:0} ${3:5} ${4:5} ${5:1} ${6:1} ${7:1}"],
    );
    after("*la$0mp := 1", &["lamp→lamp"]);
}

#[test]
fn statements_are_found_by_what_they_are_called_and_by_what_they_are() {
    let filters = |text: &str| {
        let (document, offset) = marked(text);
        let list = completions(&document, offset).into_iter();
        let statements = list.filter(|item| item.kind == CompletionKind::Statement);
        statements.map(|item| item.filter).collect::<Vec<_>>()
    };
    let all = filters("$0");
    assert_eq!(all.len(), FORMS.len());
    assert!(all.contains(&"material set !x ?= m".to_owned()), "{all:?}");
    assert_eq!(filters("*$0"), ["*x := a b c r g b"]);
}

/// What is proposed for a setting does not depend on who proposes it.
#[test]
fn settings_are_proposed_as_the_repair_would_write_them() {
    for text in [
        "!a := sphere\n!a <=\n$0",
        "?m := 0 0 0 1 0 1 0 0 0 0\nwidth := 5\n!a := sphere\n!a ?= m\n!a <=\n$0",
    ] {
        let (document, offset) = marked(text);
        let all = completions(&document, offset).remove(0);
        let mut plain = all.insert;
        for number in 1..=15 {
            plain = plain.replace(&format!("${{{number}:"), "");
        }
        // The finding stands at the last statement.
        let actions = crate::actions(&document, Span::at(offset - 1));
        let repair = actions
            .iter()
            .find(|action| action.title.ends_with("missing settings"))
            .unwrap();
        assert_eq!(plain.replace('}', ""), repair.edits[0].text.trim(), "{text}");
    }
}

#[test]
fn what_the_settings_begin_with_is_a_scene() {
    let (document, offset) = marked("!a := sphere\n!a <=\n$0");
    let all = completions(&document, offset).remove(0).insert;
    let lines = all.lines().map(|line| {
        let (name, value) = line.split_once("${").unwrap();
        format!("{name}{}\n", value.split_once(':').unwrap().1.trim_end_matches('}'))
    });
    let (document, _) = marked(&format!("!a := sphere\n!a <=\n{}", lines.collect::<String>()));
    assert!(document.scene().is_some());
    let grave = |finding: &&Diagnostic| finding.severity() != Severity::Hint;
    assert_eq!(document.diagnostics().iter().find(grave), None);
}

#[test]
fn of_very_many_names_those_that_fit_are_offered() {
    let many: String = (0..2000).map(|number| format!("!s{number} := sphere\n")).collect();
    let count = |text: &str| {
        let (document, offset) = marked(&format!("{many}{text}"));
        let list = completions(&document, offset);
        (list.len(), list.first().map(|item| item.label.clone()))
    };
    assert_eq!(count("!u := s0 | $0"), (MOST_NAMES, Some("s1999".to_owned())));
    assert_eq!(count("!u := s0 | S123$0"), (11, Some("s1239".to_owned())));
}
