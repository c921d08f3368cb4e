//! The OpenCL tracer's ground: which devices there are, which one is meant, and how work is run on it.
//!
//! This crate alone talks to OpenCL. It knows plans and pictures, but no scene and no syntax.

mod assemble;
mod auto;
mod buffer;
mod cache;
mod calls;
mod discover;
mod error;
mod info;
mod known;
mod pace;
mod program;
mod refine;
mod sampled;
mod scene;
mod select;
mod session;
mod tiles;
mod tracer;

pub use assemble::{Precision, options, probe, source};
pub use auto::{Verdict, auto, features, suited, worth_asking};
pub use buffer::{Arg, Buffer};
pub use cache::cache_folder;
pub use calls::Plain;
pub use discover::{Discovery, discover};
pub use error::{DeviceError, guarded};
pub use info::{DeviceInfo, DeviceKind};
pub use known::remember_gain;
pub use program::Program;
pub use select::{gpu, is_opencl, select};
pub use session::Session;
pub use tracer::{Manner, refiner, relaxed_tracer, tracer, tracer_in};
