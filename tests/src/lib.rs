//! What the tests across crates share: scenes from text, seeded random scenes, and how two tracers' frames are compared.

mod agree;
mod closed;
mod flat;
mod kinds;
mod random;
mod shots;

use std::path::PathBuf;

use scenec_scene::Scene;
use scenec_text::{Fix, SourceFile};

pub use agree::{Disagreement, Mask, compare};
pub use closed::{check_classes, check_colours, closed_stage, meets};
pub use flat::{BLUE, RED, check_all, check_empty, check_middle, flat_stage, middle, near};
pub use kinds::Programs;
pub use random::{aligned_scene, random_scene};
pub use scenec_measure::Numbers;
pub use shots::{Lens, Shot, device, frame, shots, shots_of};

/// The project's top folder.
#[must_use]
pub fn root() -> PathBuf {
    PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/.."))
}

/// The scene of a text that has no errors.
///
/// # Panics
/// With all findings, if it has some.
#[must_use]
pub fn scene(name: &str, text: &str) -> Scene {
    let Ok(source) = SourceFile::new(name, text) else {
        panic!("{name} is too large");
    };
    let (interpretation, diagnostics) = scenec_interpret::analyse(&source);
    interpretation
        .scene
        .unwrap_or_else(|| panic!("{name}: {diagnostics:#?}\n{text}"))
}

/// The scenes of the gallery that are meant to render, by name, in order.
///
/// # Panics
/// If the gallery can't be read.
#[must_use]
pub fn gallery() -> Vec<(String, Scene)> {
    let Ok(folder) = std::fs::read_dir(root().join("scenes")) else {
        panic!("there is no gallery");
    };
    let mut scenes: Vec<_> = folder
        .filter_map(|entry| entry.ok().map(|entry| entry.path()))
        .filter(|path| path.extension().is_some_and(|extension| extension == "scene"))
        .filter_map(|path| {
            path.file_stem()
                .map(|name| (name.to_string_lossy().into_owned(), path.clone()))
        })
        .filter(|(name, _)| name != "broken")
        .map(|(name, path)| {
            let text = std::fs::read_to_string(&path).unwrap_or_default();
            let scene = scene(&name, &text);
            (name, scene)
        })
        .collect();
    scenes.sort_by(|a, b| a.0.cmp(&b.0));
    scenes
}

/// The text after a repair.
///
/// # Panics
/// If its edits overlap.
#[must_use]
pub fn mended(text: &str, fix: &Fix) -> String {
    let mut edits = fix.edits.clone();
    edits.sort_by_key(|edit| edit.span);
    assert!(
        edits.windows(2).all(|pair| pair[0].span.end <= pair[1].span.start),
        "{fix:?}"
    );
    let mut text = text.to_owned();
    for edit in edits.iter().rev() {
        text.replace_range(edit.span.range(), &edit.text);
    }
    text
}
