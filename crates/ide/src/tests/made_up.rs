//! Texts made up at random: of pieces of the language, and of whole statements about a few names.

use proptest::prelude::*;
use scenec_scene::SETTINGS;

/// Pieces of the language and of nothing, in any order.
pub(super) fn any_text() -> impl Strategy<Value = String> {
    let piece = prop_oneof![
        4 => prop::sample::select(vec![
            "!", "?", "*", ":=", "?=", "*=", "+=", "<=", "#x=", "|", "&", "-", "sphere", "hp", "pi", "width", "a", "b",
            "1", "2.5", "1e999", "/ c", "/ scenec: allow W012", "/ scenec: allow", "\u{FEFF}", "é", "𝄞", "=",
        ])
        .prop_map(str::to_owned),
        3 => Just(" ".to_owned()),
        2 => prop::sample::select(vec!["\n", "\r\n", "\r"]).prop_map(str::to_owned),
        1 => any::<char>().prop_map(String::from),
    ];
    prop::collection::vec(piece, 0..40).prop_map(|pieces| pieces.concat())
}

/// Statements about a few names, many of which are missing or come too late, with the settings before or behind them.
pub(super) fn statements() -> impl Strategy<Value = String> {
    let line = (name(), name(), name(), value(), 0..17_usize).prop_map(|(x, y, z, v, form)| match form {
        0..=2 => format!("!{x} := sphere"),
        3 => format!("!{x} := hp"),
        4 | 5 => format!("!{x} := {y} | {z}"),
        6 => format!("!{x} := {y} - {z}"),
        7 => format!("!{x} ?= {y}"),
        8 => format!("!{x} *= 2 {v} 1"),
        9 => format!("!{x}  += {v} 0 1 / moved"),
        10 => format!("!{x} #y= {v}"),
        11 => format!("!{x} <="),
        12 => format!("?{x} := 0 .5 {v} 0 0 1 4 1 1 1"),
        13 => format!("*{x} := 1 2 3 {v} 1 1"),
        14 => format!("{x} := {v}"),
        15 => format!("eyepos_x := {v}  / scenec: allow W004"),
        _ => format!("!{x} := {y} {z}"),
    });
    let end = prop::sample::select(vec!["\n", "\r\n"]);
    (prop::collection::vec(line, 0..14), 0..3_usize, end).prop_map(|(mut lines, settings, end)| {
        let required = SETTINGS.iter().filter(|row| row.default.is_none());
        let given = required.map(|row| format!("{} := {}", row.name, row.name.len()));
        match settings {
            0 => lines.extend(given),
            1 => {
                lines.splice(0..0, given);
            }
            _ => {}
        }
        lines.join(end)
    })
}

fn name() -> impl Strategy<Value = &'static str> {
    prop::sample::select(vec!["a", "b", "c", "dd"])
}

fn value() -> impl Strategy<Value = &'static str> {
    prop::sample::select(vec!["1", "-0.5", "pi", "a", "-b", "eyepos_x"])
}
