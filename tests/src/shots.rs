//! One scene through every tracer that this machine has, and where each of its pixels looks.

use scenec_cpu::Cpu;
use scenec_device::{DeviceInfo, Precision, discover, select, tracer};
use scenec_picture::{Frame, Layers, Limits, Request, Tracer, Watch, Window};
use scenec_plan::{Features, plan};
use scenec_reference::Reference;
use scenec_scene::{DVec3, Scene, Settings};

/// What one tracer made of a scene: leaves, colours and, in doubles, exact colours.
#[derive(Clone, Debug)]
pub struct Shot {
    /// Which tracer, for messages.
    pub tracer: String,
    /// Whether it computes in single precision.
    pub single: bool,
    /// What came of it.
    pub frame: Frame,
}

impl Shot {
    /// The colour of a pixel of the frame, as exact as there is one.
    ///
    /// # Panics
    /// If the frame has no such pixel.
    #[must_use]
    pub fn colour(&self, x: u32, y: u32) -> [f64; 3] {
        let at = (y * self.frame.picture.width() + x) as usize;
        match &self.frame.exact {
            Some(exact) => exact[at],
            None => self.frame.picture.pixels()[at].map(f64::from),
        }
    }

    /// The leaf that a pixel of the frame sees, or [`scenec_picture::NOTHING`].
    ///
    /// # Panics
    /// If the frame has no such pixel.
    #[must_use]
    pub fn leaf(&self, x: u32, y: u32) -> u32 {
        let at = (y * self.frame.picture.width() + x) as usize;
        self.frame.ids.as_ref().map_or(u32::MAX, |ids| ids[at])
    }
}

/// The device of OpenCL tests; must be there if `SCENEC_REQUIRE_OPENCL` is set.
///
/// # Panics
/// If it must be there and is not.
#[must_use]
pub fn device() -> Option<&'static DeviceInfo> {
    let found = select("opencl", discover());
    assert!(
        found.is_ok() || std::env::var_os("SCENEC_REQUIRE_OPENCL").is_none(),
        "SCENEC_REQUIRE_OPENCL is set, so a device must be found: {found:?}"
    );
    found.ok()
}

/// The whole picture of a scene by every tracer, nothing dropped for its small weight.
#[must_use]
pub fn shots(scene: &Scene) -> Vec<Shot> {
    let whole = Window::whole(scene.settings.width, scene.settings.height);
    shots_of(scene, whole, Limits::NO_CUTOFF)
}

/// A part of the picture by every tracer: the reference, the processor's in both precisions, and a device's in single.
///
/// # Panics
/// If a tracer fails, or a picture holds anything but finite numbers.
#[must_use]
pub fn shots_of(scene: &Scene, window: Window, limits: Limits) -> Vec<Shot> {
    let plan = match plan(scene) {
        Ok(plan) => plan,
        Err(error) => panic!("no plan: {error}"),
    };
    let mut tracers: Vec<(Box<dyn Tracer>, bool)> = vec![(Box::new(Reference::new(scene)), false)];
    let (Ok(double), Ok(single)) = (Cpu::<f64>::new(&plan, 2), Cpu::<f32>::new(&plan, 2)) else {
        panic!("no threads");
    };
    tracers.push((Box::new(double), false));
    tracers.push((Box::new(single), true));
    if let Some(info) = device() {
        match tracer(info, &plan, Precision::F32, &Features::generic(&plan)) {
            Ok(tracer) => tracers.push((tracer, true)),
            Err(error) => panic!("{}: {error}", info.name),
        }
    }
    let shoot = |(mut tracer, single): (Box<dyn Tracer>, bool)| Shot {
        frame: frame(&mut *tracer, window, limits, false),
        tracer: tracer.name(),
        single,
    };
    tracers.into_iter().map(shoot).collect()
}

/// A part of the picture by one tracer, with its leaves, in doubles where it has them, and with its paths if asked for.
///
/// # Panics
/// If the tracer fails, or the picture holds anything but finite numbers.
#[must_use]
pub fn frame(tracer: &mut dyn Tracer, window: Window, limits: Limits, paths: bool) -> Frame {
    let request = Request {
        window,
        limits,
        layers: Layers {
            ids: true,
            exact: true,
            paths,
            ..Layers::default()
        },
        watch: &Watch::new(),
    };
    match tracer.trace(&request) {
        Ok(frame) => {
            assert_eq!(frame.picture.non_finite(), 0, "{}", tracer.name());
            frame
        }
        Err(error) => panic!("{}: {error}", tracer.name()),
    }
}

/// The camera, from the definition of its view and nothing else: no tracer's code.
#[derive(Clone, Copy, Debug)]
pub struct Lens {
    /// Where it stands.
    pub eye: DVec3,
    forward: DVec3,
    right: DVec3,
    up: DVec3,
    width: f64,
    height: f64,
}

impl Lens {
    /// The camera of a scene whose view is not along its up direction.
    #[must_use]
    pub fn new(settings: &Settings) -> Self {
        let forward = (settings.lookat - settings.eyepos).normalize();
        let right = forward.cross(settings.up).normalize();
        let (width, height) = (f64::from(settings.width), f64::from(settings.height));
        let half = (settings.fov / 2.0).tan();
        Self {
            eye: settings.eyepos,
            forward,
            right: right * half,
            up: right.cross(forward) * (half * height / width),
            width,
            height,
        }
    }

    /// The unit direction of a place in the picture, in pixels from its upper left corner.
    #[must_use]
    pub fn towards(&self, x: f64, y: f64) -> DVec3 {
        let across = self.right * (2.0 * x / self.width - 1.0);
        let upward = self.up * (1.0 - 2.0 * y / self.height);
        (self.forward + across + upward).normalize()
    }

    /// What `see` makes of a pixel, if all within `slack` pixels of its centre gives the same.
    pub fn steady<T: PartialEq>(&self, x: u32, y: u32, slack: f64, see: impl Fn(DVec3) -> T) -> Option<T> {
        let (x, y) = (f64::from(x) + 0.5, f64::from(y) + 0.5);
        let seen = see(self.towards(x, y));
        let corners = [(-slack, -slack), (-slack, slack), (slack, -slack), (slack, slack)];
        let same = |(dx, dy)| see(self.towards(x + dx, y + dy)) == seen;
        corners.into_iter().all(same).then_some(seen)
    }
}
