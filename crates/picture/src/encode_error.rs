//! Why a picture can't be written, in words that name a way out.

use std::fmt;
use std::io;

use image::ImageError;

use crate::{Depth, Format};

/// Why a picture can't be written.
#[derive(Debug)]
pub enum EncodeError {
    /// The quality is not 1 to 100.
    Quality(u8),
    /// The format doesn't hold this depth.
    Depth {
        /// The format asked for.
        format: Format,
        /// The depth asked for.
        depth: Depth,
    },
    /// The format doesn't hold so many rows or columns.
    TooLarge {
        /// The format asked for.
        format: Format,
        /// The depth asked for.
        depth: Depth,
        /// Columns.
        width: u32,
        /// Rows.
        height: u32,
    },
    /// There is no memory for the bytes.
    Memory,
    /// What is written to failed.
    Io(io::Error),
    /// The format's codec refused, in its own words.
    Codec(String),
}

impl fmt::Display for EncodeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Quality(quality) => write!(f, "a quality is 1 to 100, not {quality}"),
            Self::Depth { format, depth } => {
                write!(f, "{format} does not hold {depth} components")?;
                others(f, Format::all().filter(|other| other.depths().contains(depth)))
            }
            Self::TooLarge {
                format,
                depth,
                width,
                height,
            } => {
                let limit = format.max_side();
                write!(
                    f,
                    "{format} holds at most {limit} pixels a side, not {width} x {height}"
                )?;
                let side = *width.max(height);
                let fits = |other: &Format| other.max_side() >= side && other.depths().contains(depth);
                others(f, Format::all().filter(fits))
            }
            Self::Memory => f.write_str("there is not enough memory for the bytes of the file"),
            Self::Io(error) => error.fmt(f),
            Self::Codec(message) => f.write_str(message),
        }
    }
}

/// Which formats would do.
fn others(f: &mut fmt::Formatter<'_>, formats: impl Iterator<Item = Format>) -> fmt::Result {
    let names: Vec<_> = formats.map(Format::name).collect();
    if names.is_empty() {
        return Ok(());
    }
    write!(f, "; {} would", names.join(", "))
}

impl std::error::Error for EncodeError {}

impl From<io::Error> for EncodeError {
    fn from(error: io::Error) -> Self {
        Self::Io(error)
    }
}

impl From<ImageError> for EncodeError {
    fn from(error: ImageError) -> Self {
        match error {
            ImageError::IoError(error) => Self::Io(error),
            other => Self::Codec(other.to_string()),
        }
    }
}
