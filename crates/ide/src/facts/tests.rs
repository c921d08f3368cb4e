//! Facts are read off the statements; here they are held to the scene that the interpreter makes of the same text.

use std::collections::HashMap;
use std::path::Path;

use scenec_interpret::DefinitionId;
use scenec_scene::{MaterialId, Scene, SolidKind, Transform};
use scenec_syntax::Statement;
use scenec_text::{SourceFile, Span};

use crate::Document;
use crate::solid::Standing;

/// What the scene says of all copies of a base object together.
#[derive(Default)]
struct Seen {
    bare: bool,
    painted: bool,
    /// The last copy: where it went, and its material.
    last: Option<(Transform, MaterialId)>,
}

/// One pass back over the scene, by the statements that made the leaves.
fn seen(scene: &Scene) -> HashMap<Span, Seen> {
    let mut reached = vec![(false, false); scene.solids.len()];
    reached[scene.root.index()].0 = true;
    let mut seen: HashMap<Span, Seen> = HashMap::new();
    for (index, solid) in scene.solids.iter().enumerate().rev() {
        let (bare, painted) = reached[index];
        match &solid.kind {
            SolidKind::Combine { left, right, .. } => {
                for operand in [left, right] {
                    reached[operand.index()].0 |= bare;
                    reached[operand.index()].1 |= painted;
                }
            }
            SolidKind::Paint { inside, .. } => reached[inside.index()].1 |= bare || painted,
            SolidKind::Leaf(leaf) => {
                let seen = seen.entry(solid.span).or_default();
                seen.bare |= bare;
                seen.painted |= painted;
                seen.last.get_or_insert((scene.transform(leaf), leaf.material));
            }
        }
    }
    seen
}

/// Compares every base object of a text; gives how many there were, none where the text has an error.
fn check(text: &str) -> usize {
    let document = Document::new(SourceFile::new("t", text).unwrap());
    let Some(scene) = document.scene() else {
        return 0;
    };
    let seen = seen(scene);
    let mut count = 0;
    for (id, definition) in document.interpretation().symbols.numbered_definitions() {
        let statement = document.statement_at(definition.line.start).map(|found| found.0);
        if matches!(statement, Some(Statement::Object { .. })) {
            compare(&document, scene, id, &seen[&definition.line]);
            count += 1;
        }
        if let Some(Statement::Variable { value, .. }) = statement {
            assert_eq!(document.number(value), document.facts().value(id), "{text}");
        }
    }
    count
}

fn compare(document: &Document, scene: &Scene, id: DefinitionId, seen: &Seen) {
    let told = document.facts().taken(id);
    let text = document.text();
    assert_eq!(
        told.is_some(),
        seen.bare || seen.painted,
        "{} in {text}",
        document.name_of(id)
    );
    if let Some(told) = told {
        assert_eq!((told.bare, told.painted.is_some()), (seen.bare, seen.painted), "{text}");
    }
    let standing = Standing::of(document, id, u32::MAX).unwrap();
    let (transform, material) = seen.last.unwrap();
    assert_eq!(standing.transform, transform, "{} in {text}", document.name_of(id));
    let line = scene.material(material).span;
    let painted = standing.paint.and_then(|(_, paint)| document.definition_of(paint));
    assert_eq!(
        painted.map(|paint| paint.line),
        line,
        "{} in {text}",
        document.name_of(id)
    );
}

/// The texts of a folder of the repository.
fn texts(folder: &str) -> Vec<String> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(folder);
    let mut paths: Vec<_> = std::fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .collect();
    paths.retain(|path| path.extension().is_some_and(|extension| extension == "scene"));
    paths.sort();
    paths
        .iter()
        .filter_map(|path| std::fs::read_to_string(path).ok())
        .collect()
}

#[test]
fn objects_are_what_the_scene_has() {
    let all = ["scenes", "tests/fixtures", "tests/povray"].map(texts).concat();
    assert!(all.iter().map(|text| check(text)).sum::<usize>() > 200);
}

#[test]
fn objects_of_shuffled_statements_are_what_the_scene_has() {
    let settings: String = texts("scenes")[0]
        .lines()
        .filter(|line| line.starts_with(|first: char| first.is_alphabetic()))
        .map(|line| format!("{line}\n"))
        .collect();
    let lines = [
        "!a := sphere",
        "!b := hp",
        "!a += 1 x 0",
        "!a *= 2 1 -1",
        "!b #z= x",
        "!a ?= m",
        "!b ?= n",
        "!u := a | b",
        "!u := u - a",
        "!b := a & u",
        "!u ?= m",
        "!v := u | u",
        "!v ?= n",
        "!u <=",
        "!v <=",
        "!a <=",
        "x := 2",
        "x := -y",
        "y := x",
        "?m := 1 x 1 1 0 1 1 1 1 1",
        "?n := 0 0 0 0 0 1 1 0 0 y",
    ];
    let mut random = 0x2545_f491_4f6c_dd1d_u64;
    let mut count = 0;
    for _ in 0..3000 {
        let mut text = settings.clone();
        for _ in 0..28 {
            random ^= random << 13;
            random ^= random >> 7;
            random ^= random << 17;
            let line = usize::try_from(random % lines.len() as u64).unwrap();
            text.push_str(lines[line]);
            text.push('\n');
        }
        text.push_str("!a <=\n!u <=\n");
        count += check(&text);
    }
    assert!(count > 1000, "{count}");
}
