//! How far away things are: every tracer that computes in doubles finds the first hit of each pixel where the reference does.

#![allow(clippy::unwrap_used, reason = "a test may stop at once")]

use scenec_cpu::Cpu;
use scenec_device::{Precision, tracer};
use scenec_picture::{Frame, Layers, Limits, NOTHING, Request, Tracer, Watch, Window};
use scenec_plan::{Features, Plan, plan};
use scenec_reference::Reference;
use scenec_scene::{Base, DVec3, Scene, SolidKind};
use scenec_tests::{Lens, device, gallery, random_scene, scene};

/// The cosine between a ray and a surface's normal under which the ray is taken for a tangent. There a distance changes by
/// the ray's own rounding over the cosine, and no two ways to compute it agree.
const TANGENT: f64 = 0.01;

/// How far distances may be apart: this times the distance, or as much where that is less than 1.
const APART: f64 = 1e-12;

fn look(tracer: &mut dyn Tracer, scene: &Scene) -> Frame {
    let request = Request {
        window: Window::whole(scene.settings.width, scene.settings.height),
        limits: Limits::DEFAULT,
        layers: Layers {
            ids: true,
            distances: true,
            ..Layers::default()
        },
        watch: &Watch::new(),
    };
    tracer.trace(&request).unwrap()
}

/// The scene as what is seen first is concerned.
fn bare(mut scene: Scene, width: u32, height: u32) -> Scene {
    (scene.settings.width, scene.settings.height) = (width, height);
    (scene.settings.samples, scene.settings.raydepth) = (1, 0);
    scene.lights.clear();
    scene
}

/// The cosine between a pixel's ray and the normal of the leaf that it hits so far away.
fn cosine(scene: &Scene, direction: DVec3, leaf: u32, distance: f64) -> f64 {
    let SolidKind::Leaf(leaf) = scene.solids[leaf as usize].kind else {
        panic!("{leaf} is no leaf");
    };
    let transform = scene.transform(&leaf);
    let normal = match leaf.base {
        Base::Sphere => transform.inverse * (scene.settings.eyepos + direction * distance - transform.centre),
        Base::HalfSpace => DVec3::Y,
    };
    (transform.inverse.transpose() * normal)
        .normalize()
        .dot(direction)
        .abs()
}

/// Holds a tracer to the reference's leaves and distances; tells how many pixels count.
fn check(name: &str, scene: &Scene, truth: &Frame, tracer: &mut dyn Tracer) -> usize {
    let found = look(tracer, scene);
    let who = format!("{name} by {}", tracer.name());
    let (leaves, expect) = (found.ids.unwrap(), truth.ids.as_ref().unwrap());
    let (found, right) = (found.distances.unwrap(), truth.distances.as_ref().unwrap());
    let (lens, width) = (Lens::new(&scene.settings), scene.settings.width);
    let mut count = 0;
    for (pixel, leaf) in (0..).zip(leaves) {
        let (x, y) = (pixel % width, pixel / width);
        let (far, right) = (found[pixel as usize], right[pixel as usize]);
        assert_eq!(leaf, expect[pixel as usize], "{who}, {x}, {y}: another leaf");
        if leaf == NOTHING {
            assert!(far == f64::INFINITY && right == f64::INFINITY, "{who}, {x}, {y}");
            continue;
        }
        let direction = lens.towards(f64::from(x) + 0.5, f64::from(y) + 0.5);
        if cosine(scene, direction, leaf, right) < TANGENT {
            continue;
        }
        let apart = (far - right).abs();
        assert!(apart <= APART * right.max(1.0), "{who}, {x}, {y}: {far} and {right}");
        count += 1;
    }
    count
}

/// Every tracer that computes in doubles.
fn check_all(name: &str, scene: &Scene, features: fn(&Plan) -> Features) -> usize {
    let truth = look(&mut Reference::new(scene), scene);
    let plan = plan(scene).unwrap();
    let count = check(name, scene, &truth, &mut Cpu::<f64>::new(&plan, 1).unwrap());
    if let Some(info) = device().filter(|info| info.has_f64) {
        let features = Features {
            distances: true,
            ..features(&plan)
        };
        let mut tracer = tracer(info, &plan, Precision::F64, &features).unwrap();
        assert_eq!(check(name, scene, &truth, &mut *tracer), count);
    }
    count
}

#[test]
fn in_the_gallery() {
    for (name, scene) in gallery() {
        let count = check_all(&name, &bare(scene, 60, 40), Features::of);
        assert!(count > 500, "{name}: {count} pixels count");
    }
}

#[test]
fn in_random_scenes() {
    let of = |seed| scene("random", &random_scene(seed));
    let counts = (0..100).map(|seed| check_all(&format!("seed {seed}"), &bare(of(seed), 48, 36), Features::generic));
    let share = counts.sum::<usize>() as f64 / (100.0 * 48.0 * 36.0);
    assert!(share > 0.3, "{share} of the pixels count");
}

#[test]
fn a_program_that_was_not_asked_to_does_not_tell() {
    let Some(info) = device() else { return };
    let scene = bare(scene("random", &random_scene(0)), 4, 3);
    let plan = plan(&scene).unwrap();
    let mut tracer = tracer(info, &plan, Precision::F32, &Features::of(&plan)).unwrap();
    assert_eq!(look(&mut *tracer, &scene).distances, None);
}
