//! The manual of the rules: every code has a page, its examples do what they say, and the files in `docs/rules` are those
//! pages. `SCENEC_BLESS=1` writes the files anew.

#![allow(clippy::unwrap_used, reason = "a test may stop at once")]

use std::collections::BTreeMap;
use std::fs;

use scenec_lint::{PRELUDE, check, page, pages};
use scenec_tests::root;
use scenec_text::{Code, Severity, SourceFile};

/// The codes of a scene in a page; `\xE9` there is the byte E9.
fn codes(scene: &str) -> Vec<Code> {
    let mut bytes = Vec::new();
    let mut parts = scene.split("\\x");
    bytes.extend_from_slice(parts.next().unwrap().as_bytes());
    for part in parts {
        let (digits, rest) = part.split_at(2);
        bytes.push(u8::from_str_radix(digits, 16).unwrap());
        bytes.extend_from_slice(rest.as_bytes());
    }
    let (source, mut findings) = SourceFile::from_bytes("example", bytes).unwrap();
    findings.extend(check(&source).diagnostics);
    findings.iter().map(|finding| finding.code).collect()
}

#[test]
fn every_code_has_a_page_and_every_page_says_what_to_do() {
    for code in Code::ALL {
        let page = page(*code).unwrap_or_else(|| panic!("{} has no page", code.id()));
        let text = page.text();
        assert!(text.len() > 100 && !text.starts_with('#'), "{}:\n{text}", page.title());
        assert_eq!(text.matches("\n## ").count(), 2, "{}", page.title());
    }
    assert_eq!(pages().len(), Code::ALL.len());
}

#[test]
fn every_example_raises_its_code_and_nothing_else_and_its_repair_is_clean() {
    let mut wrong = Vec::new();
    for page in pages() {
        let found = codes(&page.scene("Example").unwrap());
        if found.is_empty() || found.iter().any(|code| *code != page.code) {
            wrong.push(format!("{}: the example raises {found:?}", page.title()));
        }
        let found = codes(&page.scene("Fixed").unwrap());
        if !found.is_empty() {
            wrong.push(format!("{}: the fixed one raises {found:?}", page.title()));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn the_settings_that_the_examples_leave_out_are_clean() {
    assert_eq!(codes(&format!("{PRELUDE}!ball := sphere\n!ball <=\n")), []);
}

/// The files of the manual by name.
fn manual() -> BTreeMap<String, String> {
    let pages = pages();
    let mut files: BTreeMap<_, _> = pages.iter().map(|page| (page.file_name(), page.whole())).collect();
    let mut index = String::from(
        "# Rules\n\nWhat `scenec check` finds. `scenec explain CODE` prints a page. Errors keep a file from being rendered; \
         warnings and hints\ncan be silenced by a comment, `/ scenec: allow W012, W013`, at the end of a line, on a line of \
         its own above it, or, before\nthe first statement, for the whole file.\n",
    );
    for (severity, title) in [
        (Severity::Error, "Errors"),
        (Severity::Warning, "Warnings"),
        (Severity::Hint, "Hints"),
    ] {
        index.push_str(&format!("\n## {title}\n\n| code | finds |\n|---|---|\n"));
        for page in pages.iter().filter(|page| page.code.severity() == severity) {
            let (id, finds) = (page.code.id(), page.code.summary().trim_end_matches('.'));
            index.push_str(&format!("| [{id}]({}) | {finds} |\n", page.file_name()));
        }
    }
    index.push_str(&format!(
        "\n## The examples\n\nThe examples of the pages leave out the settings; put these before them to try one.\n\n\
         ```scene\n{PRELUDE}```\n"
    ));
    files.insert("README.md".to_owned(), index);
    files
}

#[test]
fn the_manual_is_fresh() {
    let folder = root().join("docs/rules");
    let expect = manual();
    if std::env::var_os("SCENEC_BLESS").is_some() {
        fs::create_dir_all(&folder).unwrap();
        for entry in fs::read_dir(&folder).unwrap() {
            fs::remove_file(entry.unwrap().path()).unwrap();
        }
        for (name, text) in &expect {
            fs::write(folder.join(name), text).unwrap();
        }
    }
    let found: BTreeMap<_, _> = fs::read_dir(&folder)
        .unwrap()
        .map(|entry| entry.unwrap())
        .map(|entry| {
            let name = entry.file_name().to_string_lossy().into_owned();
            (name, fs::read_to_string(entry.path()).unwrap())
        })
        .collect();
    let stale: Vec<_> = expect
        .keys()
        .chain(found.keys())
        .filter(|name| expect.get(*name) != found.get(*name))
        .collect();
    assert!(
        stale.is_empty(),
        "{stale:?} differ from the pages: run this test with SCENEC_BLESS=1"
    );
}
