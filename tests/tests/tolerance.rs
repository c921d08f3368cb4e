//! Renders to a tolerance: the promise is kept or its breach is announced, and parts are parts of the whole.

#![allow(clippy::unwrap_used, reason = "a test may stop at once")]

use scenec_device::Precision;
use scenec_measure::stability::apart;
use scenec_measure::{Achieved, Effort, Sampler, Tolerance};
use scenec_picture::{Exact, Layers, Limits, Request, Tracer, Watch, Window};
use scenec_reference::Reference;
use scenec_scene::Scene;
use scenec_tests::{device, gallery, random_scene, scene};

fn achieved(scene: &Scene, tolerance: f64) -> Achieved {
    achieved_by(Sampler::Cpu, scene, tolerance)
}

fn achieved_by(sampler: Sampler<'_>, scene: &Scene, tolerance: f64) -> Achieved {
    let watch = Watch::new();
    let wish = Tolerance {
        sampler,
        ..Tolerance::of(scene, tolerance, &watch)
    };
    let achieved = wish.achieve().unwrap();
    assert_eq!(watch.done(), achieved.doubts.len() as u64);
    achieved
}

/// The scene by the slow tracer.
fn exact(scene: &Scene, samples: u32) -> Exact {
    let mut scene = scene.clone();
    scene.settings.samples = samples;
    let request = Request {
        window: Window::whole(scene.settings.width, scene.settings.height),
        limits: Limits::NO_CUTOFF,
        layers: Layers {
            exact: true,
            ..Layers::default()
        },
        watch: &Watch::new(),
    };
    Reference::new(&scene).trace(&request).unwrap().exact.unwrap()
}

/// The largest difference of each pixel's components.
fn differences<'a>(a: &'a [[f64; 3]], b: &'a [[f64; 3]]) -> impl Iterator<Item = f64> + 'a {
    a.iter().zip(b).map(|(a, b)| apart(*a, *b))
}

/// By every tracer, each pixel is within the tolerance by its bound, and within its bound by a reference of many samples, whose
/// own error is what the second half of them changed.
fn check(name: &str, scene: &Scene, tolerance: f64, samples: u32) {
    let (truth, half) = (exact(scene, samples), exact(scene, samples / 2));
    let own = differences(&truth, &half).fold(0.0, f64::max);
    for sampler in [Sampler::Cpu].into_iter().chain(device().map(Sampler::OpenCl)) {
        let found = achieved_by(sampler, scene, tolerance);
        let name = format!("{name} by {}", found.name);
        assert_eq!(found.missed, 0, "{name}: {:?}", found.bound);
        assert!(found.bound.max <= tolerance, "{name}: {:?}", found.bound);
        holds(&name, &found, &truth, own);
    }
}

/// Every pixel is within its bound by a reference with an error of its own.
fn holds(name: &str, found: &Achieved, truth: &Exact, own: f64) {
    let pixels: Vec<_> = found
        .picture
        .pixels()
        .iter()
        .map(|pixel| pixel.map(f64::from))
        .collect();
    for (index, (error, doubt)) in differences(&pixels, truth).zip(&found.doubts).enumerate() {
        let taken = found.samples[index];
        assert!(
            error <= doubt.bound() + own,
            "{name}, pixel {index}: {error} of {doubt:?}, {taken} samples, {own}"
        );
    }
}

fn small(scene: Scene, pixels: u64) -> Scene {
    Effort {
        pixels,
        ..Effort::QUICK
    }
    .shrunk(scene)
}

#[test]
fn every_scene_of_the_gallery_is_within_a_tolerance() {
    for (name, scene) in gallery() {
        check(&name, &small(scene, 18 * 12), 1.0 / 32.0, 256);
    }
}

#[test]
fn the_simplest_scene_is_within_a_level_of_eight_bits() {
    let (_, scene) = gallery().into_iter().find(|(name, _)| name == "seed").unwrap();
    check("seed", &small(scene, 24 * 16), 1.0 / 255.0, 1024);
}

#[test]
fn random_scenes_are_within_a_tolerance() {
    for seed in 0..30 {
        let scene = scene("random", &random_scene(seed));
        check(&format!("seed {seed}"), &small(scene, 16 * 12), 1.0 / 16.0, 256);
    }
}

/// A mirror floor under a ball of glass, whose surfaces hand on this much of the light.
fn stage(mirrored: f64, raydepth: u32) -> Scene {
    let text = format!(
        "width := 24\nheight := 16\nraydepth := {raydepth}\neyepos_x := 0\neyepos_y := 1\neyepos_z := 4\n\
         lookat_x := 0\nlookat_y := 0\nlookat_z := 0\nambient_r := .2\nambient_g := .4\nambient_b := .9\n\
         ambient_int_r := 1\nambient_int_g := 1\nambient_int_b := 1\n?m := .1 .5 .4 {mirrored} 0 1 30 .9 .6 .4\n\
         ?g := 0 0 .2 {mirrored} {mirrored} 1.5 30 1 1 1\n!a := sphere\n!a ?= g\n!f := hp\n!f ?= m\n!f += 0 -1 0\n\
         !s := a | f\n!s <=\n*l := 3 4 2 .8 .8 .8\n"
    );
    scene("stage", &text)
}

#[test]
fn what_cannot_be_kept_is_announced() {
    // Light that grows with every bounce, and too few rays to follow it.
    let watch = Watch::new();
    let gain = stage(1.0, 30);
    let poor = Tolerance {
        ray_budget: 1000,
        ..Tolerance::of(&gain, 1.0 / 64.0, &watch)
    };
    let found = poor.achieve().unwrap();
    assert!(found.missed > 0 && found.stats.over_budget > 0, "{:?}", found.bound);
    assert!(found.bound.truncation > 1.0, "{:?}", found.bound);
    // Edges that more samples would tell.
    let plain = stage(0.4, 4);
    let few = Tolerance {
        most_samples: 64,
        ..Tolerance::of(&plain, 1.0 / 255.0, &watch)
    };
    let found = few.achieve().unwrap();
    assert!(found.missed > 0 && found.bound.max > 1.0 / 255.0, "{:?}", found.bound);
    assert!(found.samples.iter().all(|samples| *samples <= 64));
    // Singles where doubles are needed.
    let coarse = Tolerance {
        precision: Some(Precision::F32),
        most_samples: 64,
        ..Tolerance::of(&plain, 1e-6, &watch)
    };
    let found = coarse.achieve().unwrap();
    assert!(found.missed > 0 && found.bound.rounding > 1e-6, "{:?}", found.bound);
}

#[test]
fn doubles_are_taken_where_singles_would_eat_up_the_tolerance() {
    let scene = stage(0.2, 2);
    assert!(achieved(&scene, 1.0 / 16.0).name.contains("f32"));
    let watch = Watch::new();
    let fine = Tolerance {
        most_samples: 16,
        ..Tolerance::of(&scene, 1e-5, &watch)
    };
    assert!(fine.achieve().unwrap().name.contains("f64"));
}

#[test]
fn faint_branches_are_dropped_as_far_as_the_tolerance_allows() {
    let scene = stage(0.4, 12);
    let (loose, strict) = (achieved(&scene, 0.25), achieved(&scene, 1.0 / 32.0));
    assert!(loose.bound.truncation > strict.bound.truncation);
    assert!(loose.bound.truncation <= 0.25 / 8.0 && strict.bound.truncation <= 1.0 / 256.0);
    let per_sample = |found: &Achieved| found.stats.rays() as f64 / found.stats.primary as f64;
    assert!(per_sample(&loose) < per_sample(&strict));
}

#[test]
fn every_tracer_takes_the_same_samples() {
    let scene = stage(0.4, 4);
    let in_doubles = |sampler| {
        let watch = Watch::new();
        let wish = Tolerance {
            sampler,
            precision: Some(Precision::F64),
            ..Tolerance::of(&scene, 1.0 / 32.0, &watch)
        };
        wish.achieve().unwrap()
    };
    let expect = in_doubles(Sampler::Cpu);
    let others = [Sampler::Reference].into_iter();
    for sampler in others.chain(device().filter(|info| info.has_f64).map(Sampler::OpenCl)) {
        let found = in_doubles(sampler);
        let pixels = found.picture.pixels().iter().zip(expect.picture.pixels());
        for (index, (a, b)) in pixels.enumerate() {
            // The slow tracer drops nothing, so that now and then a pixel of it is done earlier.
            let (taken, most) = (found.samples[index], expect.samples[index]);
            let same = sampler != Sampler::Reference;
            assert!(
                taken == most || !same && taken < most,
                "{}, {index}: {taken} {most}",
                found.name
            );
            let allowed = if same { 1e-6 } else { 1.0 / 32.0 };
            let apart = (0..3).map(|c| (a[c] - b[c]).abs()).fold(0.0, f32::max);
            assert!(apart <= allowed, "{}, {index}: {a:?} {b:?}", found.name);
        }
    }
}

#[test]
fn a_part_of_the_picture_is_that_part_of_the_whole() {
    let scene = stage(0.4, 4);
    let whole = achieved(&scene, 1.0 / 32.0);
    let watch = Watch::new();
    let window = Window {
        x: 7,
        y: 3,
        width: 9,
        height: 8,
    };
    let part = Tolerance {
        window,
        ..Tolerance::of(&scene, 1.0 / 32.0, &watch)
    };
    let part = part.achieve().unwrap();
    for (index, pixel) in part.picture.pixels().iter().enumerate() {
        let (x, y) = (index as u32 % window.width, index as u32 / window.width);
        let place = ((window.y + y) * scene.settings.width + window.x + x) as usize;
        assert_eq!(*pixel, whole.picture.pixels()[place]);
        assert_eq!(
            (part.samples[index], part.doubts[index]),
            (whole.samples[place], whole.doubts[place])
        );
    }
}

#[test]
fn an_object_smaller_than_the_gaps_between_samples_is_found() {
    // White balls a twelfth of a pixel wide before a black wall.
    let mut text = "width := 24\nheight := 24\nraydepth := 0\neyepos_x := 0\neyepos_y := 0\neyepos_z := 10\n\
                lookat_x := 0\nlookat_y := 0\nlookat_z := 0\nambient_r := 1\nambient_g := 1\nambient_b := 1\n\
                ambient_int_r := 1\nambient_int_g := 1\nambient_int_b := 1\n?w := 1 0 0 0 0 1 1 1 1 1\n\
                ?b := 0 0 0 0 0 1 1 0 0 0\n!s := hp\n!s ?= b\n!s #x= 1.5707963267948966\n!s += 0 0 -1\n"
        .to_owned();
    for k in 0..9 {
        let (x, y) = (f64::from(k % 3) * 3.1 - 3.0, f64::from(k / 3) * 3.3 - 3.2);
        text += &format!("!d := sphere\n!d ?= w\n!d *= .035 .035 .035\n!d += {x} {y} 0\n!s := s | d\n");
    }
    let scene = scene("specks", &(text + "!s <=\n"));
    check("specks", &scene, 1.0 / 255.0, 4096);
    assert!(
        achieved(&scene, 1.0 / 255.0)
            .picture
            .pixels()
            .iter()
            .filter(|pixel| pixel[0] > 0.002)
            .count()
            >= 9
    );
}

#[test]
fn somebody_may_say_stop() {
    let scene = stage(0.4, 4);
    let watch = Watch::new();
    watch.stop();
    assert!(Tolerance::of(&scene, 1.0 / 255.0, &watch).achieve().is_err());
}
