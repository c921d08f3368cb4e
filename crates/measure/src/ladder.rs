//! The settings that are tried, in families: one curve each, with one thing that changes along it.

use scenec_device::{DeviceInfo, Precision};
use scenec_picture::Limits;
use scenec_scene::Scene;

use crate::effort::{Effort, depths};
use crate::setting::{Machine, Program, Setting};

/// A step of a family.
#[derive(Clone, PartialEq, Debug)]
pub(crate) struct Rung {
    /// What stays: "cpu f32".
    pub(crate) family: String,
    /// What changes: "samples 16".
    pub(crate) knob: String,
    pub(crate) setting: Setting,
}

/// All families of a scene: the samples, on each machine and in each precision that it has; and the cut-offs and the
/// depths, on the processor in single precision.
pub(crate) fn ladder(scene: &Scene, effort: &Effort, device: Option<&DeviceInfo>) -> Vec<Rung> {
    let mut machines = vec![(Machine::Cpu, Precision::F32), (Machine::Cpu, Precision::F64)];
    if let Some(device) = device {
        let on = |program| Machine::OpenCl {
            device: device.clone(),
            program,
        };
        machines
            .extend([Program::Made, Program::General, Program::FastMath].map(|program| (on(program), Precision::F32)));
        if device.has_f64 {
            machines.push((on(Program::Made), Precision::F64));
        }
    }
    let raydepth = scene.settings.raydepth;
    let mut rungs = Vec::new();
    for (machine, precision) in machines {
        let usual = matches!(
            (&machine, precision),
            (Machine::Cpu, _)
                | (
                    Machine::OpenCl {
                        program: Program::Made,
                        ..
                    },
                    Precision::F32
                )
        );
        let samples = if usual { effort.samples } else { effort.variants };
        rungs.extend(samples.iter().map(|&samples| Rung {
            family: format!("{} {precision}", machine.name()),
            knob: format!("samples {samples}"),
            setting: Setting {
                machine: machine.clone(),
                precision,
                samples,
                raydepth,
                cutoff: Limits::DEFAULT.cutoff,
            },
        }));
    }
    let middle = Setting {
        machine: Machine::Cpu,
        precision: Precision::F32,
        samples: effort.middle(),
        raydepth,
        cutoff: 0.0,
    };
    rungs.extend(effort.cutoffs.iter().map(|&cutoff| Rung {
        family: format!("cpu f32 x{}, cut-off", middle.samples),
        knob: cutoff_words(cutoff),
        setting: Setting {
            cutoff,
            ..middle.clone()
        },
    }));
    rungs.extend(depths(raydepth).into_iter().map(|raydepth| Rung {
        family: format!("cpu f32 x{}, depth", middle.samples),
        knob: format!("raydepth {raydepth}"),
        setting: Setting {
            raydepth,
            ..middle.clone()
        },
    }));
    rungs
}

fn cutoff_words(cutoff: f64) -> String {
    match cutoff {
        0.0 => "no cut-off".to_owned(),
        _ => format!("cut-off 1/{:.0}", 1.0 / cutoff),
    }
}
