//! The picture: f32 RGB, what a tracer hands back, and (one file each) the formats it is written in.
//!
//! It must not know scenes, plans or devices: a picture is numbers in rows.

mod picture;
mod trace;

pub use picture::{MAX_PIXELS, Picture, TooManyPixels};
pub use trace::{Exact, Frame, Layers, Limits, NOTHING, Request, Stats, TraceError, Tracer, Watch, Window};
