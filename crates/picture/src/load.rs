//! A picture back from a file, for comparisons.

use std::fmt;
use std::fs::File;
use std::io::{self, BufReader};
use std::path::Path;

use image::{DynamicImage, ImageDecoder, ImageError, ImageFormat, ImageReader};

use crate::formats::Source;
use crate::{Format, MAX_PIXELS, Picture, TooManyPixels};

/// Reads a picture in the format that the extension says. Integer levels become 0 to 1 as they stand, whatever curve
/// made them; floats stay as they are; an alpha channel is left out.
///
/// # Errors
/// `Format` for an extension of no format, `TooManyPixels` above [`MAX_PIXELS`], `Io`, and `Broken` for what the format
/// does not read; so for raw files, which do not say their size: see [`load_raw`].
pub fn load(path: &Path) -> Result<Picture, LoadError> {
    let format = Format::from_path(path).ok_or(LoadError::Format)?;
    format.read(&mut BufReader::new(File::open(path)?))
}

/// Reads a file of bare floats, of which the size is known.
///
/// # Errors
/// `TooManyPixels`, and `Io` for a file that is missing or of another length.
pub fn load_raw(path: &Path, width: u32, height: u32) -> Result<Picture, LoadError> {
    read_raw(&mut BufReader::new(File::open(path)?), width, height)
}

/// Bare floats from anywhere.
pub(crate) fn read_raw(from: &mut dyn Source, width: u32, height: u32) -> Result<Picture, LoadError> {
    let mut picture = Picture::black(width, height)?;
    let mut bytes = [0; 4];
    for value in picture.pixels_mut().as_flattened_mut() {
        from.read_exact(&mut bytes)?;
        *value = f32::from_le_bytes(bytes);
    }
    if from.fill_buf()?.is_empty() {
        Ok(picture)
    } else {
        Err(LoadError::Broken(format!(
            "there is more in it than {width} x {height} pixels"
        )))
    }
}

/// What the library's codec of this format reads.
pub(crate) fn decode(from: &mut dyn Source, format: ImageFormat) -> Result<Picture, LoadError> {
    let mut reader = ImageReader::with_format(from, format);
    let mut limits = image::Limits::default();
    // Four floats a pixel: the widest that a codec decodes to.
    limits.max_alloc = Some(MAX_PIXELS * 16);
    reader.limits(limits);
    let decoder = reader.into_decoder()?;
    let (width, height) = decoder.dimensions();
    let mut picture = Picture::black(width, height)?;
    let decoded = DynamicImage::from_decoder(decoder)?.into_rgb32f();
    for (pixel, read) in picture.pixels_mut().iter_mut().zip(decoded.pixels()) {
        *pixel = read.0;
    }
    Ok(picture)
}

/// Why there is no picture.
#[derive(Debug)]
pub enum LoadError {
    /// The extension is of no known format.
    Format,
    /// It does not fit into memory.
    TooManyPixels(TooManyPixels),
    /// The file could not be read.
    Io(io::Error),
    /// The file is no picture of its format; the message says why.
    Broken(String),
}

impl fmt::Display for LoadError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Format => f.write_str("its extension is of no picture format"),
            Self::TooManyPixels(error) => error.fmt(f),
            Self::Io(error) => error.fmt(f),
            Self::Broken(message) => f.write_str(message),
        }
    }
}

impl std::error::Error for LoadError {}

impl From<io::Error> for LoadError {
    fn from(error: io::Error) -> Self {
        Self::Io(error)
    }
}

impl From<TooManyPixels> for LoadError {
    fn from(error: TooManyPixels) -> Self {
        Self::TooManyPixels(error)
    }
}

impl From<ImageError> for LoadError {
    fn from(error: ImageError) -> Self {
        match error {
            ImageError::IoError(error) => Self::Io(error),
            other => Self::Broken(other.to_string()),
        }
    }
}

#[cfg(test)]
mod tests {
    use std::io::Cursor;

    use super::{LoadError, read_raw};
    use crate::Format;

    fn check(format: &str, bytes: &[u8]) {
        let read = Format::from_name(format).unwrap().read(&mut Cursor::new(bytes));
        assert!(matches!(read, Err(LoadError::TooManyPixels(_))), "{format}: {read:?}");
    }

    #[test]
    fn sizes_beyond_memory_are_refused_by_the_header() {
        check("ppm", b"P6 60000 60000 255\n");
        check("pfm", b"PF 60000 60000 -1\n");
    }

    #[test]
    fn raw_files_of_another_length_are_refused() {
        for length in [0, 11, 13] {
            assert!(read_raw(&mut Cursor::new(vec![0; length]), 1, 1).is_err(), "{length}");
        }
    }
}
