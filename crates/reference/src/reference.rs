//! The oracle as a tracer: rows, threads, layers.

use std::iter;
use std::sync::{Mutex, PoisonError};
use std::thread;

use scenec_picture::{Frame, Picture, Request, Sampled, Spread, Stats, TraceError, Tracer, Watch};
use scenec_scene::Scene;

use crate::camera::{Eye, sample_point};
use crate::shade::{Sight, World};
use crate::tally::Tally;

/// A scene, ready to be traced slowly in f64.
///
/// The cut-off of a request is not heeded, for nothing is too faint for an oracle; its ray budget is, sample by sample
/// and depth first, a refracted ray before the reflected one beside it.
#[derive(Clone, Debug)]
pub struct Reference {
    world: World,
    eye: Option<Eye>,
    pub(crate) samples: u32,
    /// Where they are, measured from a pixel's upper left corner, if not where the language puts them.
    points: Vec<[f64; 2]>,
    threads: usize,
}

impl Reference {
    /// Takes what it needs from a scene, simplifying nothing.
    #[must_use]
    pub fn new(scene: &Scene) -> Self {
        Self {
            world: World::new(scene),
            eye: Eye::new(&scene.settings),
            samples: scene.settings.samples.max(1),
            points: Vec::new(),
            threads: thread::available_parallelism().map_or(1, usize::from),
        }
    }

    /// The same with this many threads, at least one; without, there are as many as the machine has.
    #[must_use]
    pub fn with_threads(mut self, threads: usize) -> Self {
        self.threads = threads.max(1);
        self
    }

    /// The same with samples at these points, measured from a pixel's centre; at those of the language if there are none.
    #[must_use]
    pub fn with_points(mut self, points: &[[f64; 2]]) -> Self {
        self.points = points.iter().map(|point| point.map(|place| place + 0.5)).collect();
        self.samples = u32::try_from(points.len()).unwrap_or(u32::MAX).max(1);
        self
    }

    /// The eye, if it sees.
    pub(crate) fn eye(&self) -> Result<&Eye, TraceError> {
        self.eye.as_ref().ok_or_else(|| {
            TraceError::Failed(
                "the eye, its aim and its up direction give no view; two of them agree or are 0".to_owned(),
            )
        })
    }

    /// Sample number `k` of a pixel, which has a column and a row in the whole picture.
    pub(crate) fn sample(&self, eye: &Eye, place: [u32; 2], k: u32, tally: &mut Tally) -> Sight {
        let own = self.points.get(k as usize).copied();
        self.look(eye, place, own.unwrap_or_else(|| sample_point(k).into()), tally)
    }

    /// What is seen through a point of a pixel, measured from its upper left corner.
    pub(crate) fn look(&self, eye: &Eye, [column, row]: [u32; 2], [x, y]: [f64; 2], tally: &mut Tally) -> Sight {
        let direction = eye.towards(f64::from(column) + x, f64::from(row) + y);
        self.world.look(eye.place, direction, tally)
    }

    /// The mean of a pixel's samples, and what the first one met; `each` hears of each that there is a ray for.
    fn pixel(&self, eye: &Eye, place: [u32; 2], tally: &mut Tally, mut each: impl FnMut(&Sight)) -> Sight {
        let mut look = |k| {
            let unpaid = tally.is_spent();
            let sight = self.sample(eye, place, k, tally);
            if !unpaid {
                each(&sight);
            }
            sight
        };
        let first = look(0);
        let sum = (1..self.samples).fold(first.colour, |sum, k| sum + look(k).colour);
        Sight {
            colour: sum / f64::from(self.samples),
            ..first
        }
    }

    /// A row of the window; what is left of it stays as it was if somebody says stop.
    fn row(&self, eye: &Eye, request: &Request<'_>, row: u32, mut out: Row<'_>) -> Stats {
        let mut stats = Stats::default();
        for index in 0..out.picture.len() {
            if request.watch.stopped() {
                break;
            }
            let mut tally = Tally::new(request.limits.ray_budget.max(1));
            let column = request.window.x.saturating_add(index as u32);
            let mut sampled = out.spread.as_ref().map(|_| Sampled::default());
            let sight = self.pixel(eye, [column, row], &mut tally, |sight| {
                if let Some(sampled) = &mut sampled {
                    sampled.add(sight.colour.to_array(), 0.0);
                }
            });
            let own = tally.stats(self.samples);
            out.put(index, &sight);
            if let (Some(spread), Some(sampled)) = (&mut out.spread, &sampled) {
                spread[index] = sampled.spread_with(own.dropped);
            }
            stats = stats.merge(own);
        }
        stats
    }

    /// Work that is shared among the threads; each takes the next piece when it has finished its last, until somebody says
    /// stop.
    pub(crate) fn share<T>(
        &self,
        pieces: impl Iterator<Item = T> + Send,
        watch: &Watch,
        piece: impl Fn(T) -> Stats + Sync,
    ) -> Stats {
        let queue = Mutex::new(pieces);
        let total = Mutex::new(Stats::default());
        let work = || {
            while !watch.stopped() {
                let next = queue.lock().unwrap_or_else(PoisonError::into_inner).next();
                let Some(next) = next else { return };
                let stats = piece(next);
                let mut total = total.lock().unwrap_or_else(PoisonError::into_inner);
                *total = total.merge(stats);
            }
        };
        thread::scope(|scope| {
            for _ in 0..self.threads {
                scope.spawn(work);
            }
        });
        total.into_inner().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Tracer for Reference {
    fn name(&self) -> String {
        let plural = if self.threads == 1 { "" } else { "s" };
        format!("reference f64, {} thread{plural}", self.threads)
    }

    fn trace(&mut self, request: &Request<'_>) -> Result<Frame, TraceError> {
        let eye = self.eye()?;
        let (window, layers) = (request.window, request.layers);
        let mut picture = Picture::black(window.width, window.height)?;
        let pixels = picture.pixels().len();
        let mut ids = layers.ids.then(|| vec![0; pixels]);
        let mut exact = layers.exact.then(|| vec![[0.0; 3]; pixels]);
        let mut paths = layers.paths.then(|| vec![0; pixels]);
        let mut spread = layers.spread.then(|| vec![Spread::default(); pixels]);
        let mut distances = layers.distances.then(|| vec![0.0; pixels]);

        let width = window.width.max(1) as usize;
        let stats = {
            let (mut ids, mut exact) = (rows(&mut ids, width), rows(&mut exact, width));
            let (mut paths, mut distances) = (rows(&mut paths, width), rows(&mut distances, width));
            let mut spread = rows(&mut spread, width);
            let out = picture.pixels_mut().chunks_mut(width).map(|picture| Row {
                picture,
                ids: ids.next().flatten(),
                exact: exact.next().flatten(),
                paths: paths.next().flatten(),
                spread: spread.next().flatten(),
                distances: distances.next().flatten(),
            });
            self.share((window.y..).zip(out), request.watch, |(row, out)| {
                let stats = self.row(eye, request, row, out);
                request.watch.advance(u64::from(window.width));
                stats
            })
        };
        if request.watch.stopped() {
            return Err(TraceError::Cancelled);
        }
        Ok(Frame {
            picture,
            ids,
            exact,
            paths,
            spread,
            distances,
            stats,
        })
    }
}

/// One row of all that was asked for.
struct Row<'a> {
    picture: &'a mut [[f32; 3]],
    ids: Option<&'a mut [u32]>,
    exact: Option<&'a mut [[f64; 3]]>,
    paths: Option<&'a mut [u64]>,
    spread: Option<&'a mut [Spread]>,
    distances: Option<&'a mut [f64]>,
}

impl Row<'_> {
    fn put(&mut self, index: usize, sight: &Sight) {
        let colour = sight.colour.to_array();
        self.picture[index] = colour.map(single);
        if let Some(ids) = &mut self.ids {
            ids[index] = sight.leaf;
        }
        if let Some(exact) = &mut self.exact {
            exact[index] = colour.map(|part| part.clamp(f64::MIN, f64::MAX));
        }
        if let Some(paths) = &mut self.paths {
            paths[index] = sight.path;
        }
        if let Some(distances) = &mut self.distances {
            distances[index] = sight.distance;
        }
    }
}

/// The nearest finite single: colours beyond the range of the picture's numbers end at its bounds.
fn single(value: f64) -> f32 {
    (value as f32).clamp(f32::MIN, f32::MAX)
}

/// The rows of a layer; of one that nobody asked for there is nothing in each.
fn rows<T>(layer: &mut Option<Vec<T>>, width: usize) -> impl Iterator<Item = Option<&mut [T]>> {
    let there = layer.iter_mut().flat_map(move |pixels| pixels.chunks_mut(width));
    there.map(Some).chain(iter::repeat_with(|| None))
}
