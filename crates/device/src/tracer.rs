//! The OpenCL tracer: a plan in the device's memory, and its picture tile by tile.

use std::time::Instant;

use scenec_picture::{Frame, Refiner, Request, TraceError, Tracer};
use scenec_plan::packed_structs;
use scenec_plan::{Features, Plan, Real};

use crate::assemble::{Precision, item_side, options, options_with_denormals, relaxed_options, source};
use crate::buffer::{Arg, Buffer};
use crate::calls::Plain;
use crate::error::DeviceError;
use crate::info::{DeviceInfo, DeviceKind};
use crate::known;
use crate::pace::{LEAST, Pace, Run};
use crate::program::Program;
use crate::scene::Scene;
use crate::session::{Running, Session};
use crate::tiles::{Room, Tiles, Told};

/// The most pixels of one run of the kernel: enough to fill any device.
const MOST_PIXELS: usize = 1 << 18;
/// The same of a processor: what comes of them stays in its cache until it is read, and its memory is not all new.
const MOST_PIXELS_OF_PROCESSOR: usize = 1 << 16;

/// Opens a device and prepares to trace a plan on it, with the kernels' parts that `features` name.
///
/// # Errors
/// The device fails, has no doubles though they are asked for, or can't hold the scene.
pub fn tracer(
    info: &DeviceInfo,
    plan: &Plan,
    precision: Precision,
    features: &Features,
) -> Result<Box<dyn Tracer>, DeviceError> {
    Ok(refiner(info, plan, precision, features)?)
}

/// The same as a tracer that goes on with single pixels, if `features` have it tell how far samples are apart.
///
/// # Errors
/// Those of [`tracer`].
pub fn refiner(
    info: &DeviceInfo,
    plan: &Plan,
    precision: Precision,
    features: &Features,
) -> Result<Box<dyn Refiner>, DeviceError> {
    opened(None, info, plan, precision, features)
}

/// The same in singles, with a program for which the compiler need not keep to the rules of arithmetic (fast-math): to see what
/// that would gain, and what it costs. Its pictures may be wrong anywhere.
///
/// # Errors
/// The device fails, or can't hold the scene.
pub fn relaxed_tracer(info: &DeviceInfo, plan: &Plan, features: &Features) -> Result<Box<dyn Tracer>, DeviceError> {
    let tracer = OpenCl::<f32>::new(info, plan, Precision::F32, features, Math::Relaxed)?;
    Ok(Box::new(tracer))
}

/// A way to build or run the kernels that a render does not take, and that must make no difference.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Manner {
    /// Numbers below the smallest normal one are kept, where a render lets the device take them for zero.
    Denormals,
    /// In work-groups of so many items each way, or of as many as the device can do.
    Groups(usize),
}

/// The same as [`tracer`] in another manner.
///
/// # Errors
/// Those of [`tracer`].
pub fn tracer_in(
    manner: Manner,
    info: &DeviceInfo,
    plan: &Plan,
    precision: Precision,
    features: &Features,
) -> Result<Box<dyn Tracer>, DeviceError> {
    Ok(opened(Some(manner), info, plan, precision, features)?)
}

/// Opens a device in a manner, or as a render does.
fn opened(
    manner: Option<Manner>,
    info: &DeviceInfo,
    plan: &Plan,
    precision: Precision,
    features: &Features,
) -> Result<Box<dyn Refiner>, DeviceError> {
    Ok(match precision {
        Precision::F32 => Box::new(OpenCl::<f32>::opened(manner, info, plan, precision, features)?),
        Precision::F64 if info.has_f64 => Box::new(OpenCl::<f64>::opened(manner, info, plan, precision, features)?),
        Precision::F64 => return Err(no_doubles(info)),
    })
}

fn no_doubles(info: &DeviceInfo) -> DeviceError {
    DeviceError::new(format!("{} has no doubles", info.name))
        .with_help("leave out --precision f64, or use --device cpu")
}

/// What the compiler may do with numbers.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Math {
    Strict,
    Denormals,
    Relaxed,
}

pub(crate) struct OpenCl<R> {
    pub(crate) session: Session,
    program: Program,
    precision: Precision,
    math: Math,
    /// Whether the program tells distances.
    distances: bool,
    /// Whether it tells how far samples are apart.
    pub(crate) spread: bool,
    /// The side of the square of pixels that a work-item traces.
    side: u32,
    /// World units per plan unit.
    unit: f64,
    pub(crate) frame: packed_structs::Frame<R>,
    scene: Scene<R>,
}

impl<R: Real + Plain> OpenCl<R> {
    fn opened(
        manner: Option<Manner>,
        info: &DeviceInfo,
        plan: &Plan,
        precision: Precision,
        features: &Features,
    ) -> Result<Self, DeviceError> {
        let math = match manner {
            Some(Manner::Denormals) => Math::Denormals,
            Some(Manner::Groups(_)) | None => Math::Strict,
        };
        let tracer = Self::new(info, plan, precision, features, math)?;
        Ok(match manner {
            Some(Manner::Groups(side)) => Self {
                session: tracer.session.in_groups(side),
                ..tracer
            },
            Some(Manner::Denormals) | None => tracer,
        })
    }

    fn new(
        info: &DeviceInfo,
        plan: &Plan,
        precision: Precision,
        features: &Features,
        math: Math,
    ) -> Result<Self, DeviceError> {
        let begin = Instant::now();
        let session = Session::open(info)?;
        let packed = plan.packed::<R>();
        let options = match math {
            Math::Strict => options(info, precision),
            Math::Denormals => options_with_denormals(info, precision),
            Math::Relaxed => relaxed_options(),
        };
        let program = session.build(&source(precision, features), &options)?;
        let scene = Scene::upload(&session, &packed, features)?;
        if math == Math::Strict {
            let starting = begin.elapsed().saturating_sub(program.compiled().unwrap_or_default());
            known::remember_start(info, precision, starting, program.compiled());
        }
        Ok(Self {
            session,
            program,
            precision,
            math,
            distances: features.distances,
            spread: features.spread,
            side: item_side(features),
            unit: plan.scale.recip(),
            frame: packed.frame,
            scene,
        })
    }

    /// Has a kernel run over so many pixels, which is given the scene and then `more`.
    pub(crate) fn start(
        &self,
        kernel: &str,
        frame: &Buffer<packed_structs::Frame<R>>,
        more: &[Arg<'_>],
        size: [u32; 2],
    ) -> Result<Running<'_>, DeviceError> {
        let mut args = self.scene.args(frame);
        args.extend_from_slice(more);
        let items = size.map(|pixels| pixels.div_ceil(self.side));
        self.session.start(&self.program, kernel, &args, items)
    }

    /// Has some samples of a tile run.
    fn tile(
        &self,
        frame: &Buffer<packed_structs::Frame<R>>,
        room: &Room<R>,
        run: &Run,
    ) -> Result<Running<'_>, DeviceError> {
        let more: [Arg<'_>; 8] = [
            (&room.outcomes).into(),
            (&room.sums).into(),
            run.column.into(),
            run.row.into(),
            run.columns.into(),
            run.rows.into(),
            run.samples.start.into(),
            run.samples.end.into(),
        ];
        self.start("trace", frame, &more, [run.columns, run.rows])
    }

    /// Whether the program sums up samples in blocks: one alone tells nothing that its colour does not.
    const fn sums_up(&self) -> bool {
        self.spread && self.frame.samples > 1
    }

    /// Room for a tile: of so many pixels, or of as many as the device has memory for.
    fn room(&self, pixels: usize) -> Result<Room<R>, DeviceError> {
        let most = match self.session.device().kind {
            DeviceKind::Cpu => MOST_PIXELS_OF_PROCESSOR,
            _ => MOST_PIXELS,
        };
        let mut pixels = pixels.clamp(LEAST, most);
        loop {
            let sums = self.session.zeros(if self.sums_up() { pixels } else { 1 });
            let room = self
                .session
                .zeros(pixels)
                .and_then(|outcomes| Ok(Room { outcomes, sums: sums? }));
            match room {
                Err(_) if pixels > LEAST => pixels = (pixels / 2).max(LEAST),
                room => return room,
            }
        }
    }
}

impl<R: Real + Plain> Tracer for OpenCl<R> {
    fn name(&self) -> String {
        let info = self.session.device();
        let math = match self.math {
            Math::Strict => "",
            Math::Denormals => " with denormals",
            Math::Relaxed => " fast-math",
        };
        format!("opencl {}{math} {} ({})", self.precision, info.name, info.platform)
    }

    fn trace(&mut self, request: &Request<'_>) -> Result<Frame, TraceError> {
        let window = request.window;
        let (corner, size) = ([window.x, window.y], [window.width, window.height]);
        let limits = request.limits;
        self.frame.ask(corner, size, limits.cutoff, limits.ray_budget);

        let frame = self.session.upload(&[self.frame]).map_err(failed)?;
        let room = self
            .room(window.width as usize * window.height as usize)
            .map_err(failed)?;
        let told = Told {
            distances: self.distances,
            spread: self.spread,
            sums: self.sums_up(),
            unit: self.unit,
        };
        let mut tiles = Tiles::new(request, told, room.outcomes.len())?;
        let mut kernel_ns = 0;
        let mut pace = Pace::new(window.width, window.height, self.frame.samples, room.outcomes.len());
        let mut next = pace.next();
        while let Some(run) = next {
            if request.watch.stopped() {
                return Err(TraceError::Cancelled);
            }
            let running = self.tile(&frame, &room, &run).map_err(failed)?;
            // Beside the device, which is at the next tile.
            request.watch.advance(tiles.enter());
            let time = running.wait().map_err(failed)?;
            pace.took(&run, time);
            kernel_ns += time;
            next = pace.next();
            if run.samples.end == self.frame.samples {
                tiles.read(&self.session, &room, run).map_err(failed)?;
            }
        }
        request.watch.advance(tiles.enter());
        Ok(tiles.finish(kernel_ns))
    }
}

pub(crate) fn failed(error: DeviceError) -> TraceError {
    TraceError::Failed(error.to_string())
}
