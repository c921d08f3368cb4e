//! What the language says a picture shows from any place, under any lamp and through any glass, in every tracer.

#![allow(clippy::unwrap_used, reason = "a test may stop at once")]

use scenec_picture::NOTHING;
use scenec_tests::{BLUE, RED, Shot, check_all, check_middle, flat_stage as stage, near, shots};

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
