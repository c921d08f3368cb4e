//! What the language says a picture shows, in every tracer: which surface, whose material, and nothing where nothing is.

#![allow(clippy::unwrap_used, reason = "a test may stop at once")]

use scenec_picture::{Limits, NOTHING, Window};
use scenec_scene::Scene;
use scenec_tests::{Shot, gallery, scene, shots, shots_of};

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

/// Red's and blue's ambient share under the stage's light.
const RED: [f64; 3] = [0.3, 0.0, 0.0];
const BLUE: [f64; 3] = [0.0, 0.0, 0.9];

fn stage(text: &str) -> Scene {
    scene("stage", &format!("{STAGE}{text}"))
}

fn near(a: [f64; 3], b: [f64; 3]) -> bool {
    (0..3).all(|i| (a[i] - b[i]).abs() < 1e-5)
}

fn middle(shot: &Shot) -> [f64; 3] {
    shot.colour(shot.frame.picture.width() / 2, shot.frame.picture.height() / 2)
}

/// The colour in the middle of the picture, in every tracer.
fn check_middle(text: &str, expect: [f64; 3]) {
    for shot in shots(&stage(text)) {
        assert!(
            near(middle(&shot), expect),
            "{}: {:?} of\n{text}",
            shot.tracer,
            middle(&shot)
        );
    }
}

/// The colour of the whole picture, in every tracer.
fn check_all(text: &str, expect: [f64; 3]) {
    for shot in shots(&stage(text)) {
        let other = shot
            .frame
            .picture
            .pixels()
            .iter()
            .find(|c| !near(c.map(f64::from), expect));
        assert_eq!(other, None, "{}, not {expect:?}, of\n{text}", shot.tracer);
    }
}

/// Nothing but sky, in every tracer: the very picture of a scene whose one object lies behind the eye.
fn check_empty(text: &str) {
    let empty = shots(&stage("!a := sphere\n!a += 0 0 99\n!a <=\n"));
    for (shot, empty) in shots(&stage(text)).iter().zip(empty) {
        let seen = shot.frame.ids.iter().flatten().filter(|id| **id != NOTHING).count();
        assert_eq!(seen, 0, "{}: pixels that see something of\n{text}", shot.tracer);
        let pixels = shot.frame.picture.pixels().iter().zip(empty.frame.picture.pixels());
        for (a, b) in pixels {
            assert!(near(a.map(f64::from), b.map(f64::from)), "{}: {a:?} {b:?}", shot.tracer);
        }
    }
}

#[test]
fn what_is_taken_from_itself_leaves_nothing() {
    for objects in [
        // The same values.
        "!a := sphere\n!b := sphere\n",
        "!a := sphere\n!b := a\n",
        "!a := hp\n!b := hp\n",
        "!a := sphere\n!a *= 1.1 .7 2\n!a #x= .3\n!a += .1 .2 .3\n!b := a\n",
        // The same ball, turned.
        "!a := sphere\n!b := sphere\n!b #x= .7\n!b #y= -2\n",
        "!a := sphere\n!a += .1 .2 .3\n!b := sphere\n!b #z= 1\n!b += .1 .2 .3\n",
        "!a := sphere\n!a *= .8 .8 .8\n!b := sphere\n!b #y= .4\n!b *= .8 .8 .8\n",
        "!a := sphere\n!b := sphere\n!b *= -1 1 -1\n",
        // The same half-space, turned about its normal, stretched, moved along itself.
        "!a := hp\n!b := hp\n!b #y= 1.1\n",
        "!a := hp\n!b := hp\n!b *= 3 2 .1\n!b += 5 0 -7\n",
        // The same ellipsoid by another way.
        "!a := sphere\n!a *= 2 1 1\n!b := sphere\n!b *= 1 2 1\n!b #z= -1.5707963267948966\n",
        "!a := sphere\n!a *= 2 1 1\n!b := sphere\n!b *= 2 1 1\n!b #x= .9\n",
        "!a := sphere\n!a *= 2 1 .5\n!b := sphere\n!b *= 2 1 .5\n!b #y= pi\n",
        "!a := sphere\n!a *= 2 1 .5\n!a #y= .3\n!b := sphere\n!b *= 2 1 .5\n!b #y= .1\n!b #y= .2\n",
        "!a := sphere\n!a += .3 0 0\n!b := sphere\n!b += .1 0 0\n!b += .2 0 0\n",
        "!a := sphere\n!a *= .3 .3 .3\n!b := sphere\n!b *= .1 .1 .1\n!b *= 3 3 3\n",
        "!a := sphere\n!a += 1 0 0\n!a #z= .7\n!b := sphere\n!b += .7648421872844885 .644217687237691 0\n",
        // Combinations.
        "!p := sphere\n!q := sphere\n!q += .5 0 0\n!a := p | q\n!b := q | p\n",
        "!p := sphere\n!q := sphere\n!q += .5 0 0\n!a := p & q\n!b := p\n",
        "!p := sphere\n!q := sphere\n!q += .5 0 0\n!a := p\n!b := q | p\n",
        "!p := sphere\n!q := sphere\n!q += .5 0 0\n!a := p - q\n!b := p\n",
        "!p := sphere\n!q := hp\n!q += .5 0 0\n!a := p & q\n!b := q & p\n",
    ] {
        // `!b := a` is no statement: a copy is a union with itself, which is the thing itself.
        let objects = objects.replace(":= a\n", ":= a | a\n").replace(":= p\n", ":= p | p\n");
        check_empty(&format!("{objects}!c := a - b\n!c <=\n"));
    }
}

#[test]
fn what_is_disjoint_meets_in_nothing() {
    for objects in [
        "!a := sphere\n!b := sphere\n!b += 2.5 0 0\n",
        "!a := hp\n!b := hp\n!b *= 1 -1 1\n!b += 0 .1 0\n",
        "!a := sphere\n!b := hp\n!b += 0 -1.5 0\n",
    ] {
        check_empty(&format!("{objects}!c := a & b\n!c <=\n"));
    }
}

#[test]
fn a_hollow_shows_the_material_of_what_was_taken_away() {
    let ball = "!a := sphere\n!a ?= red\n!b := sphere\n!b *= .5 .5 .5\n!b += 0 0 1\n!b ?= blue\n";
    check_middle(&format!("{ball}!c := a - b\n!c <=\n"), BLUE);
    check_middle(&format!("{ball}!c := a - b\n!c ?= red\n!c <=\n"), RED);
    check_middle(&format!("{ball}!c := a | b\n!c <=\n"), BLUE);
    check_middle(&format!("{ball}!c := a & b\n!c <=\n"), RED);
    // Taken apart by what lies before it, nothing of the ball is left to cover what lies behind.
    let gone = "!a := sphere\n!a ?= red\n!b := hp\n!b #x= 1.5707963267948966\n!b += 0 0 -2\n!b ?= blue\n";
    check_middle(&format!("{gone}!c := b - a\n!c <=\n"), BLUE);
}

#[test]
fn of_surfaces_that_coincide_the_left_one_shows() {
    let balls = "!a := sphere\n!a ?= red\n!b := sphere\n!b #y= .4\n!b ?= blue\n";
    let faces =
        "!a := hp\n!a #x= 1.5707963267948966\n!a ?= red\n!b := hp\n!b #y= .3\n!b #x= 1.5707963267948966\n!b ?= blue\n";
    for objects in [balls, faces] {
        for op in ["|", "&"] {
            check_middle(&format!("{objects}!c := a {op} b\n!c <=\n"), RED);
            check_middle(&format!("{objects}!c := b {op} a\n!c <=\n"), BLUE);
        }
    }
    // A half-space less its complement: one face, two owners.
    let halves = "!a := hp\n!a #x= 1.5707963267948966\n!a ?= red\n!b := hp\n!b #x= -1.5707963267948966\n!b ?= blue\n";
    check_middle(&format!("{halves}!c := a - b\n!c <=\n"), RED);
    // A ball that fills its hole: the whole is one ball, whose inner surfaces can't be seen.
    let plug = "!p := sphere\n!p ?= red\n!q := sphere\n!q *= .5 .5 .5\n!q += 0 0 1\n!q ?= blue\n!h := p - q\n";
    check_middle(&format!("{plug}!c := h | q\n!c <=\n"), BLUE);
}

#[test]
fn an_eye_within_sees_the_inside() {
    check_all("eyepos_z := .3\n!a := sphere\n!a ?= red\n!a <=\n", RED);
    check_all(
        "!a := sphere\n!a *= 9 7 8\n!a #x= .4\n!a += .5 0 0\n!a ?= red\n!a <=\n",
        RED,
    );
    // Within both of two, the outer end shows.
    check_all(
        "!a := sphere\n!a *= 9 9 9\n!b := sphere\n!b *= 7 7 7\n!b ?= blue\n!a ?= red\n!c := b | a\n!c <=\n",
        RED,
    );
    check_all(
        "!a := sphere\n!a *= 9 9 9\n!b := sphere\n!b *= 7 7 7\n!b ?= blue\n!a ?= red\n!c := b & a\n!c <=\n",
        BLUE,
    );
    // In the cavity of a shell.
    check_all(
        "!a := sphere\n!a *= 9 9 9\n!b := sphere\n!b *= 7 7 7\n!b ?= blue\n!a ?= red\n!c := a - b\n!c <=\n",
        BLUE,
    );
}

#[test]
fn an_eye_on_a_surface_does_not_see_that_point_of_it() {
    // The ball's far side, looking in; beyond a plane there is none.
    check_all("eyepos_z := 1\n!a := sphere\n!a ?= red\n!a <=\n", RED);
    for aim in [-9, 9] {
        for shot in shots(&stage(&format!("lookat_y := {aim}\n!a := hp\n!a ?= red\n!a <=\n"))) {
            assert!(
                shot.frame.ids.iter().flatten().all(|id| *id == NOTHING),
                "{}",
                shot.tracer
            );
        }
    }
}

#[test]
fn an_eye_on_a_ball_sees_the_sky_when_it_looks_away() {
    for shot in shots(&stage("eyepos_z := 1\nlookat_z := 6\n!a := sphere\n!a ?= red\n!a <=\n")) {
        let seen = shot.frame.ids.iter().flatten().filter(|id| **id != NOTHING).count();
        assert_eq!(seen, 0, "{}: pixels that see the ball from within", shot.tracer);
    }
}

#[test]
fn a_lamp_anywhere_lights_what_it_sees() {
    let ball = "!a := sphere\n!a ?= white\n";
    let submit = "!a <=\n";
    // At the eye, facing the ball's nearest point.
    check_middle(&format!("{ball}{submit}*l := 0 0 5 .5 .6 .7\n"), [0.5, 0.6, 0.7]);
    // In the ball, at its centre, on its surface: its outside stays dark.
    for place in ["0 0 .5", "0 0 0", "0 0 1", "0 1 0", "0 0 -1"] {
        let dark = |shot: Shot| {
            let lit = (0..33).flat_map(|x| (0..25).map(move |y| (x, y)));
            let lit = lit.filter(|(x, y)| shot.leaf(*x, *y) != NOTHING && shot.colour(*x, *y)[0] != 0.0);
            assert_eq!(lit.count(), 0, "{} with the lamp at {place}", shot.tracer);
        };
        let scene = stage(&format!("{ball}{submit}*l := {place} .5 .6 .7\n"));
        shots(&scene).into_iter().for_each(dark);
    }
    // In the ball with the eye: the inside is lit, head on from the centre.
    check_all(
        &format!("eyepos_z := .5\n{ball}{submit}*l := 0 0 0 .5 .6 .7\n"),
        [0.5, 0.6, 0.7],
    );
    // On the plane itself: along it no light falls.
    check_middle(
        "eyepos_y := 2\n!a := hp\n!a ?= white\n!a <=\n*l := 3 0 0 1 1 1\n",
        [0.0; 3],
    );
    // On the underside of a ball over the plane: it lights the plane, straight down.
    let over = "eyepos_y := 5\n!f := hp\n!f ?= white\n!a := sphere\n!a += 0 4 0\n!a ?= red\n!c := f | a\n!c <=\n";
    check_middle(&format!("{over}*l := 0 3 0 .5 .6 .7\n"), [0.5, 0.6, 0.7]);
    // Behind the ball's edge nothing comes through.
    check_middle(&format!("{over}*l := 0 9 0 1 1 1\n"), [0.0; 3]);
}

#[test]
fn at_depth_0_a_mirror_and_a_glass_show_their_own_colour() {
    let text = |depth: u32| format!("raydepth := {depth}\n?m := 1 0 0 1 0 1 1 1 0 0\n!a := sphere\n!a ?= m\n!a <=\n");
    check_middle(&text(0), RED);
    check_middle(&text(0).replace("1 0 0 1 0 1", "1 0 0 0 1 1.5"), RED);
    // The mirror sends the middle ray back at the level of the horizon.
    check_middle(&text(1), [0.3 + 0.65, 0.75, 0.95]);
}

#[test]
fn every_index_and_share_gives_finite_numbers() {
    for index in ["0", "1", "-1", "1e-300", "1e300", "-1e-9", "1e-6"] {
        for shares in ["1 1", "0 1", "-1 1", "1e30 1e30"] {
            let text = format!(
                "raydepth := 5\n?m := .1 .1 .1 {shares} {index} 5 1 .5 .2\n!a := sphere\n!b := sphere\n!b += .7 .1 .4\n\
                 !c := a - b\n!d := sphere\n!d += 0 0 -2\n!c := c | d\n!c ?= m\n!c <=\n*l := 1 2 3 1 1 1\n"
            );
            // Each picture is looked through for what is not finite.
            assert!(shots(&stage(&text)).len() >= 3);
        }
    }
}

#[test]
fn glass_of_the_index_of_air_is_not_there() {
    let glass = "?m := 0 0 0 0 1 1 1 1 1 1\nraydepth := 64\n!a := sphere\n!b := sphere\n!b *= .8 .2 .7\n!b #x= 1\n\
                 !c := a - b\n!d := sphere\n!d += 0 0 -2\n!c := c | d\n!c ?= m\n!c <=\n";
    let empty = shots(&stage("!a := sphere\n!a += 0 0 99\n!a <=\n"));
    for (shot, empty) in shots(&stage(glass)).iter().zip(empty) {
        for (a, b) in shot.frame.picture.pixels().iter().zip(empty.frame.picture.pixels()) {
            assert!(near(a.map(f64::from), b.map(f64::from)), "{}: {a:?} {b:?}", shot.tracer);
        }
    }
}

#[test]
fn without_operators_every_base_object_shows() {
    let objects = "!a := sphere\n!a ?= red\n!b := sphere\n!b += .5 0 .5\n!b ?= blue\n!d := sphere\n!d += -1 0 0\n";
    let tree = |first: &str, second: &str| {
        stage(&format!(
            "{objects}!c := a {first} b\n!c := c {second} d\n!c <=\n*l := 3 4 5 .2 .2 .2\n"
        ))
    };
    let union = shots(&tree("|", "|"));
    for (first, second) in [("-", "-"), ("&", "&"), ("-", "|"), ("&", "-")] {
        for (shot, union) in shots(&tree(first, second).ignoring_operators()).iter().zip(&union) {
            assert_eq!(
                shot.frame.picture, union.frame.picture,
                "{}: {first} {second}",
                shot.tracer
            );
            assert_eq!(shot.frame.ids, union.frame.ids, "{}: {first} {second}", shot.tracer);
        }
    }
}

#[test]
fn a_part_of_a_picture_is_that_part() {
    for (name, mut scene) in gallery() {
        (scene.settings.width, scene.settings.height) = (47, 31);
        scene.settings.samples = scene.settings.samples.min(2);
        let window = Window {
            x: 17,
            y: 9,
            width: 13,
            height: 7,
        };
        let parts = shots_of(&scene, window, Limits::NO_CUTOFF);
        for (whole, part) in shots(&scene).iter().zip(parts) {
            for (x, y) in (0..13).flat_map(|x| (0..7).map(move |y| (x, y))) {
                assert_eq!(
                    part.colour(x, y),
                    whole.colour(x + 17, y + 9),
                    "{name} {} {x} {y}",
                    whole.tracer
                );
                assert_eq!(
                    part.leaf(x, y),
                    whole.leaf(x + 17, y + 9),
                    "{name} {} {x} {y}",
                    whole.tracer
                );
            }
        }
    }
}
