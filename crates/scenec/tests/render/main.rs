//! `scenec render`: exit codes, what is written, and what is left alone.

#![allow(clippy::unwrap_used, reason = "a test may stop at once")]

mod bounds;
mod cache;
mod devices;
#[cfg(target_os = "linux")]
mod interruption;
#[cfg(target_os = "linux")]
mod large;
mod pictures;
mod refusals;
mod reports;
mod room;
