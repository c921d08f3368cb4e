//! Hovers over a text with a mark, compared by the phrases that they must hold.

use super::hover;
use crate::marked::marked;

/// What a hover is about, and phrases that stand in it in this order.
fn check(text: &str, about: &str, phrases: &[&str]) {
    let (document, offset) = marked(text);
    let hover = hover(&document, offset).unwrap_or_else(|| panic!("nothing at {text:?}"));
    assert_eq!(hover.span.of(document.text()), about, "{text:?}");
    let mut rest = hover.markdown.as_str();
    for phrase in phrases {
        let Some((_, after)) = rest.split_once(phrase) else {
            panic!("no {phrase:?} in the rest of {:?}", hover.markdown);
        };
        rest = after;
    }
}

fn silent(text: &str) {
    let (document, offset) = marked(text);
    assert_eq!(hover(&document, offset), None, "{text:?}");
}

/// Whether there is a ball of the material, and the rest as in `check`.
fn balls(text: &str, ball: bool) {
    let (document, offset) = marked(text);
    assert_eq!(hover(&document, offset).unwrap().ball.is_some(), ball, "{text:?}");
}

const GLASS: &str = "?glass := 0 0.1 0.4 0.1 0.8 1.5 200 1 0.5 0\n";

#[test]
fn a_material_is_named_value_by_value() {
    let all = [
        "`?glass`",
        "| `ambref`   |      0 | share of the ambient light |",
        "`diffref`",
        "`specref`",
        "`rflec`",
        "`rfrac`",
        "| `rfracind` |    1.5 | index of refraction, 1 = air |",
        "`shiny`",
        "| `r` ",
        "| `g` ",
        "| `b` ",
        "glass, a small, sharp highlight",
        "`#ff8000`, rgb(255, 128, 0)",
        "Ambient + diffuse = 0.1, reflection + refraction = 0.9",
        "line 1",
    ];
    check(&format!("{GLASS}!a := sphere\n!a ?= gl$0ass"), "glass", &all);
    check(&GLASS.replace("?glass", "?gla$0ss"), "glass", &all);
    check(&GLASS.replace("?glass", "$0?glass"), "?", &all);
    check(&format!("{GLASS}!a ?= glass$0 glass"), "glass", &all);
    check(
        &GLASS.replace("1.5", "1$0.5"),
        "1.5",
        &["**`rfracind`** = 1.5: index of refraction, 1 = air", "`shiny`"],
    );
    check(
        "?m := 1 0.1 0 0.5 0.6 1 0 2 0 0\n!a ?= $0m",
        "m",
        &[
            "brought between 0 and 1",
            "= 1.1 (more light than falls on it)",
            "= 1.1 (more light than falls on it)",
        ],
    );
    check("!a ?= $0m", "m", &["Nothing defines"]);
    check("?$0m := 1 1 1 1 1 1 1 1 1 q", "m", &["defines nothing"]);
    balls(&GLASS.replace("1.5", "1$0.5"), true);
    balls(&format!("{GLASS}!a ?= gl$0ass"), true);
    balls("?m := 1 $02", false);
}

#[test]
fn an_object_is_followed_through_its_life() {
    let text = "!a := sphere\n!a *= 2 1 1\n!a += 3 0 0\n!b := hp\n!u := a - b\n!a += 1 1 1\n!u <=\n!a #x= pi\n";
    let at = |words: &str| text.replacen(words, &words.replace("a ", "a$0 "), 1);
    check(
        &at("!a := sphere"),
        "a",
        &[
            "`!a`: `sphere`, made on line 1",
            "- scaled by (2, 1, 1) (line 2)",
            "- moved by (3, 0, 0) (line 3)",
            "- moved by (1, 1, 1) (line 6)",
            "Centre (4, 1, 1); x from 2 to 6, y from 0 to 2, z from 0 to 2.",
            "Default material. Looks: matt",
            "In the picture: taken by `!u := a - b` on line 5, submitted on line 7.",
            "- line 6: ",
            "(W007)",
            "- line 8: ",
            "(W005)",
        ],
    );
    check(&at("!a *= 2"), "a", &["Centre (0, 0, 0); x from -2 to 2"]);
    check(&at("a - b"), "a", &["(line 3)\n\nCentre (3, 0, 0)"]);
    check(
        &text.replace("- b", "- $0b"),
        "b",
        &["Plane through (0, 0, 0), facing (0, 1, 0)."],
    );
    check(
        &text.replace("!u <=", "!$0u <="),
        "u",
        &[
            "`!u := a - b` on line 5, of 2 base objects",
            "Within x from 1 to 5, y from",
            "submitted on line 7",
        ],
    );
}

#[test]
fn an_object_outside_the_picture_says_why() {
    check("!$0a := sphere", "a", &["nothing is submitted"]);
    check(
        "!$0a := sphere\n!b := hp\n!b <=",
        "a",
        &["nothing that is submitted takes it"],
    );
    check(
        "!$0a := sphere\n!u := a | a\n!b := hp\n!b <=",
        "a",
        &["`!u := a | a` on line 2 takes it, and is not submitted"],
    );
    check("!a := q | q\n!$0a <=", "a", &["Nothing makes an object"]);
    check("!$0a := q | q", "a", &["makes no object"]);
    check("!x := $0a | ", "a", &["Nothing makes an object"]);
    check("!a := sphere\n!x := $0a | ", "a", &["`sphere`, made on line 1"]);
}

#[test]
fn the_material_that_shows_is_told() {
    let paint = format!("{GLASS}?red := 0 1 0 0 0 1 1 1 0 0\n");
    check(
        &format!("{paint}!a := sphere\n!a ?= red\n!u := a | a\n!u ?= glass\n!$0a += 1 0 0\n!u <="),
        "a",
        &[
            "Material `?red` (line 4). Looks: matt",
            "In the picture `!u ?= glass` on line 6 replaces it.",
        ],
    );
    let both = format!("{paint}!$0a := sphere\n!u := a | a\n!v := u | u\n!u ?= red\n!v := v | u\n!v <=");
    let (document, offset) = marked(&both);
    assert!(!hover(&document, offset).unwrap().markdown.contains("replaces"));
}

#[test]
fn combinations_of_combinations_are_counted_not_walked() {
    let mut text = String::from("!a := sphere\n");
    text.push_str(&"!a := a | a\n".repeat(63));
    check(&format!("{text}!$0a <="), "a", &["9223372036854775808 base objects"]);
    text.push_str(&"!a := a | a\n".repeat(9));
    check(
        &format!("{text}!$0a <="),
        "a",
        &["more base objects than can be counted"],
    );
}

#[test]
fn values_say_what_they_are_for() {
    check("*l := 1 2 3 $00.5 1 1", "0.5", &["**`r`** = 0.5: red of its light"]);
    check("!a *= 1 2$0 3", "2", &["factor along y"]);
    check(
        "!a #x= - 1.0$0",
        "- 1.0",
        &["= -1: angle in radians", "-1 radians = -57.3°"],
    );
    check(
        "q := pi\n!a #x= $0-q",
        "-q",
        &[
            "= -3.142",
            "= -pi = -180°",
            "**variable** `q` = 3.142",
            "`q := pi` on line 1",
        ],
    );
    check("!a += 1 2 $03 4 5", "3", &["along z"]);
    check("?m := 1 2$0", "2", &["**`diffref`** = 2: share of the diffuse light"]);
    check("x := 1$0", "1", &["**variable** `x` = 1"]);
    check("!a += pi$0 0 0", "pi", &["= 3.142: along x"]);
    check("!a += 1 - $0- 2", "- 2", &["= -2: along z"]);
    silent("!a += 1 2 3 4$0");
}

#[test]
fn settings_lights_operators_and_bases_are_explained() {
    check(
        "wid$0th := 640",
        "width",
        &[
            "= 640: pixel columns",
            "whole number from 1 to 65535; every file must give it",
        ],
    );
    check("fov := 1$0", "1", &["default pi/2", "= 57.3°"]);
    check(
        "ambient_r := 0.2$0\nambient_g := 1\nambient_b := 0",
        "0.2",
        &["= 0.2: red of the ambient light", "(0.2, 1, 0) (`#33ff00`)"],
    );
    check(
        "max_reflections$0 := 3",
        "max_reflections",
        &["`max_reflections` = 3", "also written `raydepth`"],
    );
    check(
        "*l$0 := 1 2 3 1 0.5 0\n*l := 1 1 1 1 1 1",
        "l",
        &["(1, 2, 3)", "`#ff8000`", "line 2 takes its place"],
    );
    check("!a $0:= sphere", ":=", &["`!x := sphere`", "makes a base object"]);
    check("!a $0#z= 1", "#z=", &["`!x #z= v`", "rotates"]);
    check("!a := b $0- c", "-", &["**subtraction**", "`!z := x - y`"]);
    check("!a := b $0& c", "&", &["**intersection**", "`!z := x & y`"]);
    check("!a := b $0| c", "|", &["**union**", "`!z := x | y`"]);
    check("!a := sph$0ere", "sphere", &["at most 1 from the origin"]);
    for blank in ["$0", "x := 1 $0 / c", "/ wid$0th", "!a := sphere / b$0", "?? $0", "#"] {
        silent(blank);
    }
}

#[test]
fn nothing_in_a_file_can_end_its_code_or_grow_without_bounds() {
    let long = "é".repeat(10_000);
    let text = format!("!{long} := sphere\n!{long} ?= {long}\n!$0{long} <=");
    let (document, offset) = marked(&text);
    let said = hover(&document, offset).unwrap().markdown;
    assert!(said.len() < 2000, "{said}");
    let many = format!("!a := sphere\n{}!a$0 <=", "!a += 1 0 0\n!a ?= q\n".repeat(5000));
    let (document, offset) = marked(&many);
    let said = hover(&document, offset).unwrap().markdown;
    assert!(
        said.len() < 3000 && said.contains("- 4992 transforms before these"),
        "{said}"
    );
}
