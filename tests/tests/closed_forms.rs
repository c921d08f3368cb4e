//! Pictures against closed forms: what geometry and the shading formulas say about every pixel, worked out here without
//! any tracer's code.

#![allow(clippy::unwrap_used, reason = "a test may stop at once")]

use std::f64::consts::PI;

use scenec_picture::NOTHING;
use scenec_scene::{DVec3, Scene, view};
use scenec_tests::{Lens, Shot, scene, shots};

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

/// An object that no ray from the stage's eye meets.
const BEHIND: &str = "!a := sphere\n!a += 0 0 9\n!a <=\n";

/// How far from a silhouette, in pixels, a pixel's centre must lie to be held to the closed form.
const SLACK: f64 = 0.02;

fn stage(text: &str) -> Scene {
    scene("stage", &format!("{STAGE}{text}"))
}

/// Compares a class of every pixel (which leaf, which colour) with what geometry says, in every tracer. Only pixels
/// whose class changes within `SLACK` pixels are passed over, and there must be few.
fn check_classes<T: PartialEq + std::fmt::Debug>(
    text: &str,
    expect: impl Fn(DVec3) -> T,
    saw: impl Fn(&Shot, u32, u32) -> T,
) {
    let scene = stage(text);
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
fn check_colours(scene: &Scene, single: f64, double: f64, expect: impl Fn(DVec3) -> Option<[f64; 3]>) {
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
fn meets(eye: DVec3, direction: DVec3, centre: DVec3, radius: f64) -> Option<f64> {
    let way = centre - eye;
    let along = way.dot(direction);
    let off = (way - along * direction).length();
    (along > 0.0 && off < radius).then(|| along - (radius * radius - off * off).sqrt())
}

fn hits(shot: &Shot, x: u32, y: u32) -> bool {
    shot.leaf(x, y) != NOTHING
}

#[test]
fn the_outline_of_a_ball_is_its_tangent_cone() {
    for distance in [1.001, 1.5, 3.0, 10.0, 1e3, 1e6] {
        for radius in [1e-3, 1.0, 1e5] {
            let half = (1.0_f64 / distance).asin();
            // The ball takes up two thirds of the picture's width, or looks past its edges.
            let fov = 2.0 * (1.5 * half.tan()).atan();
            let far = distance * radius;
            let text =
                format!("fov := {fov}\n!a := sphere\n!a *= {radius} {radius} {radius}\n!a += 0 0 -{far}\n!a <=\n");
            let axis = -DVec3::Z;
            // An angle from its sine: a cosine near 1 has no digits.
            let expect = move |d: DVec3| d.cross(axis).length() < half.sin() && d.dot(axis) > 0.0;
            check_classes(&text, expect, hits);
        }
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
        for pitch in [-0.5, -0.1, 0.0, 0.2, 0.45] {
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

/// A direction turned by an angle towards another, in their common plane.
fn turned(direction: DVec3, towards: DVec3, angle: f64) -> DVec3 {
    let across = (towards - towards.dot(direction) * direction).normalize_or_zero();
    direction * angle.cos() + across * angle.sin()
}

/// What a clear ball does to a ray at incidence i: it enters at r, and turns by i - r twice; or it mirrors.
fn through_a_ball(direction: DVec3, centre: DVec3, index: f64) -> Option<DVec3> {
    let distance = meets(DVec3::ZERO, direction, centre, 1.0)?;
    let normal = direction * distance - centre;
    let sine = direction.cross(centre).length();
    let incidence = sine.asin();
    if sine.abs() > index.abs() {
        return Some(direction - 2.0 * direction.dot(normal) * normal);
    }
    let deviation = 2.0 * (incidence - (sine / index).asin());
    Some(turned(direction, centre, deviation))
}

#[test]
fn a_clear_ball_turns_each_ray_by_twice_the_difference_of_its_angles() {
    for index in [1.0_f64, 1.000_1, 1.33, 1.5, 2.0, 10.0, 0.7, 0.99, -1.0, -1.5] {
        let text = format!(
            "ambient_r := 0\nambient_g := .3\nwidth := 81\nheight := 81\nraydepth := 2\nfov := .8\n\
             ?m := 0 0 0 0 1 {index} 1 1 1 1\n!a := sphere\n!a += .2 -.1 -3\n!a ?= m\n!a <=\n"
        );
        let centre = DVec3::new(0.2, -0.1, -3.0);
        check_colours(&stage(&text), 3e-5, 1e-9, |d| {
            // Near the rim and the critical angle a rounding of the direction is worth its root.
            let sine = d.cross(centre).length();
            let calm = [1.0, index.abs()].iter().all(|edge| (sine - edge).abs() > 0.01);
            let out = through_a_ball(d, centre, index).unwrap_or(d);
            let t = (out.y + 1.0) / 2.0;
            calm.then_some([1.0 - t, (1.0 - t) + 0.3 * t, 1.0])
        });
    }
}

#[test]
fn a_mirror_shows_what_is_before_it_as_far_behind() {
    // A red ball above a mirror in a white room; the mirror is the plane y = -1, turned by nothing.
    let text = "raydepth := 1\nfov := 1.4\n?mirror := 0 0 0 1 0 1 1 1 1 1\n?red := 1 0 0 0 0 1 1 1 0 0\n\
                !m := hp\n!m += 0 -1 0\n!m ?= mirror\n!b := sphere\n!b *= .5 .5 .5\n!b += .4 .3 -4\n!b ?= red\n\
                !s := m | b\n!s <=\n";
    let (ball, image) = (DVec3::new(0.4, 0.3, -4.0), DVec3::new(0.4, -2.3, -4.0));
    let red = |d| [ball, image].iter().any(|c| meets(DVec3::ZERO, d, *c, 0.5).is_some());
    check_classes(text, red, |shot, x, y| shot.colour(x, y)[1] < 0.5);
}

#[test]
fn a_shadow_ends_where_the_light_grazes_the_ball() {
    // From high above: a ball of 1 at (0, 2, 0), a lamp at (5, 9, 1), a white floor. In shadow is what the lamp sees
    // within the ball's cone.
    let text = "eyepos_x := -7\neyepos_y := 14\neyepos_z := 3\nlookat_z := 0\nfov := .9\n\
                ?white := 0 1 0 0 0 1 1 1 1 1\n!f := hp\n!f ?= white\n!b := sphere\n!b += 0 2 0\n!b ?= white\n\
                !s := f | b\n!s <=\n*l := 5 9 1 1 1 1\n";
    let (eye, ball, lamp) = (DVec3::new(-7.0, 14.0, 3.0), DVec3::Y * 2.0, DVec3::new(5.0, 9.0, 1.0));
    let expect = |d: DVec3| {
        if meets(eye, d, ball, 1.0).is_some() {
            return 'b';
        }
        let point = eye - d * (eye.y / d.y);
        let cone = meets(lamp, (point - lamp).normalize(), ball, 1.0);
        if cone.is_some() { 's' } else { 'f' }
    };
    check_classes(text, expect, |shot, x, y| {
        if shot.leaf(x, y) == shot.leaf(0, 0) {
            if shot.colour(x, y)[0] == 0.0 { 's' } else { 'f' }
        } else {
            'b'
        }
    });
}

/// A lit floor at y = -1 under a lamp, with a material and a colour of ambient light.
fn lit(point: DVec3, lamp: DVec3, d: DVec3, [kd, ks, shiny]: [f64; 3]) -> f64 {
    let normal = DVec3::Y;
    let l = (lamp - point).normalize();
    let mirrored = 2.0 * normal.dot(l) * normal - l;
    let highlight = mirrored.dot(-d).clamp(0.0, 1.0).powf(shiny);
    0.1 + 0.5 * kd * normal.dot(l).max(0.0) * 0.8 + ks * highlight * 0.8
}

#[test]
fn surfaces_are_lit_as_phong_wrote() {
    for shiny in [0.0, 0.5, 1.0, 16.0, 1e3, 1e5, 1e7] {
        // So that the highlight fills a good part of the picture, whatever its size.
        let fov = if shiny < 100.0 { 1.2 } else { 8.0 / f64::sqrt(shiny) };
        let text = format!(
            "eyepos_y := 1\neyepos_z := 2\nlookat_y := -1\nlookat_z := 0\nfov := {fov}\n*l := 0 1 -2 .8 .8 .8\n\
             ?m := .2 .6 .3 0 0 1 {shiny} .5 .5 .5\n!a := hp\n!a += 0 -1 0\n!a ?= m\n!a <=\n"
        );
        let (eye, lamp) = (DVec3::new(0.0, 1.0, 2.0), DVec3::new(0.0, 1.0, -2.0));
        let single = if shiny > 1e4 { 1.0 / 255.0 } else { 1e-5 };
        check_colours(&stage(&text), single, 1e-7, |d| {
            let point = eye - d * (2.0 / d.y);
            (d.y < -0.05).then(|| [lit(point, lamp, d, [0.6, 0.3, shiny]); 3])
        });
    }
}

#[test]
fn a_ball_is_lit_as_phong_wrote() {
    let text = "fov := .6\n*l := 4 5 1 .9 .6 .3\n?m := .1 .7 .4 0 0 1 20 .5 .8 1\n\
                !a := sphere\n!a += 0 0 -4\n!a ?= m\n!a <=\n";
    let (centre, lamp) = (DVec3::Z * -4.0, DVec3::new(4.0, 5.0, 1.0));
    check_colours(&stage(text), 1e-5, 1e-11, |d| {
        let point = d * meets(DVec3::ZERO, d, centre, 1.0)?;
        let normal = point - centre;
        let l = (lamp - point).normalize();
        let cosine = normal.dot(l);
        let mirrored = (2.0 * cosine * normal - l).dot(-d).max(0.0).powf(20.0);
        let far = d.cross(centre).length() < 0.99 && cosine.abs() > 1e-3;
        far.then(|| {
            let diffuse = [0.45, 0.48, 0.3];
            let ambient = [0.05, 0.08, 0.1];
            let lamp = [0.9, 0.6, 0.3];
            std::array::from_fn(|i| {
                let lit = 0.7 * cosine * diffuse[i] + 0.4 * lamp[i] * mirrored;
                ambient[i] + if cosine > 0.0 { lit } else { 0.0 }
            })
        })
    });
}

#[test]
fn mirrors_face_to_face_add_up_a_geometric_series() {
    for (kr, depth) in [
        (0.9, 0),
        (0.9, 1),
        (0.9, 7),
        (0.5, 64),
        (0.9, 64),
        (0.99, 1024),
        (1.0, 1024),
        (-0.5, 9),
    ] {
        let text = format!(
            "width := 9\nheight := 9\nraydepth := {depth}\nfov := 1\nlookat_y := -1\nlookat_z := -.3\n\
             ?m := .25 0 0 {kr} 0 1 1 1 1 1\n!a := hp\n!a += 0 -1 0\n!b := hp\n!b *= 1 -1 1\n!b += 0 2 0\n\
             !s := a | b\n!s ?= m\n!s <=\n"
        );
        let sum: f64 = (0..=depth).map(|i| 0.25 * f64::powi(kr, i)).sum();
        check_colours(&stage(&text), 2e-5 * sum.abs(), 1e-11 * sum.abs(), |d| {
            (d.y < -0.1).then_some([sum; 3])
        });
    }
}

#[test]
fn a_hollow_mirror_never_lets_a_ray_go() {
    // Each bounce adds the ambient share, so the sum counts them: a ray lost through the wall would see the white sky.
    for depth in [0, 1, 10, 200] {
        let text = format!(
            "raydepth := {depth}\nwidth := 15\nheight := 15\neyepos_z := .4\n?m := 1 0 0 1 0 1 1 .01 .02 .03\n\
             !a := sphere\n!a ?= m\n!a <=\n"
        );
        let bounces = f64::from(depth + 1);
        check_colours(&stage(&text), 1e-5 * bounces, 1e-12 * bounces, |_| {
            Some([0.01 * bounces, 0.02 * bounces, 0.03 * bounces])
        });
    }
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
