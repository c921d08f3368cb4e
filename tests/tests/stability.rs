//! The stability suite: every awkward case through every tracer that there is.

#![allow(clippy::unwrap_used, clippy::print_stdout, reason = "a test may stop at once")]

use scenec_measure::stability::{Machines, Verdict, cases, judge, table};
use scenec_plan::plan;
use scenec_scene::Scene;
use scenec_tests::{device, gallery};
use scenec_text::{Severity, SourceFile};

#[test]
fn the_gallery_needs_no_doubles() {
    for (name, scene) in gallery() {
        assert_eq!(plan(&scene).unwrap().beyond_single(), None, "{name}");
    }
}

fn read(text: &str) -> Result<Scene, Vec<String>> {
    let (interpretation, diagnostics) = scenec_interpret::analyse(&SourceFile::new("case", text).unwrap());
    let errors = diagnostics.iter().filter(|one| one.severity() == Severity::Error);
    interpretation
        .scene
        .ok_or_else(|| errors.map(|one| one.code.id().to_owned()).collect())
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
            .map(|run| judge(&case, run, &read, &machines).unwrap());
        verdicts.extend(judged);
    }
    let table = table(&verdicts);
    println!("{table}");
    assert!(verdicts.iter().all(Verdict::holds), "{table}");
}
