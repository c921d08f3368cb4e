//! What roundings do to a picture: no more than if each ray from the eye were turned by a few of them.

#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a test may stop at once and tell what it found"
)]

use std::f64::consts::PI;

use scenec_cpu::Cpu;
use scenec_device::{Precision, tracer};
use scenec_measure::Effort;
use scenec_picture::{Exact, Limits, Tracer, Window};
use scenec_plan::{Features, plan};
use scenec_reference::Reference;
use scenec_scene::{Scene, View, view};
use scenec_tests::{device, frame, gallery};

/// How far each ray from the eye is turned, radians: four roundings of a number near 1 in single precision.
const TURN: f64 = 4.0 * (f32::EPSILON as f64 / 2.0);

/// Into how many directions.
const DIRECTIONS: u32 = 4;

fn exact(tracer: &mut dyn Tracer, scene: &Scene) -> Exact {
    let window = Window::whole(scene.settings.width, scene.settings.height);
    frame(tracer, window, Limits::NO_CUTOFF, false).exact.unwrap()
}

/// The scene seen with its camera turned a little, `angle` telling into which direction.
fn turned(scene: &Scene, angle: f64) -> Scene {
    let mut scene = scene.clone();
    let (View::Clear(camera) | View::AlongUp(camera)) = view(&scene.settings) else {
        panic!("there is no view");
    };
    let far = (scene.settings.lookat - scene.settings.eyepos).length();
    let aside = camera.right.normalize() * angle.cos() + camera.up.normalize() * angle.sin();
    scene.settings.lookat += aside * (far * TURN);
    scene
}

/// The mean of the squares of all components' differences.
fn squares(a: &Exact, b: &Exact) -> f64 {
    let (a, b) = (a.as_flattened(), b.as_flattened());
    a.iter().zip(b).map(|(a, b)| (a - b) * (a - b)).sum::<f64>() / a.len() as f64
}

/// Holds each tracer that computes in singles to twice what the turned rays change in the reference's own picture.
fn check(name: &str, scene: &Scene) {
    let truth = exact(&mut Reference::new(scene), scene);
    let turn = |k: u32| {
        let scene = turned(scene, 2.0 * PI * f64::from(k) / f64::from(DIRECTIONS));
        squares(&exact(&mut Reference::new(&scene), &scene), &truth)
    };
    let turned = ((0..DIRECTIONS).map(turn).sum::<f64>() / f64::from(DIRECTIONS)).sqrt();
    let plan = plan(scene).unwrap();
    let mut tracers: Vec<Box<dyn Tracer>> = vec![Box::new(Cpu::<f32>::new(&plan, 0).unwrap())];
    if let Some(info) = device() {
        tracers.push(tracer(info, &plan, Precision::F32, &Features::of(&plan)).unwrap());
    }
    for mut tracer in tracers {
        let single = squares(&exact(&mut *tracer, scene), &truth).sqrt();
        println!("{name} by {}: {single:.1e}, turned {turned:.1e}", tracer.name());
        assert!(
            single <= 2.0 * turned,
            "{name} by {}: {single:e}, turned {turned:e}",
            tracer.name()
        );
    }
}

#[test]
fn the_gallery_in_singles_is_as_good_as_rays_that_are_known_to_four_roundings() {
    for (name, scene) in gallery() {
        let small = Effort {
            pixels: 96 * 64,
            ..Effort::QUICK
        };
        let mut scene = small.shrunk(scene);
        scene.settings.samples = 4;
        check(&name, &scene);
    }
}
