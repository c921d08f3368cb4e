//! Where things are in pictures, against closed forms: what geometry says about every pixel, worked out here without any
//! tracer's code.

#![allow(clippy::unwrap_used, reason = "a test may stop at once")]

use std::f64::consts::PI;

use scenec_picture::NOTHING;
use scenec_scene::{DVec3, view};
use scenec_tests::{Lens, Shot, check_classes, check_colours, closed_stage as stage, meets};

/// An object that no ray from the stage's eye meets.
const BEHIND: &str = "!a := sphere\n!a += 0 0 9\n!a <=\n";

fn hits(shot: &Shot, x: u32, y: u32) -> bool {
    shot.leaf(x, y) != NOTHING
}

#[test]
fn the_outline_of_a_ball_is_its_tangent_cone() {
    for (distance, radius) in [
        (1.001, 1.0),
        (1.5, 1e-3),
        (3.0, 1e5),
        (10.0, 1.0),
        (1e3, 1e-3),
        (1e3, 1.0),
        (1e6, 1.0),
        (1e6, 1e5),
    ] {
        let half = (1.0_f64 / distance).asin();
        // The ball takes up two thirds of the picture's width.
        let fov = 2.0 * (1.5 * half.tan()).atan();
        let far = distance * radius;
        let text = format!("fov := {fov}\n!a := sphere\n!a *= {radius} {radius} {radius}\n!a += 0 0 -{far}\n!a <=\n");
        let axis = -DVec3::Z;
        // An angle from its sine: a cosine near 1 has no digits.
        let expect = move |d: DVec3| d.cross(axis).length() < half.sin() && d.dot(axis) > 0.0;
        check_classes(&text, expect, hits);
    }
}

#[test]
fn an_outline_off_the_middle_is_a_conic() {
    let centre = DVec3::new(1.7, -0.9, -2.5);
    let text = "!a := sphere\n!a *= .8 .8 .8\n!a += 1.7 -.9 -2.5\n!a <=\nfov := 1.9\nup_x := .3\nwidth := 90\n";
    check_classes(text, |d| meets(DVec3::ZERO, d, centre, 0.8).is_some(), hits);
}

#[test]
fn an_ellipsoid_is_a_ball_to_eyes_that_are_stretched_with_it() {
    // Scaled, then turned about z, then moved: undone in the opposite order.
    let text = "!a := sphere\n!a *= .4 1.2 .7\n!a #z= .6\n!a += .3 .2 -3\n!a <=\nfov := 1\n";
    let undo = |v: DVec3| {
        let (s, c) = 0.6_f64.sin_cos();
        let v = DVec3::new(c * v.x + s * v.y, c * v.y - s * v.x, v.z);
        v / DVec3::new(0.4, 1.2, 0.7)
    };
    let start = undo(DVec3::new(-0.3, -0.2, 3.0));
    check_classes(
        text,
        |d| meets(start, undo(d).normalize(), DVec3::ZERO, 1.0).is_some(),
        hits,
    );
}

#[test]
fn the_horizon_of_a_plane_is_level_with_the_eye() {
    for height in [1e-6, 1.0, 1e7] {
        for pitch in [-0.5, 0.0, 0.2] {
            let aim = height + pitch;
            let text = format!("eyepos_y := {height}\nlookat_y := {aim}\nwidth := 33\nup_z := .1\n!a := hp\n!a <=\n");
            check_classes(&text, |d| d.y < 0.0, hits);
        }
    }
}

#[test]
fn the_edge_of_a_turned_plane_is_where_geometry_puts_it() {
    // A quarter turn about z sends the normal from +y to -x: the solid is x >= 2.
    let text = "!a := hp\n!a #z= pi\n!a #z= -1.5707963267948966\n!a += 2 0 0\n!a <=\n";
    check_classes(text, |d| d.x > 1e-9, hits);
    // About x by a: the normal is (0, cos a, sin a).
    let text = "!a := hp\n!a #x= .7\n!a += 0 -1 0\n!a <=\n";
    let normal = DVec3::new(0.0, 0.7_f64.cos(), 0.7_f64.sin());
    check_classes(text, |d| d.dot(normal) < 0.0, hits);
}

#[test]
fn the_sky_is_a_gradient_in_every_direction() {
    let ambient = [0.2, 0.5, 0.9];
    let light = [0.7, 1.0, 0.4];
    for (more, width, height) in [
        ("fov := .1", 61, 61),
        ("fov := 2.5", 101, 33),
        ("fov := 1\nlookat_y := 3", 33, 101),
        ("up_x := 1\nup_y := 0\nlookat_y := -3\nlookat_x := .5", 17, 13),
        ("lookat_x := 1e9\nlookat_y := 5e8", 1, 1),
        ("fov := 3.1", 1, 40),
        ("fov := 3.1", 40, 1),
    ] {
        let text = format!(
            "{BEHIND}ambient_r := .2\nambient_g := .5\nambient_b := .9\nambient_int_r := .7\nambient_int_b := .4\n\
             {more}\nwidth := {width}\nheight := {height}\n"
        );
        check_colours(&stage(&text), 1e-6, 1e-14, |d| {
            let t = (d.y + 1.0) / 2.0;
            // The ball behind the eye is in sight of the widest views only.
            let free = meets(DVec3::ZERO, d, DVec3::Z * 9.0, 1.0).is_none();
            free.then(|| std::array::from_fn(|i| ((1.0 - t) + t * ambient[i]) * light[i]))
        });
    }
}

#[test]
fn the_camera_of_the_scene_model_is_the_one_of_the_definition() {
    let scene = stage(&format!(
        "{BEHIND}up_z := .7\nlookat_x := 3\nlookat_y := 1\nheight := 20\nfov := .8\n"
    ));
    let scenec_scene::View::Clear(camera) = view(&scene.settings) else {
        panic!("a clear view");
    };
    let corner = (camera.forward + camera.right + camera.up).normalize();
    assert!((corner - Lens::new(&scene.settings).towards(61.0, 0.0)).length() < 1e-15);
}

#[test]
fn a_quarter_turn_is_a_quarter_turn() {
    // The outline of a ball at (2, 0, -3) after a turn about y by a right angle: (-3, 0, -2).
    let text = format!(
        "!a := sphere\n!a += 2 0 -3\n!a #y= {}\n!a <=\nlookat_x := -1\n",
        PI / 2.0
    );
    let centre = DVec3::new(-3.0, 0.0, -2.0);
    check_classes(&text, |d| meets(DVec3::ZERO, d, centre, 1.0).is_some(), hits);
}
