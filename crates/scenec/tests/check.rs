//! `scenec check` as a script sees it: exit codes, what is printed where, and what the reports look like.

#![allow(clippy::unwrap_used, reason = "a test may stop at once")]

use std::io::Write;
use std::process::{Command, Output, Stdio};

const GOOD: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenes/seed.scene");

/// Runs `scenec check` with the text on standard input.
fn check_text(text: &[u8], arguments: &[&str]) -> Output {
    let mut child = Command::new(env!("CARGO_BIN_EXE_scenec"))
        .arg("check")
        .args(arguments)
        .env_remove("NO_COLOR")
        .env_remove("CLICOLOR_FORCE")
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    // A command that never reads its input closes the pipe, which is no failure of the test.
    let _ = child.stdin.take().unwrap().write_all(text);
    child.wait_with_output().unwrap()
}

fn errors(output: &Output) -> String {
    assert_eq!(output.stdout, b"", "reports go to standard error");
    String::from_utf8(output.stderr.clone()).unwrap()
}

#[test]
fn the_exit_code_tells_clean_errors_and_unusable_apart() {
    let check = |arguments: &[&str], text: &str, code: i32, words: &str| {
        let output = check_text(text.as_bytes(), arguments);
        let printed = errors(&output);
        assert_eq!(output.status.code(), Some(code), "{arguments:?}: {printed}");
        assert!(printed.contains(words), "{arguments:?}: {printed}");
    };
    check(&[GOOD], "", 0, "seed.scene: no problems");
    check(&["-"], "!a := sphere\n", 1, "2 errors in <stdin>");
    check(&["-", GOOD], "!a := sphere\n", 1, "no problems");
    check(&["no/such.scene"], "", 2, "cannot read no/such.scene");
    check(&["no/such.scene", "-"], "5", 2, "3 errors in <stdin>");
    check(&["."], "", 2, "cannot read .");
    check(&[], "", 2, "Usage");
    check(&["--color", "blue", GOOD], "", 2, "blue");
    let warned = std::fs::read_to_string(GOOD).unwrap() + "\nq := 1\n";
    check(&["-"], &warned, 0, "1 warning in <stdin>");
}

#[test]
fn reports_are_coloured_only_on_demand_and_capped() {
    let plain = errors(&check_text(b"5\n5\n", &["-"]));
    assert!(!plain.contains('\u{1b}'), "{plain:?}");
    let coloured = errors(&check_text(b"5\n5\n", &["-", "--color", "always"]));
    assert!(coloured.contains("\u{1b}["), "{coloured:?}");
    let capped = errors(&check_text(b"5\n5\n", &["-", "--max-diagnostics", "1"]));
    assert_eq!(capped.matches("Error:").count(), 1, "{capped}");
    assert!(capped.contains("3 more not shown"), "{capped}");
    // Errors come before warnings that stand further up.
    let capped = errors(&check_text(b"q := 1\n5\n", &["-", "--max-diagnostics", "1"]));
    assert!(capped.contains("E005") && !capped.contains("W009"), "{capped}");
}

#[test]
fn nothing_in_a_file_drives_the_terminal() {
    let printed = errors(&check_text(
        "x := \u{1b}[2J \u{202E} \0\u{8}\r\n\ry\u{2028}\u{85}!\u{B}\n".as_bytes(),
        &["-"],
    ));
    assert!(printed.chars().all(|c| c == '\n' || !c.is_control()), "{printed:?}");
    assert!(!printed.contains(['\u{202E}', '\u{2028}']), "{printed:?}");
    assert!(printed.contains("<stdin>:2:1 ]"), "{printed}");
}

#[test]
fn a_reader_that_goes_away_is_no_panic() {
    let mut child = Command::new(env!("CARGO_BIN_EXE_scenec"))
        .args(["check", "-"])
        .stdin(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    drop(child.stderr.take());
    child
        .stdin
        .take()
        .unwrap()
        .write_all("5\n".repeat(5000).as_bytes())
        .unwrap();
    assert_eq!(child.wait().unwrap().code(), Some(1));
}

fn report(text: &str) -> String {
    errors(&check_text(text.as_bytes(), &["-", "--color", "never"]))
}

#[test]
fn a_broken_file_looks_like_this() {
    insta::assert_snapshot!(
        "broken",
        report("!ball := shpere\n!ball += 1 0\n?red = 1\n\n!été := hp ; x\nr := 1.2.3\n")
    );
}

#[test]
fn two_lines_of_one_finding_look_like_this() {
    insta::assert_snapshot!(
        "two-lines",
        report("!a := sphere\n!b := a | a\n\n\n\n!b += 1 0 0\n!a *= 2 2 2\n!b <=\n!a := hp\n")
    );
}

#[test]
fn long_lines_look_like_this() {
    let zeros = "0 ".repeat(500);
    insta::assert_snapshot!(
        "long-line",
        report(&format!("a := {zeros}é 1.2.3 {zeros}\n!b := a | a\n"))
    );
}

#[test]
fn a_byte_order_mark_and_carriage_returns_look_like_this() {
    insta::assert_snapshot!("bom-crlf", report("\u{FEFF}é := = 1\r\n!x := y\r\n"));
}
