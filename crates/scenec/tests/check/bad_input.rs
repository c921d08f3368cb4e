//! Files that are no scenes at all: each is told of, none hangs, crashes or hides the others.

use std::fs::File;
use std::process::Stdio;

use crate::room::{Room, SETTINGS, feed};

/// The text ends `check` with this code, and the output has these words; the same text is refused or kept by `fmt`.
fn check(bytes: &[u8], code: i32, words: &str) {
    let room = Room::with(&[]);
    let ran = room.feed("check - --output-format concise", bytes);
    let shown: String = ran.out.chars().take(2000).collect();
    assert_eq!(ran.code, Some(code), "{shown}");
    assert!(ran.out.contains(words), "{words}: {shown}");
    let full = room.feed("check -", bytes);
    assert_eq!(full.code, Some(code));
    assert!(full.out.len() < 200_000, "{} bytes of reports", full.out.len());
    assert!(matches!(room.feed("fmt -", bytes).code, Some(0 | 1)));
}

#[test]
fn bytes_that_are_no_text_are_told_with_their_offset_and_the_rest_is_checked() {
    check(
        b"x := 1\n\xFFy := 2\n",
        1,
        "<stdin>:2:1: error[E001]: invalid UTF-8 at byte offset 7",
    );
    check(b"\xC3\n5\n", 1, "<stdin>:2:1: error[E005]");
    check(b"a\0b := 1\n", 1, "E002");
    check(b"x\0:\0=\0 \x001\0\n\0", 1, "E002");
}

#[test]
fn marks_and_line_ends_of_every_kind() {
    check(format!("\u{FEFF}{SETTINGS}").as_bytes(), 0, "no problems");
    check(SETTINGS.replace('\n', "\r\n").as_bytes(), 0, "no problems");
    check(SETTINGS.replace('\n', "\r").as_bytes(), 1, "error[E002]");
    check(format!("{SETTINGS}\u{FEFF}").as_bytes(), 1, "E002");
}

#[test]
fn nothing_to_check() {
    check(b"", 1, "E015");
    check(b"\n\n\n", 1, "E014");
    check(b"/ nothing\n/ but comments", 1, "E015");
}

#[test]
fn names_in_many_scripts() {
    for name in ["été", "мяч", "球", "كرة", "गेंद", "ボール", "공", "כדור"] {
        let text = SETTINGS.replace("ball", name);
        check(text.as_bytes(), 0, "no problems");
    }
}

#[test]
fn huge_lines_and_runs_of_nonsense_are_told_of_briefly() {
    check("0 ".repeat(500_000).as_bytes(), 1, "E005");
    check(format!("x := {}", "1 ".repeat(500_000)).as_bytes(), 1, "E007");
    check(format!("{} := 1", "n".repeat(1_000_000)).as_bytes(), 1, "E014");
    check("$".repeat(5_000_000).as_bytes(), 1, "E002");
    check("$ ".repeat(1_000_000).as_bytes(), 1, "E002");
    check("$\n".repeat(100_000).as_bytes(), 1, "more not shown");
    check("\n/\n".repeat(500_000).as_bytes(), 1, "E015");
}

#[test]
fn a_chain_of_a_million_unions() {
    let mut text = format!("/ scenec: allow W045\n{}", SETTINGS.replace("!ball <=\n", ""));
    text.push_str(&"!ball := ball | ball\n".repeat(1_000_000));
    text.push_str("!ball <=\n");
    let ran = Room::with(&[]).feed("check -", text.as_bytes());
    let shown: String = ran.out.chars().take(2000).collect();
    assert_eq!(
        (ran.code, shown.as_str()),
        (Some(0), "<stdin>: no problems\n"),
        "{}",
        ran.err
    );
}

#[test]
fn what_is_no_file_is_unusable() {
    let room = Room::with(&[("good.scene", SETTINGS), ("folder.scene/x.txt", "")]);
    for command in ["check", "fmt"] {
        let mut with_folder = room.command(&format!("{command} -"));
        with_folder.stdin(File::open(room.path("folder.scene")).unwrap());
        let output = with_folder.output().unwrap();
        assert_eq!(output.status.code(), Some(2), "{output:?}");
        assert!(String::from_utf8_lossy(&output.stderr).contains("cannot read <stdin>: Is a directory"));
        let ran = room.run(&format!("{command} missing.scene good.scene"));
        assert_eq!(ran.code, Some(2), "{ran:?}");
        assert!(ran.err.contains("cannot read missing.scene"), "{ran:?}");
        let ran = room.run(&format!("{command} good.scene/x"));
        assert!(ran.err.contains("cannot read good.scene/x"), "{ran:?}");
    }
}

#[cfg(target_os = "linux")]
#[test]
fn an_unreadable_file_is_unusable_and_the_others_are_checked() {
    let room = Room::with(&[("good.scene", SETTINGS)]);
    // Permissions don't stop the superuser; the memory of a process, which has nothing at its start, does.
    let ran = room.run("check /proc/self/mem good.scene");
    assert_eq!(ran.code, Some(2), "{ran:?}");
    assert!(ran.err.contains("cannot read /proc/self/mem"), "{ran:?}");
    assert!(ran.out.contains("1 file: no problems"), "{ran:?}");
}

#[test]
fn a_reader_that_goes_away_is_no_panic() {
    let room = Room::with(&[("many.scene", &"5\n".repeat(5000)), ("more.scene", "5")]);
    for format in [
        "full",
        "concise",
        "json",
        "json-lines",
        "sarif",
        "github",
        "gitlab",
        "junit",
    ] {
        let mut command = room.command(&format!("check --output-format {format} --max-diagnostics 5000"));
        let mut child = command.spawn().unwrap();
        drop(child.stdout.take());
        let output = child.wait_with_output().unwrap();
        assert_eq!(output.status.code(), Some(1), "{format}: {output:?}");
        assert_eq!(String::from_utf8_lossy(&output.stderr), "", "{format}");
    }
    let mut child = room
        .command("fmt --diff many.scene")
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();
    drop(child.stdout.take());
    assert_eq!(child.wait().unwrap().code(), Some(1));
}

#[cfg(target_os = "linux")]
#[test]
fn reports_that_cannot_be_written_are_a_failure() {
    let room = Room::with(&[("bad.scene", "x :=\n"), ("loose.scene", "x:=1\n")]);
    for arguments in [
        "check bad.scene",
        "check bad.scene --output-format sarif",
        "fmt --diff loose.scene",
        "fmt --check loose.scene",
    ] {
        let mut command = room.command(arguments);
        command.stdout(File::options().write(true).open("/dev/full").unwrap());
        let ran = feed(command, b"");
        assert_eq!(ran.code, Some(2), "{arguments}: {ran:?}");
        assert!(ran.err.contains("cannot write <stdout>"), "{arguments}: {ran:?}");
    }
}
