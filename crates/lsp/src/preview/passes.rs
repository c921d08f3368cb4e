//! How a picture is refined: which pass follows which, from how fast the scene has been traced so far.
//!
//! Pure arithmetic; it knows neither tracers nor clocks.

/// How long the first pass may take, nanoseconds.
const FIRST: f64 = 35e6;
/// How long a later pass may take without another one in between, nanoseconds.
const LATER: f64 = 200e6;
/// The speed of a scene that was never traced, nanoseconds a sample: slower than most, so that the first pass comes soon.
pub(super) const UNKNOWN: f64 = 1000.0;
/// The coarsest pass has this fraction of the columns and rows.
const COARSEST: u32 = 32;
/// How many times more samples one pass may have than the one before, unless it is quick.
const STEP: u32 = 16;

/// A way to divide the picture.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct Grain {
    /// Columns and rows are divided by this.
    pub(super) divisor: u32,
    /// Samples a pixel.
    pub(super) samples: u32,
}

/// What the refinement ends at.
#[derive(Clone, Copy, Debug)]
pub(super) struct Goal {
    /// Columns.
    pub(super) width: u32,
    /// Rows.
    pub(super) height: u32,
    /// Samples a pixel.
    pub(super) samples: u32,
}

impl Goal {
    /// The last pass.
    pub(super) const fn last(&self) -> Grain {
        Grain {
            divisor: 1,
            samples: self.samples,
        }
    }

    /// Columns and rows of a pass: at least one each.
    pub(super) fn size(&self, grain: Grain) -> (u32, u32) {
        let part = |side: u32| side.div_ceil(grain.divisor.max(1)).max(1);
        (part(self.width), part(self.height))
    }

    /// How long a pass takes at a speed in nanoseconds a sample.
    pub(super) fn nanoseconds(&self, grain: Grain, speed: f64) -> f64 {
        let (width, height) = self.size(grain);
        f64::from(width) * f64::from(height) * f64::from(grain.samples) * speed
    }

    /// The pass that follows `done`, or the first one; `None` after the last.
    ///
    /// It is the finest one that is still quick at this speed, and if none is, the next finer one: each pass costs a
    /// few times what the one before did, so that all of them together cost little more than the last alone.
    pub(super) fn next(&self, done: Option<Grain>, speed: f64) -> Option<Grain> {
        let budget = if done.is_some() { LATER } else { FIRST };
        let finer: Vec<Grain> = match done {
            Some(done) => self
                .ladder()
                .into_iter()
                .skip_while(|grain| *grain != done)
                .skip(1)
                .collect(),
            None => self.ladder(),
        };
        let quick = |grain: &&Grain| self.nanoseconds(**grain, speed) <= budget;
        finer.iter().rev().find(quick).or(finer.first()).copied()
    }

    /// All passes that there may be, the coarsest first.
    fn ladder(&self) -> Vec<Grain> {
        let mut steps = Vec::new();
        let mut divisor = COARSEST;
        while divisor >= 1 {
            // A pass of a pixel or two shows nothing.
            if divisor == 1 || self.width.min(self.height) / divisor >= 8 {
                steps.push(Grain { divisor, samples: 1 });
            }
            divisor /= 2;
        }
        let mut samples = STEP;
        while samples < self.samples / 2 {
            steps.push(Grain { divisor: 1, samples });
            samples = samples.saturating_mul(STEP);
        }
        if self.samples > 1 {
            steps.push(self.last());
        }
        steps
    }
}

#[cfg(test)]
mod tests {
    use super::{Goal, UNKNOWN};

    /// The passes of a picture that is traced at a speed known only after the first pass, as (divisor, samples).
    fn check(size: (u32, u32, u32), first: f64, speed: f64, expect: &[(u32, u32)]) {
        let (width, height, samples) = size;
        let goal = Goal { width, height, samples };
        let mut passes = Vec::new();
        let mut done = None;
        while let Some(grain) = goal.next(done, if done.is_some() { speed } else { first }) {
            passes.push((grain.divisor, grain.samples));
            done = Some(grain);
        }
        assert_eq!(passes, expect, "{size:?} at {speed} ns");
    }

    #[test]
    fn a_quick_scene_takes_few_passes() {
        check((600, 400, 1), UNKNOWN, 70.0, &[(4, 1), (1, 1)]);
        check((600, 400, 1), 70.0, 70.0, &[(1, 1)]);
        check((600, 400, 4), 70.0, 70.0, &[(1, 1), (1, 4)]);
        check((600, 400, 64), UNKNOWN, 70.0, &[(4, 1), (1, 1), (1, 16), (1, 64)]);
        check((1, 1, 1), UNKNOWN, 70.0, &[(1, 1)]);
        check((1, 65535, 1), UNKNOWN, 70.0, &[(1, 1)]);
    }

    #[test]
    fn a_slow_scene_begins_coarse_and_takes_every_step() {
        check((600, 400, 1), UNKNOWN, 50_000.0, &[(4, 1), (2, 1), (1, 1)]);
        check(
            (640, 480, 1),
            f64::INFINITY,
            f64::NAN,
            &[(32, 1), (16, 1), (8, 1), (4, 1), (2, 1), (1, 1)],
        );
        check(
            (1920, 1080, 4096),
            UNKNOWN,
            500.0,
            &[(8, 1), (4, 1), (2, 1), (1, 1), (1, 16), (1, 256), (1, 4096)],
        );
    }

    #[test]
    fn sizes_round_up() {
        let goal = Goal {
            width: 601,
            height: 3,
            samples: 1,
        };
        let grain = goal.next(None, 1e9).unwrap();
        assert_eq!((grain.divisor, goal.size(grain)), (1, (601, 3)));
        let goal = Goal {
            width: 601,
            height: 401,
            samples: 1,
        };
        assert_eq!(goal.size(goal.next(None, 1e9).unwrap()), (19, 13));
    }
}
