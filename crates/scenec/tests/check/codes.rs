//! Exit codes, which files are looked at, and in which order they are told of.

use crate::room::{Room, SETTINGS};

const BAD: &str = "!a := sphere\n";

/// A command ends with this code and says these words, wherever.
fn check(room: &Room, arguments: &str, input: &str, code: i32, words: &str) {
    let ran = room.feed(arguments, input.as_bytes());
    assert_eq!(ran.code, Some(code), "{arguments}: {ran:?}");
    let said = format!("{}{}", ran.out, ran.err);
    assert!(said.contains(words), "{arguments}: {said}");
}

#[test]
fn the_exit_code_tells_clean_errors_and_unusable_apart() {
    let room = Room::with(&[("good.scene", SETTINGS)]);
    check(&room, "check good.scene", "", 0, "good.scene: no problems");
    check(&room, "check -", BAD, 1, "2 errors in <stdin>");
    check(&room, "check - good.scene", BAD, 1, "2 errors in 2 files");
    check(&room, "check good.scene ./good.scene", "", 0, "1 file: no problems");
    check(&room, "check no/such.scene", "", 2, "error: cannot read no/such.scene");
    check(&room, "check no/such.scene -", "5", 2, "3 errors in 1 file");
    check(&room, "check --color blue good.scene", "", 2, "blue");
    check(&room, "check --output-format word good.scene", "", 2, "word");
    check(&room, "check --deny W9 good.scene", "", 2, "there is no code `W9`");
    check(&room, "check --watch -", "", 2, "standard input can't be watched");
    check(&room, "check --exit-zero -", BAD, 0, "2 errors in <stdin>");
    check(&room, "check --exit-zero no.scene", "", 2, "cannot read no.scene");
    let warned = format!("{SETTINGS}q := 1\n");
    check(&room, "check -", &warned, 0, "1 warning in <stdin>");
    check(&room, "check - --deny W009", &warned, 1, "1 error in <stdin>");
    check(&room, "check - --deny warnings --allow W009", &warned, 0, "no problems");
    check(
        &room,
        "check - --allow=w009,W005 --stdin-filename x",
        &warned,
        0,
        "x: no problems",
    );
}

#[test]
fn quiet_says_nothing_but_findings() {
    let room = Room::with(&[("good.scene", SETTINGS)]);
    let ran = room.run("check -q good.scene");
    assert_eq!((ran.code, ran.out.as_str(), ran.err.as_str()), (Some(0), "", ""));
    let ran = room.feed("check -q --output-format concise -", b"5");
    assert_eq!(ran.out.lines().count(), 3, "{ran:?}");
}

#[test]
fn folders_are_looked_through_in_a_fixed_order() {
    let room = Room::with(&[
        ("c.scene", "5"),
        ("a.RTI", "5"),
        ("notes.txt", "5"),
        ("sub/b.scene", "5"),
        ("sub/out/left-out.scene", "5"),
        ("sub/.gitignore", "out/\n"),
    ]);
    let order = |arguments: &str| {
        let out = room.run(arguments).out;
        let mut names: Vec<_> = out
            .lines()
            .filter_map(|line| line.split_once("."))
            .map(|(name, _)| name.to_owned())
            .collect();
        names.dedup();
        names
    };
    for _ in 0..3 {
        assert_eq!(order("check -q --output-format concise"), ["a", "c", "sub/b"]);
    }
    assert_eq!(order("check -q --output-format concise sub ."), ["sub/b", "a", "c"]);
    let explicit = "check -q --output-format concise sub/out/left-out.scene notes.txt";
    assert_eq!(order(explicit), ["sub/out/left-out", "notes"]);
    let empty = Room::with(&[("notes.txt", "5")]);
    check(&empty, "check", "", 0, "no scene files found");
}

#[test]
fn many_files_come_in_the_order_of_their_names() {
    let names: Vec<String> = (0..100).map(|number| format!("{number:03}.scene")).collect();
    let files: Vec<_> = names.iter().map(|name| (name.as_str(), "5")).collect();
    let out = Room::with(&files).run("check -q --output-format concise").out;
    let found: Vec<_> = out.lines().step_by(3).map(|line| &line[..9]).collect();
    assert_eq!(found, names);
}
