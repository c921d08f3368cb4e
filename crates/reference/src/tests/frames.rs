//! Whole pictures, their layers and their accounts.

use scenec_picture::{Frame, Layers, Limits, NOTHING, Request, TraceError, Tracer, Watch, Window};
use scenec_scene::{Base, DVec3, MaterialId, Op, Scene, Transform};

use super::{Build, glow, scene};
use crate::Reference;

fn trace(scene: &Scene, window: Window, limits: Limits, watch: &Watch) -> Result<Frame, TraceError> {
    let layers = Layers {
        ids: true,
        exact: true,
        paths: true,
        ..Layers::default()
    };
    Reference::new(scene).trace(&Request {
        window,
        limits,
        layers,
        watch,
    })
}

fn frame(scene: &Scene, window: Window) -> Frame {
    let watch = Watch::new();
    let frame = trace(scene, window, Limits::DEFAULT, &watch).unwrap();
    assert_eq!(watch.done(), window.pixels());
    frame
}

/// A ball over a floor, under a light.
fn still_life(width: u32, height: u32) -> Scene {
    let mut scene = scene();
    (scene.settings.width, scene.settings.height) = (width, height);
    scene.settings.eyepos = DVec3::Z * 3.0;
    scene.settings.lookat = DVec3::ZERO;
    let ball = scene.ball([0.0; 3], 1.0);
    let floor = scene.leaf(
        Base::HalfSpace,
        Transform::IDENTITY.translated(-DVec3::Y),
        MaterialId::DEFAULT,
    );
    scene.combine(Op::Union, ball, floor);
    scene.light([3.0, 4.0, 5.0], 1.0);
    scene
}

#[test]
fn the_horizon_is_where_the_tilt_says() {
    for (tilt, first) in [(0.0, 50), (0.305, 35), (-0.305, 65)] {
        let mut scene = scene();
        (scene.settings.width, scene.settings.height) = (100, 100);
        scene.settings.eyepos = DVec3::Y;
        scene.settings.lookat = DVec3::new(0.0, 1.0 - tilt, -1.0);
        scene.leaf(Base::HalfSpace, Transform::IDENTITY, MaterialId::DEFAULT);
        let ids = frame(&scene, Window::whole(100, 100)).ids.unwrap();
        for (index, id) in ids.into_iter().enumerate() {
            assert_eq!(id == NOTHING, index / 100 < first, "{tilt}: pixel {index}");
        }
    }
}

#[test]
fn a_disc_is_as_wide_as_the_tangent_cone() {
    let mut scene = scene();
    (scene.settings.width, scene.settings.height) = (301, 3);
    scene.settings.eyepos = DVec3::Z * 5.0;
    scene.settings.fov = 0.5;
    let ball = scene.ball([0.0; 3], 1.0);
    let ids = frame(&scene, Window::whole(301, 3)).ids.unwrap();
    let wide = ids[301..602].iter().filter(|&&id| id == ball.0).count();
    // The tangent is 1 / sqrt(24), the picture's edge tan 0.25, 150.5 pixels from the middle of the middle one.
    let radius = 150.5 / 24f64.sqrt() / 0.25f64.tan();
    assert_eq!(wide, 2 * radius.floor() as usize + 1);
}

#[test]
fn a_window_is_a_piece_of_the_whole() {
    let scene = still_life(17, 13);
    let whole = frame(&scene, Window::whole(17, 13));
    let window = Window {
        x: 5,
        y: 3,
        width: 7,
        height: 9,
    };
    let piece = frame(&scene, window);
    for y in 0..9 {
        for x in 0..7 {
            let (there, here) = ((y + 3) * 17 + x + 5, y * 7 + x);
            let exact = |frame: &Frame, index: usize| frame.exact.as_ref().unwrap()[index];
            assert_eq!(exact(&whole, there), exact(&piece, here));
            assert_eq!(whole.ids.as_ref().unwrap()[there], piece.ids.as_ref().unwrap()[here]);
            assert_eq!(
                whole.paths.as_ref().unwrap()[there],
                piece.paths.as_ref().unwrap()[here]
            );
            let narrow = exact(&whole, there).map(|value| value as f32);
            assert_eq!(piece.picture.row(y as u32)[x], narrow);
        }
    }
    assert_eq!(whole.stats.primary, 17 * 13);
}

#[test]
fn samples_are_averaged_and_the_first_one_names_the_pixel() {
    // Two samples, at the centre of the only pixel and at 0.2549 0.0698 of it: the ball and the sky.
    let mut scene = scene();
    (scene.settings.width, scene.settings.height, scene.settings.samples) = (1, 1, 2);
    scene.settings.eyepos = DVec3::Z * 5.0;
    let one = glow(&mut scene, 3.0);
    let ball = scene.leaf(Base::Sphere, Transform::IDENTITY, one);
    let frame = frame(&scene, Window::whole(1, 1));
    // With an ambient light of 1, the sky is 1 everywhere.
    assert_eq!(frame.exact.unwrap(), [[2.0; 3]]);
    assert_eq!(frame.ids.unwrap(), [ball.0]);
    assert_eq!(frame.stats.primary, 2);
}

#[test]
fn paths_differ_where_ways_do() {
    let scene = still_life(64, 64);
    let frame = frame(&scene, Window::whole(64, 64));
    let (ids, mut paths) = (frame.ids.unwrap(), frame.paths.unwrap());
    for (index, id) in ids.iter().enumerate() {
        let same = (0..ids.len()).filter(|&other| paths[other] == paths[index]);
        assert!(same.into_iter().all(|other| ids[other] == *id), "pixel {index}");
    }
    paths.sort_unstable();
    paths.dedup();
    // The sky; the ball facing the light and not; the floor lit and in shadow.
    assert_eq!(paths.len(), 5);
}

#[test]
fn a_budget_drops_the_rest_and_says_so() {
    let mut scene = still_life(8, 8);
    scene.settings.ambient = DVec3::ONE;
    scene.materials[0].reflect = 0.5;
    let watch = Watch::new();
    let whole = frame(&scene, Window::whole(8, 8));
    assert_eq!((whole.stats.over_budget, whole.stats.dropped), (0, 0.0));
    let limits = Limits {
        ray_budget: 2,
        ..Limits::DEFAULT
    };
    let cut = trace(&scene, Window::whole(8, 8), limits, &watch).unwrap();
    let mut changed = 0;
    for (a, b) in whole.exact.unwrap().iter().zip(cut.exact.unwrap()) {
        let lost = (0..3).map(|index| (a[index] - b[index]).abs()).fold(0.0, f64::max);
        assert!(lost <= cut.stats.dropped, "{lost} of at most {}", cut.stats.dropped);
        changed += u64::from(lost > 0.0);
    }
    assert!(changed > 0 && changed <= cut.stats.over_budget, "{changed}");
    assert!(cut.stats.primary + cut.stats.reflected <= 2 * 64);
}

#[test]
fn there_is_no_half_a_frame() {
    let scene = still_life(64, 64);
    let watch = Watch::new();
    watch.stop();
    let stopped = trace(&scene, Window::whole(64, 64), Limits::DEFAULT, &watch);
    assert_eq!(stopped.unwrap_err(), TraceError::Cancelled);
    let large = trace(&scene, Window::whole(65535, 65535), Limits::DEFAULT, &Watch::new());
    assert!(matches!(large, Err(TraceError::TooManyPixels(_))));
    let mut blind = scene.clone();
    blind.settings.lookat = blind.settings.eyepos;
    let error = trace(&blind, Window::whole(1, 1), Limits::DEFAULT, &Watch::new());
    assert!(matches!(error, Err(TraceError::Failed(_))));
}
