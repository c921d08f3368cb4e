//! The three tracers catch each other: the f64 reference straight from the scene, the processor's tracer and the OpenCL
//! kernels, each in both precisions, specialised and general.

#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::print_stdout,
    reason = "a test may, in its helpers too"
)]

use std::sync::LazyLock;

use scenec_cpu::Cpu;
use scenec_device::{DeviceInfo, Precision, suited, tracer};
use scenec_picture::{Frame, Limits, Tracer, Window};
use scenec_plan::{Features, Plan, plan};
use scenec_reference::Reference;
use scenec_scene::Scene;
use scenec_tests::{Mask, Programs, aligned_scene, compare, device, frame, gallery, random_scene, scene};

/// How far colours may be apart on calm pixels.
const F64: f64 = 1e-9;
const F32: f64 = 1.0 / 255.0;

fn whole(tracer: &mut dyn Tracer, scene: &Scene, paths: bool) -> Frame {
    let window = Window::whole(scene.settings.width, scene.settings.height);
    frame(tracer, window, Limits::NO_CUTOFF, paths)
}

/// Room for the waiting rays of every scene here, so that they have one general program.
const MOST_WAITING: u32 = 16;

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

    /// By the general program, and by the special ones for these features.
    fn on_device(&self, info: &DeviceInfo, precision: Precision, special: &[Features]) {
        let (possible, tolerance) = match precision {
            Precision::F32 => (self.narrow(), F32),
            Precision::F64 => (info.has_f64, F64),
        };
        if !possible {
            return;
        }
        let run = |features| self.check(&mut *tracer(info, &self.plan, precision, &features).unwrap(), tolerance);
        let general = run(Features {
            waiting: MOST_WAITING,
            ..Features::generic(&self.plan)
        });
        for features in special {
            // What a scene does not need may be left out, and nothing may show it.
            let same = run(suited(info, *features)).picture == general.picture;
            assert!(same, "{} {precision}: general, and special for {features:?}", self.name);
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
    for judge in small_gallery() {
        for precision in [Precision::F32, Precision::F64] {
            judge.on_device(info, precision, &[Features::of(&judge.plan)]);
        }
    }
}

fn random(seed: u64) -> Judge {
    Judge::new(&format!("seed {seed}"), scene("random", &random_scene(seed)))
}

/// Of objects that stand on a grid, as people place them.
fn aligned(seed: u64) -> Judge {
    Judge::new(&format!("aligned seed {seed}"), scene("aligned", &aligned_scene(seed)))
}

/// Trees of both sorts: the reference draws each once for all tests.
static TREES: LazyLock<[Vec<Judge>; 2]> = LazyLock::new(|| [SEEDS.map(random).collect(), SEEDS.map(aligned).collect()]);

#[test]
fn trees_on_the_processor() {
    for judges in &*TREES {
        judges.iter().for_each(Judge::on_processor);
        let compared = judges.iter().map(|judge| judge.mask.share()).sum::<f64>() / judges.len() as f64;
        println!("{:.0} % of the pixels are away from every silhouette", compared * 100.0);
        assert!(compared > 0.4, "only {compared:.2} of all pixels are compared");
    }
}

/// All by the general program, and each by special ones of which, with few exceptions, one or the other leaves out whatever it
/// does not need. The scenes are of some 120 kinds and a driver takes seconds to compile for one, so few have a program of their
/// own; that many things left out at once are no different is shown by those and by the gallery, and what any two features do
/// to each other is shown elsewhere.
fn trees_on_a_device(precision: Precision) {
    let Some(info) = device() else { return };
    let judges = || TREES.iter().flatten();
    let kinds: Vec<Features> = judges().map(|judge| Features::of(&judge.plan)).collect();
    let programs = Programs::of(&kinds);
    let mut own = 0;
    for (judge, kind) in judges().zip(&kinds) {
        let mut special = programs.drawing(kind);
        own += usize::from(special.contains(kind));
        if special.is_empty() {
            // Still in the way that suits the device.
            special.push(Features::generic(&judge.plan));
        }
        judge.on_device(info, precision, &special);
    }
    println!(
        "{} programs, {own} of {} scenes by their own",
        programs.kinds().len(),
        kinds.len()
    );
    assert!(
        4 * own > kinds.len(),
        "only {own} scenes are drawn by their own program"
    );
}

// A test for each precision, for these have no program in common: tests that run beside each other compile none twice.

#[test]
fn trees_on_a_device_in_single_precision() {
    trees_on_a_device(Precision::F32);
}

#[test]
fn trees_on_a_device_in_double_precision() {
    trees_on_a_device(Precision::F64);
}
