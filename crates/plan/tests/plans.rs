//! What is left of a scene in its plan.

#![allow(clippy::unwrap_used, reason = "a test may, in its helpers too")]

use std::fmt::Write;

use scenec_plan::{Features, Plan, PlanError, plan};
use scenec_text::SourceFile;

const SETTINGS: &str = "width := 8\nheight := 8\nlookat_x := 0\nlookat_y := 0\nlookat_z := 0\neyepos_x := 0\n\
    eyepos_y := 0\neyepos_z := 9\nambient_r := 1\nambient_g := 1\nambient_b := 1\nambient_int_r := 1\n\
    ambient_int_g := 1\nambient_int_b := 1\nraydepth := 3\n!s := sphere\n!t := sphere\n!t += 0.5 0 0\n!h := hp\n";

fn planned(text: &str) -> Result<Plan, PlanError> {
    let source = SourceFile::new("test", format!("{SETTINGS}{text}")).unwrap();
    let (interpretation, diagnostics) = scenec_interpret::analyse(&source);
    plan(&interpretation.scene.unwrap_or_else(|| panic!("{diagnostics:#?}")))
}

/// Checks the number of islands, of leaves and of all islands' instructions.
fn check(text: &str, islands: usize, leaves: usize, instructions: usize) {
    let plan = planned(text).unwrap();
    let seen = (plan.islands.len(), plan.leaves.len(), plan.program.len());
    assert_eq!(seen, (islands, leaves, instructions), "{text}");
}

#[test]
fn unions_become_islands_and_what_adds_nothing_goes() {
    check("!s <=", 1, 1, 1);
    check("!u := s | t\n!v := u | h\n!v <=", 3, 3, 3);
    check("!u := s | s\n!u <=", 1, 1, 1);
    check("!a := sphere\n!u := s | a\n!u <=", 1, 1, 1);
    check("!u := s | t\n!v := u | u\n!w := v | u\n!w <=", 2, 2, 2);
    check("!u := s & t\n!v := u | h\n!v <=", 2, 3, 3);
    check(
        "!u := s & t\n!v := u - h\n!w := s | h\n!w := w & t\n!x := v | w\n!x <=",
        2,
        3,
        8,
    );
    check("!u := s - s\n!v := u | h\n!v <=", 1, 1, 1);
    check(
        "!far := sphere\n!far += 9 0 0\n!u := s & far\n!v := u | t\n!v <=",
        1,
        1,
        1,
    );
}

#[test]
fn a_solid_with_itself_is_itself_however_often() {
    let doubled: String = (0..100).map(|i| format!("!d{} := d{i} & d{i}\n", i + 1)).collect();
    check(&format!("!d0 := s & t\n{doubled}!d100 <="), 1, 2, 2);
}

#[test]
fn a_tree_that_grows_without_bound_is_refused_with_the_figure() {
    let mut text = String::from("!d0 := s & t\n");
    for i in 0..40 {
        text += &format!("!e{i} := d{i} | t\n!f{i} := d{i} - h\n!d{} := e{i} - f{i}\n", i + 1);
    }
    let error = planned(&format!("{text}!d40 <=")).unwrap_err();
    assert!(
        matches!(error, PlanError::ProgramTooLarge { leaves } if leaves > 1 << 40),
        "{error}"
    );
    assert!(error.to_string().contains("16777216"), "{error}");
}

#[test]
fn only_what_the_scene_needs_is_on() {
    let features = Features::of(&planned("!s <=").unwrap());
    assert!(features.balls && !features.ellipsoids && !features.half_spaces && !features.programs);
    assert!(!features.lights && !features.highlights && !features.reflections && !features.inside);
    let glass = "?g := 0 0 0.5 0.1 0.9 1.5 50 1 1 1\n!s ?= g\n!u := s - h\n*l := 5 5 5 1 1 1\n!u <=";
    let features = Features::of(&planned(glass).unwrap());
    assert!(features.lights && features.highlights && features.branching && features.inside);
    assert!(features.products && !features.programs && !features.cells);
    assert_eq!((features.waiting, features.members), (4, 2));
}

/// A ball minus many small ones, seen with so many samples for each of its few pixels: the number of its cells.
fn cells(samples: u32) -> usize {
    let mut text = format!("samples := {samples}\n");
    for number in 0..300_u32 {
        let [x, y, z] = [1, 7, 49].map(|step| f64::from(number * step % 101) / 50.0 - 1.0);
        write!(text, "!b := sphere\n!b *= .1 .1 .1\n!b += {x} {y} {z}\n!s := s - b\n").unwrap();
    }
    planned(&format!("{text}!s <=\n")).unwrap().cells.len()
}

#[test]
fn cells_are_as_many_as_the_rays_that_meet_them_are_worth() {
    let [few, many] = [1, 256].map(cells);
    assert!(0 < few && few < many, "{few} {many}");
}

#[test]
fn the_eye_knows_where_it_stands() {
    for (place, expect) in [("0 0 9", true), ("0 0 0", false), ("3 0 9", false)] {
        let plan = planned(&format!("!e := sphere\n!e += {place}\n!u := e - h\n!v := u | e\n!v <=")).unwrap();
        assert_eq!(plan.standpoint.in_front, expect, "{place}");
    }
}
