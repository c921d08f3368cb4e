//! Pictures at the ends of what a file may say: sizes, depths, huge trees, huge worlds, and budgets that run out.

#![allow(clippy::unwrap_used, reason = "a test may stop at once")]

use std::fmt::Write;
use std::time::{Duration, Instant};

use scenec_cpu::Cpu;
use scenec_picture::{Layers, Limits, Request, Tracer, Watch, Window};
use scenec_plan::{Plan, plan};
use scenec_scene::Scene;
use scenec_tests::{gallery, scene, shots, shots_of};

/// Boolean glass, a mirror, a floor and shadows, with every length multiplied by `k`.
fn world(k: f64) -> String {
    let [eye, r, near, far] = [6.0, 0.8, 0.7, 3.0].map(|length| length * k);
    format!(
        "width := 40\nheight := 30\nraydepth := 4\neyepos_x := {r}\neyepos_y := {far}\neyepos_z := {eye}\n\
         lookat_x := 0\nlookat_y := 0\nlookat_z := 0\nambient_r := .3\nambient_g := .5\nambient_b := .9\n\
         ambient_int_r := 1\nambient_int_g := .9\nambient_int_b := .8\n?glass := 0 .1 .5 .1 .9 1.4 40 .9 1 .9\n\
         ?mirror := .1 .1 .5 .8 0 1 90 1 .8 .6\n!a := sphere\n!a *= {k} {k} {k}\n!b := sphere\n!b *= {r} {near} {r}\n\
         !b #x= .4\n!b += 0 {near} {near}\n!c := a - b\n!c ?= glass\n!m := sphere\n!m *= {k} {k} {k}\n\
         !m += {far} {near} 0\n!m ?= mirror\n!f := hp\n!f += 0 -{k} 0\n!c := c | m\n!c := c | f\n!c <=\n\
         *l := -{far} {eye} {eye} .9 .8 .7\n"
    )
}

#[test]
fn the_unit_of_length_does_not_show() {
    let plain = shots(&scene("plain", &world(1.0)));
    for power in [40, -40, 200, -200] {
        let scaled = shots(&scene("scaled", &world(f64::powi(2.0, power))));
        for (scaled, plain) in scaled.iter().zip(&plain) {
            assert_eq!(
                scaled.frame.picture, plain.frame.picture,
                "{} by 2^{power}",
                plain.tracer
            );
            assert_eq!(scaled.frame.ids, plain.frame.ids, "{} by 2^{power}", plain.tracer);
        }
    }
}

#[test]
fn any_size_of_picture_is_a_picture() {
    for (width, height) in [(1, 1), (17, 13), (1, 300), (300, 1), (64, 1), (65, 3)] {
        let mut scene = scene("small", &world(1.0));
        (scene.settings.width, scene.settings.height) = (width, height);
        for shot in shots(&scene) {
            let picture = &shot.frame.picture;
            assert_eq!((picture.width(), picture.height()), (width, height), "{}", shot.tracer);
            assert_eq!(shot.frame.stats.primary, u64::from(width * height), "{}", shot.tracer);
        }
    }
}

#[test]
fn a_gallery_at_its_promised_limits_is_finite() {
    for (_, mut scene) in gallery() {
        (scene.settings.width, scene.settings.height, scene.settings.samples) = (31, 23, 1);
        let whole = Window::whole(31, 23);
        // Each picture is looked through for what is not finite.
        for shot in shots_of(&scene, whole, Limits::DEFAULT) {
            assert!(shot.frame.stats.dropped.is_finite(), "{}", shot.tracer);
            assert_eq!(shot.frame.stats.over_budget, 0, "{}", shot.tracer);
        }
    }
}

/// A ball in a hollow, both of which split every ray in two, at depth 40: 2^40 rays, were there no budget.
fn splitting(share: f64) -> Scene {
    let text = format!(
        "width := 16\nheight := 12\nraydepth := 40\nfov := .5\neyepos_x := 0\neyepos_y := 0\neyepos_z := 5\n\
         lookat_x := 0\nlookat_y := 0\nlookat_z := 0\nambient_r := .5\nambient_g := .5\nambient_b := .5\n\
         ambient_int_r := 1\nambient_int_g := 1\nambient_int_b := 1\n?m := .1 0 0 {share} {share} 1.5 1 1 1 1\n\
         !a := sphere\n!w := hp\n!w += 0 30 0\n!h := sphere\n!h *= 20 20 20\n!w := w - h\n!c := a | w\n!c ?= m\n!c <=\n"
    );
    scene("splitting", &text)
}

#[test]
fn a_budget_ends_what_would_never_end() {
    for share in [0.5, 0.9, 1.0] {
        let limits = Limits {
            cutoff: 0.0,
            ray_budget: 200,
        };
        let began = Instant::now();
        for shot in shots_of(&splitting(share), Window::whole(16, 12), limits) {
            let stats = shot.frame.stats;
            assert!(stats.over_budget > 50, "{}: {stats:?}", shot.tracer);
            let rays = stats.primary + stats.reflected + stats.refracted;
            assert!(rays <= 200 * 16 * 12, "{}: {stats:?}", shot.tracer);
            // Something was left out, and it is said how much that can be.
            assert!(
                stats.dropped > 0.0 && !stats.dropped.is_nan(),
                "{}: {stats:?}",
                shot.tracer
            );
        }
        assert!(began.elapsed() < Duration::from_secs(20));
    }
}

#[test]
fn what_is_said_to_be_left_out_bounds_what_is_missing() {
    // Shares of 0.3 die out soon enough to see the whole.
    let mut scene = splitting(0.3);
    scene.settings.raydepth = 12;
    let whole = Window::whole(16, 12);
    let full = shots_of(&scene, whole, Limits::NO_CUTOFF);
    for (cutoff, ray_budget) in [
        (1.0 / 4096.0, 65_536),
        (0.01, 65_536),
        (0.3, 65_536),
        (0.0, 20),
        (0.0, 1),
    ] {
        let some = shots_of(&scene, whole, Limits { cutoff, ray_budget });
        for (some, full) in some.iter().zip(&full) {
            let missing = (0..16 * 12).map(|i| (some.colour(i % 16, i / 16)[0] - full.colour(i % 16, i / 16)[0]).abs());
            let missing = missing.fold(0.0, f64::max);
            let said = some.frame.stats.dropped;
            assert!(missing <= said * 1.000_1 + 1e-6, "{}: {missing} of {said}", some.tracer);
        }
    }
}

/// A row of balls, joined one by one: a tree as deep as it is long.
fn chain(length: u32) -> String {
    let mut text = world(1.0).replace("!c <=\n", "");
    for i in 0..length {
        let _ = write!(
            text,
            "!b := sphere\n!b *= .1 .1 .1\n!b += {} {} {}\n!c := c | b\n",
            f64::from(i % 100) * 0.3 - 15.0,
            f64::from(i / 100 % 100) * 0.3,
            -2.0 - f64::from(i / 10_000) * 0.3
        );
    }
    text + "!c <=\n"
}

/// A scene and its plan, made where there is next to no stack.
fn in_a_small_room(text: String) -> (Scene, Plan) {
    let work = move || {
        let scene = scene("chain", &text);
        let plan = plan(&scene).unwrap();
        (scene, plan)
    };
    let room = std::thread::Builder::new().stack_size(256 * 1024);
    room.spawn(work).unwrap().join().unwrap()
}

fn chain_of(length: u32) {
    let began = Instant::now();
    let (scene, plan) = in_a_small_room(chain(length));
    assert_eq!(plan.leaves.len(), length as usize + 4);
    let watch = Watch::new();
    let request = Request {
        window: Window::whole(scene.settings.width, scene.settings.height),
        limits: Limits::DEFAULT,
        layers: Layers::default(),
        watch: &watch,
    };
    let frame = Cpu::<f32>::new(&plan, 2).unwrap().trace(&request).unwrap();
    assert_eq!(frame.picture.non_finite(), 0);
    let took = began.elapsed();
    assert!(took < Duration::from_secs(60), "{took:?}");
}

#[test]
fn a_chain_of_a_hundred_thousand_unions_is_a_scene() {
    chain_of(1_000_000);
}

#[test]
fn a_long_chain_is_the_same_picture_in_every_tracer() {
    let mut scene = scene("chain", &chain(1_000));
    (scene.settings.width, scene.settings.height, scene.settings.raydepth) = (24, 18, 1);
    let shots = shots(&scene);
    for shot in &shots[1..] {
        let other = (0..24 * 18).filter(|i| shot.leaf(i % 24, i / 24) != shots[0].leaf(i % 24, i / 24));
        assert_eq!(other.count(), 0, "{}", shot.tracer);
    }
}
