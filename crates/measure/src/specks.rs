//! Things that are smaller than a pixel: a few samples may all miss them, and a plan knows of them beforehand.

use std::f64::consts::PI;

use scenec_picture::Window;
use scenec_plan::{Leaf, Plan, ShapeKind};

/// The gaps between n scrambled points are no wider than this over the root of n, in pixels, at the numbers that pixels stop at.
const GAP: f64 = 2.5;

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
    if shape.kind() == ShapeKind::HalfSpace {
        return None;
    }
    let offset = shape.centre - view.eye;
    let axes = shape.linear().to_cols_array_2d();
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

#[cfg(test)]
mod tests {
    use std::iter;

    use scenec_picture::Sampled;

    use super::GAP;
    use crate::points::{SCRAMBLE, scrambled_points};

    /// The diameter of the largest disc without a point, where pixels with the same points are all around.
    fn gap(points: &[[f64; 2]]) -> f64 {
        let steps = (6.0 * (points.len() as f64).sqrt()) as u32;
        let place = |step: u32| (f64::from(step) + 0.5) / f64::from(steps) - 0.5;
        let aside = |a: f64, b: f64| (a - b).abs().min(1.0 - (a - b).abs());
        let nearest = |[x, y]: [f64; 2]| {
            let square = |point: &[f64; 2]| aside(x, point[0]).powi(2) + aside(y, point[1]).powi(2);
            points.iter().map(square).fold(f64::INFINITY, f64::min)
        };
        let places = (0..steps * steps).map(|k| [place(k % steps), place(k / steps)]);
        2.0 * places.map(nearest).fold(0.0, f64::max).sqrt()
    }

    #[test]
    fn no_gap_is_wider_than_is_said() {
        let all = scrambled_points(768, SCRAMBLE);
        let stops = iter::successors(Some(16), |count| Some(Sampled::stop_after(*count)));
        let widths: Vec<_> = stops
            .take_while(|count| *count <= 768)
            .map(|count| gap(&all[..count as usize]) * f64::from(count).sqrt())
            .collect();
        let widest = widths.iter().copied().fold(0.0, f64::max);
        assert!(widest <= GAP && GAP < 1.1 * widest, "{widths:?}");
    }
}
