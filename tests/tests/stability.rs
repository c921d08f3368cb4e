//! The stability suite: every awkward case through every tracer that there is.

#![allow(clippy::unwrap_used, clippy::print_stdout, reason = "a test may stop at once")]

use scenec_interpret::scene_of;
use scenec_measure::stability::{Machines, Verdict, cases, judge, summary, table};
use scenec_plan::plan;
use scenec_tests::{device, gallery, root};

#[test]
fn the_gallery_needs_no_doubles() {
    for (name, scene) in gallery() {
        assert_eq!(plan(&scene).unwrap().beyond_single(), None, "{name}");
    }
}

/// What is the same on every machine in the rows of a table of cases: the case, how many members it has, for how many of them
/// doubles are taken, and the verdict, without what it says of devices that are not there.
fn steady(text: &str) -> Vec<String> {
    let is_case = |line: &&str| matches!(line.as_bytes(), [b'|', b' ', b'0'..=b'9', b'0'..=b'9', b'-', ..]);
    let cell = |cell: &str| cell.split(';').next().unwrap_or_default().trim().to_owned();
    let cells = |line: &str| line.split('|').take(5).map(cell).collect::<Vec<_>>().join(" | ");
    text.lines().filter(is_case).map(cells).collect()
}

#[test]
fn every_awkward_case_holds() {
    let machines = Machines {
        device: device(),
        ..Machines::default()
    };
    let mut verdicts = Vec::new();
    for case in cases().unwrap() {
        let judged = case
            .runs()
            .iter()
            .map(|run| judge(&case, run, &scene_of, &machines).unwrap());
        verdicts.extend(judged);
    }
    let table = table(&verdicts);
    println!("{table}");
    assert!(verdicts.iter().all(Verdict::holds), "{table}");
    let page = std::fs::read_to_string(root().join("docs/accuracy.md")).unwrap();
    assert_eq!(
        steady(&page),
        steady(&summary(&verdicts)),
        "docs/accuracy.md shows another table"
    );
}
