//! How wrong one pixel may be, from its own samples and those of the pixels around it.

use scenec_device::Precision;
use scenec_picture::{Frame, Spread};
use scenec_plan::Plan;

use crate::discrepancy::of_edges;
use crate::setting::roundoff;

/// How many standard errors the mean of a pixel may be off. As few blocks as there are tell the standard error itself
/// only roughly.
const ERRORS: f64 = 4.0;

/// How many times its typical share an edge may be counted wrong.
const EDGES: f64 = 4.0;

/// How many roundings of itself a colour may be off by where no ray takes another way: the sums and products of shading.
pub(crate) const SHADING: f64 = 16.0;

/// How many times the roundings of its surfaces' places a ray may lie beside where it belongs.
const ASTRAY: f64 = 4.0;

/// How wrong a pixel may be in its worst component.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct Doubt {
    /// Proven: what dropped branches may have added.
    pub truncation: f32,
    /// Estimated: what roundings change.
    pub rounding: f32,
    /// Estimated: what more samples would change.
    pub sampling: f32,
}

impl Doubt {
    /// The bound on the pixel's distance from what it would be without end.
    #[must_use]
    pub fn bound(&self) -> f64 {
        f64::from(self.truncation) + f64::from(self.rounding) + f64::from(self.sampling)
    }
}

/// From the least to the most of each component.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct Range {
    low: [f32; 3],
    high: [f32; 3],
}

impl Range {
    const NONE: Self = Self {
        low: [f32::INFINITY; 3],
        high: [f32::NEG_INFINITY; 3],
    };

    /// Of one pixel's samples.
    pub(crate) const fn of(spread: &Spread) -> Self {
        Self {
            low: spread.low,
            high: spread.high,
        }
    }

    /// What holds both.
    pub(crate) fn with(self, other: &Self) -> Self {
        Self {
            low: [0, 1, 2].map(|c| self.low[c].min(other.low[c])),
            high: [0, 1, 2].map(|c| self.high[c].max(other.high[c])),
        }
    }

    fn width(&self, component: usize) -> f64 {
        f64::from((self.high[component] - self.low[component]).max(0.0))
    }
}

/// The ranges of each pixel together with the eight around it, of a picture with so many columns.
pub(crate) fn around(ranges: &[Range], columns: usize) -> Vec<Range> {
    let rows = ranges.len() / columns.max(1);
    let of = |index: usize| {
        let (x, y) = (index % columns, index / columns);
        let across = x.saturating_sub(1)..(x + 2).min(columns);
        (y.saturating_sub(1)..(y + 2).min(rows))
            .flat_map(|row| &ranges[row * columns + across.start..row * columns + across.end])
            .fold(Range::NONE, |sum, range| sum.with(range))
    };
    (0..ranges.len()).map(of).collect()
}

/// What a number of sample points may miss.
#[derive(Clone, Copy, PartialEq, Debug)]
struct Points {
    /// The largest part of a pixel that a straight edge can cut off without a point in it.
    empty: f64,
    /// The share of a pixel by which the points count a straight edge wrong: the root of the mean square over all edges.
    typical: f64,
}

/// The first points of the sequence, at the numbers that pixels stop at.
const POINTS: &[(u32, f64, f64)] = &[
    (16, 1.87e-1, 7.74e-2),
    (24, 1.46e-1, 5.72e-2),
    (32, 1.05e-1, 5.14e-2),
    (48, 9.75e-2, 3.75e-2),
    (64, 3.84e-2, 2.27e-2),
    (96, 1.92e-2, 1.23e-2),
    (128, 1.92e-2, 1.33e-2),
    (192, 1.92e-2, 7.29e-3),
    (256, 1.18e-2, 5.91e-3),
    (384, 1.18e-2, 4.39e-3),
    (512, 6.15e-3, 3.15e-3),
    (768, 3.13e-3, 2.45e-3),
    (1024, 1.61e-3, 2.01e-3),
    (1536, 1.52e-3, 1.47e-3),
    (2048, 9.57e-4, 1.08e-3),
    (3072, 8.69e-4, 8.58e-4),
    (4096, 8.69e-4, 7.28e-4),
    (6144, 3.27e-4, 5.02e-4),
    (8192, 1.93e-4, 3.73e-4),
    (12288, 1.46e-4, 2.84e-4),
    (16384, 1.18e-4, 2.26e-4),
    (24576, 9.71e-5, 1.54e-4),
    (32768, 7.71e-5, 1.23e-4),
    (49152, 3.11e-5, 9.61e-5),
    (65536, 2.71e-5, 7.41e-5),
    (98304, 1.81e-5, 4.71e-5),
    (131_072, 1.81e-5, 3.91e-5),
    (196_608, 1.51e-5, 3.61e-5),
    (262_144, 1.51e-5, 3.21e-5),
];

/// The most samples that there is a row for.
pub(crate) const MOST_SAMPLES: u32 = 1 << 18;

impl Points {
    /// Of as many points, or the next smaller number that is listed.
    fn first(count: u32) -> Option<Self> {
        let place = POINTS.partition_point(|row| row.0 <= count);
        let (_, empty, typical) = *POINTS.get(place.checked_sub(1)?)?;
        Some(Self { empty, typical })
    }
}

/// How wrong each pixel of a picture may be that was traced with the sample points of a plan, the same for all of its pixels.
/// `None` if the tracer did not tell how far its samples are apart.
#[must_use]
pub fn doubts(plan: &Plan, precision: Precision, frame: &Frame) -> Option<Vec<Doubt>> {
    let spread = frame.spread.as_ref()?;
    let judge = Doubts::of(plan, roundoff(precision));
    let ranges: Vec<_> = spread.iter().map(Range::of).collect();
    let around = around(&ranges, frame.picture.width() as usize);
    let count = u32::try_from(plan.view.samples.len()).unwrap_or(u32::MAX);
    let pixels = frame.picture.pixels().iter().zip(spread).zip(&around);
    let doubt = |((pixel, spread), around): ((&[f32; 3], &Spread), &Range)| {
        judge.of_pixel(count, pixel.map(f64::from), spread, around, Sides::Unseen)
    };
    Some(pixels.map(doubt).collect())
}

/// Whether the points on a pixel's sides are in its range.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Sides {
    Unseen,
    Seen,
}

/// The largest part of a pixel that a disc with a radius of half a pixel cuts off between two points on a side.
const CAP: f64 = 2.7e-3;

/// Tells how wrong pixels may be.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Doubts {
    /// The share of a contrast that too few points for any other estimate may be wrong about.
    few: f64,
    /// How far a ray may lie beside where it belongs, in pixels.
    astray: f64,
    /// Relative to a component.
    rounding: f64,
}

impl Doubts {
    /// For pictures of a plan that are traced with this unit roundoff.
    pub(crate) fn of(plan: &Plan, roundoff: f64) -> Self {
        let points = &plan.view.samples;
        Self {
            few: of_edges(points.get(..points.len().min(16)).unwrap_or_default()),
            astray: ASTRAY * plan.displaced(roundoff),
            // The picture itself is of singles.
            rounding: SHADING * roundoff + f64::from(f32::EPSILON) / 2.0,
        }
    }

    /// What roundings may change across a full contrast.
    pub(crate) fn of_a_contrast(&self) -> f64 {
        std::f64::consts::SQRT_2 * self.astray + self.rounding
    }

    /// How wrong a pixel may be whose samples have this mean and spread, in the midst of that range.
    ///
    /// *Sampling.* With 16 samples or more, the largest of three: four times the standard error that blocks of samples
    /// show, each block being the same points shifted (Cranley and Patterson 1976); four times what the points typically
    /// count wrong about a straight edge, times the range of the pixel's own samples; and what a straight edge may cut
    /// off unseen, times the range of the samples all around. Where the pixel's sides were looked at, which a straight edge can't
    /// pass unseen, their colours are in its own range, and that is the one which counts; of the range all around no more is left
    /// than what a curve may cut off. With fewer, twice what the points may be wrong about
    /// any straight edge, times that range.
    ///
    /// *Rounding.* The picture is that of rays which lie a little beside their places, and so is that of a pixel moved as far: it
    /// gains and loses a strip along its sides, in which colours are within the range all around.
    pub(crate) fn of_pixel(&self, count: u32, mean: [f64; 3], spread: &Spread, around: &Range, sides: Sides) -> Doubt {
        // Without a sample nothing is known.
        let dropped = if count == 0 { f32::INFINITY } else { spread.dropped };
        let (own, truncation) = (Range::of(spread), f64::from(dropped));
        let around = around.with(&own);
        let mut worst = Doubt::default();
        for component in [0, 1, 2] {
            let (own, around) = (own.width(component), around.width(component));
            let sampling = match Points::first(count) {
                Some(points) => (ERRORS * f64::from(spread.error[component]))
                    .max(EDGES * points.typical * own)
                    .max(match sides {
                        Sides::Unseen => points.empty * around,
                        Sides::Seen => (points.empty * own).max(points.empty.min(CAP) * around),
                    }),
                None => 2.0 * self.few * around,
            };
            let strip = std::f64::consts::SQRT_2 * self.astray * around;
            let rounding = strip + self.rounding * mean[component].abs();
            let doubt = Doubt {
                truncation: upwards(truncation),
                rounding: upwards(rounding),
                sampling: upwards(sampling),
            };
            if !mean[component].is_finite() || doubt.bound().is_nan() {
                return Doubt {
                    truncation: f32::INFINITY,
                    ..Doubt::default()
                };
            }
            if doubt.bound() >= worst.bound() {
                worst = doubt;
            }
        }
        worst
    }
}

/// A single that is not below.
fn upwards(value: f64) -> f32 {
    let single = value as f32;
    if f64::from(single) < value {
        single.next_up()
    } else {
        single
    }
}

#[cfg(test)]
mod tests {
    use scenec_picture::Spread;
    use scenec_plan::sample_points;

    use super::{CAP, Doubt, Doubts, MOST_SAMPLES, POINTS, Range, Sides, around};
    use crate::discrepancy::{empty, typical};

    #[test]
    fn the_table_is_what_the_points_give() {
        assert_eq!(POINTS.last().map(|row| row.0), Some(MOST_SAMPLES));
        for (count, empty_part, typical_share) in POINTS.iter().take_while(|row| row.0 <= 4096) {
            let points = sample_points(*count);
            for (found, listed) in [(empty(&points), empty_part), (typical(&points), typical_share)] {
                assert!(found <= *listed && *listed <= 1.01 * found, "{count}: {found} {listed}");
            }
        }
    }

    /// The doubt about a pixel of so many samples in one component, which range from 0 to `own`, in a range up to `around`.
    fn check(count: u32, error: f32, own: f32, around: f32, expect: Doubt) {
        check_sides(Sides::Unseen, count, error, own, around, expect);
    }

    fn check_sides(sides: Sides, count: u32, error: f32, own: f32, around: f32, expect: Doubt) {
        let doubts = Doubts {
            few: 0.25,
            astray: 0.0,
            rounding: 0.125,
        };
        let spread = Spread {
            high: [own, 0.0, 0.0],
            error: [error, 0.0, 0.0],
            dropped: 0.5,
            ..Spread::default()
        };
        let around = Range {
            low: [0.0; 3],
            high: [around, 0.0, 0.0],
        };
        assert_eq!(doubts.of_pixel(count, [1.0, 0.5, 0.0], &spread, &around, sides), expect);
    }

    fn doubt(sampling: f64) -> Doubt {
        Doubt {
            truncation: 0.5,
            rounding: 0.125,
            sampling: super::upwards(sampling),
        }
    }

    #[test]
    fn the_largest_estimate_counts() {
        check(1, f32::INFINITY, 0.0, 0.0, doubt(0.0));
        check(1, f32::INFINITY, 0.0, 1.0, doubt(0.5));
        check(16, 0.0, 0.0, 0.0, doubt(0.0));
        check(16, 0.25, 1.0, 1.0, doubt(1.0));
        check(16, 0.0, 1.0, 1.0, doubt(4.0 * 7.74e-2));
        check(16, 0.0, 0.0, 1.0, doubt(1.87e-1));
        check(100, 0.0, 0.0, 1.0, doubt(1.92e-2));
        check_sides(Sides::Seen, 16, 0.0, 0.0, 1.0, doubt(CAP));
        check_sides(Sides::Seen, 4096, 0.0, 0.0, 1.0, doubt(8.69e-4));
        check_sides(Sides::Seen, 16, 0.0, 0.5, 1.0, doubt(4.0 * 7.74e-2 * 0.5));
    }

    #[test]
    fn what_is_no_number_has_no_bound() {
        let doubts = Doubts {
            few: 0.5,
            astray: 0.0,
            rounding: 0.0,
        };
        let range = Range::of(&Spread::default());
        let of = |mean| {
            doubts
                .of_pixel(16, mean, &Spread::default(), &range, Sides::Unseen)
                .bound()
        };
        assert_eq!(of([1.0, f64::NAN, 1.0]), f64::INFINITY);
        assert_eq!(of([1.0, f64::INFINITY, 1.0]), f64::INFINITY);
        assert_eq!(of([1.0; 3]), 0.0);
    }

    #[test]
    fn neighbours_count_up_to_the_sides_of_the_picture() {
        let ranges: Vec<_> = (0..6)
            .map(|k| Range {
                low: [k as f32; 3],
                high: [k as f32 + 0.5; 3],
            })
            .collect();
        let widths = |columns| -> Vec<f64> { around(&ranges, columns).iter().map(|range| range.width(0)).collect() };
        assert_eq!(widths(3), [4.5, 5.5, 4.5, 4.5, 5.5, 4.5]);
        assert_eq!(widths(1), [1.5, 2.5, 2.5, 2.5, 2.5, 1.5]);
    }
}
