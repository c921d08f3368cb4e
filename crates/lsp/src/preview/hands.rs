//! One running process and the threads at its three ends.

use std::io::{self, BufRead, BufReader, BufWriter, Read};
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::sync::Arc;
use std::sync::mpsc::{self, Sender};
use std::thread;
use std::time::Duration;

use super::wire::{receive, send};
use super::words::{Answer, Order};

/// The longest line of the process's own words that is passed on, in bytes.
const MAX_LINE: u64 = 2000;

/// What a process says.
#[derive(Debug)]
pub(super) enum Said {
    /// An answer with its payload.
    Answer(Answer, Vec<u8>),
    /// A line on its standard error.
    Line(String),
    /// Nothing more: the line is closed, or what came is no answer.
    End(Option<String>),
}

/// A running process.
pub(super) struct Hands {
    child: Option<Child>,
    orders: Sender<(Order, Arc<str>)>,
}

impl Hands {
    /// Starts the process. `hear` is called on threads of its own.
    pub(super) fn start(
        program: &Path,
        arguments: &[String],
        hear: impl Fn(Said) + Clone + Send + 'static,
    ) -> io::Result<Self> {
        let mut child = Command::new(program)
            .args(arguments)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()?;
        let missing = || io::Error::other("a pipe is missing");
        let input = child.stdin.take().ok_or_else(missing)?;
        let output = child.stdout.take().ok_or_else(missing)?;
        let errors = child.stderr.take().ok_or_else(missing)?;
        let (orders, to_send) = mpsc::channel::<(Order, Arc<str>)>();
        let thread = || thread::Builder::new().name("preview".to_owned());
        thread().spawn(move || {
            let mut input = BufWriter::new(input);
            for (order, text) in to_send {
                if send(&mut input, &order, text.as_bytes()).is_err() {
                    // Who reads the answers notices too.
                    break;
                }
            }
        })?;
        let lines = hear.clone();
        thread().spawn(move || pass_lines(errors, &lines))?;
        thread().spawn(move || {
            let mut output = BufReader::new(output);
            let end = loop {
                match receive::<Answer>(&mut output) {
                    Ok(Some((answer, payload))) => hear(Said::Answer(answer, payload)),
                    Ok(None) => break None,
                    Err(error) => break Some(error.to_string()),
                }
            };
            hear(Said::End(end));
        })?;
        Ok(Self {
            child: Some(child),
            orders,
        })
    }

    /// Sends an order; it may wait for the ones before it, but never the caller.
    pub(super) fn order(&self, order: Order, text: Arc<str>) {
        self.orders.send((order, text)).unwrap_or_default();
    }

    /// How it ended, given a moment to do so; `None` if it runs on.
    pub(super) fn ended(&mut self) -> Option<String> {
        let child = self.child.as_mut()?;
        for _ in 0..50 {
            if let Ok(Some(status)) = child.try_wait() {
                return Some(status.to_string());
            }
            thread::sleep(Duration::from_millis(1));
        }
        None
    }
}

impl Drop for Hands {
    fn drop(&mut self) {
        if let Some(mut child) = self.child.take() {
            // It may be gone already.
            child.kill().unwrap_or_default();
            // A process in the hands of a driver may take long to die, and nobody is to wait for that.
            thread::spawn(move || child.wait());
        }
    }
}

fn pass_lines(errors: impl Read, hear: &impl Fn(Said)) {
    let mut errors = BufReader::new(errors);
    loop {
        let mut line = Vec::new();
        match errors.by_ref().take(MAX_LINE).read_until(b'\n', &mut line) {
            Ok(0) | Err(_) => return,
            Ok(_) => hear(Said::Line(String::from_utf8_lossy(&line).trim_end().to_owned())),
        }
    }
}
