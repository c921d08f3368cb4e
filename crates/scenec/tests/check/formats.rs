//! Every output format on the same three files.

use serde_json::Value;

use crate::room::{Room, SETTINGS};

fn room() -> Room {
    let late = format!("{SETTINGS}!late := sphere\n!été := shpere\n!ball ?= \"<&100%\n");
    Room::with(&[
        ("clean.scene", SETTINGS),
        ("late, 100%.scene", &late),
        ("sub/broken.rti", &format!("5\n{SETTINGS}")),
    ])
}

fn printed(format: &str) -> String {
    let ran = room().run(&format!("check --color never --output-format {format}"));
    assert_eq!((ran.code, ran.err.as_str()), (Some(1), ""), "{ran:?}");
    ran.out
}

#[test]
fn full_looks_like_this() {
    insta::assert_snapshot!("full", printed("full"));
}

#[test]
fn concise_looks_like_this() {
    insta::assert_snapshot!("concise", printed("concise"));
}

#[test]
fn json_looks_like_this() {
    let printed = printed("json");
    let lines: Vec<Value> = self::printed("json-lines")
        .lines()
        .map(|line| serde_json::from_str(line).unwrap())
        .collect();
    assert_eq!(serde_json::from_str::<Vec<Value>>(&printed).unwrap(), lines);
    insta::assert_snapshot!("json", printed);
}

#[test]
fn json_lines_looks_like_this() {
    insta::assert_snapshot!("json-lines", printed("json-lines"));
}

/// SARIF without the manual's pages, which have tests of their own.
#[test]
fn sarif_looks_like_this() {
    let mut log: Value = serde_json::from_str(&printed("sarif")).unwrap();
    for rule in log["runs"][0]["tool"]["driver"]["rules"].as_array_mut().unwrap() {
        let help = rule.as_object_mut().unwrap().remove("help").unwrap();
        assert!(help["markdown"].as_str().unwrap().contains("## Example"), "{help}");
    }
    log["runs"][0]["tool"]["driver"]["semanticVersion"] = "x".into();
    insta::assert_snapshot!("sarif", format!("{log:#}"));
}

#[test]
fn results_refer_to_their_rules_and_failures_are_told() {
    let ran = room().run("check . missing.scene --output-format sarif");
    assert_eq!(ran.code, Some(2), "{ran:?}");
    let log: Value = serde_json::from_str(&ran.out).unwrap();
    let run = &log["runs"][0];
    for result in run["results"].as_array().unwrap() {
        let index = usize::try_from(result["ruleIndex"].as_u64().unwrap()).unwrap();
        assert_eq!(run["tool"]["driver"]["rules"][index]["id"], result["ruleId"]);
    }
    let invocation = &run["invocations"][0];
    assert_eq!(invocation["executionSuccessful"], false);
    let told = invocation["toolExecutionNotifications"][0]["message"]["text"]
        .as_str()
        .unwrap();
    assert!(told.starts_with("cannot read missing.scene"), "{told}");
}

#[test]
fn github_looks_like_this() {
    insta::assert_snapshot!("github", printed("github"));
}

#[test]
fn gitlab_looks_like_this() {
    let printed = printed("gitlab");
    let records: Vec<Value> = serde_json::from_str(&printed).unwrap();
    let mut prints: Vec<_> = records.iter().map(|record| record["fingerprint"].to_string()).collect();
    prints.sort();
    prints.dedup();
    assert_eq!(prints.len(), records.len(), "fingerprints differ");
    insta::assert_snapshot!("gitlab", printed);
}

#[test]
fn junit_looks_like_this() {
    insta::assert_snapshot!("junit", printed("junit"));
}

/// The findings of every fixture, one a line: no message changes unseen.
#[test]
fn the_fixtures_look_like_this() {
    let fixtures = concat!(env!("CARGO_MANIFEST_DIR"), "/../../tests/fixtures");
    let command = "check -q --color never --max-diagnostics 1000 --output-format concise";
    let ran = crate::room::feed(crate::room::command_in(fixtures.as_ref(), command), b"");
    assert_eq!((ran.code, ran.err.as_str()), (Some(1), ""), "{ran:?}");
    insta::assert_snapshot!("fixtures", ran.out);
}

#[test]
fn every_format_has_a_snapshot() {
    let refused = room().run("check --output-format none").err;
    let formats = refused
        .split_once("[possible values: ")
        .unwrap()
        .1
        .split(']')
        .next()
        .unwrap();
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/check/snapshots");
    for format in formats.split(", ") {
        let file = format!("{folder}/check__formats__{format}.snap");
        assert!(std::path::Path::new(&file).exists(), "{file}");
    }
    assert_eq!(formats.split(", ").count(), 8, "{formats}");
}

#[test]
fn no_findings_are_a_whole_document_too() {
    let room = Room::with(&[("clean.scene", SETTINGS)]);
    let check = |format: &str, expect: &str| {
        let ran = room.run(&format!("check clean.scene --output-format {format}"));
        assert_eq!((ran.code, ran.out.as_str()), (Some(0), expect), "{ran:?}");
    };
    check("full", "clean.scene: no problems\n");
    check("concise", "clean.scene: no problems\n");
    check("json", "[]\n");
    check("json-lines", "");
    check("github", "");
    check("gitlab", "[]\n");
}

#[test]
fn a_level_shows_in_every_format() {
    let text = format!("{SETTINGS}!late := sphere\n");
    let check = |format: &str, expect: &str| {
        let arguments = format!("check - --deny W005 --output-format {format}");
        let ran = Room::with(&[]).feed(&arguments, text.as_bytes());
        assert_eq!(ran.code, Some(1), "{ran:?}");
        assert!(ran.out.contains(expect), "{format}: {}", ran.out);
    };
    check("full", "[W005] Error");
    check("concise", "error[W005]");
    check("json", "\"severity\": \"error\"");
    check("json-lines", "\"severity\":\"error\"");
    check("sarif", "\"level\": \"error\"");
    check("github", "::error ");
    check("gitlab", "\"severity\": \"major\"");
    check("junit", "type=\"error\"");
}
