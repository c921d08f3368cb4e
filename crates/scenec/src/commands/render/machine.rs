//! What computes: the tracer that was asked for, or the one that serves best.

use clap::Args;
use scenec_cpu::Cpu;
use scenec_device::{DeviceInfo, Precision, discover, is_opencl, select};
use scenec_picture::{Frame, Request, TraceError, Tracer};
use scenec_plan::{Features, Plan, plan};
use scenec_reference::Reference;
use scenec_scene::Scene;

use super::clock::Clock;
use crate::failure::Failure;
use crate::progress;
use crate::values::named;

const PRECISIONS: &[(Option<Precision>, &str)] = &[
    (None, "auto"),
    (Some(Precision::F32), "f32"),
    (Some(Precision::F64), "f64"),
];

/// What was asked for; `None` for `auto`. Under this name an argument of the parser's own type, not one that may be missing.
type Asked = Option<Precision>;

/// Arguments about what computes.
#[derive(Args, Debug)]
#[command(next_help_heading = "Device")]
pub(super) struct MachineOptions {
    /// What computes: `auto`, `cpu`, `reference`, `opencl`, `opencl:INDEX` or `opencl:NAME`
    ///
    /// `auto` takes the first OpenCL GPU, and the built-in tracer on this processor where there is none or it fails.
    /// `cpu` is the built-in tracer. `reference` is the slow tracer that the others are judged by. `opencl` takes the
    /// first GPU, accelerator or processor that has an OpenCL driver, `opencl:INDEX` and `opencl:NAME` the one that
    /// `scenec devices` lists under that number or with that text in its name.
    #[arg(long, value_name = "DEVICE", default_value = "auto", value_parser = Choice::parse)]
    device: Choice,
    /// The numbers to compute with: `auto`, `f32` or `f64`; the reference tracer always takes f64
    ///
    /// `auto` takes f32 unless the scene shows before it is traced that f32 can't tell it: an eye too far away for its
    /// field of view, surfaces that almost coincide, sizes that span too much.
    #[arg(long, value_name = "TYPE", default_value = "auto", value_parser = named(PRECISIONS))]
    precision: Asked,
    /// Threads of the built-in tracers; as many as the machine has unless given
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    threads: Option<u16>,
    /// Use OpenCL kernels that serve any scene, not only this one
    #[arg(long, hide = true)]
    generic: bool,
}

/// What computes.
#[derive(Clone, PartialEq, Eq, Debug)]
enum Choice {
    Auto,
    Cpu,
    Reference,
    /// A request that the device crate understands.
    OpenCl(String),
}

impl Choice {
    fn parse(text: &str) -> Result<Self, String> {
        match text {
            "auto" => Ok(Self::Auto),
            "cpu" => Ok(Self::Cpu),
            "reference" => Ok(Self::Reference),
            _ if is_opencl(text) => Ok(Self::OpenCl(text.to_owned())),
            _ => Err("a device is auto, cpu, reference, opencl, opencl:INDEX or opencl:NAME".to_owned()),
        }
    }
}

/// What came of it.
pub(super) struct Traced {
    pub(super) frame: Frame,
    /// What computed, for people.
    pub(super) name: String,
    /// Unless it was the reference tracer, which goes without.
    pub(super) plan: Option<Plan>,
    /// What the kernels were made for, if they were.
    pub(super) features: Option<Features>,
}

/// One attempt after another, until one succeeds.
pub(super) struct Attempt<'a> {
    pub(super) options: &'a MachineOptions,
    pub(super) request: Request<'a>,
    pub(super) clock: &'a mut Clock,
    /// Whether progress is to be shown.
    pub(super) progress: bool,
    /// Told what a person should know about how the picture comes about.
    pub(super) warn: fn(&str),
}

impl Attempt<'_> {
    /// Traces the scene.
    pub(super) fn trace(&mut self, scene: &Scene) -> Result<Traced, Failure> {
        let choice = &self.options.device;
        if *choice == Choice::Reference {
            let mut tracer = Reference::new(scene);
            if let Some(threads) = self.options.threads {
                tracer = tracer.with_threads(threads.into());
            }
            return self.finish(&mut tracer, None, None);
        }
        let plan = plan(scene).map_err(|error| Failure::Unusable(format!("the scene can't be traced: {error}")))?;
        let precision = self.precision(&plan);
        self.clock.lap("plan");
        match choice {
            Choice::OpenCl(request) => {
                let info = select(request, discover())?;
                let precision = self.on_device(info, precision);
                self.opencl(info, plan, precision)
            }
            Choice::Auto => match best(precision) {
                Some(info) => match self.opencl(info, plan.clone(), precision) {
                    Err(Failure::Device(reason)) if !self.request.watch.stopped() => {
                        // A compiler's log has many more lines.
                        let reason = reason.lines().next().unwrap_or_default();
                        (self.warn)(&format!("{} failed, so the cpu takes over: {reason}", info.name));
                        self.cpu(plan, precision)
                    }
                    outcome => outcome,
                },
                None => self.cpu(plan, precision),
            },
            Choice::Cpu | Choice::Reference => self.cpu(plan, precision),
        }
    }

    /// The precision that was asked for, or the one that the plan asks for.
    fn precision(&self, plan: &Plan) -> Precision {
        match (self.options.precision, plan.beyond_single()) {
            (None, Some(reason)) => {
                (self.warn)(&format!("f64 is taken, since {reason}"));
                Precision::F64
            }
            (Some(Precision::F32), Some(reason)) => {
                (self.warn)(&format!("{reason}; --precision f64 can tell it"));
                Precision::F32
            }
            (asked, _) => asked.unwrap_or(Precision::F32),
        }
    }

    /// The same on a device that somebody insists on, which may not have doubles.
    fn on_device(&self, info: &DeviceInfo, precision: Precision) -> Precision {
        if precision == Precision::F64 && self.options.precision.is_none() && !info.has_f64 {
            (self.warn)(&format!("{} has no f64, so f32 has to do", info.name));
            return Precision::F32;
        }
        precision
    }

    fn cpu(&mut self, plan: Plan, precision: Precision) -> Result<Traced, Failure> {
        let threads = self.options.threads.unwrap_or(0).into();
        match precision {
            Precision::F32 => self.finish(&mut Cpu::<f32>::new(&plan, threads)?, Some(plan), None),
            Precision::F64 => self.finish(&mut Cpu::<f64>::new(&plan, threads)?, Some(plan), None),
        }
    }

    fn opencl(&mut self, info: &DeviceInfo, plan: Plan, precision: Precision) -> Result<Traced, Failure> {
        let features = if self.options.generic {
            Features::generic(&plan)
        } else {
            Features::of(&plan)
        };
        let mut tracer = scenec_device::tracer(info, &plan, precision, &features)?;
        let outcome = self.finish(tracer.as_mut(), Some(plan), Some(features));
        drop(tracer);
        self.clock.lap("release");
        outcome
    }

    fn finish(
        &mut self,
        tracer: &mut dyn Tracer,
        plan: Option<Plan>,
        features: Option<Features>,
    ) -> Result<Traced, Failure> {
        self.clock.lap("prepare");
        let request = &self.request;
        let outcome = if request.watch.stopped() {
            Err(TraceError::Cancelled)
        } else {
            progress::shown(request.watch, request.window.pixels(), self.progress, || {
                tracer.trace(request)
            })
        };
        self.clock.lap("trace");
        Ok(Traced {
            frame: outcome?,
            name: tracer.name(),
            plan,
            features,
        })
    }
}

/// The GPU that `auto` takes, if one can do what is asked.
fn best(precision: Precision) -> Option<&'static DeviceInfo> {
    scenec_device::gpu(discover()).filter(|info| precision == Precision::F32 || info.has_f64)
}

#[cfg(test)]
mod tests {
    use super::Choice;

    fn check(text: &str, expect: Option<Choice>) {
        assert_eq!(Choice::parse(text).ok(), expect, "{text}");
    }

    #[test]
    fn devices_are_chosen_by_word() {
        check("auto", Some(Choice::Auto));
        check("cpu", Some(Choice::Cpu));
        check("reference", Some(Choice::Reference));
        check("opencl:rtx 3060", Some(Choice::OpenCl("opencl:rtx 3060".to_owned())));
        check("gpu", None);
        check("openclx", None);
        check("", None);
    }
}
