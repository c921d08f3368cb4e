//! What the samples of one pixel add up to.

use crate::Spread;

/// The samples of one pixel so far. A device adds them up in the same way, so that all of it is open.
#[derive(Clone, Copy, Debug)]
pub struct Sampled {
    /// How many.
    pub count: u32,
    /// Sums of whole blocks, of the one that is being filled, and nothing in the rest.
    pub blocks: [[f64; 3]; Self::BLOCKS],
    /// Whole blocks.
    pub whole: usize,
    /// Samples in a whole block.
    pub size: u32,
    /// Samples in the last block.
    pub filled: u32,
    /// The least of any sample.
    pub low: [f64; 3],
    /// The most of any sample.
    pub high: [f64; 3],
    /// The sum of what dropped branches could have added.
    pub dropped: f64,
}

impl Spread {
    /// What one sample tells: nothing of how far others would be apart.
    #[must_use]
    pub fn of_one(colour: [f64; 3], dropped: f64) -> Self {
        let colour = colour.map(|value| value as f32);
        Self {
            low: colour,
            high: colour,
            error: [f32::INFINITY; 3],
            dropped: upwards(dropped),
        }
    }

    /// The same in a range that holds another one's as well.
    #[must_use]
    pub fn widened(&self, other: &Self) -> Self {
        Self {
            low: [0, 1, 2].map(|component| self.low[component].min(other.low[component])),
            high: [0, 1, 2].map(|component| self.high[component].max(other.high[component])),
            ..*self
        }
    }
}

/// As a single, and never less: what is proven stays so.
fn upwards(dropped: f64) -> f32 {
    if dropped > 0.0 {
        (dropped as f32).next_up()
    } else {
        dropped as f32
    }
}

impl Default for Sampled {
    fn default() -> Self {
        Self {
            count: 0,
            blocks: [[0.0; 3]; Self::BLOCKS],
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
    /// Blocks of samples that follow one another: never fewer than half as many, once there are enough samples.
    pub const BLOCKS: usize = 16;

    /// Widens the range by a colour that is no sample.
    #[inline(always)]
    pub fn see(&mut self, colour: [f64; 3]) {
        for (component, value) in colour.into_iter().enumerate() {
            self.low[component] = self.low[component].min(value);
            self.high[component] = self.high[component].max(value);
        }
    }

    /// Adds one sample, and the most that its dropped branches could have added to it.
    #[inline(always)]
    pub fn add(&mut self, colour: [f64; 3], dropped: f64) {
        self.count += 1;
        self.dropped += dropped;
        for (component, value) in colour.into_iter().enumerate() {
            self.blocks[self.whole][component] += value;
        }
        self.see(colour);
        self.filled += 1;
        if self.filled == self.size {
            (self.whole, self.filled) = (self.whole + 1, 0);
        }
        if self.whole == Self::BLOCKS {
            self.merge();
        }
    }

    /// Two blocks become one.
    fn merge(&mut self) {
        for block in 0..Self::BLOCKS / 2 {
            let (first, second) = (self.blocks[2 * block], self.blocks[2 * block + 1]);
            self.blocks[block] = [0, 1, 2].map(|component| first[component] + second[component]);
        }
        self.blocks[Self::BLOCKS / 2..].fill([0.0; 3]);
        (self.whole, self.size) = (Self::BLOCKS / 2, self.size * 2);
    }

    /// Whether this is a number of samples to stop at, which whole blocks make up: 16, 18, 20 up to 32, 36, 40 up to 64, 72 and so on.
    #[must_use]
    pub const fn is_stop(&self) -> bool {
        self.size > 1 && self.filled == 0
    }

    /// How many whole blocks there are of so many samples.
    #[must_use]
    pub const fn blocks_of(count: u32) -> usize {
        let half = Self::BLOCKS as u32 / 2;
        if count < half {
            return count as usize;
        }
        (count >> (count.ilog2() - half.ilog2())) as usize
    }

    /// The first number to stop at that is above this one.
    #[must_use]
    pub const fn stop_after(count: u32) -> u32 {
        let blocks = Self::BLOCKS as u32;
        if count < blocks {
            return blocks;
        }
        let size = 2 * (1 << count.ilog2()) / blocks;
        (count / size + 1) * size
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
    #[must_use]
    pub fn spread_with(&self, dropped: f64) -> Spread {
        Spread {
            low: self.low.map(|value| value as f32),
            high: self.high.map(|value| value as f32),
            error: [0, 1, 2].map(|component| self.error(component) as f32),
            dropped: upwards(dropped),
        }
    }

    /// The standard error of the mean, as of that many independent blocks.
    fn error(&self, component: usize) -> f64 {
        let blocks = &self.blocks[..self.whole];
        if blocks.len() < Self::BLOCKS / 2 {
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
    use crate::Spread;

    #[test]
    fn one_sample_tells_what_it_would_tell_among_none() {
        let mut sampled = Sampled::default();
        sampled.add([0.1, -2.0, 1e300], 0.0);
        for dropped in [0.0, 0.3] {
            assert_eq!(
                sampled.spread_with(dropped),
                Spread::of_one([0.1, -2.0, 1e300], dropped)
            );
        }
    }

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
    fn there_are_eight_stops_from_a_number_to_its_double() {
        let mut sampled = Sampled::default();
        let mut stops = Vec::new();
        for _ in 0..200 {
            sampled.add([0.0; 3], 0.0);
            assert_eq!(Sampled::blocks_of(sampled.count), sampled.whole);
            stops.extend(sampled.is_stop().then_some(sampled.count));
        }
        assert_eq!(stops[..9], [16, 18, 20, 22, 24, 26, 28, 30, 32]);
        assert_eq!(stops[9..17], [36, 40, 44, 48, 52, 56, 60, 64]);
        assert_eq!(stops[17..], [72, 80, 88, 96, 104, 112, 120, 128, 144, 160, 176, 192]);
        let next = |count: &u32| Some(Sampled::stop_after(*count)).filter(|next| *next < 200);
        assert_eq!(std::iter::successors(next(&0), next).collect::<Vec<_>>(), stops);
    }
}
