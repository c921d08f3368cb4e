//! What a file means: the scene that comes out, and the findings that come with it.

#![allow(clippy::unwrap_used, reason = "a test may stop at once")]

use scenec_interpret::{Interpretation, Role, analyse};
use scenec_scene::{DVec3, MaterialId, Scene, SolidKind};
use scenec_text::{Code, Diagnostic, SourceFile};

/// Every required setting, on the first line numbers of the file.
const SETTINGS: &str = "width := 8\nheight := 6\nraydepth := 2\nlookat_x := 0\nlookat_y := 0\nlookat_z := 0\n\
    eyepos_x := 0\neyepos_y := 1\neyepos_z := 5\nambient_r := 0\nambient_g := 0\nambient_b := 0\n\
    ambient_int_r := 1\nambient_int_g := 1\nambient_int_b := 1\n";

fn read(text: &str) -> (Interpretation, Vec<Diagnostic>) {
    analyse(&SourceFile::new("t", text).unwrap())
}

/// What stands after the settings, and the codes of its findings.
fn check(body: &str, expect: &[Code]) {
    let (interpretation, findings) = read(&format!("{SETTINGS}{body}"));
    let codes: Vec<_> = findings.iter().map(|finding| finding.code).collect();
    assert_eq!(codes, expect, "{body:?}: {findings:#?}");
    let errors = findings.iter().any(|finding| finding.code.id().starts_with('E'));
    assert_eq!(interpretation.scene.is_none(), errors, "{body:?}");
}

fn scene(body: &str) -> Scene {
    let (interpretation, findings) = read(&format!("{SETTINGS}{body}"));
    interpretation
        .scene
        .unwrap_or_else(|| panic!("{body:?}: {findings:#?}"))
}

/// The leaves that the root reaches, left to right: place and material.
fn leaves(scene: &Scene) -> Vec<(DVec3, MaterialId)> {
    let mut found = Vec::new();
    let mut open = vec![(scene.root, None)];
    while let Some((id, paint)) = open.pop() {
        match &scene.solid(id).kind {
            SolidKind::Leaf(leaf) => found.push((scene.transform(leaf).centre, paint.unwrap_or(leaf.material))),
            SolidKind::Combine { left, right, .. } => open.extend([(*right, paint), (*left, paint)]),
            SolidKind::Paint { inside, material } => open.push((*inside, paint.or(Some(*material)))),
        }
    }
    found
}

#[test]
fn binding_is_by_value() {
    let scene =
        scene("?m := 0 0 0 0 0 1 1 1 1 1\n!a := sphere\n!b := a | a\n!a += 1 0 0\n!a ?= m\n!c := b | a\n!c <=\n");
    let at = |x: f64, m: u32| (DVec3::new(x, 0.0, 0.0), MaterialId(m));
    assert_eq!(leaves(&scene), [at(0.0, 0), at(0.0, 0), at(1.0, 1)]);
    // `a | a` shares its leaf, the edit made a second one, and two combinations follow.
    assert_eq!(scene.solids.len(), 4);
}

#[test]
fn a_material_given_to_a_combination_reaches_every_leaf_of_it_alone() {
    let scene = scene(
        "?m := 0 0 0 0 0 1 1 1 1 1\n?n := 0 0 0 0 0 1 1 1 1 1\n!a := sphere\n!a ?= m\n!b := hp\n!c := a - b\n!d := c | c\n\
         !c ?= m\n!c ?= n\n!e := d | c\n!e <=\n",
    );
    let materials: Vec<_> = leaves(&scene).iter().map(|(_, material)| material.0).collect();
    assert_eq!(materials, [1, 0, 1, 0, 2, 2]);
}

#[test]
fn the_last_binding_before_a_use_counts_and_settings_are_read_at_the_end() {
    let scene = scene(
        "r := 2\n!a := sphere\n!a += r -r +pi\nr := 3\n!a += r 0 0\n!a <=\nwidth := 9\n?x := 0 0 0 0 0 1 r 1 1 1\n",
    );
    assert_eq!(leaves(&scene)[0].0, DVec3::new(5.0, -2.0, std::f64::consts::PI));
    assert_eq!(scene.settings.width, 9);
    assert_eq!(scene.materials[1].shiny, 3.0);
}

#[test]
fn lights_keep_the_order_of_their_names() {
    let scene = scene("!a := sphere\n!a <=\n*x := 1 0 0 1 1 1\n*y := 2 0 0 1 1 1\n*x := 3 0 0 1 1 1\n");
    let xs: Vec<_> = scene.lights.iter().map(|light| light.position.x).collect();
    assert_eq!(xs, [3.0, 2.0]);
}

#[test]
fn one_cause_has_one_report() {
    use Code::{TransformedCombination, UnexpectedToken, UnknownBase, UnknownObject, UnknownVariable, ZeroScale};
    check(
        "!a := sphre\n!a += 1 0 0\n!b := a | a\n!b ?= m\n!b <=\n",
        &[UnknownBase, Code::UnknownMaterial],
    );
    check(
        "r := 5 |\n!a := sphere\n!a *= r r r\ns := r\n!a += s s s\n!a <=\n",
        &[UnexpectedToken],
    );
    check(
        "!a := sphere\n!a += q q p\n!a <=\n",
        &[UnknownVariable, UnknownVariable],
    );
    check("!a := b | b\n!c := sphere\n!c <=\n", &[UnknownObject]);
    check(
        "!a := sphere\n!b := a | a\n!b += 1 0 0\n!b <=\n",
        &[TransformedCombination],
    );
    check("!a := sphere\n!a *= 1 0 1\n!a <=\n", &[ZeroScale]);
    check("!a := sphere\n!a <= now\n", &[Code::TooManyValues]);
    check(
        "width := 1e\nm := sphere\n!a := sphere\n!a <=\n",
        &[Code::MalformedNumber, UnknownVariable],
    );
}

#[test]
fn a_comment_that_swallowed_a_file_of_carriage_returns_is_told() {
    let (_, findings) = read(&format!("/ A scene\n{SETTINGS}!a := sphere\n!a <=\n").replace('\n', "\r"));
    let helps: Vec<_> = findings.iter().filter_map(|finding| finding.help.as_deref()).collect();
    assert!(helps[0].contains("carriage returns alone"), "{helps:?}");
}

#[test]
fn edits_that_do_nothing_are_told() {
    use Code::{AfterSubmission, MaterialRedefined, OperandEdited, OverwrittenUnused, UnknownBase, UnusedVariable};
    let m = "?m := 0 0 0 0 0 1 1 1 1 1\n";
    check(
        "!a := sphere\n!b := a | a\n!a += 1 0 0\n!a *= 2 2 2\n!b <=\n",
        &[OperandEdited; 2],
    );
    check("!a := sphere\n!b := a | a\n!a += 1 0 0\n!b := b | a\n!b <=\n", &[]);
    check(
        "!a := sphere\n!b := a | a\n!a += 1 0 0\n!a := hp\n!b <=\n",
        &[OperandEdited],
    );
    check(&format!("{m}!a := sphere\n!a ?= m\n{m}!a <=\n"), &[MaterialRedefined]);
    check(&format!("{m}!a := sphere\n!a ?= m\n{m}!a ?= m\n!a <=\n"), &[]);
    check(
        &format!("{m}!a := sphere\n!a ?= m\n{m}{m}!a <=\n"),
        &[OverwrittenUnused, MaterialRedefined],
    );
    check(&format!("{m}{m}!a := sphere\n!a ?= m\n!a <=\n"), &[OverwrittenUnused]);
    check("!a := sphere\n!a += 1 0 0\n!a := hp\n!a <=\n", &[OverwrittenUnused]);
    check(
        "*l := 0 0 0 0 0 0\n*l := 1 1 1 1 1 1\n!a := hp\n!a <=\n",
        &[OverwrittenUnused],
    );
    check("width := 7\n!a := hp\n!a <=\n", &[OverwrittenUnused]);
    check("q := 7\n!a := hp\n!a <=\n", &[UnusedVariable]);
    check("q := 7\n!a := hp\n!a += q q q\nq := 8\n!a <=\n", &[UnusedVariable]);
    check(
        "!a := hp\n!a <=\n!b := a | a\n!a += 1 0 0\n!a <=\n!c := sphere\n",
        &[AfterSubmission; 4],
    );
    // What is no statement at all is an error wherever it stands.
    check("!a := hp\n!a <=\n!c := nothing\n", &[UnknownBase]);
}

#[test]
fn a_chain_of_unions_needs_no_stack() {
    let mut text = format!("{SETTINGS}!s := sphere\n!u := s | s\n");
    text.push_str(&"!u := u | s\n".repeat(100_000));
    text.push_str("!u <=\n");
    let count = std::thread::Builder::new()
        .stack_size(256 * 1024)
        .spawn(move || read(&text).0.scene.map(|scene| scene.solids.len()))
        .unwrap()
        .join()
        .unwrap();
    assert_eq!(count, Some(100_002));
}

#[test]
fn a_file_of_misspelt_names_ends_in_time() {
    let mut text = SETTINGS.to_owned();
    for i in 0..20_000 {
        text.push_str(&format!("name{i} := 1\n!a += nam{i} 0 0\n"));
    }
    assert_eq!(read(&text).1.len(), 60_001);
    let unbound: String = (0..100_000).map(|i| format!("a{i} := b{i}\n")).collect();
    assert_eq!(read(&unbound).1.len(), 100_002);
}

#[test]
fn the_symbol_table_tells_every_place_of_a_name() {
    let text = "r := 1\n!r := sphere\n!r += r 0 r\n!r <=\n";
    let (interpretation, _) = read(text);
    let symbols = &interpretation.symbols;
    assert_eq!(symbols.symbols().len(), 2);
    let at = |offset: usize| symbols.at(u32::try_from(offset).unwrap()).unwrap();
    let variable = at(0);
    assert_eq!(
        (variable.role, at(8).role, at(21).role),
        (Role::Define, Role::Define, Role::Edit)
    );
    assert_eq!(at(text.find("r 0").unwrap()).symbol, variable.symbol);
    assert_eq!(symbols.places(variable.symbol).count(), 3);
    assert_eq!(symbols.places(at(8).symbol).count(), 3);
    assert_eq!(symbols.at(4), None);
}
