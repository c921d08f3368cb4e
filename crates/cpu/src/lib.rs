//! The embedded tracer: from a plan to pixels on this processor, in f32 or f64, on all its threads.
//!
//! It must not know OpenCL or the scene model. The kernels of the device tracer follow the same algorithm step by step.

mod crossings;
mod dispatch;
mod event;
mod hierarchy;
mod path;
mod pixel;
mod ray;
mod refine;
mod sampled;
mod shade;
mod shape;
mod vector;

use std::ops::Range;

use rayon::ThreadPool;
use rayon::prelude::*;
use scenec_picture::{Exact, Frame, NOTHING, Picture, Request, Spread, Stats, TraceError, Tracer};
use scenec_plan::{Packed, Plan, Real, in_doubles, in_singles};

use pixel::Pixel;
pub use refine::{Refined, Task};
pub use sampled::Sampled;

/// A picture is handed to threads in runs of pixels of about this many samples, so that progress and a stop are noticed
/// soon and yet handing out costs nothing.
const RUN_SAMPLES: usize = 1024;

/// Traces one plan in the precision `R`.
pub struct Cpu<R> {
    scene: Packed<R>,
    threads: ThreadPool,
}

impl<R: Real> Cpu<R> {
    /// A tracer for a plan; `threads` = 0 takes as many as the machine has.
    ///
    /// # Errors
    /// `Failed` if the threads can't be started.
    pub fn new(plan: &Plan, threads: usize) -> Result<Self, TraceError> {
        let threads = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .map_err(|error| TraceError::Failed(format!("no threads to trace on: {error}")))?;
        Ok(Self {
            scene: plan.packed(),
            threads,
        })
    }

    /// Traces another plan from here on, on the same threads.
    pub fn show(&mut self, plan: &Plan) {
        self.scene = plan.packed();
    }

    /// Divides what the camera sees into other columns and rows, and a pixel into other sample points (measured from
    /// its centre). The part of the world in the picture stays what it was.
    pub fn divide(&mut self, width: u32, height: u32, samples: &[[f64; 2]]) {
        let scene = &mut self.scene;
        (scene.frame.width, scene.frame.height) = (width, height);
        scene.samples = samples.iter().map(|point| point.map(R::of)).collect();
        scene.frame.samples = u32::try_from(samples.len()).unwrap_or(u32::MAX);
    }
}

impl<R: Real> Tracer for Cpu<R> {
    fn name(&self) -> String {
        let threads = self.threads.current_num_threads();
        format!(
            "cpu {}, {threads} thread{}",
            R::NAME,
            if threads == 1 { "" } else { "s" }
        )
    }

    fn trace(&mut self, request: &Request<'_>) -> Result<Frame, TraceError> {
        let window = request.window;
        let mut picture = Picture::black(window.width, window.height)?;
        let count = picture.pixels().len();
        let mut ids = request.layers.ids.then(|| vec![NOTHING; count]);
        let mut exact = request.layers.exact.then(|| vec![[0.0; 3]; count]);
        let mut spread = request.layers.spread.then(|| vec![Spread::default(); count]);

        let (corner, size) = ([window.x, window.y], [window.width, window.height]);
        let limits = request.limits;
        self.scene.frame.ask(corner, size, limits.cutoff, limits.ray_budget);

        let scene = &self.scene;
        let run = (RUN_SAMPLES / scene.samples.len().max(1)).max(1);
        let runs = runs(run, picture.pixels_mut(), ids.as_mut(), exact.as_mut(), spread.as_mut());
        let stats = self.threads.install(|| {
            runs.into_par_iter()
                .map(|run| {
                    if request.watch.stopped() {
                        return None;
                    }
                    let mut pixels = vec![Pixel::default(); run.picture.len()];
                    let stats = dispatch::trace_run(scene, run.range.clone(), request.layers.spread, &mut pixels);
                    run.store(&pixels);
                    request.watch.advance(pixels.len() as u64);
                    Some(stats)
                })
                .try_reduce(Stats::default, |a, b| Some(a.merge(b)))
        });
        let stats = stats.ok_or(TraceError::Cancelled)?;
        Ok(Frame {
            picture,
            ids,
            exact,
            paths: None,
            spread,
            stats,
        })
    }
}

/// A run of pixels and where they go.
struct Run<'a> {
    range: Range<usize>,
    picture: &'a mut [[f32; 3]],
    ids: Option<&'a mut [u32]>,
    exact: Option<&'a mut [[f64; 3]]>,
    spread: Option<&'a mut [Spread]>,
}

fn runs<'a>(
    run: usize,
    picture: &'a mut [[f32; 3]],
    ids: Option<&'a mut Vec<u32>>,
    exact: Option<&'a mut Exact>,
    spread: Option<&'a mut Vec<Spread>>,
) -> Vec<Run<'a>> {
    let mut ids = ids.map(|ids| ids.chunks_mut(run));
    let mut exact = exact.map(|exact| exact.chunks_mut(run));
    let mut spread = spread.map(|spread| spread.chunks_mut(run));
    picture
        .chunks_mut(run)
        .enumerate()
        .map(|(i, picture)| Run {
            range: i * run..i * run + picture.len(),
            picture,
            ids: ids.as_mut().and_then(Iterator::next),
            exact: exact.as_mut().and_then(Iterator::next),
            spread: spread.as_mut().and_then(Iterator::next),
        })
        .collect()
}

impl Run<'_> {
    fn store<R: Real>(self, pixels: &[Pixel<R>]) {
        for (to, pixel) in self.picture.iter_mut().zip(pixels) {
            *to = in_singles(pixel.colour);
        }
        for (to, pixel) in self.ids.into_iter().flatten().zip(pixels) {
            *to = pixel.solid;
        }
        for (to, pixel) in self.exact.into_iter().flatten().zip(pixels) {
            *to = in_doubles(pixel.colour);
        }
        for (to, pixel) in self.spread.into_iter().flatten().zip(pixels) {
            *to = pixel.spread;
        }
    }
}
