//! What the reports look like.

use crate::room::{Room, SETTINGS};

/// Everything that is said about a text.
fn report(text: &str) -> String {
    let ran = Room::with(&[]).feed("check - --color never", text.as_bytes());
    assert_eq!(ran.err, "", "findings go to standard output");
    ran.out
}

#[test]
fn reports_are_coloured_only_on_demand_and_capped() {
    let room = Room::with(&[]);
    let check = |arguments: &str, text: &str| room.feed(&format!("check - {arguments}"), text.as_bytes()).out;
    for format in ["", "--output-format concise"] {
        let plain = check(format, "5\n5\n");
        assert!(!plain.contains('\u{1b}'), "{plain:?}");
        let coloured = check(&format!("--color always {format}"), "5\n5\n");
        assert!(coloured.contains("\u{1b}["), "{coloured:?}");
        let capped = check(&format!("--max-diagnostics 1 {format}"), "5\n5\n");
        assert_eq!(capped.matches("E005").count(), 1, "{capped}");
        assert!(capped.contains("3 more not shown"), "{capped}");
        // Errors come before warnings that stand further up.
        let capped = check(&format!("--max-diagnostics 1 {format}"), "q := 1\n5\n");
        assert!(capped.contains("E005") && !capped.contains("W009"), "{capped}");
    }
}

#[test]
fn what_can_be_fixed_is_marked_and_counted() {
    let text = format!("q := 1\n{SETTINGS}!ball += 1 0 0\n").replace("!ball <=", "!ball #y= 45\n!ball #x= 1\n!ball <=");
    let room = Room::with(&[]);
    let check = |arguments: &str, marks: usize, last: &str| {
        let ran = room.feed(&format!("check - --output-format concise {arguments}"), text.as_bytes());
        let out = if arguments.contains("--fix") {
            &ran.err
        } else {
            &ran.out
        };
        assert_eq!(out.matches("]: [*] ").count(), marks, "{arguments}: {out}");
        assert_eq!(out.lines().last(), Some(last), "{arguments}: {out}");
    };
    check("", 2, "[*] 2 can be fixed with --fix, 3 more with --unsafe-fixes");
    check("--unsafe-fixes", 5, "[*] 5 can be fixed with --fix --unsafe-fixes");
    check("--allow W009,W005", 0, "3 can be fixed with --fix --unsafe-fixes");
    check("--fix", 0, "3 more can be fixed with --unsafe-fixes");
}

#[test]
fn nothing_in_a_file_or_its_name_drives_the_terminal() {
    let room = Room::with(&[]);
    let text = "x := \u{1b}[2J \u{202E} \0\u{8}\r\n\ry\u{2028}\u{85}!\u{B}\n";
    for format in ["full", "concise"] {
        let mut command = room.command(&format!("check - --output-format {format} --stdin-filename"));
        command.arg("evil\u{1b}]0;\u{7}.scene");
        let printed = crate::room::feed(command, text.as_bytes()).out;
        assert!(printed.chars().all(|c| c == '\n' || !c.is_control()), "{printed:?}");
        assert!(!printed.contains(['\u{202E}', '\u{2028}']), "{printed:?}");
        assert!(printed.contains("evil?]0;?.scene:2:1"), "{printed}");
    }
}

#[test]
fn a_broken_file_looks_like_this() {
    insta::assert_snapshot!(
        "broken",
        report("!ball := shpere\n!ball += 1 0\n?red = 1\n\n!été := hp ; x\nr := 1.2.3\n")
    );
}

#[test]
fn lines_far_apart_look_like_this() {
    let between = "\n".repeat(12_000);
    insta::assert_snapshot!("far-apart", report(&format!("{SETTINGS}{between}!ball *= 2 2 2\n")));
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

#[test]
fn statistics_count_by_code() {
    let room = Room::with(&[("a.scene", SETTINGS), ("b.scene", "5\n5\nx")]);
    let ran = room.run("check --statistics");
    let rows: Vec<&str> = ran.out.lines().map(|line| &line[..7.min(line.len())]).collect();
    assert_eq!(
        rows,
        ["3  E005", "1  E014", "1  E015", "5 errors"].map(|row| &row[..7]),
        "{}",
        ran.out
    );
    assert!(ran.out.ends_with("5 errors in 2 files\n"), "{}", ran.out);
    let ran = room.run("check --statistics --output-format json");
    let rows: serde_json::Value = serde_json::from_str(&ran.out).unwrap();
    assert_eq!((&rows[0]["code"], &rows[0]["count"]), (&"E005".into(), &3.into()));
}
