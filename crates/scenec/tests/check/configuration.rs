//! `scenec.toml`, found upwards from each file.

use crate::room::{Room, SETTINGS};

#[test]
fn the_nearest_configuration_holds_and_the_command_line_beats_it() {
    let warned = format!("{SETTINGS}q := 1\n");
    let room = Room::with(&[
        ("scenec.toml", "[lint]\ndeny = [\"W009\"]\n"),
        ("a.scene", &warned),
        ("sub/scenec.toml", "[lint]\nallow = [\"warnings\"]\n"),
        ("sub/deep/b.scene", &warned),
    ]);
    let check = |arguments: &str, code: i32| {
        let ran = room.feed(arguments, warned.as_bytes());
        assert_eq!(ran.code, Some(code), "{arguments}: {ran:?}");
    };
    check("check a.scene", 1);
    check("check sub", 0);
    check("check .", 1);
    check("check a.scene --warn W009", 0);
    check("check sub --deny W009", 1);
    check("check -", 1);
    check("check - --stdin-filename sub/deep/new.scene", 0);
}

#[test]
fn one_configuration_for_all_files_or_none() {
    let warned = format!("{SETTINGS}q := 1\n");
    let room = Room::with(&[
        ("scenec.toml", "[lint]\ndeny = [\"W009\"]\n[fmt]\nalign = true\n"),
        ("other.toml", "[lint]\nallow = [\"W009\"]\n"),
        ("bad.toml", "[lint]\nx = 1\n"),
        ("a.scene", &warned),
        ("loose.scene", "x := 1\nyy := 2\n"),
    ]);
    let check = |arguments: &str, code: i32, words: &str| {
        let ran = room.run(arguments);
        assert_eq!(ran.code, Some(code), "{arguments}: {ran:?}");
        let said = format!("{}{}", ran.out, ran.err);
        assert!(said.contains(words), "{arguments}: {said}");
    };
    check("check a.scene", 1, "1 error");
    check("check a.scene --isolated", 0, "1 warning");
    check("check a.scene --config other.toml", 0, "no problems");
    check("check a.scene --config other.toml --deny W009", 1, "1 error");
    check(
        "check a.scene --config bad.toml",
        2,
        "bad.toml:2:1: unknown key `lint.x`",
    );
    check("check a.scene --config no.toml", 2, "cannot read no.toml");
    check(
        "check --watch --config no.toml a.scene --isolated",
        2,
        "cannot be used with",
    );
    check("fmt --check loose.scene", 1, "would format loose.scene");
    check("fmt --check loose.scene --isolated", 0, "in style already");
    check("fmt --check loose.scene --config other.toml", 0, "in style already");
}

#[test]
fn a_wrong_configuration_is_told_once_and_other_files_are_checked() {
    let room = Room::with(&[
        ("bad/scenec.toml", "[lint]\n\n  dney = []\n"),
        ("bad/a.scene", SETTINGS),
        ("bad/b.scene", SETTINGS),
        ("good/c.scene", SETTINGS),
    ]);
    for command in ["check .", "fmt . --check"] {
        let ran = room.run(command);
        assert_eq!(ran.code, Some(2), "{ran:?}");
        let said = "error: bad/scenec.toml:3:3: unknown key `lint.dney`; did you mean `deny`?\n";
        assert!(
            ran.err.starts_with(said) && ran.err.matches("unknown").count() == 1,
            "{ran:?}"
        );
    }
    assert!(room.run("check .").out.contains("1 file: no problems"));
}
