//! How the program ends.

use std::process::ExitCode;

/// What the exit code tells a script.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(crate) enum Exit {
    /// Nothing is wrong; there may have been warnings.
    Clean,
    /// A scene file has errors.
    Errors,
    /// The command could not be carried out: bad arguments, or a file that can't be read.
    Unusable,
}

impl From<Exit> for ExitCode {
    fn from(exit: Exit) -> Self {
        match exit {
            Exit::Clean => Self::SUCCESS,
            Exit::Errors => Self::from(1),
            Exit::Unusable => Self::from(2),
        }
    }
}
