//! Pictures against closed forms: every pixel of a scene, in every tracer, held to a formula of its direction.

use std::fmt::Debug;

use scenec_scene::{DVec3, Scene};

use crate::{Lens, Shot, scene, shots};

/// The eye at the origin, looking along -z, in white light without a gradient; what follows may say otherwise.
const STAGE: &str = "
width := 61
height := 61
raydepth := 0
eyepos_x := 0
eyepos_y := 0
eyepos_z := 0
lookat_x := 0
lookat_y := 0
lookat_z := -1
ambient_r := 1
ambient_g := 1
ambient_b := 1
ambient_int_r := 1
ambient_int_g := 1
ambient_int_b := 1
";

/// How far from a silhouette, in pixels, a pixel's centre must lie to be held to the closed form.
const SLACK: f64 = 0.02;

/// The scene of a text on the stage.
#[must_use]
pub fn closed_stage(text: &str) -> Scene {
    scene("stage", &format!("{STAGE}{text}"))
}

/// Compares a class of every pixel (which leaf, which colour) with what geometry says, in every tracer. Only pixels
/// whose class changes within `SLACK` pixels are passed over, and there must be few.
///
/// # Panics
/// At the first pixel of another class.
pub fn check_classes<T: PartialEq + Debug>(
    text: &str,
    expect: impl Fn(DVec3) -> T,
    saw: impl Fn(&Shot, u32, u32) -> T,
) {
    let scene = closed_stage(text);
    let lens = Lens::new(&scene.settings);
    let (width, height) = (scene.settings.width, scene.settings.height);
    for shot in shots(&scene) {
        let (mut passed, mut other) = (0, 0);
        let first = expect(lens.towards(0.5, 0.5));
        for (x, y) in (0..height).flat_map(|y| (0..width).map(move |x| (x, y))) {
            let Some(class) = lens.steady(x, y, SLACK, &expect) else {
                passed += 1;
                continue;
            };
            other += u32::from(class != first);
            assert_eq!(saw(&shot, x, y), class, "{} at {x} {y} of\n{text}", shot.tracer);
        }
        assert!(
            passed * 20 <= width * height,
            "{}: {passed} pixels passed over",
            shot.tracer
        );
        assert!(
            other > 20,
            "{}: only {other} pixels tell anything of\n{text}",
            shot.tracer
        );
    }
}

/// Compares the colour of every pixel with a formula of its direction, where the formula holds.
///
/// # Panics
/// At the first pixel that is further off than the tolerance for its tracer's precision.
pub fn check_colours(scene: &Scene, single: f64, double: f64, expect: impl Fn(DVec3) -> Option<[f64; 3]>) {
    let lens = Lens::new(&scene.settings);
    let (width, height) = (scene.settings.width, scene.settings.height);
    for shot in shots(scene) {
        let mut compared = 0;
        for (x, y) in (0..height).flat_map(|y| (0..width).map(move |x| (x, y))) {
            let Some(colour) = expect(lens.towards(f64::from(x) + 0.5, f64::from(y) + 0.5)) else {
                continue;
            };
            compared += 1;
            let found = shot.colour(x, y);
            let tolerance = if shot.single { single } else { double };
            let near = (0..3).all(|i| (found[i] - colour[i]).abs() <= tolerance);
            assert!(near, "{} at {x} {y}: {found:?}, not {colour:?}", shot.tracer);
        }
        assert!(
            compared * 8 >= width * height,
            "{}: only {compared} compared",
            shot.tracer
        );
    }
}

/// The distance along a unit direction to a ball.
#[must_use]
pub fn meets(eye: DVec3, direction: DVec3, centre: DVec3, radius: f64) -> Option<f64> {
    let way = centre - eye;
    let along = way.dot(direction);
    let off = (way - along * direction).length();
    (along > 0.0 && off < radius).then(|| along - (radius * radius - off * off).sqrt())
}
