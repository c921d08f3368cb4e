//! The three tracers catch each other: the f64 reference straight from the scene, the processor's tracer and the OpenCL
//! kernels, each in both precisions, specialised and general.

#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::print_stdout,
    reason = "a test may, in its helpers too"
)]

use scenec_cpu::Cpu;
use scenec_device::{DeviceInfo, Precision, suited, tracer};
use scenec_picture::{Frame, Limits, Tracer, Window};
use scenec_plan::{Features, Plan, plan};
use scenec_reference::Reference;
use scenec_scene::Scene;
use scenec_tests::{Mask, aligned_scene, compare, device, frame, gallery, random_scene, scene};

/// How far colours may be apart on calm pixels.
const F64: f64 = 1e-9;
const F32: f64 = 1.0 / 255.0;

fn whole(tracer: &mut dyn Tracer, scene: &Scene, paths: bool) -> Frame {
    let window = Window::whole(scene.settings.width, scene.settings.height);
    frame(tracer, window, Limits::NO_CUTOFF, paths)
}

struct Judge {
    name: String,
    scene: Scene,
    plan: Plan,
    truth: Frame,
    mask: Mask,
}

impl Judge {
    fn new(name: &str, scene: Scene) -> Self {
        let truth = whole(&mut Reference::new(&scene), &scene, true);
        let mask = Mask::of(&truth);
        Self {
            name: name.to_owned(),
            plan: plan(&scene).unwrap(),
            scene,
            truth,
            mask,
        }
    }

    fn check(&self, tracer: &mut dyn Tracer, tolerance: f64) -> Frame {
        let mut frame = whole(tracer, &self.scene, false);
        if tolerance == F32 {
            frame.exact = None;
        }
        let found = compare(&self.truth, &frame, &self.mask);
        let who = format!("{} by {}", self.name, tracer.name());
        assert_eq!(found.leaves, 0, "{who}: {found:?}");
        assert!(found.colour <= tolerance, "{who}: {found:?}");
        frame
    }

    fn on_processor(&self) {
        self.check(&mut Cpu::<f64>::new(&self.plan, 1).unwrap(), F64);
        if self.narrow() {
            self.check(&mut Cpu::<f32>::new(&self.plan, 1).unwrap(), F32);
        }
    }

    /// Whether single precision is what a render takes.
    fn narrow(&self) -> bool {
        self.plan.beyond_single().is_none()
    }

    fn on_device(&self, info: &DeviceInfo) {
        let general = Features::generic(&self.plan);
        let special = suited(info, Features::of(&self.plan));
        let run = |precision, features, tolerance| {
            self.check(&mut *tracer(info, &self.plan, precision, features).unwrap(), tolerance)
        };
        let pairs = [(Precision::F32, F32), (Precision::F64, F64)];
        let possible = |precision| match precision {
            Precision::F32 => self.narrow(),
            Precision::F64 => info.has_f64,
        };
        for (precision, tolerance) in pairs.into_iter().filter(|(precision, _)| possible(*precision)) {
            let one = run(precision, &special, tolerance);
            let other = run(precision, &general, tolerance);
            // What a scene does not need may be left out, and nothing may show it.
            assert_eq!(
                one.picture, other.picture,
                "{} {precision}: specialised and general",
                self.name
            );
        }
    }
}

/// The gallery at a size at which the reference is quick.
fn small_gallery() -> Vec<Judge> {
    let small = |(name, mut scene): (String, Scene)| {
        let wide = scene.settings.width.max(1);
        scene.settings.height = (scene.settings.height * 96 / wide).max(1);
        scene.settings.width = 96;
        scene.settings.samples = scene.settings.samples.min(4);
        Judge::new(&name, scene)
    };
    gallery().into_iter().map(small).collect()
}

const SEEDS: std::ops::Range<u64> = 0..200;

#[test]
fn the_gallery_on_the_processor() {
    for judge in small_gallery() {
        judge.on_processor();
        assert!(
            judge.mask.share() > 0.1,
            "{}: only {:.2} of it is compared",
            judge.name,
            judge.mask.share()
        );
    }
}

#[test]
fn the_gallery_on_a_device() {
    let Some(info) = device() else { return };
    small_gallery().iter().for_each(|judge| judge.on_device(info));
}

fn random(seed: u64) -> Judge {
    Judge::new(&format!("seed {seed}"), scene("random", &random_scene(seed)))
}

/// Of objects that stand on a grid, as people place them.
fn aligned(seed: u64) -> Judge {
    Judge::new(&format!("aligned seed {seed}"), scene("aligned", &aligned_scene(seed)))
}

fn trees_on_the_processor(judge: fn(u64) -> Judge) {
    let mut compared = 0.0;
    for judge in SEEDS.map(judge) {
        judge.on_processor();
        compared += judge.mask.share() / SEEDS.end as f64;
    }
    println!("{:.0} % of the pixels are away from every silhouette", compared * 100.0);
    assert!(compared > 0.4, "only {compared:.2} of all pixels are compared");
}

fn trees_on_a_device(judge: fn(u64) -> Judge) {
    let Some(info) = device() else { return };
    SEEDS.map(judge).for_each(|judge| judge.on_device(info));
}

#[test]
fn random_trees_on_the_processor() {
    trees_on_the_processor(random);
}

#[test]
fn random_trees_on_a_device() {
    trees_on_a_device(random);
}

#[test]
fn aligned_trees_on_the_processor() {
    trees_on_the_processor(aligned);
}

#[test]
fn aligned_trees_on_a_device() {
    trees_on_a_device(aligned);
}
