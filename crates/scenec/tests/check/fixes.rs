//! `--fix`, `--diff` and what they leave alone.

use crate::room::{Room, SETTINGS};

#[test]
fn safe_fixes_are_written_until_none_is_left() {
    let text = format!("/ kept\r\na := 1\r\nb := 2\r\n{}", SETTINGS.replace('\n', "\r\n"));
    let room = Room::with(&[("a.scene", &text), ("b.scene", SETTINGS)]);
    let counted = room.run("check a.scene");
    assert!(counted.out.contains("can be fixed with --fix"), "{counted:?}");
    let diff = room.run("check --diff");
    assert_eq!(diff.code, Some(1), "{diff:?}");
    assert!(diff.out.starts_with("--- a.scene\n+++ a.scene\n"), "{diff:?}");
    assert!(
        diff.out.contains("\n-a := 1\r\n-b := 2\r\n") && !diff.out.contains("W009"),
        "{diff:?}"
    );
    assert_eq!(room.read("a.scene"), text);
    let fixed = room.run("check --fix");
    assert_eq!(fixed.code, Some(0), "{fixed:?}");
    assert!(fixed.out.contains("2 files: no problems\n2 fixed\n"), "{fixed:?}");
    assert_eq!(
        room.read("a.scene"),
        format!("/ kept\r\n{}", SETTINGS.replace('\n', "\r\n"))
    );
    assert_eq!(room.read("b.scene"), SETTINGS);
    assert_eq!(room.entries(), ["a.scene", "b.scene"]);
    let none = room.run("check --diff");
    assert_eq!((none.code, none.out.as_str()), (Some(0), ""));
}

#[test]
fn standard_input_is_mended_onto_standard_output() {
    let room = Room::with(&[]);
    let ran = room.feed("check --fix -", format!("q := 1\n{SETTINGS}").as_bytes());
    assert_eq!((ran.code, ran.out.as_str()), (Some(0), SETTINGS), "{ran:?}");
    assert!(ran.err.contains("<stdin>: no problems"), "{ran:?}");
    let ran = room.feed("check --fix -", b"q := 1 / \xFF\n");
    assert_eq!((ran.code, ran.out.as_str()), (Some(1), ""), "{ran:?}");
}

#[test]
fn what_is_allowed_or_no_text_is_left_alone() {
    let text = format!("q := 1\n{SETTINGS}");
    let room = Room::with(&[("a.scene", &text)]);
    room.write("b.scene", b"q := 1 / \xFF\n");
    let ran = room.run("check --fix --allow W009");
    assert_eq!(ran.code, Some(1), "{ran:?}");
    assert_eq!(room.read("a.scene"), text);
    assert_eq!(std::fs::read(room.path("b.scene")).unwrap(), b"q := 1 / \xFF\n");
}

#[cfg(unix)]
#[test]
fn a_file_that_may_not_be_written_is_a_failure() {
    use std::os::unix::fs::PermissionsExt;
    let room = Room::with(&[("a.scene", &format!("q := 1\n{SETTINGS}"))]);
    std::fs::set_permissions(room.path("a.scene"), std::fs::Permissions::from_mode(0o444)).unwrap();
    let ran = room.run("check --fix");
    assert_eq!(ran.code, Some(2), "{ran:?}");
    assert!(ran.err.contains("a.scene: it is read-only"), "{ran:?}");
    assert_eq!(room.entries(), ["a.scene"]);
}
