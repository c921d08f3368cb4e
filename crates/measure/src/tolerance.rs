//! A picture to a tolerance: each pixel gets as many samples, and loses as many faint branches, as its bound allows.

use scenec_cpu::Cpu;
use scenec_device::{DeviceInfo, Precision, refiner, suited};
use scenec_picture::{
    Limits, Picture, Refined, Refiner, Sampled, Stats, Task, TooManyPixels, TraceError, Watch, Window,
};
use scenec_plan::{Features, Plan, PlanError, plan};
use scenec_reference::Reference;
use scenec_scene::Scene;

use crate::bound::Bound;
use crate::doubt::{Doubt, Doubts, Range, around};
use crate::edges::{MOST_SAMPLES, Taken};
use crate::points::{SCRAMBLE, Scramble, scrambled_points};
use crate::setting::roundoff;
use crate::specks::least_samples;

/// The part of a tolerance that dropped branches may use up.
const DROPPED: f64 = 1.0 / 8.0;

/// The part of that which a single branch may use up: so many small ones are rather dropped than one large one.
const BRANCH: f64 = 1.0 / 4.0;

/// The part of a tolerance that roundings across a full contrast may use up, unless there is nothing more exact.
const ROUNDED: f64 = 1.0 / 8.0;

/// The power of the samples with which the error of an edge falls, that of points without order having a half.
const FALL: f64 = 3.0 / 4.0;

/// Samples from which on a pixel is given up if more of them can't be expected to help.
const PATIENCE: u32 = 1024;

/// About how many pixels are worked on at a time.
const BAND: u32 = 1 << 19;

/// What is asked for.
#[derive(Clone, Copy, Debug)]
pub struct Tolerance<'a> {
    /// What is traced; the samples of its settings don't count.
    pub scene: &'a Scene,
    /// Which part of its picture.
    pub window: Window,
    /// The most that any component may be off.
    pub tolerance: f64,
    /// The most samples of a pixel: up to [`Tolerance::MOST_SAMPLES`].
    pub most_samples: u32,
    /// The most rays of a pixel, those towards lights aside.
    pub ray_budget: u32,
    /// What takes the samples.
    pub sampler: Sampler<'a>,
    /// In which numbers; the least exact that will do unless given.
    pub precision: Option<Precision>,
    /// How many threads; 0 for as many as the machine has.
    pub threads: usize,
    /// Who says stop, and who hears of each pixel that is done.
    pub watch: &'a Watch,
}

/// What takes the samples.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub enum Sampler<'a> {
    /// The built-in tracer.
    #[default]
    Cpu,
    /// The slow tracer, always in doubles.
    Reference,
    /// An OpenCL device.
    OpenCl(&'a DeviceInfo),
}

/// What came of it.
#[derive(Clone, Debug)]
pub struct Achieved {
    /// The picture.
    pub picture: Picture,
    /// What it took.
    pub stats: Stats,
    /// Who computed.
    pub name: String,
    /// The plan that was traced.
    pub plan: Plan,
    /// How wrong each pixel may be, row by row.
    pub doubts: Vec<Doubt>,
    /// How many samples each pixel has.
    pub samples: Vec<u32>,
    /// How wrong the picture may be.
    pub bound: Bound,
    /// Pixels whose bound is above the tolerance.
    pub missed: u64,
}

impl<'a> Tolerance<'a> {
    /// The whole picture of a scene, with nothing more said.
    #[must_use]
    pub const fn of(scene: &'a Scene, tolerance: f64, watch: &'a Watch) -> Self {
        Self {
            scene,
            window: Window::whole(scene.settings.width, scene.settings.height),
            tolerance,
            most_samples: Self::MOST_SAMPLES,
            ray_budget: Self::RAY_BUDGET,
            sampler: Sampler::Cpu,
            precision: None,
            threads: 0,
            watch,
        }
    }
}

impl Tolerance<'_> {
    /// The most samples that a pixel may be asked to take.
    pub const MOST_SAMPLES: u32 = MOST_SAMPLES;

    /// The most rays of a pixel unless somebody says otherwise: more than [`Limits::DEFAULT`] allows, for edges and
    /// mirrors may need them.
    pub const RAY_BUDGET: u32 = 1 << 24;

    /// Renders.
    ///
    /// # Errors
    /// There is no plan, no memory, or somebody says stop. A tolerance that can't be kept is none: see
    /// [`Achieved::missed`].
    pub fn achieve(&self) -> Result<Achieved, TraceError> {
        self.achieve_with(SCRAMBLE)
    }

    /// The same with other sample points.
    pub(crate) fn achieve_with(&self, scramble: Scramble) -> Result<Achieved, TraceError> {
        let mut scene = self.scene.clone();
        scene.settings.samples = self.most_samples.clamp(1, MOST_SAMPLES);
        let failed = |error: PlanError| TraceError::Failed(error.to_string());
        let mut plan = plan(&scene).map_err(failed)?;
        plan.view.samples = scrambled_points(scene.settings.samples, scramble);
        let precision = self.precision(&plan);
        let mut tracer = self.tracer(&scene, &plan, precision)?;
        self.on(tracer.as_mut(), plan, precision)
    }

    fn tracer(&self, scene: &Scene, plan: &Plan, precision: Precision) -> Result<Box<dyn Refiner>, TraceError> {
        Ok(match (self.sampler, precision) {
            (Sampler::Cpu, Precision::F32) => Box::new(Cpu::<f32>::new(plan, self.threads)?),
            (Sampler::Cpu, Precision::F64) => Box::new(Cpu::<f64>::new(plan, self.threads)?),
            (Sampler::Reference, _) => {
                let tracer = Reference::new(scene).with_points(&plan.view.samples);
                match self.threads {
                    0 => Box::new(tracer),
                    threads => Box::new(tracer.with_threads(threads)),
                }
            }
            (Sampler::OpenCl(info), precision) => {
                let features = Features {
                    spread: true,
                    ..suited(info, Features::of(plan))
                };
                let refiner = refiner(info, plan, precision, &features);
                refiner.map_err(|error| TraceError::Failed(error.to_string()))?
            }
        })
    }

    /// The one that was asked for, or singles where the plan has nothing against them and their roundings don't eat up
    /// the tolerance.
    fn precision(&self, plan: &Plan) -> Precision {
        match self.sampler {
            Sampler::Reference => return Precision::F64,
            Sampler::OpenCl(info) if !info.has_f64 && self.precision.is_none() => return Precision::F32,
            _ => {}
        }
        self.precision.unwrap_or_else(|| {
            let rounded = Doubts::of(plan, roundoff(Precision::F32)).of_a_contrast();
            if plan.beyond_single().is_none() && rounded <= ROUNDED * self.tolerance {
                Precision::F32
            } else {
                Precision::F64
            }
        })
    }

    fn on(&self, tracer: &mut dyn Refiner, plan: Plan, precision: Precision) -> Result<Achieved, TraceError> {
        let doubts = Doubts::of(&plan, roundoff(precision));
        let mut pixels = Pixels::none_of(self.window)?;
        let mut stats = Stats::default();
        for window in bands(self.window) {
            let work = Work {
                asked: self,
                plan: &plan,
                doubts,
                inside: window,
                window: widened(window, &plan),
            };
            let (first, few) = work.look(tracer)?;
            let (settled, more) = work.settle(tracer, &first)?;
            pixels.take(&settled);
            stats = stats.merge(few).merge(more);
        }
        let Pixels {
            picture,
            doubts,
            samples,
        } = pixels;
        let missed = doubts.iter().filter(|doubt| doubt.bound() > self.tolerance);
        let bound = Bound::of(&doubts);
        stats.dropped = bound.truncation;
        Ok(Achieved {
            missed: missed.count() as u64,
            bound,
            picture,
            stats,
            name: tracer.name(),
            plan,
            doubts,
            samples,
        })
    }
}

/// Pixels that are done, row by row.
struct Pixels {
    picture: Picture,
    doubts: Vec<Doubt>,
    samples: Vec<u32>,
}

impl Pixels {
    /// None yet, and room for all of a window.
    fn none_of(window: Window) -> Result<Self, TraceError> {
        let Window { width, height, .. } = window;
        let picture = Picture::black(width, height)?;
        let count = picture.pixels().len();
        let (mut doubts, mut samples) = (Vec::new(), Vec::new());
        let room = doubts
            .try_reserve_exact(count)
            .and_then(|()| samples.try_reserve_exact(count));
        room.map_err(|_| TooManyPixels { width, height })?;
        Ok(Self {
            picture,
            doubts,
            samples,
        })
    }

    fn take(&mut self, settled: &[Settled]) {
        let single = |value: f64| (value as f32).clamp(f32::MIN, f32::MAX);
        let room = self.picture.pixels_mut().iter_mut().skip(self.doubts.len());
        for (to, pixel) in room.zip(settled) {
            *to = pixel.refined.mean.map(single);
        }
        self.doubts.extend(settled.iter().map(|pixel| pixel.doubt));
        self.samples.extend(settled.iter().map(|pixel| pixel.refined.samples));
    }
}

/// The window in parts of whole rows, from the top: what is known of pixels that are not done takes much more room.
fn bands(window: Window) -> impl Iterator<Item = Window> {
    let rows = (BAND / window.width.max(1)).max(1);
    let part = move |y: u32| Window {
        y: window.y + y,
        height: rows.min(window.height - y),
        ..window
    };
    (0..window.height).step_by(rows as usize).map(part)
}

/// A window with a pixel more on each side, so far as the picture goes: a pixel's bound asks its neighbours, and the part
/// of a picture is to be that part of the whole.
fn widened(window: Window, plan: &Plan) -> Window {
    let (x, y) = (window.x.saturating_sub(1), window.y.saturating_sub(1));
    let end = |start: u32, length: u32, most: u32| start.saturating_add(length).saturating_add(1).min(most);
    Window {
        x,
        y,
        width: end(window.x, window.width, plan.view.width) - x,
        height: end(window.y, window.height, plan.view.height) - y,
    }
}

/// A pixel that is done.
#[derive(Clone, Copy)]
struct Settled {
    refined: Refined,
    doubt: Doubt,
}

struct Work<'a> {
    asked: &'a Tolerance<'a>,
    plan: &'a Plan,
    doubts: Doubts,
    /// A part of what is asked for.
    inside: Window,
    /// The same with a margin.
    window: Window,
}

impl Work<'_> {
    /// As few samples as may tell anything, everywhere.
    fn look(&self, tracer: &mut dyn Refiner) -> Result<(Vec<Refined>, Stats), TraceError> {
        let least = least_samples(self.plan, self.window, self.asked.tolerance);
        let count = u32::try_from(self.window.pixels()).unwrap_or(u32::MAX);
        let pixels: Vec<u32> = (0..count).collect();
        let enough =
            |index: usize, so_far: &Sampled| least.get(index).is_none_or(|least| so_far.count >= u32::from(*least));
        self.refine(tracer, &pixels, true, &enough)
    }

    /// More samples where the first ones do not suffice.
    fn settle(&self, tracer: &mut dyn Refiner, first: &[Refined]) -> Result<(Vec<Settled>, Stats), TraceError> {
        let ranges: Vec<_> = first.iter().map(|pixel| Range::of(&pixel.spread)).collect();
        let around = around(&ranges, self.window.width as usize);
        // What the first look saw at a pixel's sides is not looked at again.
        let doubt = |place: usize, pixel: &Refined| {
            self.doubts.of_pixel(
                pixel.samples,
                pixel.mean,
                &pixel.spread.widened(&first[place].spread),
                &around[place],
                Taken::ToTolerance,
            )
        };
        let inside = self.inside();
        let mut settled: Vec<_> = inside
            .iter()
            .map(|place| *place as usize)
            .map(|place| Settled {
                refined: first[place],
                doubt: doubt(place, &first[place]),
            })
            .collect();
        let open = |pixel: &Settled| pixel.doubt.bound() > self.asked.tolerance;
        let places: Vec<usize> = (0..settled.len()).filter(|index| open(&settled[*index])).collect();
        let pixels: Vec<u32> = places.iter().map(|index| inside[*index]).collect();
        self.asked.watch.advance((settled.len() - places.len()) as u64);
        let enough = |index: usize, so_far: &Sampled| {
            let place = pixels[index] as usize;
            let done = so_far.count > first[place].samples
                && self.is_done(so_far.count, &doubt(place, &Refined::from(so_far)));
            if done {
                self.asked.watch.advance(1);
            }
            done || self.asked.watch.stopped()
        };
        let (refined, stats) = self.refine(tracer, &pixels, false, &enough)?;
        for ((index, place), refined) in places.into_iter().zip(&pixels).zip(refined) {
            let doubt = doubt(*place as usize, &refined);
            settled[index] = Settled { refined, doubt };
        }
        Ok((settled, stats))
    }

    /// Whether a pixel is within the tolerance, or has no prospect of it: no error falls faster than that of an edge.
    fn is_done(&self, count: u32, doubt: &Doubt) -> bool {
        let tolerance = self.asked.tolerance;
        let last = (f64::from(count) / f64::from(self.asked.most_samples.max(1))).powf(FALL);
        // Half of it, for an estimate may well be twice too large.
        let in_the_end = Doubt {
            sampling: doubt.sampling * (last / 2.0) as f32,
            ..*doubt
        };
        doubt.bound() <= tolerance || (count >= PATIENCE && in_the_end.bound() > tolerance)
    }

    fn refine(
        &self,
        tracer: &mut dyn Refiner,
        pixels: &[u32],
        sides: bool,
        enough: &(dyn Fn(usize, &Sampled) -> bool + Sync),
    ) -> Result<(Vec<Refined>, Stats), TraceError> {
        let spare = DROPPED * self.asked.tolerance;
        let limits = Limits {
            cutoff: BRANCH * spare,
            ray_budget: self.asked.ray_budget,
        };
        let task = Task {
            pixels,
            enough,
            sides,
            spare,
        };
        tracer.refine(self.window, limits, &task, self.asked.watch)
    }

    /// The places of what is asked for, row by row within the window.
    fn inside(&self) -> Vec<u32> {
        let (asked, window) = (self.inside, self.window);
        let (left, top) = (asked.x - window.x, asked.y - window.y);
        let row = |row: u32| (left..left + asked.width).map(move |column| row * window.width + column);
        (top..top + asked.height).flat_map(row).collect()
    }
}
