//! `scenec check` and `scenec fmt` as a script sees them: exit codes, what is printed where, and what happens to files.

#![allow(clippy::unwrap_used, reason = "a test may stop at once")]

mod bad_input;
mod codes;
mod configuration;
mod fixes;
mod fmt;
mod formats;
mod look;
mod readers;
mod room;
mod watching;
