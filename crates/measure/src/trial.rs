//! One picture at one setting.

use std::time::Instant;

use scenec_cpu::Cpu;
use scenec_device::{Precision, relaxed_tracer, suited, tracer};
use scenec_picture::{Frame, Layers, Request, TraceError, Tracer, Watch, Window};
use scenec_plan::{Features, Plan, plan};
use scenec_scene::Scene;

use crate::setting::{Machine, Program, Setting};

/// What came of it.
pub(crate) struct Trial {
    /// Who computed.
    pub(crate) name: String,
    /// With its pixels in f64.
    pub(crate) frame: Frame,
    /// Of tracing alone: by the device's clock where it has one, by ours otherwise.
    pub(crate) seconds: f64,
}

/// Traces the scene; everything before the first ray is made anew and not timed.
///
/// # Errors
/// There is no plan, the device fails, or somebody says stop.
pub(crate) fn trial(scene: &Scene, setting: &Setting, watch: &Watch) -> Result<Trial, TraceError> {
    let scene = setting.scene(scene);
    let failed = |error: &dyn std::fmt::Display| TraceError::Failed(error.to_string());
    let plan = plan(&scene).map_err(|error| failed(&error))?;
    let mut tracer = tracer_of(setting, &plan)?;
    let request = Request {
        window: Window::whole(scene.settings.width, scene.settings.height),
        limits: setting.limits(),
        layers: Layers {
            exact: true,
            ..Layers::default()
        },
        watch,
    };
    let begin = Instant::now();
    let frame = tracer.trace(&request)?;
    let seconds = begin.elapsed().as_secs_f64();
    Ok(Trial {
        name: tracer.name(),
        seconds: frame.stats.kernel_ns.map_or(seconds, |ns| ns as f64 * 1e-9),
        frame,
    })
}

fn tracer_of(setting: &Setting, plan: &Plan) -> Result<Box<dyn Tracer>, TraceError> {
    match (&setting.machine, setting.precision) {
        (Machine::Cpu, Precision::F32) => Ok(Box::new(Cpu::<f32>::new(plan, 0)?)),
        (Machine::Cpu, Precision::F64) => Ok(Box::new(Cpu::<f64>::new(plan, 0)?)),
        (Machine::OpenCl { device, program }, precision) => match program {
            Program::Made => tracer(device, plan, precision, &suited(device, Features::of(plan))),
            Program::General => tracer(device, plan, precision, &Features::generic(plan)),
            Program::FastMath => relaxed_tracer(device, plan, &suited(device, Features::of(plan))),
        }
        .map_err(|error| TraceError::Failed(error.to_string())),
    }
}
