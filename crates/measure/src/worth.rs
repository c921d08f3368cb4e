//! What a tolerance is worth: what it costs beside the cheapest number of samples that is as good everywhere.

use std::fmt::Write;

use scenec_cpu::Cpu;
use scenec_picture::{Exact, Limits, Refiner as _, Sampled, Task, TraceError};
use scenec_plan::{PlanError, plan, sample_points};

use crate::points::Scramble;
use crate::tolerance::{Achieved, Tolerance};

/// The reference is this many times more exact than what is judged by it.
const FINER: f64 = 8.0;

/// The reference's sample points, which are not those that it judges.
const OTHER: Scramble = [0x7654_3210, 0x0fed_cba9];

/// A tolerance at work on one scene.
#[derive(Clone, Debug)]
pub struct Worth {
    /// What came of it.
    pub achieved: Achieved,
    /// The largest difference from the reference.
    pub error: f64,
    /// How wrong the reference may be by its own bound: more than was asked of it where some pixels of it had to be given up.
    pub reference: f64,
    /// Pixels further from the reference than their bound and the reference's own.
    pub defects: u64,
    /// The samples of every pixel without a tolerance, so that the bound of each is within it; and their rays.
    pub by_bound: (u32, u64),
    /// The same, so that the error of each is within it: nobody knows this one beforehand.
    pub by_error: (u32, u64),
}

/// Renders a scene to a tolerance, and finds out how wrong it is and what the same samples for all pixels would cost.
///
/// The reference is the same scene to an eighth of the tolerance, with other sample points. Every pixel has a number
/// of samples at which its bound is within the tolerance; all together need the largest of these. Rays of so many
/// samples are those of 64, as often as they go into them.
///
/// # Errors
/// Those of [`Tolerance::achieve`].
pub fn worth(wish: &Tolerance<'_>) -> Result<Worth, TraceError> {
    let achieved = wish.achieve()?;
    let finer = Tolerance {
        tolerance: wish.tolerance / FINER,
        ..*wish
    };
    let truth = finer.achieve_with(OTHER)?;
    let pixels = achieved.picture.pixels().iter().zip(truth.picture.pixels());
    let errors: Vec<f64> = pixels
        .map(|(a, b)| (0..3).map(|c| f64::from((a[c] - b[c]).abs())).fold(0.0, f64::max))
        .collect();
    let bounds = achieved.doubts.iter().zip(&truth.doubts);
    let allowed = bounds.map(|(own, reference)| own.bound() + reference.bound());
    let exact: Exact = truth
        .picture
        .pixels()
        .iter()
        .map(|pixel| pixel.map(f64::from))
        .collect();
    let most = achieved.samples.iter().copied().max().unwrap_or_default();
    let (enough, rays) = Uniform::of(wish)?.enough(&exact, most)?;
    let of = |samples: u32| (samples, (rays * f64::from(samples)) as u64);
    Ok(Worth {
        error: errors.iter().copied().fold(0.0, f64::max),
        defects: errors
            .iter()
            .zip(allowed)
            .filter(|(error, allowed)| *error > allowed)
            .count() as u64,
        reference: truth.bound.max,
        by_bound: of(most),
        by_error: of(enough),
        achieved,
    })
}

/// The same samples for every pixel.
struct Uniform<'a> {
    wish: &'a Tolerance<'a>,
    cpu: Cpu<f32>,
}

impl<'a> Uniform<'a> {
    fn of(wish: &'a Tolerance<'a>) -> Result<Self, TraceError> {
        let plan = plan(wish.scene).map_err(|error: PlanError| TraceError::Failed(error.to_string()))?;
        let cpu = Cpu::new(&plan, wish.threads)?;
        Ok(Self { wish, cpu })
    }

    /// The first of 64, 96, 128, 192 and so on up to a given number, with which no pixel is further from the truth than the
    /// tolerance; and the rays of one sample for each pixel.
    fn enough(&mut self, truth: &Exact, most: u32) -> Result<(u32, f64), TraceError> {
        let window = self.wish.window;
        let pixels: Vec<u32> = (0..u32::try_from(window.pixels()).unwrap_or(u32::MAX)).collect();
        let size = (self.wish.scene.settings.width, self.wish.scene.settings.height);
        let mut samples = 64;
        loop {
            self.cpu.divide(size.0, size.1, &sample_points(samples));
            let task = Task {
                pixels: &pixels,
                enough: &|_, _: &Sampled| false,
                sides: false,
                spare: f64::INFINITY,
            };
            let limits = Limits {
                ray_budget: self.wish.ray_budget,
                ..Limits::DEFAULT
            };
            let (found, stats) = self.cpu.refine(window, limits, &task, self.wish.watch)?;
            let near = |(pixel, truth): (&[f64; 3], &[f64; 3])| {
                pixel
                    .iter()
                    .zip(truth)
                    .all(|(a, b)| (a - b).abs() <= self.wish.tolerance)
            };
            if samples >= most || found.iter().map(|pixel| &pixel.mean).zip(truth).all(near) {
                return Ok((samples, stats.rays() as f64 / f64::from(samples)));
            }
            samples = if samples.is_power_of_two() {
                samples / 2 * 3
            } else {
                samples / 3 * 4
            };
        }
    }
}

/// The table in Markdown, a line a scene.
#[must_use]
pub fn worth_table(rows: &[(String, Worth)]) -> String {
    let mut text = "| scene | samples per pixel: mean, most | rays | bound | error | bound of the reference | \
         the same samples everywhere, by bound | rays | by error | rays |\n|---|---|---|---|---|---|---|---|---|---|\n"
        .to_owned();
    for (name, row) in rows {
        let Achieved {
            samples, stats, bound, ..
        } = &row.achieved;
        let mean = samples.iter().map(|n| f64::from(*n)).sum::<f64>() / samples.len().max(1) as f64;
        let rays = stats.rays();
        let many = |(samples, own): (u32, u64)| {
            let times = own as f64 / rays.max(1) as f64;
            format!("{samples} | {:.1} M, {times:.1} times", own as f64 * 1e-6)
        };
        // Writing to a string can't fail.
        writeln!(
            text,
            "| {name} | {mean:.0}, {} | {:.1} M | {:.5} | {:.5} | {:.5} | {} | {} |",
            samples.iter().max().unwrap_or(&0),
            rays as f64 * 1e-6,
            bound.max,
            row.error,
            row.reference,
            many(row.by_bound),
            many(row.by_error)
        )
        .unwrap_or_default();
    }
    text
}
