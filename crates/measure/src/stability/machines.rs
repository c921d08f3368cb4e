//! Every tracer that there is, in every precision that it has.

use scenec_cpu::Cpu;
use scenec_device::{DeviceInfo, Precision, tracer};
use scenec_picture::{Exact, Frame, Layers, Limits, Request, TraceError, Tracer, Watch, Window};
use scenec_plan::{BeyondSingle, Features, Plan, plan};
use scenec_reference::Reference;
use scenec_scene::Scene;

/// What the suite is run on: the reference and the built-in tracer always, an OpenCL device where there is one.
#[derive(Clone, Copy, Debug, Default)]
pub struct Machines<'a> {
    /// The OpenCL device.
    pub device: Option<&'a DeviceInfo>,
    /// Whether POV-Ray is asked for its opinion.
    pub povray: bool,
}

/// A picture by one tracer.
#[derive(Debug)]
pub(super) struct Shot {
    pub(super) tracer: String,
    pub(super) single: bool,
    pub(super) frame: Frame,
    /// The picture in f64, from f32 where the tracer has nothing better.
    pub(super) exact: Exact,
}

impl Machines<'_> {
    /// The picture of the independent tracer, with the ways that its rays took.
    pub(super) fn reference(&self, scene: &Scene) -> Result<Shot, TraceError> {
        shoot(&mut Reference::new(scene), scene, false)
    }

    /// Why single precision is not taken for a scene, if it is not.
    pub(super) fn beyond_single(scene: &Scene) -> Result<Option<BeyondSingle>, TraceError> {
        Ok(planned(scene)?.beyond_single())
    }

    /// The pictures of all other tracers, in single precision only where that is what they would take.
    pub(super) fn others(&self, scene: &Scene) -> Result<Vec<Shot>, TraceError> {
        let plan = planned(scene)?;
        let narrow = plan.beyond_single().is_none();
        let mut shots = vec![shoot(&mut Cpu::<f64>::new(&plan, 0)?, scene, false)?];
        if narrow {
            shots.push(shoot(&mut Cpu::<f32>::new(&plan, 0)?, scene, true)?);
        }
        for precision in [Precision::F64, Precision::F32] {
            let single = precision == Precision::F32;
            let possible = |info: &&DeviceInfo| if single { narrow } else { info.has_f64 };
            let Some(info) = self.device.filter(possible) else {
                continue;
            };
            let mut tracer = tracer(info, &plan, precision, &Features::generic(&plan))
                .map_err(|error| TraceError::Failed(error.to_string()))?;
            shots.push(shoot(tracer.as_mut(), scene, single)?);
        }
        Ok(shots)
    }
}

fn planned(scene: &Scene) -> Result<Plan, TraceError> {
    plan(scene).map_err(|error| TraceError::Failed(error.to_string()))
}

fn shoot(tracer: &mut dyn Tracer, scene: &Scene, single: bool) -> Result<Shot, TraceError> {
    let watch = Watch::new();
    let frame = tracer.trace(&Request {
        window: Window::whole(scene.settings.width, scene.settings.height),
        limits: Limits::NO_CUTOFF,
        layers: Layers {
            ids: true,
            exact: true,
            paths: true,
            ..Layers::default()
        },
        watch: &watch,
    })?;
    let wide = |pixel: &[f32; 3]| pixel.map(f64::from);
    let exact = match &frame.exact {
        Some(exact) => exact.clone(),
        None => frame.picture.pixels().iter().map(wide).collect(),
    };
    Ok(Shot {
        tracer: tracer.name(),
        single,
        frame,
        exact,
    })
}
