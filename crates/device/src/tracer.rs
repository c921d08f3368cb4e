//! The OpenCL tracer: a plan in the device's memory, and its picture band by band.

use scenec_picture::{Exact, Frame, NOTHING, Picture, Request, Stats, TraceError, Tracer};
use scenec_plan::packed_structs::{self, Outcome};
use scenec_plan::{Features, Packed, Plan, Real, in_doubles, in_singles};

use crate::assemble::{Precision, options, source};
use crate::buffer::{Arg, Buffer};
use crate::calls::Plain;
use crate::error::DeviceError;
use crate::info::DeviceInfo;
use crate::program::Program;
use crate::session::Session;

/// About how many samples one run of the kernel takes: enough to fill any device, and few enough that progress shows,
/// that a stop is soon heard, and that no display driver takes the device away from a run that seems to hang.
const BAND_SAMPLES: u64 = 1 << 18;

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
    Ok(match precision {
        Precision::F32 => Box::new(OpenCl::<f32>::new(info, plan, precision, features)?),
        Precision::F64 if info.has_f64 => Box::new(OpenCl::<f64>::new(info, plan, precision, features)?),
        Precision::F64 => {
            return Err(DeviceError::new(format!("{} has no doubles", info.name))
                .with_help("leave out --precision f64, or use --device cpu"));
        }
    })
}

struct OpenCl<R> {
    session: Session,
    program: Program,
    precision: Precision,
    frame: packed_structs::Frame<R>,
    scene: Scene<R>,
}

/// The plan in the device's memory.
struct Scene<R> {
    shapes: Buffer<packed_structs::Shape<R>>,
    leaves: Buffer<packed_structs::Leaf>,
    islands: Buffer<packed_structs::Island>,
    cells: Buffer<packed_structs::Cell>,
    program: Buffer<u32>,
    members: Buffer<u32>,
    nodes: Buffer<packed_structs::Node>,
    materials: Buffer<packed_structs::Material<R>>,
    lights: Buffer<packed_structs::Light<R>>,
    touches: Buffer<packed_structs::Touch<R>>,
    samples: Buffer<[R; 2]>,
    reach: Buffer<R>,
}

impl<R: Real + Plain> Scene<R> {
    fn upload(session: &Session, packed: &Packed<R>) -> Result<Self, DeviceError> {
        Ok(Self {
            shapes: session.upload(&packed.shapes)?,
            leaves: session.upload(&packed.leaves)?,
            islands: session.upload(&packed.islands)?,
            cells: session.upload(&packed.cells)?,
            program: session.upload(&packed.program)?,
            members: session.upload(&packed.members)?,
            nodes: session.upload(&packed.nodes)?,
            materials: session.upload(&packed.materials)?,
            lights: session.upload(&packed.lights)?,
            touches: session.upload(&packed.touches)?,
            samples: session.upload(&packed.samples)?,
            reach: session.upload(&packed.reach)?,
        })
    }
}

impl<R: Real + Plain> OpenCl<R> {
    fn new(info: &DeviceInfo, plan: &Plan, precision: Precision, features: &Features) -> Result<Self, DeviceError> {
        let session = Session::open(info)?;
        let packed = plan.packed::<R>();
        let program = session.build(&source(precision, features), &options(info, precision))?;
        let scene = Scene::upload(&session, &packed)?;
        Ok(Self {
            session,
            program,
            precision,
            frame: packed.frame,
            scene,
        })
    }

    /// Runs the kernel over the rows from `first` up to `end` of the window; returns the device's nanoseconds.
    fn band(
        &self,
        frame: &Buffer<packed_structs::Frame<R>>,
        outcomes: &Buffer<Outcome<R>>,
        first: u32,
        end: u32,
    ) -> Result<u64, DeviceError> {
        let scene = &self.scene;
        let args: [Arg<'_>; 16] = [
            frame.into(),
            (&scene.shapes).into(),
            (&scene.leaves).into(),
            (&scene.islands).into(),
            (&scene.cells).into(),
            (&scene.program).into(),
            (&scene.members).into(),
            (&scene.nodes).into(),
            (&scene.materials).into(),
            (&scene.lights).into(),
            (&scene.touches).into(),
            (&scene.samples).into(),
            (&scene.reach).into(),
            outcomes.into(),
            first.into(),
            end.into(),
        ];
        self.session
            .run(&self.program, "trace", &args, [self.frame.window_width, end - first])
    }
}

impl<R: Real + Plain> Tracer for OpenCl<R> {
    fn name(&self) -> String {
        let info = self.session.device();
        format!("opencl {} {} ({})", self.precision, info.name, info.platform)
    }

    fn trace(&mut self, request: &Request<'_>) -> Result<Frame, TraceError> {
        let window = request.window;
        let mut picture = Picture::black(window.width, window.height)?;
        let count = picture.pixels().len();
        let mut ids = request.layers.ids.then(|| vec![NOTHING; count]);
        let mut exact: Option<Exact> = request.layers.exact.then(|| vec![[0.0; 3]; count]);

        let (corner, size) = ([window.x, window.y], [window.width, window.height]);
        let limits = request.limits;
        self.frame.ask(corner, size, limits.cutoff, limits.ray_budget);

        let rows = band_rows(window.width, self.frame.samples);
        let size = rows.min(window.height) as usize * window.width as usize;
        let frame = self.session.upload(&[self.frame]).map_err(failed)?;
        let outcomes = self.session.zeros::<Outcome<R>>(size).map_err(failed)?;
        let mut band = vec![Outcome::<R>::default(); size];
        let mut stats = Stats {
            kernel_ns: Some(0),
            ..Stats::default()
        };
        for first in (0..window.height).step_by(rows as usize) {
            if request.watch.stopped() {
                return Err(TraceError::Cancelled);
            }
            let end = first.saturating_add(rows).min(window.height);
            let at = first as usize * window.width as usize;
            let done = &mut band[..(end - first) as usize * window.width as usize];
            let kernel_ns = Some(self.band(&frame, &outcomes, first, end).map_err(failed)?);
            self.session.read(&outcomes, 0, done).map_err(failed)?;
            for (i, outcome) in done.iter().enumerate() {
                picture.pixels_mut()[at + i] = in_singles(outcome.colour);
                if let Some(ids) = &mut ids {
                    ids[at + i] = outcome.solid;
                }
                if let Some(exact) = &mut exact {
                    exact[at + i] = in_doubles(outcome.colour);
                }
                stats = stats.merge(pixel_stats(outcome));
            }
            stats = stats.merge(Stats {
                kernel_ns,
                ..Stats::default()
            });
            request.watch.advance(done.len() as u64);
        }
        Ok(Frame {
            picture,
            ids,
            exact,
            paths: None,
            spread: None,
            stats,
        })
    }
}

fn pixel_stats<R: Real>(outcome: &Outcome<R>) -> Stats {
    Stats {
        primary: outcome.primary.into(),
        shadow: outcome.shadow.into(),
        reflected: outcome.reflected.into(),
        refracted: outcome.refracted.into(),
        dropped: outcome.dropped.to_f64(),
        over_budget: outcome.over.into(),
        kernel_ns: None,
    }
}

/// Rows in one run of the kernel: whole work-groups where a row is short enough for that.
fn band_rows(width: u32, samples: u32) -> u32 {
    const GROUP: u64 = 16;
    let rows = (BAND_SAMPLES / (u64::from(width) * u64::from(samples)).max(1)).max(1);
    let rows = if rows > GROUP { rows - rows % GROUP } else { rows };
    u32::try_from(rows).unwrap_or(u32::MAX)
}

fn failed(error: DeviceError) -> TraceError {
    TraceError::Failed(error.to_string())
}

#[cfg(test)]
mod tests {
    use super::band_rows;

    fn check(width: u32, samples: u32, expect: u32) {
        assert_eq!(band_rows(width, samples), expect, "{width} wide, {samples} samples");
    }

    #[test]
    fn bands_are_whole_groups_until_a_row_is_long() {
        check(600, 1, 432);
        check(1280, 1, 192);
        check(1, 1, 262_144);
        check(65535, 1, 4);
        check(65535, 4096, 1);
    }
}
