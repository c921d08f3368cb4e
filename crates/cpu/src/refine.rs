//! Pixels that are sampled until somebody says that each has enough.

use std::fmt;

use rayon::prelude::*;
use scenec_picture::{Limits, Spread, Stats, TraceError, Watch, Window};

use crate::Cpu;
use crate::dispatch::Number;
use crate::sampled::Sampled;

/// A thread takes this many pixels at a time: few, for one of them may need thousands of samples.
const RUN: usize = 8;

/// Which pixels, and until when.
#[derive(Clone, Copy)]
pub struct Task<'a> {
    /// Numbers of pixels, counted row by row within the window.
    pub pixels: &'a [u32],
    /// Whether a pixel, by its place among those above, has enough samples. Asked at 16, 24, 32, 48, 64, 96 and so on.
    pub enough: &'a (dyn Fn(usize, &Sampled) -> bool + Sync),
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

impl<R: Number> Cpu<R> {
    /// Samples some pixels of a window, each until it has enough or has had all of the tracer's sample points or its
    /// budget of rays. A pixel has the same samples whichever others are asked for.
    ///
    /// # Errors
    /// `Cancelled` soon after the watch says stop.
    pub fn refine(
        &mut self,
        window: Window,
        limits: Limits,
        task: &Task<'_>,
        watch: &Watch,
    ) -> Result<(Vec<Refined>, Stats), TraceError> {
        let (corner, size) = ([window.x, window.y], [window.width, window.height]);
        self.scene.frame.ask(corner, size, limits.cutoff, limits.ray_budget);
        let scene = &self.scene;
        let mut refined = vec![Refined::default(); task.pixels.len()];
        let run = |(number, pixels): (usize, &mut [Refined])| {
            let stats = (!watch.stopped()).then(|| R::refine_run(scene, task, number * RUN, pixels));
            stats.filter(|_| !watch.stopped())
        };
        let stats = self.threads.install(|| {
            let runs = refined.par_chunks_mut(RUN).enumerate();
            runs.map(run).try_reduce(Stats::default, |a, b| Some(a.merge(b)))
        });
        Ok((refined, stats.ok_or(TraceError::Cancelled)?))
    }
}
