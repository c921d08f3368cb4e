//! POV-Ray as a second opinion: scenes written for both, each surface in a flat colour of its own, must show the same
//! surface in every pixel but for those on an edge.
//!
//! `tests/povray/NAME.scene` and `NAME.pov` are translations of each other; each `.pov` tells how the axes carry over.

#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a test may stop at once and tell what it skips"
)]

use std::path::{Path, PathBuf};
use std::process::Command;

use scenec_measure::povray;
use scenec_picture::NOTHING;
use scenec_scene::Scene;
use scenec_tests::{Shot, closed_stage, gallery, root, scene, shots};

/// Colours are made of 0 and 1 alone, so that three bits name one; this is the sky's.
const WHITE: u8 = 7;

/// One colour a pixel.
type Mask = Vec<u8>;

fn class(colour: [f64; 3]) -> u8 {
    colour.iter().fold(0, |class, value| {
        assert!(*value < 0.01 || *value > 0.99, "{colour:?} is no flat colour");
        class * 2 + u8::from(*value > 0.5)
    })
}

fn has_povray() -> bool {
    let found = povray::is_there();
    assert!(
        found || std::env::var_os("SCENEC_REQUIRE_POVRAY").is_none(),
        "SCENEC_REQUIRE_POVRAY is set, so povray must be on the path"
    );
    found
}

fn names() -> Vec<PathBuf> {
    let folder = std::fs::read_dir(root().join("tests/povray")).unwrap();
    let paths = folder.map(|entry| entry.unwrap().path());
    let mut scenes: Vec<_> = paths
        .filter(|path| path.extension().is_some_and(|e| e == "scene"))
        .collect();
    scenes.sort();
    scenes
}

/// What POV-Ray sees, without anti-aliasing or gamma.
fn by_povray(pov: &Path, scene: &Scene) -> Mask {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("out.ppm");
    let (width, height) = (scene.settings.width, scene.settings.height);
    let run = Command::new("povray")
        .arg(format!("+I{}", pov.display()))
        .arg(format!("+O{}", out.display()))
        .args([format!("+W{width}"), format!("+H{height}")])
        .args(["+FP8", "-A", "-D", "-P", "+WT1", "File_Gamma=1.0"])
        .env("HOME", folder.path())
        .current_dir(folder.path())
        .output()
        .unwrap();
    let log = String::from_utf8_lossy(&run.stderr);
    assert!(run.status.success(), "{}: {log}", pov.display());
    let bytes = std::fs::read(out).unwrap();
    let pixels = (width * height * 3) as usize;
    assert!(bytes.starts_with(b"P6") && bytes.len() > pixels, "{}", pov.display());
    let (rgb, _) = bytes[bytes.len() - pixels..].as_chunks::<3>();
    rgb.iter()
        .map(|rgb| class(rgb.map(|value| f64::from(value) / 255.0)))
        .collect()
}

fn by_us(shot: &Shot) -> Mask {
    let ids = shot.frame.ids.as_ref().unwrap();
    let pixels = shot.frame.picture.pixels().iter().zip(ids);
    let mask = |(colour, id): (&[f32; 3], &u32)| {
        let class = class(colour.map(f64::from));
        assert_eq!(class == WHITE, *id == NOTHING, "{}", shot.tracer);
        class
    };
    pixels.map(mask).collect()
}

/// How many pixels differ; none may but where the other's colour is next to it.
fn differing(who: &str, ours: &Mask, theirs: &Mask, width: usize) -> usize {
    let height = ours.len() / width;
    let beside = |i: usize| {
        let (x, y) = (i % width, i / width);
        let columns = x.saturating_sub(1)..(x + 2).min(width);
        let mut rows = y.saturating_sub(1)..(y + 2).min(height);
        rows.any(|row| columns.clone().any(|column| ours[row * width + column] == theirs[i]))
    };
    let differing: Vec<_> = (0..ours.len()).filter(|i| ours[*i] != theirs[*i]).collect();
    let astray: Vec<_> = differing
        .iter()
        .filter(|i| !beside(**i))
        .map(|i| (i % width, i / width))
        .collect();
    assert!(
        astray.is_empty(),
        "{who}: {} pixels away from any edge: {:?}",
        astray.len(),
        &astray[..astray.len().min(9)]
    );
    differing.len()
}

/// Whether there is one; says so if not.
fn ready() -> bool {
    let found = has_povray();
    if !found {
        println!("skipped: there is no povray");
    }
    found
}

#[test]
fn the_gallery_means_the_same_in_its_language() {
    if !ready() {
        return;
    }
    for (name, mut scene) in gallery() {
        (scene.settings.width, scene.settings.height) = (96, 72);
        let shot = shots(&scene).swap_remove(0);
        let theirs = povray::leaves(&scene).unwrap_or_else(|reason| panic!("{name}: {reason}"));
        let astray = povray::astray(&theirs, shot.frame.ids.as_ref().unwrap(), 96);
        assert!(astray < 0.001, "{name}: {astray} of the pixels off the edges");
    }
}

#[test]
fn povray_sees_the_same_surfaces() {
    if !ready() {
        return;
    }
    let scenes = names();
    assert!(scenes.len() >= 5);
    for path in scenes {
        let name = path.file_stem().unwrap().to_string_lossy().into_owned();
        let scene = scene(&name, &std::fs::read_to_string(&path).unwrap());
        let theirs = by_povray(&path.with_extension("pov"), &scene);
        for shot in shots(&scene) {
            let ours = by_us(&shot);
            let who = format!("{name} by {}", shot.tracer);
            let colours = (0..=WHITE).filter(|c| ours.iter().filter(|o| *o == c).count() * 200 > ours.len());
            assert!(colours.count() >= 3, "{who}: nothing much to compare");
            let differing = differing(&who, &ours, &theirs, scene.settings.width as usize);
            println!("{who}: {differing} of {} pixels differ", ours.len());
            assert!(differing * 1000 < ours.len(), "{who}: {differing} pixels differ");
        }
    }
}

#[test]
fn what_would_take_it_too_long_is_not_asked() {
    let balls = |count: u32, op: &str| {
        let ball = |k: u32| format!("!b := sphere\n!b += {k} 0 -9\n!c := c {op} b\n");
        let text: String = (0..count).map(ball).collect();
        closed_stage(&format!("!c := sphere\n{text}!c <=\n"))
    };
    for (count, op, asked) in [
        (2047, "|", true),
        (2048, "|", false),
        (50_000, "|", false),
        (3000, "-", false),
    ] {
        let told = povray::text(&balls(count, op));
        match told {
            Ok(_) => assert!(asked, "{count} {op}"),
            Err(reason) => assert!(
                !asked && reason == "not asked: more than 2048 objects",
                "{count} {op}: {reason}"
            ),
        }
    }
}
