//! Single pixels on a device: all that are open go on together from one number of samples to the next at which some of them may
//! have enough.

use std::ops::Range;

use scenec_picture::{Limits, Refined, Refiner, Sampled, Stats, Task, TraceError, Watch, Window};
use scenec_plan::Real;
use scenec_plan::packed_structs::{self, Outcome};

use crate::buffer::{Arg, Buffer};
use crate::calls::Plain;
use crate::error::DeviceError;
use crate::pace::Pace;
use crate::sampled::in_picture;
use crate::session::Running;
use crate::tiles::pixel_stats;
use crate::tracer::{OpenCl, failed};

/// The most pixels that are open at a time: their sums travel to the device and back at each stop.
const GROUP: usize = 1 << 16;

/// How many pixels stand in a row of those that a kernel goes on with.
const WIDTH: u32 = 256;

/// Pixels that have not enough samples yet, side by side.
struct Open<R> {
    /// Their places in the task.
    places: Vec<usize>,
    /// Their numbers in the window.
    pixels: Vec<u32>,
    outcomes: Vec<Outcome<R>>,
    sums: Vec<packed_structs::Sampled<R>>,
}

impl<R: Real + Plain> Open<R> {
    /// Keeps some of them, by their place here.
    fn keep(&mut self, kept: &[usize]) {
        self.places = kept.iter().map(|at| self.places[*at]).collect();
        self.pixels = kept.iter().map(|at| self.pixels[*at]).collect();
        self.outcomes = kept.iter().map(|at| self.outcomes[*at]).collect();
        self.sums = kept.iter().map(|at| self.sums[*at]).collect();
    }
}

/// The rays that a pixel's budget counts.
const fn rays<R: Copy>(outcome: &Outcome<R>) -> u32 {
    outcome.primary + outcome.reflected + outcome.refracted
}

impl<R: Real + Plain> Refiner for OpenCl<R> {
    fn refine(
        &mut self,
        window: Window,
        limits: Limits,
        task: &Task<'_>,
        watch: &Watch,
    ) -> Result<(Vec<Refined>, Stats), TraceError> {
        if !self.spread {
            return Err(TraceError::Failed(
                "these kernels were not made to tell how far samples are apart".to_owned(),
            ));
        }
        let (corner, size) = ([window.x, window.y], [window.width, window.height]);
        self.frame.ask(corner, size, limits.cutoff, limits.ray_budget);
        self.frame.spare = R::of(task.spare);
        let frame = self.session.upload(&[self.frame]).map_err(failed)?;
        let mut refined = vec![Refined::default(); task.pixels.len()];
        let mut stats = Stats {
            kernel_ns: Some(0),
            ..Stats::default()
        };
        for (number, pixels) in task.pixels.chunks(GROUP).enumerate() {
            let mut open = Open {
                places: (number * GROUP..).take(pixels.len()).collect(),
                pixels: pixels.to_owned(),
                outcomes: vec![Outcome::default(); pixels.len()],
                sums: vec![packed_structs::Sampled::default(); pixels.len()],
            };
            let mut count = 0;
            while !open.places.is_empty() {
                let stop = Sampled::stop_after(count).min(self.frame.samples);
                let time = self.go_on(&frame, &mut open, count..stop, task.sides, watch)?;
                stats.kernel_ns = stats.kernel_ns.map(|sum| sum + time);
                count = stop;
                let mut left = Vec::new();
                for (at, (outcome, sums)) in open.outcomes.iter().zip(&open.sums).enumerate() {
                    let (sampled, place) = (in_picture(sums), open.places[at]);
                    let spent = stop >= self.frame.samples || rays(outcome) >= self.frame.ray_budget;
                    // Everybody is asked, for whoever counts those that are done.
                    let enough = sampled.is_stop() && (task.enough)(place, &sampled);
                    if enough || spent {
                        refined[place] = Refined::from(&sampled);
                        stats = stats.merge(Stats {
                            dropped: refined[place].spread.dropped.into(),
                            ..pixel_stats(outcome)
                        });
                    } else {
                        left.push(at);
                    }
                }
                open.keep(&left);
            }
        }
        Ok((refined, stats))
    }
}

impl<R: Real + Plain> OpenCl<R> {
    /// Takes the samples of a range of all open pixels.
    fn go_on(
        &self,
        frame: &Buffer<packed_structs::Frame<R>>,
        open: &mut Open<R>,
        samples: Range<u32>,
        sides: bool,
        watch: &Watch,
    ) -> Result<u64, TraceError> {
        let upload = |open: &Open<R>| -> Result<_, DeviceError> {
            let session = &self.session;
            Ok((
                session.upload(&open.outcomes)?,
                session.upload(&open.sums)?,
                session.upload(&open.pixels)?,
            ))
        };
        let (outcomes, sums, pixels) = upload(open).map_err(failed)?;
        let count = open.pixels.len() as u32;
        let mut pace = Pace::new(WIDTH, count.div_ceil(WIDTH), samples.end - samples.start, GROUP);
        let mut kernel_ns = 0;
        while let Some(run) = pace.next() {
            if watch.stopped() {
                return Err(TraceError::Cancelled);
            }
            let more: [Arg<'_>; 12] = [
                (&outcomes).into(),
                (&sums).into(),
                (&pixels).into(),
                u32::from(sides).into(),
                count.into(),
                WIDTH.into(),
                run.column.into(),
                run.row.into(),
                run.columns.into(),
                run.rows.into(),
                (samples.start + run.samples.start).into(),
                (samples.start + run.samples.end).into(),
            ];
            let time = self
                .start("refine", frame, &more, [run.columns, run.rows])
                .and_then(Running::wait)
                .map_err(failed)?;
            pace.took(&run, time);
            kernel_ns += time;
        }
        self.session.read(&outcomes, 0, &mut open.outcomes).map_err(failed)?;
        self.session.read(&sums, 0, &mut open.sums).map_err(failed)?;
        Ok(kernel_ns)
    }
}
