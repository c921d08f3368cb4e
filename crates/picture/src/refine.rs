//! Pixels that are sampled until somebody says that each has enough.

use std::fmt;

use crate::{Limits, Sampled, Spread, Stats, TraceError, Tracer, Watch, Window};

/// A tracer that can tell when a pixel has enough samples.
pub trait Refiner: Tracer {
    /// Samples some pixels of a window, each until it has enough or has had all of the tracer's sample points or its
    /// budget of rays. A pixel has the same samples whichever others are asked for.
    ///
    /// # Errors
    /// `Cancelled` soon after the watch says stop, `Failed` when a device does.
    fn refine(
        &mut self,
        window: Window,
        limits: Limits,
        task: &Task<'_>,
        watch: &Watch,
    ) -> Result<(Vec<Refined>, Stats), TraceError>;
}

/// Points on the sides of a pixel, measured from its centre: its corners, and three on each side between them. Whatever lies beyond
/// a straight line has one of the corners, if any of the pixel.
pub const SIDES: [[f64; 2]; 16] = {
    let mut points = [[0.0; 2]; 16];
    let mut k = 0;
    while k < 4 {
        let along = k as f64 / 4.0 - 0.5;
        points[k] = [along, -0.5];
        points[4 + k] = [0.5, along];
        points[8 + k] = [-along, 0.5];
        points[12 + k] = [-0.5, -along];
        k += 1;
    }
    points
};

/// Which pixels, and until when.
#[derive(Clone, Copy)]
pub struct Task<'a> {
    /// Numbers of pixels, counted row by row within the window.
    pub pixels: &'a [u32],
    /// Whether a pixel, by its place among those above, has enough samples. Asked at the numbers at which
    /// [`Sampled::is_stop`]: 16, 18, 20 and so on.
    pub enough: &'a (dyn Fn(usize, &Sampled) -> bool + Sync),
    /// Whether the points on a pixel's sides are looked at before its samples: they count in its range, and in nothing else.
    pub sides: bool,
    /// The most that may be left out of one sample by all its branches that are below the cut-off.
    pub spare: f64,
}

impl fmt::Debug for Task<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Task")
            .field("pixels", &self.pixels.len())
            .finish_non_exhaustive()
    }
}

/// A pixel that was sampled until it had enough.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct Refined {
    /// The mean of its samples.
    pub mean: [f64; 3],
    /// How many there are.
    pub samples: u32,
    /// How far they are apart.
    pub spread: Spread,
}

impl From<&Sampled> for Refined {
    fn from(sampled: &Sampled) -> Self {
        Self {
            mean: sampled.mean(),
            samples: sampled.count,
            spread: sampled.spread(),
        }
    }
}
