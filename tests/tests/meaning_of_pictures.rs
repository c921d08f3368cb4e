//! What the language says a picture shows of combined solids, in every tracer: which surface, whose material, and nothing
//! where nothing is.

#![allow(clippy::unwrap_used, reason = "a test may stop at once")]

use scenec_picture::{Limits, Window};
use scenec_tests::{BLUE, RED, check_empty, check_middle, flat_stage as stage, gallery, shots, shots_of};

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
