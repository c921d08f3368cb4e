//! How the program ends.

use std::process::ExitCode;

/// What the exit code tells a script.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(crate) enum Exit {
    /// Nothing is wrong; there may have been warnings.
    Clean,
    /// A scene file has errors, or what was measured is worse than allowed.
    Errors,
    /// The command could not be carried out: bad arguments, or a file that can't be read.
    Unusable,
    /// The device that was asked for failed, or there is none.
    DeviceFailed,
    /// The picture is written, and may be more wrong than was asked for.
    Missed,
    /// Ctrl-C.
    Interrupted,
}

impl Exit {
    /// The number.
    pub(crate) const fn code(self) -> u8 {
        match self {
            Self::Clean => 0,
            Self::Errors => 1,
            Self::Unusable => 2,
            Self::DeviceFailed => 3,
            Self::Missed => 4,
            // As shells have it: 128 and the number of the signal.
            Self::Interrupted => 130,
        }
    }
}

impl From<Exit> for ExitCode {
    fn from(exit: Exit) -> Self {
        Self::from(exit.code())
    }
}
