//! How wrong one pixel may be, from its own samples and those of the pixels around it.

use scenec_device::Precision;
use scenec_picture::{Frame, Sampled, Spread};
use scenec_plan::Plan;

use crate::discrepancy::of_edges;
use crate::edges::{Missed, Taken};
use crate::setting::roundoff;

/// How many standard errors the mean of a pixel may be off that blocks of its samples tell: 8 of them tell the standard error itself only
/// roughly, and four are exceeded one time in 193 where points have no order at all (Student's t).
const ERRORS: f64 = 4.0;

/// How many count under a tolerance, where 8, 9 and up to 15 blocks tell it. A pixel may stop at any of these, so that luck has eight chances
/// from a number of samples to its double, and it has them when blocks are few. 15 are believed as Student's t has it, fewer less and
/// less, so that all in all no more pixels without order stop too early than one in 240.
const ERRORS_TO_TOLERANCE: [f64; Sampled::BLOCKS / 2] = [5.2, 4.84, 4.51, 4.2, 3.93, 3.68, 3.46, 3.31];

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
        judge.of_pixel(count, pixel.map(f64::from), spread, around, Taken::Plainly)
    };
    Some(pixels.map(doubt).collect())
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
    /// *Sampling.* With 16 samples or more, the largest of three: about four times the standard error that blocks of samples
    /// show, each block being the same points shifted (Cranley and Patterson 1976) or scrambled (Owen 1995); what the points may count wrong
    /// about a straight edge while the blocks agree, times the range of the pixel's own samples; and what a
    /// straight edge may cut off unseen, times the range of the samples all around. Where the pixel's sides were looked at,
    /// which a straight edge can't pass unseen, their colours are in its own range, and that is the one which counts; of the
    /// range all around no more is left than what a curve may cut off. With fewer, twice what the points may be wrong about
    /// any straight edge, times that range.
    ///
    /// *Rounding.* The picture is that of rays which lie a little beside their places, and so is that of a pixel moved as far: it
    /// gains and loses a strip along its sides, in which colours are within the range all around.
    pub(crate) fn of_pixel(&self, count: u32, mean: [f64; 3], spread: &Spread, around: &Range, taken: Taken) -> Doubt {
        // Without a sample nothing is known.
        let dropped = if count == 0 { f32::INFINITY } else { spread.dropped };
        let (own, truncation) = (Range::of(spread), f64::from(dropped));
        let around = around.with(&own);
        let mut worst = Doubt::default();
        for component in [0, 1, 2] {
            let (own, around) = (own.width(component), around.width(component));
            let sampling = match Missed::by(taken, count) {
                Some(missed) => (errors(taken, count) * f64::from(spread.error[component]))
                    .max(missed.edge * own)
                    .max(match taken {
                        Taken::Plainly => missed.empty * around,
                        Taken::ToTolerance => (missed.empty * own).max(missed.empty.min(CAP) * around),
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

/// How many standard errors count. A plan's points may be in step with an edge, so that too many blocks agree about it, and
/// four is what that takes.
fn errors(taken: Taken, count: u32) -> f64 {
    let more = Sampled::blocks_of(count).saturating_sub(Sampled::BLOCKS / 2);
    match taken {
        Taken::Plainly => ERRORS,
        Taken::ToTolerance => ERRORS_TO_TOLERANCE[more.min(ERRORS_TO_TOLERANCE.len() - 1)],
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
    use scenec_picture::{Sampled, Spread};
    use scenec_plan::sample_points;

    use super::{CAP, Doubt, Doubts, Range, Taken, around};
    use crate::discrepancy::area;
    use crate::edges::Missed;
    use crate::points::{SCRAMBLE, scrambled_points};

    /// The doubt about a pixel of so many samples in one component, which range from 0 to `own`, in a range up to `around`.
    fn check(count: u32, error: f32, own: f32, around: f32, expect: Doubt) {
        check_taken(Taken::Plainly, count, error, own, around, expect);
    }

    fn check_taken(taken: Taken, count: u32, error: f32, own: f32, around: f32, expect: Doubt) {
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
        assert_eq!(doubts.of_pixel(count, [1.0, 0.5, 0.0], &spread, &around, taken), expect);
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
        check(16, 0.0, 1.0, 1.0, doubt(4.5 * 7.74e-2));
        check(16, 0.0, 0.0, 1.0, doubt(1.87e-1));
        check(100, 0.0, 0.0, 1.0, doubt(1.92e-2));
        let missed = |count| Missed::by(Taken::ToTolerance, count).unwrap();
        check_taken(Taken::ToTolerance, 16, 0.0, 0.0, 1.0, doubt(CAP));
        check_taken(Taken::ToTolerance, 4096, 0.0, 0.0, 1.0, doubt(missed(4096).empty));
        check_taken(Taken::ToTolerance, 16, 0.0, 0.5, 1.0, doubt(missed(16).edge * 0.5));
        // Eight blocks, and twelve.
        check_taken(Taken::ToTolerance, 64, 0.25, 0.0, 0.0, doubt(1.3));
        check_taken(Taken::ToTolerance, 96, 0.25, 0.0, 0.0, doubt(0.9825));
        check_taken(Taken::Plainly, 96, 0.25, 0.0, 0.0, doubt(1.0));
    }

    /// Feeds pixels of so many samples, which are told apart by their number; at each number to stop at hears of the sum and the
    /// bound.
    fn sample(most: u32, colour: impl Fn(u32, [f64; 2]) -> f64, mut tell: impl FnMut(&Sampled, f64)) {
        let doubts = Doubts {
            few: 0.0,
            astray: 0.0,
            rounding: 0.0,
        };
        let mut sampled = Sampled::default();
        for (k, point) in (0..).zip(scrambled_points(most, SCRAMBLE)) {
            sampled.add([colour(k, point), 0.0, 0.0], 0.0);
            if sampled.is_stop() {
                let spread = sampled.spread();
                let own = Range::of(&spread);
                let doubt = doubts.of_pixel(sampled.count, sampled.mean(), &spread, &own, Taken::ToTolerance);
                tell(&sampled, doubt.bound());
            }
        }
    }

    #[test]
    fn no_straight_edge_is_counted_more_wrong_than_is_said() {
        let wanted = std::env::var("SCENEC_EDGES").ok().and_then(|text| text.parse().ok());
        for edge in sample_points(wanted.unwrap_or(600)) {
            let (turn, place) = (edge[0] * std::f64::consts::PI, edge[1]);
            let (sine, cosine) = turn.sin_cos();
            // Of the edges in this direction, all that cross the pixel.
            let place = place * (sine.abs() + cosine.abs());
            let exact = area(place, cosine.abs(), sine.abs());
            let below = |_, point: [f64; 2]| f64::from(u8::from(point[0] * cosine + point[1] * sine < place));
            sample(16384, below, |sampled, bound| {
                // What lies between all samples shows only at the sides.
                let (error, seen) = ((sampled.mean()[0] - exact).abs(), sampled.low[0] < sampled.high[0]);
                assert!(
                    error <= bound || !seen,
                    "{edge:?}, {}: {error} of {bound}",
                    sampled.count
                );
            });
        }
    }

    /// Without order there is nothing but the standard error.
    #[test]
    fn few_pixels_without_order_are_more_wrong_than_is_said() {
        // SplitMix64.
        let noise = |number: u64| {
            let mixed = number.wrapping_mul(0x9e37_79b9_7f4a_7c15);
            let mixed = (mixed ^ (mixed >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
            let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
            ((mixed ^ (mixed >> 31)) >> 40) as f64 / 24.0_f64.exp2()
        };
        let (pixels, mut wrong) = (1000, 0);
        for pixel in 0..pixels {
            let mut error = None;
            let colour = |k, _| noise((pixel << 32) | u64::from(k));
            sample(2048, colour, |sampled, bound| {
                if bound <= 0.05 {
                    error = error.or(Some((sampled.mean()[0] - 0.5).abs()));
                }
            });
            wrong += u64::from(error.unwrap() > 0.05);
        }
        assert!((1..=pixels / 100).contains(&wrong), "{wrong}");
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
                .of_pixel(16, mean, &Spread::default(), &range, Taken::Plainly)
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
