//! The OpenCL tracer's ground: which devices there are, which one is meant, and how work is run on it.
//!
//! This crate alone talks to OpenCL. It knows plans and pictures, but no scene and no syntax.

mod calls;
mod discover;
mod error;
mod select;
mod session;

pub use calls::Plain;
pub use discover::{DeviceInfo, DeviceKind, Discovery, discover};
pub use error::{DeviceError, guarded};
pub use select::{gpu, is_opencl, select};
pub use session::{Arg, Buffer, Program, Session};
