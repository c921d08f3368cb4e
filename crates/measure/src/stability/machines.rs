//! Every tracer that there is, in every precision that it has.

use scenec_cpu::Cpu;
use scenec_device::{DeviceError, DeviceInfo, DeviceKind, Manner, Precision, discover, tracer, tracer_in};
use scenec_picture::{Exact, Frame, Layers, Limits, Request, TraceError, Tracer, Watch, Window};
use scenec_plan::{BeyondSingle, Features, Plan, plan};
use scenec_reference::Reference;
use scenec_scene::Scene;

use super::case::OnDevice;

/// What the suite is run on: the reference and the built-in tracer always, an OpenCL device where there is one.
#[derive(Clone, Copy, Debug, Default)]
pub struct Machines<'a> {
    /// The OpenCL device.
    pub device: Option<&'a DeviceInfo>,
    /// Whether POV-Ray is asked for its opinion.
    pub povray: bool,
    /// Whether of scenes that are drawn by lot all are traced, and not some.
    pub all: bool,
    /// Who may ask to stop: of a member with many scenes no further one is begun then, and its verdict is worth nothing.
    pub watch: Option<&'a Watch>,
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
        let features = Features::generic(&plan);
        if let Some(info) = self.device {
            let open = |precision| tracer(info, &plan, precision, &features);
            shots.extend(shots_on(info, scene, narrow, open)?);
        }
        Ok(shots)
    }

    /// Why there are no pictures of a device otherwise than a render takes it, if there are none.
    pub(super) fn lack(&self, how: OnDevice) -> Option<&'static str> {
        match how {
            _ if self.device.is_none() => Some("no OpenCL device"),
            OnDevice::Graphics if graphics().next().is_none() => Some("no graphics processor"),
            _ => None,
        }
    }

    /// The pictures of a device otherwise than a render takes it; none where it is lacking.
    pub(super) fn besides(&self, scene: &Scene, how: OnDevice) -> Result<Vec<Shot>, TraceError> {
        let Some(info) = self.device else {
            return Ok(Vec::new());
        };
        let plan = planned(scene)?;
        let (narrow, features) = (plan.beyond_single().is_none(), Features::generic(&plan));
        let in_manner = |manner| {
            let open = |precision| tracer_in(manner, info, &plan, precision, &features);
            shots_on(info, scene, narrow, open)
        };
        match how {
            OnDevice::Denormals => in_manner(Manner::Denormals),
            OnDevice::Groups(side) => in_manner(Manner::Groups(side)),
            OnDevice::Graphics => {
                let shots = graphics().map(|info| {
                    let open = |precision| tracer(info, &plan, precision, &features);
                    shots_on(info, scene, narrow, open)
                });
                Ok(shots.collect::<Result<Vec<_>, _>>()?.into_iter().flatten().collect())
            }
        }
    }
}

fn graphics() -> impl Iterator<Item = &'static DeviceInfo> {
    let devices = discover().devices.iter();
    devices.filter(|info| info.kind == DeviceKind::Gpu)
}

/// The pictures of a device in the precisions that it has and that a render would take.
fn shots_on(
    info: &DeviceInfo,
    scene: &Scene,
    narrow: bool,
    open: impl Fn(Precision) -> Result<Box<dyn Tracer>, DeviceError>,
) -> Result<Vec<Shot>, TraceError> {
    let precisions = [(Precision::F64, info.has_f64), (Precision::F32, narrow)];
    let possible = precisions.into_iter().filter(|(_, possible)| *possible);
    let shots = possible.map(|(precision, _)| {
        let mut tracer = open(precision).map_err(|error| TraceError::Failed(error.to_string()))?;
        shoot(tracer.as_mut(), scene, precision == Precision::F32)
    });
    shots.collect()
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
