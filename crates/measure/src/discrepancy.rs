//! How wrong the share of sample points on one side of an edge may be.

use std::f64::consts::PI;

/// Directions of edges that are tried.
const DIRECTIONS: u32 = 90;

/// The largest difference between the share of points that lie on one side of a straight edge and the share of the
/// pixel that does, over all edges. Points are measured from the centre of a pixel of side 1.
pub(crate) fn of_edges(points: &[[f64; 2]]) -> f64 {
    let mut worst = 0.0_f64;
    // The edge passes a point on either side.
    each(points, |below, area, step| {
        worst = worst.max((area - below).abs()).max((below + step - area).abs());
    });
    worst
}

/// The same difference over edges of all directions through all points, which have half of their point on either side:
/// the root of the mean square.
#[cfg(test)]
pub(crate) fn typical(points: &[[f64; 2]]) -> f64 {
    let (mut squares, mut count) = (0.0, 0.0);
    each(points, |below, area, step| {
        squares += (below + step / 2.0 - area).powi(2);
        count += 1.0;
    });
    (squares / f64::max(count, 1.0)).sqrt()
}

/// The largest part of the pixel that an edge cuts off without a point in it.
#[cfg(test)]
pub(crate) fn empty(points: &[[f64; 2]]) -> f64 {
    let mut worst = 0.0_f64;
    each(points, |below, area, step| {
        if below == 0.0 {
            worst = worst.max(area);
        }
        if below + 1.5 * step > 1.0 {
            worst = worst.max(1.0 - area);
        }
    });
    worst
}

/// Tells, for edges of all directions through each point: the share of the points on one side without this one, the share of
/// the pixel, and the share of a point.
fn each(points: &[[f64; 2]], mut tell: impl FnMut(f64, f64, f64)) {
    let step = 1.0 / points.len().max(1) as f64;
    for direction in 0..DIRECTIONS {
        let (sine, cosine) = (PI * f64::from(direction) / f64::from(DIRECTIONS)).sin_cos();
        let mut places: Vec<_> = points.iter().map(|[x, y]| x * cosine + y * sine).collect();
        places.sort_by(f64::total_cmp);
        for (below, place) in (0..).map(|count| f64::from(count) * step).zip(places) {
            tell(below, area(place, cosine.abs(), sine.abs()), step);
        }
    }
}

/// The share of the square on one side of an edge: `place` is its distance from the centre, `a` and `b` the parts of its
/// unit normal along the sides.
pub(crate) fn area(place: f64, a: f64, b: f64) -> f64 {
    let (long, short) = (a.max(b), a.min(b));
    let width = long + short;
    let from_corner = (place + width / 2.0).clamp(0.0, width);
    // The corners' triangles, and the slanted band between them.
    if from_corner < short {
        from_corner * from_corner / (2.0 * long * short)
    } else if from_corner <= long {
        (from_corner - short / 2.0) / long
    } else {
        1.0 - (width - from_corner).powi(2) / (2.0 * long * short)
    }
}

#[cfg(test)]
mod tests {
    use super::{area, of_edges};

    #[test]
    fn shares_of_the_square() {
        let half = 0.5_f64.sqrt();
        for (place, a, b, expect) in [
            (0.0, 1.0, 0.0, 0.5),
            (0.25, 0.0, 1.0, 0.75),
            (-1.0, 1.0, 0.0, 0.0),
            (0.0, half, half, 0.5),
            (-half / 2.0, half, half, 0.125),
            (half / 2.0, half, half, 0.875),
            (half, half, half, 1.0),
            (0.0, 0.8, 0.6, 0.5),
        ] {
            assert!((area(place, a, b) - expect).abs() < 1e-12, "{place} {a} {b}");
        }
    }

    #[test]
    fn one_point_at_the_centre_is_half_wrong_and_more_are_less() {
        assert!((of_edges(&[[0.0, 0.0]]) - 0.5).abs() < 1e-12);
        let grid: Vec<_> = (0..64)
            .map(|k| [k % 8, k / 8].map(|place| (f64::from(place) + 0.5) / 8.0 - 0.5))
            .collect();
        // An edge just beside a row of eight.
        assert!((of_edges(&grid) - 1.0 / 16.0).abs() < 0.02, "{}", of_edges(&grid));
    }
}
