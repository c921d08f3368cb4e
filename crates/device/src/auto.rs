//! What `auto` means: the built-in tracer, unless a GPU is worth its preparations.
//!
//! Here is the arithmetic alone; the page on performance has it in words. How long the built-in tracer would take is the
//! caller's to know. An OpenCL driver for the processor itself is never taken: it shares the cores with the built-in
//! tracer and has more to prepare.

use scenec_plan::{Features, Plan};

use crate::assemble::{Precision, options, source};
use crate::discover::{Discovery, discover};
use crate::info::{DeviceInfo, DeviceKind};
use crate::known::{self, Known};
use crate::program;
use crate::session::programs;

/// The drivers are asked if the built-in tracer takes this many times longer than that: where the answer is no, little
/// was lost.
const PATIENCE: f64 = 4.0;
/// How much longer a program takes that serves any scene, as a part of what one for this scene takes.
const GENERIC: f64 = 0.25;

/// What `auto` takes, and why.
#[derive(Clone, Debug)]
pub struct Verdict {
    /// The device; none for the built-in tracer.
    pub device: Option<&'static DeviceInfo>,
    /// A sentence's end, for people.
    pub why: String,
}

/// Whether work that takes the built-in tracer so many nanoseconds is worth asking drivers for their devices.
#[must_use]
pub fn worth_asking(nanoseconds: f64) -> bool {
    nanoseconds > PATIENCE * known::asking(&known::cache())
}

/// What serves a picture best that takes the built-in tracer so many nanoseconds. Only one that takes long lets the
/// drivers be asked.
#[must_use]
pub fn auto(nanoseconds: f64, precision: Precision, plan: &Plan) -> Verdict {
    if !worth_asking(nanoseconds) {
        return built_in("so short a time is not worth asking drivers for devices".to_owned());
    }
    let known = |info: &DeviceInfo| {
        let mut known = Known::of(&known::cache(), info, precision);
        if is_kept(info, precision, &Features::of(plan)) || is_kept(info, precision, &Features::generic(plan)) {
            known.compiling = 0.0;
        }
        known
    };
    judge(nanoseconds, precision, discover(), known)
}

/// The features to compile for on a device, where the picture would take the built-in tracer so many nanoseconds: those of
/// the plan, unless a program for any scene is there already and compiling takes longer than it can save.
#[must_use]
pub fn features(nanoseconds: f64, info: &DeviceInfo, precision: Precision, plan: &Plan) -> Features {
    let (own, generic) = (Features::of(plan), Features::generic(plan));
    let known = Known::of(&known::cache(), info, precision);
    if !pays(nanoseconds, &known) && !is_kept(info, precision, &own) && is_kept(info, precision, &generic) {
        return generic;
    }
    own
}

/// The same features in the way that suits a device: eight rays, boxes or balls at a time make a processor's vectors, and nothing
/// else does, while a GPU makes its own of neighbouring rays.
#[must_use]
pub fn suited(info: &DeviceInfo, features: Features) -> Features {
    Features {
        eights: info.kind == DeviceKind::Cpu,
        ..features
    }
}

/// Whether a program for one scene saves more than compiling it takes.
fn pays(nanoseconds: f64, known: &Known) -> bool {
    GENERIC * nanoseconds / known.gain > known.compiling
}

fn is_kept(info: &DeviceInfo, precision: Precision, features: &Features) -> bool {
    programs().has(program::key(
        info,
        &source(precision, features),
        &options(info, precision),
    ))
}

fn judge(
    nanoseconds: f64,
    precision: Precision,
    found: &'static Discovery,
    known: impl Fn(&DeviceInfo) -> Known,
) -> Verdict {
    let fit = |info: &&DeviceInfo| info.kind == DeviceKind::Gpu && (precision == Precision::F32 || info.has_f64);
    let costs = found
        .devices
        .iter()
        .filter(fit)
        .map(|info| (info, cost(nanoseconds, &known(info))));
    let Some((info, expected)) = costs.min_by(|(_, a), (_, b)| a.total_cmp(b)) else {
        return built_in(match precision {
            Precision::F32 => "there is no GPU with an OpenCL driver".to_owned(),
            Precision::F64 => "there is no GPU with an OpenCL driver and doubles".to_owned(),
        });
    };
    let why = format!("{} would take about {:.0} ms", info.name, expected / 1e6);
    if expected >= nanoseconds {
        return built_in(why);
    }
    Verdict {
        device: Some(info),
        why,
    }
}

/// What a device takes in all for a picture that takes the built-in tracer so many nanoseconds.
fn cost(nanoseconds: f64, known: &Known) -> f64 {
    known.compiling + known.starting + nanoseconds / known.gain
}

const fn built_in(why: String) -> Verdict {
    Verdict { device: None, why }
}

#[cfg(test)]
mod tests {
    use super::{Known, cost, judge, pays};
    use crate::DeviceKind;
    use crate::assemble::Precision;
    use crate::discover::Discovery;
    use crate::select::tests::device;

    /// Which device a machine with these kinds of them takes for work of so many milliseconds, if any.
    fn check(kinds: &[DeviceKind], precision: Precision, milliseconds: f64, known: Known, expect: Option<usize>) {
        let devices = kinds.iter().enumerate().map(|(index, kind)| crate::DeviceInfo {
            has_f64: false,
            ..device(index, "P", "D", *kind)
        });
        let found = Box::leak(Box::new(Discovery::of(devices.collect())));
        let verdict = judge(milliseconds * 1e6, precision, found, |_| known);
        let taken = verdict.device.map(|info| info.index);
        assert_eq!(taken, expect, "{kinds:?} {milliseconds}: {}", verdict.why);
    }

    #[test]
    fn a_gpu_is_taken_for_long_work_and_a_processor_never() {
        let both = [DeviceKind::Cpu, DeviceKind::Gpu];
        check(&both, Precision::F32, 500.0, Known::GUESS, None);
        check(&both, Precision::F32, 5000.0, Known::GUESS, Some(1));
        check(&both, Precision::F64, 5000.0, Known::GUESS, None);
        check(&both[..1], Precision::F32, 1e6, Known::GUESS, None);
        check(&[], Precision::F32, 1e6, Known::GUESS, None);
    }

    #[test]
    fn what_was_measured_decides() {
        let gpu = [DeviceKind::Gpu];
        let kept = Known {
            compiling: 0.0,
            ..Known::GUESS
        };
        check(&gpu, Precision::F32, 500.0, kept, Some(0));
        let slow = Known { gain: 0.5, ..kept };
        check(&gpu, Precision::F32, 1e6, slow, None);
        assert!(pays(60e9, &Known::GUESS) && !pays(1e9, &Known::GUESS));
    }

    /// What was measured on a driver for the processor (PoCL 3.1, two threads) within one minute, milliseconds: what the
    /// built-in tracer took for a scene, and what the driver took to get ready and to trace. As if it were a GPU's.
    const MEASURED: [(&str, f64, f64, f64); 3] = [
        ("seed.scene", 47.0, 35.0, 57.0),
        ("1,000 balls", 360.0, 90.0, 366.0),
        ("100,000 balls", 611.0, 96.0, 727.0),
    ];

    #[test]
    fn what_one_scene_taught_foretells_the_others() {
        for (taught, built_in, starting, tracing) in MEASURED {
            let known = Known {
                compiling: 0.0,
                starting: starting * 1e6,
                gain: built_in / tracing,
            };
            for (name, built_in, starting, tracing) in MEASURED {
                let (foretold, came) = (cost(built_in * 1e6, &known) / 1e6, starting + tracing);
                let ratio = foretold / came;
                assert!(
                    (0.6..1.7).contains(&ratio),
                    "{name} after {taught}: {foretold:.0} ms for {came:.0} ms"
                );
                // It never was the faster one, and is never taken.
                check(&[DeviceKind::Gpu], Precision::F32, built_in, known, None);
            }
        }
    }
}
