//! What a command over files has in common with the others: each file with its configuration, and what went wrong.

use std::io;

use crate::config::{ConfigOptions, Configs, Found};
use crate::exit::Exit;
use crate::files::{FileOptions, Input, Inputs};
use crate::report;

/// A file and the configuration that holds for it.
pub(crate) struct Job {
    pub(crate) input: Input,
    pub(crate) config: Found,
}

/// The files that the arguments stand for, each with its configuration, and what could not be looked into.
pub(crate) fn jobs(options: &FileOptions, config: &ConfigOptions) -> (Vec<Job>, Failures) {
    let Inputs { files, failures } = options.find();
    let mut told = Failures::default();
    for failure in failures {
        told.tell(failure);
    }
    if files.is_empty() && told.messages.is_empty() {
        remark("no scene files found");
    }
    let mut configs = Configs::new(config);
    if let Some(failure) = configs.failure() {
        told.tell(failure.to_owned());
    }
    let job = |input: Input| {
        let config = configs.of(options.place(&input));
        Job { input, config }
    };
    (files.into_iter().map(job).collect(), told)
}

/// Why files could not be worked on. Each reason is told once, at once, on standard error.
#[derive(Debug, Default)]
pub(crate) struct Failures {
    pub(crate) messages: Vec<String>,
}

impl Failures {
    pub(crate) fn tell(&mut self, message: String) {
        if !self.messages.contains(&message) {
            // Where standard error is gone, the exit code still tells.
            report::failure(&mut io::stderr().lock(), &message).unwrap_or_default();
            self.messages.push(message);
        }
    }

    /// That the output can't be written. Of a reader who went away nothing is said: it has what it wanted.
    pub(crate) fn tell_unwritten(&mut self, error: &io::Error) {
        if error.kind() != io::ErrorKind::BrokenPipe {
            self.tell(format!("cannot write <stdout>: {error}"));
        }
    }

    /// How the program ends, if it would end with `exit` otherwise.
    pub(crate) fn exit(&self, exit: Exit) -> Exit {
        if self.messages.is_empty() {
            exit
        } else {
            exit.max(Exit::Unusable)
        }
    }
}

/// Says something that is no finding, on standard error.
pub(crate) fn remark(message: &str) {
    report::remark(&mut io::stderr().lock(), message).unwrap_or_default();
}
