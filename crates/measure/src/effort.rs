//! How much is tried, and how often.

use scenec_scene::{Scene, Settings};

/// How much a bench takes on.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Effort {
    /// The most pixels, unless a size is asked for: a larger picture is made smaller, its shape kept.
    pub pixels: u64,
    /// Samples per pixel of the reference.
    pub reference_samples: u32,
    /// The samples per pixel that are tried, ascending.
    pub samples: &'static [u32],
    /// Those that are tried of the programs and numbers that an OpenCL device has besides the usual ones.
    pub variants: &'static [u32],
    /// The cut-offs that are tried, descending; at the last number of samples but one.
    pub cutoffs: &'static [f64],
    /// How often each setting is timed after one run to warm up.
    pub repeats: u32,
    /// About how many seconds the tracing may take of a scene that has no size given; preparations come on top.
    pub seconds: Option<f64>,
}

impl Effort {
    /// About a minute.
    pub const QUICK: Self = Self {
        pixels: 96 * 64,
        reference_samples: 256,
        samples: &[1, 4, 16, 64],
        variants: &[4, 16],
        cutoffs: &[1.0 / 4.0, 1.0 / 16.0, 1.0 / 64.0, 1.0 / 256.0, 0.0],
        repeats: 3,
        seconds: Some(25.0),
    };

    /// For figures that are to be kept.
    pub const FULL: Self = Self {
        pixels: 240 * 160,
        reference_samples: 1024,
        samples: &[1, 4, 16, 64, 256],
        variants: &[1, 4, 16, 64, 256],
        cutoffs: &[1.0 / 4.0, 1.0 / 16.0, 1.0 / 64.0, 1.0 / 256.0, 1.0 / 1024.0, 0.0],
        repeats: 11,
        seconds: None,
    };

    /// A scene of a size that this effort can bear.
    #[must_use]
    pub fn shrunk(&self, mut scene: Scene) -> Scene {
        let Settings { width, height, .. } = scene.settings;
        let pixels = u64::from(width) * u64::from(height);
        if pixels > self.pixels {
            let by = (self.pixels as f64 / pixels as f64).sqrt();
            let less = |side: u32| (f64::from(side) * by).round().max(1.0) as u32;
            (scene.settings.width, scene.settings.height) = (less(width), less(height));
        }
        scene
    }

    /// How many pictures of each setting are traced: itself, two for its bound, and as many as are timed, alone and as
    /// processes.
    pub(crate) const fn pictures(&self) -> u64 {
        3 + 2 * self.rounds()
    }

    /// One round to warm up, and those that count.
    pub(crate) const fn rounds(&self) -> u64 {
        self.repeats as u64 + 1
    }

    /// The samples at which cut-offs and depths are tried.
    pub(crate) fn middle(&self) -> u32 {
        let place = self.samples.len().saturating_sub(2);
        self.samples.get(place).copied().unwrap_or(1)
    }
}

/// The depths that are tried below that of a scene: the first powers of two, and 0.
pub(crate) fn depths(raydepth: u32) -> Vec<u32> {
    [0, 1, 2, 4, 8].into_iter().filter(|depth| *depth < raydepth).collect()
}

#[cfg(test)]
mod tests {
    use super::{Effort, depths};

    #[test]
    fn depths_stay_below_the_scenes() {
        assert_eq!(depths(0), [0; 0]);
        assert_eq!(depths(3), [0, 1, 2]);
        assert_eq!(depths(100), [0, 1, 2, 4, 8]);
    }

    #[test]
    fn samples_nest_in_those_of_the_reference() {
        for effort in [Effort::QUICK, Effort::FULL] {
            assert!(effort.samples.is_sorted() && effort.samples.contains(&effort.middle()));
            assert!(effort.variants.iter().all(|samples| effort.samples.contains(samples)));
            assert!(effort.samples.iter().all(|samples| *samples < effort.reference_samples));
        }
    }
}
