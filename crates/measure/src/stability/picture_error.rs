//! How far a picture is from what it should be, in the units of each oracle.

use scenec_picture::{Exact, NOTHING};
use scenec_scene::{Camera, DVec3, Scene, View, view};

use super::machines::Shot;

/// The largest difference of a component; infinite if a number is none.
#[must_use]
pub fn apart(a: [f64; 3], b: [f64; 3]) -> f64 {
    let apart = |i: usize| (a[i] - b[i]).abs();
    (0..3)
        .map(apart)
        .fold(0.0, |most, x| if x.is_nan() { f64::INFINITY } else { x.max(most) })
}

/// The largest difference from another picture on the pixels that count.
pub(super) fn largest(shot: &Exact, other: &Exact, counts: impl Fn(usize) -> bool) -> f64 {
    let pairs = shot.iter().zip(other).enumerate().filter(|(i, _)| counts(*i));
    pairs.map(|(_, (a, b))| apart(*a, *b)).fold(0.0, f64::max)
}

/// The pixels that show another object.
pub(super) fn strays(shot: &Shot, other: &Shot) -> Vec<usize> {
    let pairs = shot.frame.ids.iter().flatten().zip(other.frame.ids.iter().flatten());
    let strays = pairs.enumerate().filter(|(_, (a, b))| a != b);
    strays.map(|(i, _)| i).collect()
}

/// The root mean square difference.
pub(super) fn root_mean_square(a: &Exact, b: &Exact) -> f64 {
    let square = |(a, b): (&[f64; 3], &[f64; 3])| (0..3).map(|i| (a[i] - b[i]).powi(2)).sum::<f64>();
    (a.iter().zip(b).map(square).sum::<f64>() / (3 * a.len().max(1)) as f64).sqrt()
}

/// The share of pixels with a number that is not finite, or that differ from those of a second run.
pub(super) fn unsteady(first: &Shot, second: &Shot) -> f64 {
    let bits = |pixel: &[f64; 3]| pixel.map(f64::to_bits);
    let wrong = first.exact.iter().zip(&second.exact);
    let wrong = wrong.filter(|(a, b)| bits(a) != bits(b) || !a.iter().all(|x| x.is_finite()));
    share(wrong.count(), first.exact.len())
}

/// The share of pixels that see an object.
pub(super) fn seen(shot: &Shot) -> f64 {
    let ids = shot.frame.ids.as_deref().unwrap_or_default();
    share(ids.iter().filter(|id| **id != NOTHING).count(), ids.len())
}

fn share(count: usize, of: usize) -> f64 {
    count as f64 / of.max(1) as f64
}

/// The largest distance of a wrongly seen pixel's centre from an outline, in units of `unit` radians. `inside` tells how
/// far within the outline a direction lies, in radians; negative outside.
pub(super) fn beyond_outline(shot: &Shot, scene: &Scene, unit: f64, inside: impl Fn(DVec3) -> f64) -> f64 {
    let (View::Clear(camera) | View::AlongUp(camera)) = view(&scene.settings) else {
        return f64::INFINITY;
    };
    let ids = shot.frame.ids.as_deref().unwrap_or_default();
    let width = scene.settings.width as usize;
    let wrong = ids.iter().enumerate().filter_map(|(i, id)| {
        let depth = inside(towards(scene, &camera, i % width, i / width));
        ((depth > 0.0) != (*id != NOTHING)).then(|| depth.abs() / unit)
    });
    wrong.fold(0.0, f64::max)
}

/// The direction through a pixel's centre, by the camera's definition.
fn towards(scene: &Scene, camera: &Camera, x: usize, y: usize) -> DVec3 {
    let across = 2.0 * (x as f64 + 0.5) / f64::from(scene.settings.width) - 1.0;
    let upward = 1.0 - 2.0 * (y as f64 + 0.5) / f64::from(scene.settings.height);
    (camera.forward + camera.right * across + camera.up * upward).normalize()
}

/// How far within a ball's tangent cone a direction lies, in radians, for an eye outside the ball.
pub(super) fn within_ball(way: DVec3, radius: f64, direction: DVec3) -> f64 {
    let distance = way.length();
    let axis = way / distance;
    // Angles from their sines: a cosine near 1 has no digits.
    let off = direction.cross(axis).length().atan2(direction.dot(axis));
    (radius / distance).asin() - off
}
