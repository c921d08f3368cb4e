//! The formats for programs, as their readers take them: whatever the files hold and are called, a reader gets the same
//! findings as the one of `json-lines`.

use std::collections::BTreeSet;
use std::fs;
use std::path::PathBuf;

use serde_json::Value;

use crate::room::{Room, SETTINGS};

/// File names that mean something to the formats, or to a shell.
const ODD: &[&str] = &[
    "a b.scene",
    "50%,off::now.scene",
    "<&\"quoted'>.scene",
    "#1?x=y.scene",
    "[été]{0}.scene",
    "сцена/球.scene",
    "line\nend\r\tx.scene",
    "\u{1b}[31m.scene",
];

fn tests() -> PathBuf {
    PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/../../tests"))
}

/// A clean file, the fixtures of every code, which are broken in every way, and files whose names are.
fn rooms() -> Vec<Room> {
    let clean = Room::with(&[("clean.scene", SETTINGS)]);
    let many = Room::with(&[]);
    for entry in fs::read_dir(tests().join("fixtures")).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap().to_str().unwrap();
        many.write(name, &fs::read(&path).unwrap());
    }
    let late = format!("{SETTINGS}!été := shpere\n!ball ?= \"<&]]>100%\n!a := {{0}} [x](1)\nq := 1\n");
    let odd = Room::with(&[]);
    for name in ODD {
        odd.write(name, late.as_bytes());
    }
    vec![clean, many, odd]
}

/// What a reader has of a finding: the file, the line, the code and the message.
type Read = (String, u64, String, String);

/// Every reader of `format` reads what the file says: `read` takes the findings out of it.
fn check(format: &str, read: impl Fn(&str) -> Vec<Read>) {
    for (number, room) in rooms().into_iter().enumerate() {
        let out = |format: &str| room.run(&format!("check --output-format {format}")).out;
        let expect: Vec<Read> = out("json-lines")
            .lines()
            .map(|line| {
                let finding: Value = serde_json::from_str(line).unwrap();
                let word = |key: &str| finding[key].as_str().unwrap().to_owned();
                let line = finding["location"]["row"].as_u64().unwrap();
                (word("filename"), line, word("code"), word("message"))
            })
            .collect();
        assert_eq!(expect.is_empty(), number == 0);
        let found = read(&out(format));
        assert_eq!(found.len(), expect.len(), "{format}");
        for (found, expect) in found.iter().zip(&expect) {
            assert_eq!(found, expect, "{format}");
        }
    }
}

/// The schema that OASIS publishes.
fn schema() -> jsonschema::Validator {
    let text = fs::read_to_string(tests().join("sarif/sarif-schema-2.1.0.json")).unwrap();
    // A stray bracket, which only some engines take for a letter, stands in the patterns of languages; no log of ours has one.
    let text = text.replace("-[a-zA-Z]{2}]?$", "-[a-zA-Z]{2}$");
    let options = jsonschema::options().should_validate_formats(true);
    options.build(&serde_json::from_str(&text).unwrap()).unwrap()
}

fn faults(schema: &jsonschema::Validator, log: &Value) -> Vec<String> {
    let fault = |error: jsonschema::ValidationError<'_>| format!("{}: {error}", error.instance_path());
    schema.iter_errors(log).map(fault).collect()
}

/// A path from a reference: what is in percents, and the rest as it is.
fn path(uri: &str) -> String {
    let mut bytes = Vec::new();
    let mut rest = uri.bytes();
    while let Some(byte) = rest.next() {
        let digits = (byte == b'%').then(|| [rest.next().unwrap(), rest.next().unwrap()]);
        bytes.push(digits.map_or(byte, |digits| {
            u8::from_str_radix(std::str::from_utf8(&digits).unwrap(), 16).unwrap()
        }));
    }
    String::from_utf8(bytes).unwrap()
}

#[test]
fn sarif_is_valid() {
    let schema = schema();
    let (mut fixes, mut codes) = (0, BTreeSet::new());
    let seen = std::cell::RefCell::new((&mut fixes, &mut codes));
    check("sarif", |out| {
        let log: Value = serde_json::from_str(out).unwrap();
        assert_eq!(faults(&schema, &log), [""; 0]);
        let results = log["runs"][0]["results"].as_array().unwrap();
        let read = |result: &Value| {
            let (fixes, codes) = &mut *seen.borrow_mut();
            **fixes += result["fixes"].as_array().map_or(0, Vec::len);
            let place = &result["locations"][0]["physicalLocation"];
            let code = result["ruleId"].as_str().unwrap().to_owned();
            codes.insert(code.clone());
            let message = result["message"]["text"].as_str().unwrap();
            let name = path(place["artifactLocation"]["uri"].as_str().unwrap());
            let line = place["region"]["startLine"].as_u64().unwrap();
            // The help follows on lines of its own.
            (name, line, code, message.split('\n').next().unwrap().to_owned())
        };
        results.iter().map(read).collect()
    });
    let pages = Room::with(&[]).run("explain --all --output-format json").out;
    let pages: Vec<Value> = serde_json::from_str(&pages).unwrap();
    let all: BTreeSet<_> = pages
        .iter()
        .map(|page| page["code"].as_str().unwrap().to_owned())
        .collect();
    assert!(fixes > 30 && codes == all, "{fixes} repairs, {codes:?}");
}

#[test]
fn sarif_is_valid_without_files_and_with_failures() {
    let room = Room::with(&[]);
    for (arguments, input) in [
        ("check", ""),
        ("check no.scene", ""),
        ("check - no.scene /no/é.scene", "5"),
        ("check - --stdin-filename /a/b.scene", "5"),
    ] {
        let ran = room.feed(&format!("{arguments} --output-format sarif"), input.as_bytes());
        let log: Value = serde_json::from_str(&ran.out).unwrap();
        assert_eq!(faults(&schema(), &log), [""; 0], "{arguments}");
    }
}

#[test]
fn a_log_that_is_not_valid_is_refused() {
    let schema = schema();
    let ran = Room::with(&[]).feed("check - --output-format sarif", b"5");
    let valid: Value = serde_json::from_str(&ran.out).unwrap();
    for (place, wrong) in [
        ("/version", "2.1"),
        ("/runs/0/results/0/level", "fatal"),
        (
            "/runs/0/results/0/locations/0/physicalLocation/artifactLocation/uri",
            "a b",
        ),
        ("/runs/0/columnKind", "bytes"),
    ] {
        let mut log = valid.clone();
        *log.pointer_mut(place).unwrap() = wrong.into();
        assert_eq!(faults(&schema, &log).len(), 1, "{place}");
    }
}

#[test]
fn junit_is_xml() {
    check("junit", |out| {
        let document = roxmltree::Document::parse(out).unwrap_or_else(|error| panic!("{error}: {out}"));
        let mut found = Vec::new();
        for suite in document.root_element().children().filter(roxmltree::Node::is_element) {
            let cases: Vec<_> = suite.children().filter(|node| node.has_tag_name("testcase")).collect();
            let failed: Vec<_> = cases.iter().filter_map(|case| case.first_element_child()).collect();
            let count = |name: &str| suite.attribute(name).unwrap().parse::<usize>().unwrap();
            assert_eq!((count("tests"), count("failures")), (cases.len(), failed.len()));
            for (case, failure) in cases.iter().zip(&failed) {
                let word = |name: &str| case.attribute(name).unwrap().to_owned();
                let code = word("name").split(' ').next().unwrap().to_owned();
                let message = failure.attribute("message").unwrap().to_owned();
                assert!(failure.text().unwrap().contains(&message));
                // What XML can't hold stands as U+FFFD there.
                let name = word("file").replace('\u{FFFD}', "\u{1b}");
                found.push((name, word("line").parse().unwrap(), code, message));
            }
        }
        found
    });
}

#[test]
fn github_reads_every_command() {
    let plain = |text: &str| {
        let text = text.replace("%2C", ",").replace("%3A", ":");
        text.replace("%0D", "\r").replace("%0A", "\n").replace("%25", "%")
    };
    check("github", |out| {
        let read = |line: &str| {
            // A runner takes a line that begins with `::` up to the next `::` for the command and its properties.
            let (head, data) = line.strip_prefix("::").unwrap().split_once("::").unwrap();
            let (kind, properties) = head.split_once(' ').unwrap();
            assert!(["error", "warning", "notice"].contains(&kind), "{line}");
            let property = |name: &str| {
                let mut pairs = properties.split(',').map(|pair| pair.split_once('=').unwrap());
                plain(pairs.find(|(key, _)| *key == name).unwrap().1)
            };
            let (name, line) = (property("file"), property("line"));
            let data = data.replace("%0D", "\r").replace("%0A", "\n").replace("%25", "%");
            let rest = data.strip_prefix(&format!("{name}:{line}:")).unwrap();
            let message = rest.split_once(": ").unwrap().1.split('\n').next().unwrap();
            let code = property("title").trim_start_matches("scenec ").to_owned();
            (name, line.parse().unwrap(), code, message.to_owned())
        };
        out.lines().map(read).collect()
    });
}

#[test]
fn gitlab_has_what_its_reader_asks_for() {
    check("gitlab", |out| {
        let records: Vec<Value> = serde_json::from_str(out).unwrap();
        let prints: BTreeSet<_> = records
            .iter()
            .map(|record| record["fingerprint"].as_str().unwrap())
            .collect();
        assert_eq!(prints.len(), records.len(), "fingerprints differ");
        let read = |record: &Value| {
            let severity = record["severity"].as_str().unwrap();
            assert!(
                ["info", "minor", "major", "critical", "blocker"].contains(&severity),
                "{severity}"
            );
            let (path, place) = (&record["location"]["path"], &record["location"]["positions"]["begin"]);
            let description = record["description"].as_str().unwrap();
            let (code, message) = description.split_once(": ").unwrap();
            assert_eq!(record["check_name"], code);
            let name = path.as_str().unwrap().to_owned();
            (
                name,
                place["line"].as_u64().unwrap(),
                code.to_owned(),
                message.to_owned(),
            )
        };
        records.iter().map(read).collect()
    });
}
