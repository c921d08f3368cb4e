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

const PRECISIONS: &[(Precision, &str)] = &[(Precision::F32, "f32"), (Precision::F64, "f64")];

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
    /// The numbers to compute with; the reference tracer always takes f64
    #[arg(long, value_name = "TYPE", default_value = "f32", value_parser = named(PRECISIONS))]
    precision: Precision,
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
    /// Told, once, why the device that serves best does not.
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
        self.clock.lap("plan");
        match choice {
            Choice::OpenCl(request) => self.opencl(select(request, discover())?, plan),
            Choice::Auto => match self.options.best() {
                Some(info) => match self.opencl(info, plan.clone()) {
                    Err(Failure::Device(reason)) if !self.request.watch.stopped() => {
                        // A compiler's log has many more lines.
                        let reason = reason.lines().next().unwrap_or_default();
                        (self.warn)(&format!("{} failed, so the cpu takes over: {reason}", info.name));
                        self.cpu(plan)
                    }
                    outcome => outcome,
                },
                None => self.cpu(plan),
            },
            Choice::Cpu | Choice::Reference => self.cpu(plan),
        }
    }

    fn cpu(&mut self, plan: Plan) -> Result<Traced, Failure> {
        let threads = self.options.threads.unwrap_or(0).into();
        match self.options.precision {
            Precision::F32 => self.finish(&mut Cpu::<f32>::new(&plan, threads)?, Some(plan), None),
            Precision::F64 => self.finish(&mut Cpu::<f64>::new(&plan, threads)?, Some(plan), None),
        }
    }

    fn opencl(&mut self, info: &DeviceInfo, plan: Plan) -> Result<Traced, Failure> {
        let features = if self.options.generic {
            Features::generic(&plan)
        } else {
            Features::of(&plan)
        };
        let mut tracer = scenec_device::tracer(info, &plan, self.options.precision, &features)?;
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

impl MachineOptions {
    /// The GPU that `auto` takes, if one can do what is asked.
    fn best(&self) -> Option<&'static DeviceInfo> {
        scenec_device::gpu(discover()).filter(|info| self.precision == Precision::F32 || info.has_f64)
    }
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
