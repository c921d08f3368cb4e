//! The suite of scene files in `fixtures/`: each marks, in comments of its own, every finding that it must have.
//!
//! Under the line that a finding is about stands `/  ^^^^ E005 some words`: the carets lie under the place to jump to,
//! counted in characters, and the words are part of the message, its label or its help. Further places of the same
//! finding are marked with `~` in place of `^`. A finding about the file as a whole, which points behind its last word,
//! is marked `/@ E014 some words` anywhere. Since `/` takes the first column, a marked line is indented by a space.
//! A file without marks has no findings.

#![allow(clippy::unwrap_used, reason = "a test may stop at once")]

use std::collections::BTreeSet;
use std::fs;
use std::path::PathBuf;

use scenec_lint::check;
use scenec_text::{Code, Diagnostic, Severity, SourceFile, Span};

/// A place that a finding names, or a mark that asks for one.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
struct Mark {
    /// From 1; 0 for the file as a whole.
    line: u32,
    /// From 0, in characters.
    column: u32,
    width: u32,
    primary: bool,
    code: String,
    /// What the finding says here, or a part of it.
    words: String,
}

fn folder() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("fixtures")
}

fn fixtures() -> Vec<(String, Vec<u8>)> {
    let mut files: Vec<_> = fs::read_dir(folder())
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.extension().is_some_and(|extension| extension == "scene"))
        .map(|path| {
            let name = path.file_name().unwrap().to_string_lossy().into_owned();
            (name, fs::read(path).unwrap())
        })
        .collect();
    files.sort();
    files
}

/// The marks in a file.
fn expected(source: &SourceFile) -> Vec<Mark> {
    let mut marks = Vec::new();
    let mut line = 0;
    for number in 0..source.line_count() {
        let text = source.line_span(number).unwrap().of(source.text());
        let (at, primary) = match text.strip_prefix('/').map(str::trim_start) {
            Some(rest) if rest.starts_with('^') => (text.len() - rest.len(), true),
            Some(rest) if rest.starts_with('~') => (text.len() - rest.len(), false),
            Some(rest) if text.starts_with("/@") => {
                let (code, words) = rest[1..].trim().split_once(' ').unwrap();
                marks.push(Mark {
                    line: 0,
                    column: 0,
                    width: 0,
                    primary: true,
                    code: code.into(),
                    words: words.into(),
                });
                continue;
            }
            _ => {
                line = number + 1;
                continue;
            }
        };
        let rest = text[at..].trim_start_matches(['^', '~']);
        let (code, words) = rest.trim().split_once(' ').unwrap_or((rest.trim(), ""));
        marks.push(Mark {
            line,
            column: u32::try_from(at).unwrap(),
            width: u32::try_from(text.len() - at - rest.len()).unwrap(),
            primary,
            code: code.into(),
            words: words.into(),
        });
    }
    marks
}

/// What a finding would have to be marked with.
fn found(source: &SourceFile, finding: &Diagnostic) -> Vec<Mark> {
    let mark = |(index, label): (usize, &scenec_text::Label)| {
        let Span { start, end } = label.span;
        let (from, to) = (source.position(start), source.position(end));
        let whole = start == end;
        let mut words = label.message.clone();
        if index == 0 {
            words = format!(
                "{}\n{words}\n{}",
                finding.message,
                finding.help.as_deref().unwrap_or_default()
            );
        }
        Mark {
            line: if whole { 0 } else { from.line + 1 },
            column: if whole { 0 } else { from.chars },
            width: to.chars - from.chars,
            primary: index == 0,
            code: finding.code.id().into(),
            words,
        }
    };
    finding.labels.iter().enumerate().map(mark).collect()
}

fn findings(name: &str, bytes: Vec<u8>) -> (SourceFile, Vec<Diagnostic>) {
    let (source, mut findings) = SourceFile::from_bytes(name, bytes).unwrap();
    let checked = check(&source);
    let (interpretation, more) = (checked.interpretation, checked.diagnostics);
    findings.extend(more);
    let failed = findings.iter().any(|finding| finding.severity() == Severity::Error);
    assert_eq!(
        interpretation.scene.is_none(),
        failed,
        "{name}: a scene comes out unless there is an error"
    );
    (source, findings)
}

/// Every way in which a file's findings differ from its marks.
fn differences(name: &str, bytes: Vec<u8>) -> Vec<String> {
    let (source, findings) = findings(name, bytes);
    let mut left: Vec<_> = findings.iter().flat_map(|finding| found(&source, finding)).collect();
    let mut wrong = Vec::new();
    for mark in expected(&source) {
        let same = |other: &Mark| {
            Mark {
                words: String::new(),
                ..other.clone()
            } == Mark {
                words: String::new(),
                ..mark.clone()
            }
        };
        match left
            .iter()
            .position(|other| same(other) && other.words.contains(&mark.words))
        {
            Some(index) => drop(left.remove(index)),
            None => wrong.push(format!("{name}: not found: {mark:?}")),
        }
    }
    wrong.extend(left.iter().map(|other| format!("{name}: not marked: {other:?}")));
    wrong
}

#[test]
fn every_fixture_has_the_findings_that_it_marks_and_no_others() {
    let wrong: Vec<_> = fixtures()
        .into_iter()
        .flat_map(|(name, bytes)| differences(&name, bytes))
        .collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn every_code_has_a_fixture() {
    let marked: BTreeSet<_> = fixtures()
        .into_iter()
        .flat_map(|(name, bytes)| expected(&SourceFile::from_bytes(name, bytes).unwrap().0))
        .map(|mark| mark.code)
        .collect();
    let missing: Vec<_> = Code::ALL
        .iter()
        .map(|code| code.id())
        .filter(|id| !marked.contains(*id))
        .collect();
    assert!(missing.is_empty(), "no fixture marks {missing:?}");
}

#[test]
fn a_missing_and_a_surplus_mark_are_both_noticed() {
    let text = "/@ E014 settings\n/@ E015 submitted\n q := 1\n/^ W009\n";
    let wrong = differences("t", text.into());
    assert_eq!(wrong.len(), 2, "{wrong:#?}");
}

#[test]
fn every_scene_of_the_project_is_clean() {
    let folder = folder().join("../../scenes");
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_some_and(|extension| extension == "scene") {
            let (_, findings) = findings(&path.to_string_lossy(), fs::read(&path).unwrap());
            // One file of the gallery is there to practise on.
            let broken = path.file_stem().is_some_and(|name| name == "broken");
            assert_eq!(findings.is_empty(), !broken, "{}: {findings:#?}", path.display());
        }
    }
}
