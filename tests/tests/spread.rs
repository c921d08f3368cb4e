//! How far the samples of a pixel are apart: every tracer tells the same, and none is more wrong than its samples say.

#![allow(clippy::unwrap_used, reason = "a test may stop at once")]

use scenec_cpu::Cpu;
use scenec_device::{Precision, tracer};
use scenec_measure::{Effort, doubts};
use scenec_picture::{Exact, Frame, Layers, Limits, Request, Spread, Tracer, Watch, Window};
use scenec_plan::{Features, Plan, plan};
use scenec_reference::Reference;
use scenec_scene::Scene;
use scenec_tests::{device, gallery, random_scene, scene};

fn look(tracer: &mut dyn Tracer, scene: &Scene, limits: Limits) -> Frame {
    let request = Request {
        window: Window::whole(scene.settings.width, scene.settings.height),
        limits,
        layers: Layers {
            exact: true,
            spread: true,
            ..Layers::default()
        },
        watch: &Watch::new(),
    };
    tracer.trace(&request).unwrap()
}

/// Every tracer of a scene, and what it computes in.
fn tracers(scene: &Scene, plan: &Plan) -> Vec<(Box<dyn Tracer>, Precision)> {
    let mut tracers: Vec<(Box<dyn Tracer>, Precision)> = vec![
        (Box::new(Cpu::<f64>::new(plan, 1).unwrap()), Precision::F64),
        (Box::new(Cpu::<f32>::new(plan, 1).unwrap()), Precision::F32),
        (Box::new(Reference::new(scene)), Precision::F64),
    ];
    if let Some(info) = device() {
        let features = Features {
            spread: true,
            ..Features::generic(plan)
        };
        for precision in [Precision::F32, Precision::F64] {
            if precision == Precision::F32 || info.has_f64 {
                tracers.push((tracer(info, plan, precision, &features).unwrap(), precision));
            }
        }
    }
    tracers
}

fn small(scene: Scene, pixels: u64, samples: u32) -> Scene {
    let mut scene = Effort {
        pixels,
        ..Effort::QUICK
    }
    .shrunk(scene);
    scene.settings.samples = samples;
    scene
}

/// The largest difference of anything that is told of a pixel.
fn apart(a: &Spread, b: &Spread) -> f64 {
    let all = |spread: &Spread| {
        let sides = [spread.low, spread.high, spread.error];
        let numbers = sides.into_iter().flatten().chain([spread.dropped]);
        numbers.map(f64::from).collect::<Vec<_>>()
    };
    let apart = |(a, b): (f64, f64)| if a == b { 0.0 } else { (a - b).abs() };
    all(a).into_iter().zip(all(b)).map(apart).fold(0.0, f64::max)
}

/// All tracers tell of a scene what the first one does: in doubles nearly so; in singles but for a few pixels on edges, where
/// a sample may fall on either side.
fn check(name: &str, scene: &Scene, limits: Limits) {
    let plan = plan(scene).unwrap();
    let mut tracers = tracers(scene, &plan).into_iter();
    let expect = look(&mut *tracers.next().unwrap().0, scene, limits).spread.unwrap();
    for (mut tracer, precision) in tracers {
        // The slow tracer spends its rays in another order.
        if limits.ray_budget < Limits::DEFAULT.ray_budget && tracer.name().starts_with("reference") {
            continue;
        }
        let found = look(&mut *tracer, scene, limits).spread.unwrap();
        let allowed = match precision {
            Precision::F32 => (1.0 / 255.0, expect.len() / 50),
            Precision::F64 => (1e-6, 0),
        };
        let pairs = expect.iter().zip(&found).enumerate();
        let others: Vec<_> = pairs.filter(|(_, (a, b))| apart(a, b) > allowed.0).collect();
        let who = tracer.name();
        assert!(others.len() <= allowed.1, "{name} by {who}: {:?}", others.first());
    }
}

#[test]
fn all_tracers_tell_the_same() {
    for (name, scene) in gallery() {
        check(&name, &small(scene, 15 * 10, 40), Limits::NO_CUTOFF);
    }
    for seed in 0..12 {
        let scene = scene("random", &random_scene(seed));
        check(&format!("seed {seed}"), &small(scene, 16 * 12, 17), Limits::NO_CUTOFF);
    }
}

#[test]
fn all_tracers_tell_the_same_of_samples_that_run_out_of_rays() {
    let (name, scene) = gallery().into_iter().find(|(name, _)| name == "glass").unwrap();
    let limits = Limits {
        ray_budget: 60,
        ..Limits::NO_CUTOFF
    };
    let scene = small(scene, 18 * 12, 32);
    let plan = plan(&scene).unwrap();
    let stats = look(&mut Cpu::<f64>::new(&plan, 1).unwrap(), &scene, limits).stats;
    assert!(stats.over_budget > 0 && stats.dropped > 0.0);
    check(&name, &scene, limits);
}

/// The scene by the slow tracer, at so many samples.
fn exact(scene: &Scene, samples: u32) -> Exact {
    let mut scene = scene.clone();
    scene.settings.samples = samples;
    look(&mut Reference::new(&scene), &scene, Limits::NO_CUTOFF)
        .exact
        .unwrap()
}

#[test]
fn no_tracer_is_more_wrong_than_its_samples_say() {
    for (name, scene) in gallery() {
        for samples in [4, 32] {
            let scene = small(scene.clone(), 15 * 10, samples);
            let plan = plan(&scene).unwrap();
            let (truth, half) = (exact(&scene, 128), exact(&scene, 64));
            let worst = |a: &[f64; 3], b: &[f64; 3]| (0..3).map(|c| (a[c] - b[c]).abs()).fold(0.0, f64::max);
            let own = truth.iter().zip(&half).map(|(a, b)| worst(a, b)).fold(0.0, f64::max);
            for (mut tracer, precision) in tracers(&scene, &plan) {
                let frame = look(&mut *tracer, &scene, Limits::DEFAULT);
                let doubts = doubts(&plan, precision, &frame).unwrap();
                let pixels = frame.exact.unwrap();
                for (index, (pixel, truth)) in pixels.iter().zip(&truth).enumerate() {
                    let (error, bound) = (worst(pixel, truth), doubts[index].bound());
                    let who = format!("{name} by {} x{samples}, pixel {index}", tracer.name());
                    assert!(error <= bound + own, "{who}: {error} of {:?}, {own}", doubts[index]);
                }
            }
        }
    }
}
