//! Things that are smaller than a pixel: a few samples may all miss them, and a plan knows of them beforehand.

use std::f64::consts::PI;

use scenec_picture::Window;
use scenec_plan::{Leaf, Plan, ShapeKind};

/// The gaps between n sample points are no wider than this over the root of n, in pixels.
const GAP: f64 = 1.6;

/// A thing that is wider than this many pixels is not missed.
const PLAIN: f64 = 0.4;

/// In pixels: what reaches further is seen by samples of some of them.
const MOST_REACH: f64 = 16.0;

/// How many samples each pixel of a window needs at least, so that no object which the eye sees itself is missed between
/// them: fewer and fewer, the wider the object, and none for one too small to matter to the tolerance. Row by row.
pub(crate) fn least_samples(plan: &Plan, window: Window, tolerance: f64) -> Vec<u16> {
    let mut least = vec![0; usize::try_from(window.pixels()).unwrap_or(usize::MAX)];
    for leaf in &plan.leaves {
        let Some(speck) = speck(plan, leaf) else {
            continue;
        };
        // What it covers, black on white, is what missing it costs.
        if speck.width >= PLAIN || speck.area < tolerance / 2.0 {
            continue;
        }
        let samples = (GAP / speck.width).powi(2).ceil().min(f64::from(u16::MAX)) as u16;
        let columns = touched(speck.place[0], speck.reach, window.x, window.width);
        for row in touched(speck.place[1], speck.reach, window.y, window.height) {
            for column in columns.clone() {
                let pixel = &mut least[row * window.width as usize + column];
                *pixel = samples.max(*pixel);
            }
        }
    }
    least
}

/// A leaf as the eye sees it, in pixels.
struct Speck {
    /// Its centre, from the picture's upper left corner.
    place: [f64; 2],
    /// Nothing of it is further away.
    reach: f64,
    /// A bound from below on its diameter from any side.
    width: f64,
    /// A bound on what it covers.
    area: f64,
}

fn speck(plan: &Plan, leaf: &Leaf) -> Option<Speck> {
    let (view, shape) = (&plan.view, &plan.shapes[leaf.shape as usize]);
    if shape.kind == ShapeKind::HalfSpace {
        return None;
    }
    let offset = shape.centre - view.eye;
    let axes = shape.linear.to_cols_array_2d();
    // At most the root of the sum of the squares of the semi-axes.
    let radius = axes.as_flattened().iter().map(|part| part * part).sum::<f64>().sqrt();
    let (depth, distance) = (offset.dot(view.forward), offset.length());
    if depth <= 2.0 * radius {
        return None;
    }
    let pixels = f64::from(view.width) / (2.0 * view.right.length());
    let along = |axis: scenec_scene::DVec3| offset.dot(axis) / axis.length_squared() / depth;
    let place = [
        (1.0 + along(view.right)) / 2.0 * f64::from(view.width),
        (1.0 - along(view.up)) / 2.0 * f64::from(view.height),
    ];
    // Away from the middle of the picture things are drawn larger, up to the square of the slant.
    let slant = distance / depth;
    let near = radius / (depth - radius) * pixels * slant;
    let speck = Speck {
        place,
        reach: near + 1.0,
        width: 2.0 * shape.least_radius() / distance * pixels,
        area: PI * near * near,
    };
    (speck.reach <= MOST_REACH).then_some(speck)
}

/// The columns or rows of a window that lie so far around a place.
fn touched(place: f64, reach: f64, first: u32, count: u32) -> std::ops::Range<usize> {
    let inside = |at: f64| (at - f64::from(first)).clamp(0.0, f64::from(count)) as usize;
    inside((place - reach).floor())..inside((place + reach).ceil())
}
