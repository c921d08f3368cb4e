//! The OpenCL functions, for a program that must also start where there is no OpenCL.
//!
//! Linking against OpenCL in the usual way makes a program that the system refuses to start on a machine without
//! the library. This crate defines every `cl*` symbol itself. Each one opens the machine's OpenCL on first use and
//! passes the call on; where there is none, it reports zero platforms or an error code, and everything else in the
//! program goes on working.
//!
//! It owns the symbols and the search for a library, and knows nothing of devices, kernels or pictures.

mod forward;
mod status;

pub use forward::{status, take_vendor_code};
pub use status::LoaderStatus;
