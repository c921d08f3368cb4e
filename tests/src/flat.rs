//! A small stage for what a picture means: flat colours, and pictures that are all one thing.

use scenec_picture::NOTHING;
use scenec_scene::Scene;

use crate::{Shot, scene, shots};

/// The eye at (0, 0, 5), looking along -z, under a sky with a gradient.
const STAGE: &str = "
width := 33
height := 25
raydepth := 3
fov := .8
eyepos_x := 0
eyepos_y := 0
eyepos_z := 5
lookat_x := 0
lookat_y := 0
lookat_z := 0
ambient_r := .3
ambient_g := .5
ambient_b := .9
ambient_int_r := 1
ambient_int_g := 1
ambient_int_b := 1
?red := 1 0 0 0 0 1 1 1 0 0
?blue := 1 0 0 0 0 1 1 0 0 1
?white := 0 1 0 0 0 1 1 1 1 1
";

/// Red's ambient share under the stage's light.
pub const RED: [f64; 3] = [0.3, 0.0, 0.0];
/// Blue's.
pub const BLUE: [f64; 3] = [0.0, 0.0, 0.9];

/// The scene of a text on the stage: materials red and blue of nothing but their colour, and a white one to be lit.
#[must_use]
pub fn flat_stage(text: &str) -> Scene {
    scene("stage", &format!("{STAGE}{text}"))
}

/// Whether two colours are the same but for rounding.
#[must_use]
pub fn near(a: [f64; 3], b: [f64; 3]) -> bool {
    (0..3).all(|i| (a[i] - b[i]).abs() < 1e-5)
}

/// The colour in the middle of a picture.
#[must_use]
pub fn middle(shot: &Shot) -> [f64; 3] {
    shot.colour(shot.frame.picture.width() / 2, shot.frame.picture.height() / 2)
}

/// Holds every tracer to the colour in the middle of the picture.
///
/// # Panics
/// If one shows another.
pub fn check_middle(text: &str, expect: [f64; 3]) {
    for shot in shots(&flat_stage(text)) {
        assert!(
            near(middle(&shot), expect),
            "{}: {:?} of\n{text}",
            shot.tracer,
            middle(&shot)
        );
    }
}

/// Holds every tracer to a picture all of one colour.
///
/// # Panics
/// If one shows another.
pub fn check_all(text: &str, expect: [f64; 3]) {
    for shot in shots(&flat_stage(text)) {
        let other = shot
            .frame
            .picture
            .pixels()
            .iter()
            .find(|c| !near(c.map(f64::from), expect));
        assert_eq!(other, None, "{}, not {expect:?}, of\n{text}", shot.tracer);
    }
}

/// Holds every tracer to a picture of nothing but sky: that of a scene whose one object lies behind the eye.
///
/// # Panics
/// If one sees something.
pub fn check_empty(text: &str) {
    let empty = shots(&flat_stage("!a := sphere\n!a += 0 0 99\n!a <=\n"));
    for (shot, empty) in shots(&flat_stage(text)).iter().zip(empty) {
        let seen = shot.frame.ids.iter().flatten().filter(|id| **id != NOTHING).count();
        assert_eq!(seen, 0, "{}: pixels that see something of\n{text}", shot.tracer);
        let pixels = shot.frame.picture.pixels().iter().zip(empty.frame.picture.pixels());
        for (a, b) in pixels {
            assert!(near(a.map(f64::from), b.map(f64::from)), "{}: {a:?} {b:?}", shot.tracer);
        }
    }
}
