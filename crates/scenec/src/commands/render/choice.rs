//! What is to compute: what was asked for, and what serves best where nothing was.

use clap::Args;
use scenec_device::{DeviceInfo, Precision, Verdict, auto, discover, features, is_opencl, select, suited};
use scenec_measure::Sampler;
use scenec_plan::{Features, Plan};

use crate::failure::Failure;
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
pub(crate) struct MachineOptions {
    /// What computes: `auto`, `cpu`, `reference`, `opencl`, `opencl:INDEX` or `opencl:NAME`
    ///
    /// `auto` takes an OpenCL GPU if the scene is worth its preparations, and the built-in tracer on this processor
    /// otherwise, or where there is none or it fails.
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
    /// Let the compiler of OpenCL kernels in f32 break the rules of arithmetic, for comparison: nothing is promised then
    #[arg(long, hide = true)]
    fast_math: bool,
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

impl MachineOptions {
    /// Refuses arithmetic of which nothing is known, as this option of the command line needs it.
    pub(super) fn must_keep_rules(&self, option: &str) -> Result<(), Failure> {
        if self.fast_math {
            return Err(Failure::Unusable(format!(
                "{option} is about what is promised, and with --fast-math nothing is"
            )));
        }
        Ok(())
    }

    /// Whether anything is known of how wrong a picture is.
    pub(super) fn keeps_rules(&self) -> bool {
        !self.fast_math
    }

    /// What samples pixel by pixel: the built-in tracer, unless another is asked for.
    ///
    /// # Errors
    /// There is no such device.
    pub(super) fn sampler(&self) -> Result<Sampler<'static>, Failure> {
        Ok(match &self.device {
            Choice::Auto | Choice::Cpu => Sampler::Cpu,
            Choice::Reference => Sampler::Reference,
            Choice::OpenCl(request) => Sampler::OpenCl(select(request, discover())?),
        })
    }

    /// The precision that was asked for; `None` for `auto`.
    pub(super) fn asked_precision(&self) -> Option<Precision> {
        self.precision
    }

    /// Whether the slow tracer was asked for, which goes without a plan.
    pub(crate) fn wants_reference(&self) -> bool {
        self.device == Choice::Reference
    }

    /// Whether what computes depends on how long it would take.
    pub(crate) fn wants_forecast(&self) -> bool {
        self.device == Choice::Auto
    }

    /// Whether another tracer may take over from a device that fails.
    pub(crate) fn may_change(&self) -> bool {
        self.device == Choice::Auto
    }

    /// Whether a device that was asked for itself is to break the rules of arithmetic, which only singles are worth.
    pub(crate) fn fast_math(&self, precision: Precision) -> bool {
        self.fast_math && precision == Precision::F32 && matches!(self.device, Choice::OpenCl(_))
    }

    /// Threads of the built-in tracers; 0 for as many as the machine has.
    pub(crate) fn threads(&self) -> usize {
        self.threads.unwrap_or(0).into()
    }

    /// The parts of the kernels that a plan needs, or all of them.
    pub(crate) fn features(&self, plan: &Plan) -> Features {
        if self.generic {
            Features::generic(plan)
        } else {
            Features::of(plan)
        }
    }

    /// The same on a device, for a picture that takes the built-in tracer so many nanoseconds: where nothing was asked for,
    /// no more is compiled than pays.
    pub(crate) fn features_on(
        &self,
        info: &DeviceInfo,
        plan: &Plan,
        precision: Precision,
        nanoseconds: f64,
    ) -> Features {
        let features = if self.device == Choice::Auto && !self.generic {
            features(nanoseconds, info, precision, plan)
        } else {
            self.features(plan)
        };
        suited(info, features)
    }

    /// What computes a picture that takes the built-in tracer so many nanoseconds; no device is a built-in tracer.
    ///
    /// # Errors
    /// There is no such device.
    pub(crate) fn choose(&self, plan: &Plan, precision: Precision, nanoseconds: f64) -> Result<Verdict, Failure> {
        let asked = |device: Option<&'static DeviceInfo>| Verdict {
            device,
            why: "it was asked for".to_owned(),
        };
        match &self.device {
            Choice::Auto => Ok(auto(nanoseconds, precision, plan)),
            Choice::Cpu | Choice::Reference => Ok(asked(None)),
            Choice::OpenCl(request) => Ok(asked(Some(select(request, discover())?))),
        }
    }

    /// The precision that was asked for, or the one that the plan asks for; `warn` hears what a person should know.
    pub(crate) fn precision(&self, plan: &Plan, warn: fn(&str)) -> Precision {
        match (self.precision, plan.beyond_single()) {
            (None, Some(reason)) => {
                warn(&format!("f64 is taken, since {reason}"));
                Precision::F64
            }
            (Some(Precision::F32), Some(reason)) => {
                warn(&format!("{reason}; --precision f64 can tell it"));
                Precision::F32
            }
            (asked, _) => asked.unwrap_or(Precision::F32),
        }
    }

    /// The same on a device that somebody insists on, which may not have doubles.
    pub(crate) fn precision_on(&self, info: &DeviceInfo, precision: Precision, warn: fn(&str)) -> Precision {
        if precision == Precision::F64 && self.precision.is_none() && !info.has_f64 {
            warn(&format!("{} has no f64, so f32 has to do", info.name));
            return Precision::F32;
        }
        precision
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
