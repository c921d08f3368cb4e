//! The one door to every tracer: what is asked, what comes back, how it is watched and stopped.

use std::fmt;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};

use crate::{Picture, TooManyPixels};

/// Turns one prepared scene into pixels.
pub trait Tracer {
    /// What computes, for people: "cpu f32, 2 threads".
    fn name(&self) -> String;

    /// Traces the pixels of the request's window.
    ///
    /// # Errors
    /// `Cancelled` soon after the watch says stop, `TooManyPixels` before memory is touched, `Failed` when a device does.
    /// There is no half a frame.
    fn trace(&mut self, request: &Request<'_>) -> Result<Frame, TraceError>;
}

/// What a tracer is asked for.
#[derive(Clone, Copy, Debug)]
pub struct Request<'a> {
    /// Which pixels of the whole picture.
    pub window: Window,
    /// Where paths end early.
    pub limits: Limits,
    /// What is wanted besides the picture.
    pub layers: Layers,
    /// Who watches.
    pub watch: &'a Watch,
}

/// A rectangle of the whole picture, in pixels from its upper left corner.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Window {
    /// First column.
    pub x: u32,
    /// First row.
    pub y: u32,
    /// Columns, at least 1.
    pub width: u32,
    /// Rows, at least 1.
    pub height: u32,
}

impl Window {
    /// The whole of a picture.
    #[must_use]
    pub const fn whole(width: u32, height: u32) -> Self {
        Self {
            x: 0,
            y: 0,
            width,
            height,
        }
    }

    /// How many pixels it has.
    #[must_use]
    pub const fn pixels(&self) -> u64 {
        self.width as u64 * self.height as u64
    }
}

/// Where paths end before the scene's ray depth does.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Limits {
    /// A branch is dropped when the most it could still add to its sample is below this; 0 never drops.
    pub cutoff: f64,
    /// The most rays, shadow rays aside, that one pixel may use; at least 1.
    pub ray_budget: u32,
}

impl Limits {
    /// What the language promises unless told otherwise.
    pub const DEFAULT: Self = Self {
        cutoff: 1.0 / 4096.0,
        ray_budget: 65_536,
    };

    /// Nothing is dropped for its small weight.
    pub const NO_CUTOFF: Self = Self {
        cutoff: 0.0,
        ..Self::DEFAULT
    };
}

/// What is wanted besides the picture.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Layers {
    /// The leaf that each pixel's first sample hits.
    pub ids: bool,
    /// The pixels in f64, from tracers that compute in f64.
    pub exact: bool,
    /// A number for the whole path tree of each pixel's first sample, from tracers that can tell.
    pub paths: bool,
    /// How far the samples of each pixel are apart, from tracers that can tell.
    pub spread: bool,
    /// How far from the eye each pixel's first sample hits, from tracers that can tell.
    pub distances: bool,
}

/// What the samples of a pixel tell besides their mean, component by component.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct Spread {
    /// The least of any sample.
    pub low: [f32; 3],
    /// The most of any sample.
    pub high: [f32; 3],
    /// The standard error of the mean, from the means of 8 to 15 blocks of samples that follow one another; infinite
    /// where there are fewer than 8 samples.
    pub error: [f32; 3],
    /// The most that the dropped branches could have added to the mean.
    pub dropped: f32,
}

/// What a leaf layer says of a ray that meets nothing.
pub const NOTHING: u32 = u32::MAX;

/// The pixels in f64.
pub type Exact = Vec<[f64; 3]>;

/// What a tracer hands back: the window's pixels, row by row.
#[derive(Clone, Debug)]
pub struct Frame {
    /// The picture.
    pub picture: Picture,
    /// The leaf (its number in the scene, or [`NOTHING`]) that each pixel's first sample hits, if asked for.
    pub ids: Option<Vec<u32>>,
    /// The picture in f64, if asked for and there.
    pub exact: Option<Exact>,
    /// Equal for two pixels only if their first samples took the same ways: the same leaves, the same lights seen, the
    /// same turns. If asked for and there.
    pub paths: Option<Vec<u64>>,
    /// How far the samples of each pixel are apart, if asked for and there.
    pub spread: Option<Vec<Spread>>,
    /// How far from the eye each pixel's first sample hits, world units; infinite where it meets nothing. If asked for and
    /// there.
    pub distances: Option<Vec<f64>>,
    /// What it took.
    pub stats: Stats,
}

impl Frame {
    /// Which pixels are calm: their whole neighbourhood of 3 by 3 took the same ways through the scene, so that nothing
    /// changes within a pixel of them. `None` without the layer of paths.
    #[must_use]
    pub fn calm(&self) -> Option<Vec<bool>> {
        let paths = self.paths.as_ref()?;
        let (width, height) = (self.picture.width() as usize, self.picture.height() as usize);
        let calm = |i: usize| {
            let (x, y) = (i % width, i / width);
            let columns = x.saturating_sub(1)..(x + 2).min(width);
            let mut rows = y.saturating_sub(1)..(y + 2).min(height);
            rows.all(|row| columns.clone().all(|column| paths[row * width + column] == paths[i]))
        };
        Some((0..width * height).map(calm).collect())
    }
}

/// What a frame took, and what was left out of it.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct Stats {
    /// Rays from the eye.
    pub primary: u64,
    /// Rays towards lights.
    pub shadow: u64,
    /// Rays that left a surface as a mirror sends them.
    pub reflected: u64,
    /// Rays that went through a surface.
    pub refracted: u64,
    /// The most that the dropped branches could have added to any pixel, any component.
    pub dropped: f64,
    /// Pixels that met their ray budget.
    pub over_budget: u64,
    /// Nanoseconds of kernel time by the device's own clock, if it has one.
    pub kernel_ns: Option<u64>,
}

impl Stats {
    /// Both together.
    #[must_use]
    pub fn merge(self, other: Self) -> Self {
        Self {
            primary: self.primary + other.primary,
            shadow: self.shadow + other.shadow,
            reflected: self.reflected + other.reflected,
            refracted: self.refracted + other.refracted,
            dropped: self.dropped.max(other.dropped),
            over_budget: self.over_budget + other.over_budget,
            kernel_ns: match (self.kernel_ns, other.kernel_ns) {
                (Some(a), Some(b)) => Some(a + b),
                (a, b) => a.or(b),
            },
        }
    }

    /// Rays of all kinds.
    #[must_use]
    pub const fn rays(&self) -> u64 {
        self.primary + self.shadow + self.reflected + self.refracted
    }
}

/// Why there is no frame.
#[derive(Clone, PartialEq, Debug)]
pub enum TraceError {
    /// Somebody said stop.
    Cancelled,
    /// The picture does not fit into memory.
    TooManyPixels(TooManyPixels),
    /// The device failed; the message says how and what to do.
    Failed(String),
}

impl fmt::Display for TraceError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Cancelled => f.write_str("stopped"),
            Self::TooManyPixels(error) => error.fmt(f),
            Self::Failed(message) => f.write_str(message),
        }
    }
}

impl std::error::Error for TraceError {}

impl From<TooManyPixels> for TraceError {
    fn from(error: TooManyPixels) -> Self {
        Self::TooManyPixels(error)
    }
}

/// Shared between a tracer at work and whoever waits for it.
#[derive(Debug, Default)]
pub struct Watch {
    done: AtomicU64,
    stop: AtomicBool,
}

impl Watch {
    /// Nothing done, nobody stopping.
    #[must_use]
    pub const fn new() -> Self {
        Self {
            done: AtomicU64::new(0),
            stop: AtomicBool::new(false),
        }
    }

    /// The tracer finished this many more pixels.
    pub fn advance(&self, pixels: u64) {
        self.done.fetch_add(pixels, Ordering::Relaxed);
    }

    /// How many pixels are finished.
    #[must_use]
    pub fn done(&self) -> u64 {
        self.done.load(Ordering::Relaxed)
    }

    /// Asks the tracer to stop; it answers with `Cancelled`. Safe to call from a signal handler.
    pub fn stop(&self) {
        self.stop.store(true, Ordering::Relaxed);
    }

    /// Whether somebody asked to stop.
    #[must_use]
    pub fn stopped(&self) -> bool {
        self.stop.load(Ordering::Relaxed)
    }
}
