//! Why there is no picture, and what the exit code says of it.

use std::io;

use scenec_device::DeviceError;
use scenec_picture::TraceError;

use crate::exit::Exit;
use crate::report;

/// Why there is no picture.
#[derive(Debug)]
pub(crate) enum Failure {
    /// The file has errors, and they have been reported.
    Errors,
    /// What was asked for can't be done: a sentence for the user.
    Unusable(String),
    /// The device failed: a sentence for the user, perhaps followed by a compiler's log.
    Device(String),
    /// Somebody said stop.
    Interrupted,
}

impl Failure {
    pub(crate) fn unusable(message: impl ToString) -> Self {
        Self::Unusable(message.to_string())
    }

    /// What the exit code tells.
    pub(crate) fn exit(&self) -> Exit {
        match self {
            Self::Errors => Exit::Errors,
            Self::Unusable(_) => Exit::Unusable,
            Self::Device(_) => Exit::DeviceFailed,
            Self::Interrupted => Exit::Interrupted,
        }
    }

    /// Says what is left to say.
    pub(crate) fn tell(&self, out: &mut impl io::Write) -> io::Result<()> {
        match self {
            Self::Errors => Ok(()),
            Self::Unusable(message) | Self::Device(message) => report::failure(out, message),
            Self::Interrupted => report::remark(out, "stopped before the picture was complete"),
        }
    }
}

impl From<TraceError> for Failure {
    fn from(error: TraceError) -> Self {
        match error {
            TraceError::Cancelled => Self::Interrupted,
            TraceError::TooManyPixels(error) => Self::unusable(error),
            TraceError::Failed(message) => Self::Device(message),
        }
    }
}

impl From<DeviceError> for Failure {
    fn from(error: DeviceError) -> Self {
        Self::Device(match error.log() {
            Some(log) => format!("{error}\n{log}"),
            None => error.to_string(),
        })
    }
}
