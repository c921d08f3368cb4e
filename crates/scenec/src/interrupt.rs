//! Ctrl-C: the first one asks to stop, the second one ends the program.
//!
//! This owns the only signal handler. It must not know what is being stopped.

use std::io::{self, Write};
use std::process;
use std::sync::atomic::{AtomicBool, Ordering};

use scenec_picture::Watch;

use crate::exit::Exit;

static WATCH: Watch = Watch::new();
static WRITING: AtomicBool = AtomicBool::new(false);

/// From here on Ctrl-C (or a request to terminate) stops whoever looks at the watch, and no longer the program.
///
/// A signal that the parent chose to ignore stays ignored, as `nohup` wants it: then no handler is set.
pub(crate) fn watch() -> &'static Watch {
    // Without a handler a signal ends the program at once, which is bearable.
    ctrlc::try_set_handler(heard).unwrap_or_default();
    &WATCH
}

fn heard() {
    // A program that ends while it writes would leave half a file behind. Writing stops soon by itself.
    if WATCH.stopped() && !WRITING.load(Ordering::Relaxed) {
        process::exit(i32::from(Exit::Interrupted.code()));
    }
    WATCH.stop();
}

/// Runs `write`, which leaves something behind if the program ends in its midst.
pub(crate) fn while_writing<T>(write: impl FnOnce() -> T) -> T {
    WRITING.store(true, Ordering::Relaxed);
    let outcome = write();
    WRITING.store(false, Ordering::Relaxed);
    outcome
}

/// A writer that fails once somebody says stop.
pub(crate) struct Stoppable<'a, W> {
    pub(crate) out: W,
    pub(crate) watch: &'a Watch,
}

impl<W> Stoppable<'_, W> {
    fn unless_stopped(&self) -> io::Result<()> {
        if self.watch.stopped() {
            // Not the kind `Interrupted`: writers take that one as an invitation to try again.
            return Err(io::Error::other("stopped"));
        }
        Ok(())
    }
}

impl<W: Write> Write for Stoppable<'_, W> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.unless_stopped()?;
        self.out.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.unless_stopped()?;
        self.out.flush()
    }
}

impl<W: io::Seek> io::Seek for Stoppable<'_, W> {
    fn seek(&mut self, to: io::SeekFrom) -> io::Result<u64> {
        self.out.seek(to)
    }
}

#[cfg(test)]
mod tests {
    use std::io::Write;

    use scenec_picture::Watch;

    use super::Stoppable;

    #[test]
    fn a_stopped_writer_takes_nothing_more() {
        let watch = Watch::new();
        let mut out = Stoppable {
            out: Vec::new(),
            watch: &watch,
        };
        out.write_all(b"before").unwrap();
        watch.stop();
        assert!(out.write_all(b"after").is_err() && out.flush().is_err());
        assert_eq!(out.out, b"before");
    }
}
