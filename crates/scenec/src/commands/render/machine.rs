//! The tracer at work: the one that was asked for, or the one that serves best, and another where that one fails.

use std::thread;

use scenec_cpu::{Cpu, Number};
use scenec_device::{DeviceInfo, Precision, remember_gain, worth_asking};
use scenec_measure::{Doubt, Tolerance, doubts};
use scenec_picture::{Frame, Request, Stats, Tracer, Window};
use scenec_plan::{Features, Plan, PlanError, plan};
use scenec_reference::Reference;
use scenec_scene::Scene;

use super::choice::MachineOptions;
use super::clock::Clock;
use super::target::Deliver;
use crate::failure::Failure;
use crate::forecast::{forecast, most};
use crate::progress;

/// What came of it.
pub(super) struct Traced {
    /// Of a picture that was handed out in bands, the last one and the figures of all.
    pub(super) frame: Frame,
    /// Pixels that are no finite numbers.
    pub(super) strange: u64,
    /// What computed, for people.
    pub(super) name: String,
    /// Unless it was the reference tracer, which goes without.
    pub(super) plan: Option<Plan>,
    /// What the kernels were made for, if they were.
    pub(super) features: Option<Features>,
    /// How wrong each pixel may be, if the tracer can tell and somebody asks.
    pub(super) doubts: Option<Vec<Doubt>>,
    /// What was promised, if something was.
    pub(super) promise: Option<Promise>,
}

/// A tolerance, and what was spent on it.
pub(super) struct Promise {
    pub(super) tolerance: f64,
    /// Of each pixel.
    pub(super) samples: Vec<u32>,
}

/// One attempt after another, until one succeeds.
pub(super) struct Attempt<'a> {
    pub(super) options: &'a MachineOptions,
    pub(super) request: Request<'a>,
    pub(super) clock: &'a mut Clock,
    /// Takes the picture band by band, where it is too large to be held.
    pub(super) deliver: Option<Deliver<'a>>,
    /// Whether progress is to be shown.
    pub(super) progress: bool,
    /// Told what a person should know about how the picture comes about.
    pub(super) warn: fn(&str),
    /// What is done: a tracer that takes over from another goes on from there.
    pub(super) delivered: Delivered,
}

/// The bands that were handed out.
#[derive(Default)]
pub(super) struct Delivered {
    rows: u32,
    strange: u64,
    stats: Stats,
}

/// About the pixels of a band.
const BAND: u32 = 1 << 22;

impl Attempt<'_> {
    /// Traces the scene.
    pub(super) fn trace(&mut self, scene: &Scene) -> Result<Traced, Failure> {
        if self.options.wants_reference() {
            // The tracer goes without a plan; what roundings may do is told by one.
            let told = self.request.layers.spread.then(|| plan(scene).map_err(unplanned));
            let told = told.transpose()?;
            let traced = self.finish(&mut self.reference(scene), None)?;
            return Ok(match told {
                Some(plan) => self.doubted(traced, &plan, Precision::F64),
                None => traced,
            });
        }
        let plan = plan(scene).map_err(unplanned)?;
        let precision = self.options.precision(&plan, self.warn);
        self.clock.lap("plan");
        match precision {
            Precision::F32 => self.planned::<f32>(plan, precision),
            Precision::F64 => self.planned::<f64>(plan, precision),
        }
    }

    fn planned<R: Number>(&mut self, plan: Plan, precision: Precision) -> Result<Traced, Failure> {
        let threads = self.options.threads();
        let mut prepared = None;
        let nanoseconds = match most(&plan, &self.request, workers(threads)) {
            _ if !self.options.wants_forecast() => 0.0,
            Some(most) if !worth_asking(most) => most,
            _ => {
                let cpu = prepared.insert(Cpu::<R>::new(&plan, threads)?);
                forecast(cpu, &plan, &self.request)?.nanoseconds
            }
        };
        self.clock.lap("prepare");
        if let Some(info) = self.options.choose(&plan, precision, nanoseconds)?.device {
            let precision = self.options.precision_on(info, precision, self.warn);
            match self.opencl(info, plan.clone(), precision, nanoseconds) {
                Err(Failure::Device(reason)) if self.options.may_change() && !self.request.watch.stopped() => {
                    // A compiler's log has many more lines.
                    let reason = reason.lines().next().unwrap_or_default();
                    (self.warn)(&format!("{} failed, so the cpu takes over: {reason}", info.name));
                }
                outcome => return outcome,
            }
        }
        let mut cpu = match prepared {
            Some(cpu) => cpu,
            None => Cpu::<R>::new(&plan, threads)?,
        };
        let traced = self.finish(&mut cpu, None)?;
        let traced = self.doubted(traced, &plan, precision);
        Ok(Traced {
            plan: Some(plan),
            ..traced
        })
    }

    fn reference(&self, scene: &Scene) -> Reference {
        let tracer = Reference::new(scene);
        match self.options.threads() {
            0 => tracer,
            threads => tracer.with_threads(threads),
        }
    }

    /// The same with how wrong each pixel may be, if the tracer tells how far samples are apart.
    fn doubted(&mut self, mut traced: Traced, plan: &Plan, precision: Precision) -> Traced {
        traced.doubts = doubts(plan, precision, &traced.frame);
        if traced.doubts.is_some() {
            self.clock.lap("bound");
        }
        traced
    }

    /// Traces the scene until no pixel may be off by more than a tolerance, or none can be improved.
    pub(super) fn promised(&mut self, scene: &Scene, tolerance: f64, most_samples: u32) -> Result<Traced, Failure> {
        let request = &self.request;
        let wish = Tolerance {
            window: request.window,
            most_samples,
            ray_budget: request.limits.ray_budget,
            sampler: self.options.sampler()?,
            precision: self.options.asked_precision(),
            threads: self.options.threads(),
            ..Tolerance::of(scene, tolerance, request.watch)
        };
        let pixels = request.window.pixels();
        let achieved = progress::shown(request.watch, pixels, self.progress, || wish.achieve());
        self.clock.lap("trace");
        let achieved = achieved?;
        Ok(Traced {
            strange: achieved.picture.non_finite() as u64,
            frame: Frame {
                picture: achieved.picture,
                ids: None,
                exact: None,
                paths: None,
                spread: None,
                distances: None,
                stats: achieved.stats,
            },
            name: achieved.name,
            plan: Some(achieved.plan),
            features: None,
            doubts: Some(achieved.doubts),
            promise: Some(Promise {
                tolerance,
                samples: achieved.samples,
            }),
        })
    }

    fn opencl(
        &mut self,
        info: &DeviceInfo,
        plan: Plan,
        precision: Precision,
        nanoseconds: f64,
    ) -> Result<Traced, Failure> {
        let features = Features {
            spread: self.request.layers.spread,
            ..self.options.features_on(info, &plan, precision, nanoseconds)
        };
        let mut tracer = if self.options.fast_math(precision) {
            scenec_device::relaxed_tracer(info, &plan, &features)?
        } else {
            scenec_device::tracer(info, &plan, precision, &features)?
        };
        let outcome = self.finish(tracer.as_mut(), Some(features));
        drop(tracer);
        if let Ok(traced) = &outcome
            && let Some(kernel) = traced.frame.stats.kernel_ns
            && nanoseconds > 0.0
        {
            remember_gain(info, precision, kernel as f64, nanoseconds);
        }
        self.clock.lap("release");
        let traced = self.doubted(outcome?, &plan, precision);
        Ok(Traced {
            plan: Some(plan),
            ..traced
        })
    }

    fn finish(&mut self, tracer: &mut dyn Tracer, features: Option<Features>) -> Result<Traced, Failure> {
        self.clock.lap("prepare");
        let (watch, pixels, shown) = (self.request.watch, self.request.window.pixels(), self.progress);
        let traced = progress::shown(watch, pixels, shown, || self.bands(tracer));
        self.clock.lap("trace");
        let (frame, strange) = traced?;
        Ok(Traced {
            frame,
            strange,
            name: tracer.name(),
            plan: None,
            features,
            doubts: None,
            promise: None,
        })
    }

    /// Traces the bands that are left, or the one that is the whole picture.
    fn bands(&mut self, tracer: &mut dyn Tracer) -> Result<(Frame, u64), Failure> {
        let whole = self.request.window;
        let rows = match self.deliver {
            Some(_) => (BAND / whole.width).max(1),
            None => whole.height,
        };
        loop {
            if self.request.watch.stopped() {
                return Err(Failure::Interrupted);
            }
            let window = Window {
                y: whole.y + self.delivered.rows,
                height: rows.min(whole.height - self.delivered.rows),
                ..whole
            };
            let mut frame = tracer.trace(&Request { window, ..self.request })?;
            if let Some(deliver) = &mut self.deliver {
                deliver(&frame.picture)?;
            }
            let delivered = &mut self.delivered;
            delivered.rows += window.height;
            delivered.strange += frame.picture.non_finite() as u64;
            delivered.stats = delivered.stats.merge(frame.stats);
            if delivered.rows >= whole.height {
                frame.stats = delivered.stats;
                return Ok((frame, delivered.strange));
            }
        }
    }
}

fn unplanned(error: PlanError) -> Failure {
    Failure::Unusable(format!("the scene can't be traced: {error}"))
}

/// How many threads a built-in tracer has that is asked for so many.
fn workers(threads: usize) -> usize {
    match threads {
        0 => thread::available_parallelism().map_or(1, usize::from),
        _ => threads,
    }
}
