//! What can go wrong with a device, in one line, with advice; and the fence that keeps panics in.
//!
//! The bindings panic in places, and drivers return what they like. Nothing of that may reach the rest of the
//! program as anything other than a [`DeviceError`].

use ocl::core::Status;
use scenec_opencl_loader as loader;
use std::cell::Cell;
use std::fmt;
use std::panic::{self, AssertUnwindSafe};
use std::sync::Once;

/// The longest text taken from a driver for one fact about it, in characters.
const LINE_LIMIT: usize = 300;
/// The longest message, which may hold several such texts.
const MESSAGE_LIMIT: usize = 3000;

/// What helps where PoCL finds no device or compiles nothing.
pub(crate) const CACHE_HELP: &str = "PoCL needs a cache folder that it can write to: set POCL_CACHE_DIR to one";
/// What helps where a device has too little memory.
pub(crate) const MEMORY_HELP: &str = "try a smaller picture, a simpler scene or another device";
const OTHER_HELP: &str = "try another device, or the built-in tracer with --device cpu";

/// A failure of a device or of OpenCL as a whole.
///
/// It displays as one line: what failed, then what to do about it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DeviceError {
    message: String,
    help: Option<String>,
    log: Option<String>,
}

impl DeviceError {
    /// An error from a message, which is made a single line.
    pub fn new(message: impl AsRef<str>) -> Self {
        Self {
            message: single(message.as_ref(), MESSAGE_LIMIT),
            help: None,
            log: None,
        }
    }

    /// The same error with advice.
    #[must_use]
    pub fn with_help(mut self, help: impl AsRef<str>) -> Self {
        self.help = Some(single(help.as_ref(), MESSAGE_LIMIT));
        self
    }

    /// The same error with a compiler's log, which may have many lines.
    #[must_use]
    pub fn with_log(mut self, log: &str) -> Self {
        let log: Vec<String> = log.lines().map(|one| clean(one, usize::MAX)).collect();
        self.log = Some(log.join("\n")).filter(|log| !log.trim().is_empty());
        self
    }

    /// What failed, in one line.
    pub fn message(&self) -> &str {
        &self.message
    }

    /// What to do about it, in one line.
    pub fn help(&self) -> Option<&str> {
        self.help.as_deref()
    }

    /// What the device's compiler said, if this is about a program that doesn't build.
    pub fn log(&self) -> Option<&str> {
        self.log.as_deref()
    }

    /// The error of an OpenCL call that was made to do `task` ("create a buffer").
    pub(crate) fn of_call(task: &str, error: &ocl::core::Error) -> Self {
        // Taken in any case, so that it can't turn up in a later message.
        let vendor = loader::take_vendor_code();
        let reason = match (vendor, error.api_status()) {
            (Some(code), _) => format!("the driver answered {code}, which is no OpenCL code"),
            (None, Some(status)) => format!("the driver answered {status}"),
            (None, None) => error.to_string(),
        };
        let plain = Self::new(format!("couldn't {task}: {reason}"));
        match error.api_status() {
            Some(status) => plain.with_help(advice(status)),
            None => plain,
        }
    }
}

impl fmt::Display for DeviceError {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.help {
            Some(help) => write!(out, "{}; {help}", self.message),
            None => out.write_str(&self.message),
        }
    }
}

impl std::error::Error for DeviceError {}

/// Runs `work`, and turns a panic inside it into an error without a word on the terminal.
pub fn guarded<T>(work: impl FnOnce() -> Result<T, DeviceError>) -> Result<T, DeviceError> {
    quieten();
    let outer = QUIET.replace(true);
    let outcome = panic::catch_unwind(AssertUnwindSafe(work));
    QUIET.set(outer);
    outcome.unwrap_or_else(|payload| {
        let words = payload
            .downcast_ref::<String>()
            .map(String::as_str)
            .or(payload.downcast_ref::<&str>().copied());
        let words = words.unwrap_or("no reason given");
        Err(DeviceError::new(format!("the OpenCL bindings gave up: {words}")).with_help(OTHER_HELP))
    })
}

thread_local! {
    /// Whether a panic on this thread is to be caught, and so isn't news.
    static QUIET: Cell<bool> = const { Cell::new(false) };
}

/// Puts a filter before the panic hook, once, that skips the threads which are inside [`guarded`].
///
/// Taking the hook away and putting it back around each call would silence other threads' panics meanwhile.
fn quieten() {
    static ONCE: Once = Once::new();
    ONCE.call_once(|| {
        let previous = panic::take_hook();
        panic::set_hook(Box::new(move |panic| {
            if !QUIET.try_with(Cell::get).unwrap_or(false) {
                previous(panic);
            }
        }));
    });
}

fn advice(status: Status) -> &'static str {
    use Status::*;
    match status {
        CL_MEM_OBJECT_ALLOCATION_FAILURE | CL_OUT_OF_RESOURCES | CL_OUT_OF_HOST_MEMORY | CL_INVALID_BUFFER_SIZE => {
            MEMORY_HELP
        }
        CL_DEVICE_NOT_FOUND | CL_COMPILER_NOT_AVAILABLE | CL_LINKER_NOT_AVAILABLE | CL_BUILD_PROGRAM_FAILURE => {
            CACHE_HELP
        }
        _ => OTHER_HELP,
    }
}

/// One clean line of text from outside: no control characters, no runs of blanks, a bounded length.
pub(crate) fn line(text: &str) -> String {
    single(text, LINE_LIMIT)
}

fn single(text: &str, limit: usize) -> String {
    let words: Vec<&str> = text.split_whitespace().collect();
    clean(&words.join(" "), limit)
}

/// `text` without control characters and without the marks that reorder what a terminal shows.
fn clean(text: &str, limit: usize) -> String {
    let reorders = |c| matches!(c, '\u{200e}' | '\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}');
    let mut kept = text
        .chars()
        .map(|c| if c == '\t' { ' ' } else { c })
        .filter(|&c| !c.is_control() && !reorders(c));
    let mut short: String = kept.by_ref().take(limit).collect();
    if kept.next().is_some() {
        short.push('…');
    }
    short.truncate(short.trim_end().len());
    short
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(text: &str, expect: &str) {
        assert_eq!(line(text), expect);
    }

    #[test]
    fn text_from_drivers_is_made_harmless() {
        check("  NVIDIA\tCorporation \n", "NVIDIA Corporation");
        check("a\u{1b}[31mb\u{0}c\r\nd", "a[31mbc d");
        check("ab\u{202e}cd", "abcd");
        check("", "");
        check(&"x".repeat(400), &format!("{}…", "x".repeat(LINE_LIMIT)));
    }

    #[test]
    fn an_error_is_one_line_and_keeps_its_log() {
        let error = DeviceError::new("it\nbroke")
            .with_help("mend\nit")
            .with_log("one\u{7}\n\ttwo\n");
        assert_eq!(error.to_string(), "it broke; mend it");
        assert_eq!((error.message(), error.help()), ("it broke", Some("mend it")));
        assert_eq!(error.log(), Some("one\n two"));
        assert_eq!(DeviceError::new("x").with_log(" \n").log(), None);
    }

    #[test]
    fn a_panic_becomes_an_error() {
        let error = guarded::<()>(|| panic!("code {}", 7)).unwrap_err();
        assert_eq!(error.message(), "the OpenCL bindings gave up: code 7");
        let error = guarded::<()>(|| guarded(|| panic!("inner"))).unwrap_err();
        assert_eq!(error.message(), "the OpenCL bindings gave up: inner");
        assert!(!QUIET.get());
        assert_eq!(guarded(|| Ok(3)), Ok(3));
    }
}
