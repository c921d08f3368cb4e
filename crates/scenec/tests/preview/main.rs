//! `scenec preview-worker`, and the server's hand that leads it.

#![allow(clippy::expect_used, clippy::unwrap_used, reason = "a test may stop at once")]

#[cfg(unix)]
mod losses;
mod pictures;
mod room;
