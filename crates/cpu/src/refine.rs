//! Single pixels, a few to a thread at a time.

use rayon::prelude::*;
use scenec_picture::{Limits, Refined, Refiner, Stats, Task, TraceError, Watch, Window};

use crate::Cpu;
use crate::dispatch::Number;
use crate::path::Room;
use crate::pixel::Work;

/// A thread takes this many pixels at a time: more than come in one go, for some have enough soon; few, for one of them may need
/// thousands of samples.
const RUN: usize = 16;

impl<R: Number> Refiner for Cpu<R> {
    fn refine(
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
        let run = |room: &mut Room<R>, (number, pixels): (usize, &mut [Refined])| {
            let stats = (!watch.stopped()).then(|| {
                let first = number * RUN;
                R::trace(scene, Work::Run { task, first, pixels }, room)
            });
            stats.filter(|_| !watch.stopped())
        };
        let stats = self.threads.install(|| {
            let runs = refined.par_chunks_mut(RUN).enumerate();
            runs.map_init(|| Room::new(scene), run)
                .try_reduce(Stats::default, |a, b| Some(a.merge(b)))
        });
        Ok((refined, stats.ok_or(TraceError::Cancelled)?))
    }
}
