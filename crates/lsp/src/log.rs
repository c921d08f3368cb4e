//! What the server says about itself: lines on standard error, and only if somebody asked for them.
//!
//! A client need not read standard error, and a full pipe would stop the server: silence is the default.

use std::fmt::Display;
use std::io::{self, Write};

/// Where remarks go, if anywhere.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub(crate) struct Log {
    /// Whether remarks are written.
    pub(crate) on: bool,
}

impl Log {
    /// Writes one line.
    pub(crate) fn say(self, words: impl Display) {
        if self.on {
            // Where standard error is gone there is nobody left to tell.
            writeln!(io::stderr().lock(), "scenec lsp: {words}").unwrap_or_default();
        }
    }

    /// Sends what a panic says the same way.
    pub(crate) fn catch_panics(self) {
        std::panic::set_hook(Box::new(move |panic| self.say(panic)));
    }
}
