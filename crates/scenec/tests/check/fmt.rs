//! `scenec fmt`

use crate::room::Room;

const LOOSE: &str = "\u{FEFF}x:=1   / one\r\n\r\n\r\n! ball:=sphere\r\n";
const TIDY: &str = "x := 1  / one\r\n\r\n!ball := sphere\r\n";

/// The command ends like this: code, standard output, standard error.
fn check(room: &Room, arguments: &str, expect: (i32, &str, &str)) {
    let ran = room.feed(arguments, LOOSE.as_bytes());
    let found = (ran.code, ran.out.as_str(), ran.err.as_str());
    assert_eq!(found, (Some(expect.0), expect.1, expect.2), "{arguments}");
}

#[test]
fn files_are_rewritten_once() {
    let room = Room::with(&[("a.scene", LOOSE), ("b.rti", TIDY)]);
    let summary = "1 file would be formatted, 1 file in style already\n";
    check(&room, "fmt --check", (1, "would format a.scene\n", summary));
    check(&room, "fmt --check -q", (1, "would format a.scene\n", ""));
    let diff = "--- a.scene\n+++ a.scene\n@@ -1,4 +1,3 @@\n-\u{FEFF}x:=1   / one\r\n-\r\n+x := 1  / one\r\n \r\n-! ball:=sphere\r\n+!ball := sphere\r\n";
    check(&room, "fmt --diff -q", (1, diff, ""));
    assert_eq!(room.read("a.scene"), LOOSE);
    check(&room, "fmt", (0, "", "1 file formatted, 1 file in style already\n"));
    assert_eq!(
        (room.read("a.scene").as_str(), room.read("b.rti").as_str()),
        (TIDY, TIDY)
    );
    check(&room, "fmt", (0, "", "2 files in style already\n"));
    check(&room, "fmt --check --diff", (0, "", "2 files in style already\n"));
    assert_eq!(room.entries(), ["a.scene", "b.rti"]);
}

#[test]
fn standard_input_goes_to_standard_output() {
    let room = Room::with(&[("scenec.toml", "[fmt]\nalign = true\n")]);
    check(&room, "fmt -", (0, TIDY, ""));
    check(&room, "fmt - --check", (1, "would format <stdin>\n", ""));
    let ran = room.feed("fmt -", b"width := 1\nup_y := -.5\n");
    assert_eq!(ran.out, "width := 1\nup_y  := -.5\n");
}

#[test]
fn a_file_with_errors_is_refused_loudly_and_the_others_are_formatted() {
    let broken = "x := 1\n!ball :== sphere\n  y:=2\n";
    let room = Room::with(&[("a.scene", broken), ("b.scene", LOOSE)]);
    let ran = room.run("fmt");
    assert_eq!((ran.code, ran.out.as_str()), (Some(1), ""), "{ran:?}");
    assert!(ran.err.contains("E002") && ran.err.contains("a.scene:2:9"), "{ran:?}");
    assert!(
        ran.err
            .contains("cannot format a.scene: it has errors; it was left untouched"),
        "{ran:?}"
    );
    assert!(ran.err.ends_with("1 file formatted, 1 file with errors\n"), "{ran:?}");
    assert_eq!(
        (room.read("a.scene").as_str(), room.read("b.scene").as_str()),
        (broken, TIDY)
    );
    // What a name means is no business of the formatter.
    let ran = room.feed("fmt -", b"!x:=nothing\n!y|=");
    assert_eq!((ran.code, ran.out.as_str()), (Some(1), ""), "{ran:?}");
    let ran = room.feed("fmt -", b"!x:=nothing\n!x<=");
    assert_eq!(
        (ran.code, ran.out.as_str()),
        (Some(0), "!x := nothing\n!x <=\n"),
        "{ran:?}"
    );
    let ran = room.feed("fmt -", b"/ \xFF\n");
    assert_eq!((ran.code, ran.out.as_str()), (Some(1), ""), "{ran:?}");
    assert!(ran.err.contains("invalid UTF-8 at byte offset 2"), "{ran:?}");
}
