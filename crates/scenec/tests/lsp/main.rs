//! `scenec lsp` as an editor sees it: a process that is talked to over its standard input and output.

#![allow(clippy::unwrap_used, clippy::expect_used, reason = "a test may stop at once")]

mod client;
mod ending;
mod features;
mod findings;
mod folders;
mod frames;
mod greetings;
#[cfg(target_os = "linux")]
mod losses;
mod order;
mod preview;
mod synchronisation;
