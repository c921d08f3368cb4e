//! Times of several runs, and of a fixed piece of work that tells how steady the machine is.

use std::hint::black_box;
use std::time::Instant;

/// What several runs took, in seconds.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Times {
    /// The first run of all: nothing is warm.
    pub cold: f64,
    /// The middle one of the others.
    pub median: f64,
    /// The quickest of them.
    pub min: f64,
    /// The median of their distances from the median.
    pub mad: f64,
}

impl Times {
    /// Of a cold run and others; `None` if there were no others.
    #[must_use]
    pub fn of(cold: f64, warm: &[f64]) -> Option<Self> {
        let middle = median(warm)?;
        let distances: Vec<_> = warm.iter().map(|time| (time - middle).abs()).collect();
        Some(Self {
            cold,
            median: middle,
            min: warm.iter().copied().fold(f64::INFINITY, f64::min),
            mad: median(&distances)?,
        })
    }
}

/// The middle one, or the mean of the two in the middle.
pub(crate) fn median(values: &[f64]) -> Option<f64> {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    let half = sorted.len() / 2;
    let upper = *sorted.get(half)?;
    match sorted.len() % 2 {
        0 => Some((sorted.get(half - 1)? + upper) / 2.0),
        _ => Some(upper),
    }
}

/// The seconds of some work that is always the same: what else changes in this time changes all other times too.
pub(crate) fn calibration() -> f64 {
    let begin = Instant::now();
    let mut x = black_box(0.5_f64);
    for _ in 0..1_000_000 {
        x = (x * x).mul_add(-1.9, 1.0).abs().sqrt();
    }
    black_box(x);
    begin.elapsed().as_secs_f64()
}

/// How far the slowest run is from the quickest: 0.1 is a tenth.
pub(crate) fn drift(runs: &[f64]) -> f64 {
    let quickest = runs.iter().copied().fold(f64::INFINITY, f64::min);
    let slowest = runs.iter().copied().fold(0.0, f64::max);
    if runs.is_empty() || quickest <= 0.0 {
        return 0.0;
    }
    slowest / quickest - 1.0
}

#[cfg(test)]
mod tests {
    use super::{Times, drift};

    fn check(warm: &[f64], expect: Option<(f64, f64, f64)>) {
        let times = Times::of(9.0, warm).map(|times| (times.median, times.min, times.mad));
        assert_eq!(times, expect, "{warm:?}");
    }

    #[test]
    fn medians_do_not_mind_one_slow_run() {
        check(&[], None);
        check(&[2.0], Some((2.0, 2.0, 0.0)));
        check(&[3.0, 1.0, 100.0], Some((3.0, 1.0, 2.0)));
        check(&[4.0, 1.0, 2.0, 100.0], Some((3.0, 1.0, 1.5)));
    }

    #[test]
    fn drift_is_from_the_quickest_to_the_slowest() {
        assert_eq!(drift(&[]), 0.0);
        assert_eq!(drift(&[2.0, 2.5, 2.25]), 0.25);
    }
}
