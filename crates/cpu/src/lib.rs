//! The embedded tracer: from a plan to pixels on this processor, in f32 or f64, on all its threads.
//!
//! It must not know OpenCL or the scene model. The kernels of the device tracer follow the same algorithm step by step.

mod balls;
mod bands;
mod contact;
mod crossings;
mod dispatch;
mod hierarchy;
mod hits;
mod intervals;
mod island;
mod lanes;
mod lone;
mod path;
mod pixel;
mod ray;
mod refine;
mod shade;
mod shape;
mod stage;
mod vector;
mod visitors;
mod walk;

use rayon::ThreadPool;
use rayon::prelude::*;
use scenec_picture::{Frame, NOTHING, Picture, Request, Spread, Stats, TraceError, Tracer};
use scenec_plan::Plan;

use bands::{Band, Layers, bands};
pub use dispatch::Number;
use dispatch::Traced;
use path::Room;
use pixel::{Pixel, Work};
use stage::Prepared;

/// Traces one plan in the precision `R`.
pub struct Cpu<R> {
    scene: Prepared<R>,
    /// World units per plan unit.
    unit: f64,
    threads: ThreadPool,
}

impl<R: Number> Cpu<R> {
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
            scene: Prepared::new(plan),
            unit: plan.scale.recip(),
            threads,
        })
    }

    /// Traces another plan from here on, on the same threads.
    pub fn show(&mut self, plan: &Plan) {
        (self.scene, self.unit) = (Prepared::new(plan), plan.scale.recip());
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

impl<R: Number> Tracer for Cpu<R> {
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
        // On all threads, for it is four times as large as the picture, and memory takes its time when it is first touched.
        let blank = || (0..count).into_par_iter().map(|_| Spread::default()).collect();
        let mut spread: Option<Vec<_>> = request.layers.spread.then(|| self.threads.install(blank));
        let mut distances = request.layers.distances.then(|| vec![f64::INFINITY; count]);

        let (corner, size) = ([window.x, window.y], [window.width, window.height]);
        let limits = request.limits;
        self.scene.frame.ask(corner, size, limits.cutoff, limits.ray_budget);

        let scene = &self.scene;
        let layers = Layers {
            ids: ids.as_mut(),
            exact: exact.as_mut(),
            spread: spread.as_mut(),
            distances: distances.as_mut(),
        };
        let bands = bands(
            &mut picture,
            layers,
            self.threads.current_num_threads(),
            scene.samples.len(),
        );
        let stats = self.threads.install(|| {
            bands
                .into_par_iter()
                .map_init(|| Room::new(scene), |room, band| trace_band(scene, request, room, band))
                .try_reduce(Stats::default, |a, b| Some(a.merge(b)))
        });
        let stats = stats.ok_or(TraceError::Cancelled)?;
        distances
            .iter_mut()
            .flatten()
            .for_each(|distance| *distance *= self.unit);
        Ok(Frame {
            picture,
            ids,
            exact,
            paths: None,
            spread,
            distances,
            stats,
        })
    }
}

/// Traces a band tile by tile; nothing if it was stopped.
fn trace_band<R: Traced>(
    scene: &Prepared<R>,
    request: &Request<'_>,
    room: &mut Room<R>,
    mut band: Band<'_>,
) -> Option<Stats> {
    let mut stats = Stats::default();
    let mut pixels = Vec::new();
    for tile in band.tiles() {
        if request.watch.stopped() {
            return None;
        }
        pixels.clear();
        pixels.resize(tile.pixels(), Pixel::default());
        let work = Work::Tile {
            tile: &tile,
            spread: request.layers.spread,
            pixels: &mut pixels,
        };
        stats = stats.merge(R::trace(scene, work, room));
        band.store(&tile, &pixels, &scene.leaves);
        request.watch.advance(pixels.len() as u64);
    }
    Some(stats)
}
