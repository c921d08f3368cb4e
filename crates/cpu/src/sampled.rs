//! What the samples of one pixel add up to.

use scenec_picture::Spread;

/// Blocks of samples that follow one another: never fewer than half as many, once there are enough samples.
const BLOCKS: usize = 16;

/// The samples of one pixel so far.
#[derive(Clone, Copy, Debug)]
pub struct Sampled {
    count: u32,
    /// Sums of whole blocks, and of the one that is being filled.
    blocks: [[f64; 3]; BLOCKS],
    /// Whole blocks.
    whole: usize,
    /// Samples in a whole block.
    size: u32,
    /// Samples in the last block.
    filled: u32,
    low: [f64; 3],
    high: [f64; 3],
    /// The sum of what dropped branches could have added.
    dropped: f64,
}

impl Default for Sampled {
    fn default() -> Self {
        Self {
            count: 0,
            blocks: [[0.0; 3]; BLOCKS],
            whole: 0,
            size: 1,
            filled: 0,
            low: [f64::INFINITY; 3],
            high: [f64::NEG_INFINITY; 3],
            dropped: 0.0,
        }
    }
}

impl Sampled {
    /// Adds one sample, and the most that its dropped branches could have added to it.
    #[inline(always)]
    pub(crate) fn add(&mut self, colour: [f64; 3], dropped: f64) {
        self.count += 1;
        self.dropped += dropped;
        for (component, value) in colour.into_iter().enumerate() {
            self.blocks[self.whole][component] += value;
            self.low[component] = self.low[component].min(value);
            self.high[component] = self.high[component].max(value);
        }
        self.filled += 1;
        if self.filled == self.size {
            (self.whole, self.filled) = (self.whole + 1, 0);
        }
        if self.whole == BLOCKS {
            self.merge();
        }
    }

    /// Two blocks become one.
    fn merge(&mut self) {
        for block in 0..BLOCKS / 2 {
            let (first, second) = (self.blocks[2 * block], self.blocks[2 * block + 1]);
            self.blocks[block] = [0, 1, 2].map(|component| first[component] + second[component]);
        }
        self.blocks[BLOCKS / 2..].fill([0.0; 3]);
        (self.whole, self.size) = (BLOCKS / 2, self.size * 2);
    }

    /// How many.
    #[must_use]
    pub const fn count(&self) -> u32 {
        self.count
    }

    /// Whether this is a number of samples to stop at: 16, 24, 32, 48, 64, 96 and so on, which whole blocks make up.
    #[must_use]
    pub(crate) const fn is_stop(&self) -> bool {
        self.size > 1 && self.filled == 0 && self.whole.is_multiple_of(BLOCKS / 4)
    }

    /// Their mean; black without any.
    #[must_use]
    pub fn mean(&self) -> [f64; 3] {
        let count = f64::from(self.count.max(1));
        [0, 1, 2].map(|component| self.blocks.iter().map(|block| block[component]).sum::<f64>() / count)
    }

    /// How far they are apart.
    #[must_use]
    pub fn spread(&self) -> Spread {
        self.spread_with(self.dropped / f64::from(self.count.max(1)))
    }

    /// The same where it is known otherwise how much of the mean was dropped at most.
    pub(crate) fn spread_with(&self, dropped: f64) -> Spread {
        Spread {
            low: self.low.map(|value| value as f32),
            high: self.high.map(|value| value as f32),
            error: [0, 1, 2].map(|component| self.error(component) as f32),
            // What is proven stays so.
            dropped: if dropped > 0.0 {
                (dropped as f32).next_up()
            } else {
                dropped as f32
            },
        }
    }

    /// The standard error of the mean, as of that many independent blocks.
    fn error(&self, component: usize) -> f64 {
        let blocks = &self.blocks[..self.whole];
        if blocks.len() < BLOCKS / 2 {
            return f64::INFINITY;
        }
        let (count, size) = (blocks.len() as f64, f64::from(self.size));
        let means = || blocks.iter().map(|block| block[component] / size);
        let mean = means().sum::<f64>() / count;
        let squares: f64 = means().map(|value| (value - mean) * (value - mean)).sum();
        (squares / (count * (count - 1.0))).sqrt()
    }
}

#[cfg(test)]
mod tests {
    use super::Sampled;

    fn of(values: impl IntoIterator<Item = f64>) -> Sampled {
        let mut sampled = Sampled::default();
        for value in values {
            sampled.add([value, -value, 0.0], 0.25);
        }
        sampled
    }

    /// The first component's mean and standard error.
    fn check(values: impl IntoIterator<Item = f64>, mean: f64, error: f64) {
        let sampled = of(values);
        let (found, spread) = (sampled.mean(), sampled.spread());
        assert!(
            (found[0] - mean).abs() < 1e-12 && (found[1] + mean).abs() < 1e-12,
            "{found:?}"
        );
        let near = (f64::from(spread.error[0]) - error).abs() <= 1e-6 * error;
        assert!(near || spread.error[0] as f64 == error, "{spread:?}");
        assert!((spread.dropped - 0.25).abs() < 1e-6 && spread.dropped >= 0.25);
    }

    #[test]
    fn blocks_tell_how_far_off_the_mean_may_be() {
        check([1.0; 7], 1.0, f64::INFINITY);
        check([1.0; 100], 1.0, 0.0);
        // Eight blocks of one: the standard deviation 4 / sqrt(7) over sqrt(8).
        check([0.0, 2.0].repeat(4), 1.0, (1.0_f64 / 7.0).sqrt());
        // Blocks of two are all alike.
        check([0.0, 2.0].repeat(16), 1.0, 0.0);
        // A slow change is what blocks show.
        check(
            (0..1024).map(f64::from),
            511.5,
            (128.0 * 128.0 * 42.0 / 56.0_f64).sqrt(),
        );
    }

    #[test]
    fn the_range_is_of_samples_and_not_of_blocks() {
        let spread = of((0..1000).map(f64::from)).spread();
        assert_eq!((spread.low[0], spread.high[0]), (0.0, 999.0));
        assert_eq!((spread.low[1], spread.high[1]), (-999.0, 0.0));
    }

    #[test]
    fn there_are_two_stops_between_a_number_and_its_double() {
        let mut sampled = Sampled::default();
        let mut stops = Vec::new();
        for _ in 0..200 {
            sampled.add([0.0; 3], 0.0);
            stops.extend(sampled.is_stop().then_some(sampled.count()));
        }
        assert_eq!(stops, [16, 24, 32, 48, 64, 96, 128, 192]);
    }
}
