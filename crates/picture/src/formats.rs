//! The table of output formats: one row and one file each.

mod bmp;
mod exr;
mod hdr;
mod jpeg;
mod pfm;
mod png;
mod ppm;
mod qoi;
mod raw;
mod tga;
mod tiff;
mod webp;

#[cfg(test)]
mod tests;

use std::ffi::OsStr;
use std::fmt;
use std::io::{BufRead, Seek, Write};
use std::path::Path;

use crate::{EncodeError, Encoding, LoadError, Picture};

/// Where a file's bytes go.
pub(crate) trait Sink: Write + Seek {}
impl<T: Write + Seek> Sink for T {}

/// Where a file's bytes come from.
pub(crate) trait Source: BufRead + Seek {}
impl<T: BufRead + Seek> Source for T {}

/// A row of the table.
struct Row {
    name: &'static str,
    /// Lower case; the first is the usual one.
    extensions: &'static [&'static str],
    /// The first is the usual one.
    depths: &'static [Depth],
    lossless: bool,
    /// The most rows, and the most columns.
    max_side: u32,
    write: Way,
    read: fn(&mut dyn Source) -> Result<Picture, LoadError>,
}

/// Columns and rows of a whole picture.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) struct Size {
    pub(crate) width: u32,
    pub(crate) height: u32,
}

/// Where a band of rows stands.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Place {
    /// The picture that it is a part of.
    pub(crate) whole: Size,
    /// The band's upper row.
    pub(crate) first_row: u32,
}

type Whole = fn(&Picture, &Encoding, &mut dyn Sink) -> Result<(), EncodeError>;
type Head = fn(Size, &Encoding, &mut dyn Sink) -> Result<(), EncodeError>;
type Band = fn(&Picture, Place, &Encoding, &mut dyn Sink) -> Result<(), EncodeError>;

/// How a picture is written.
enum Way {
    /// All of it at once.
    Whole(Whole),
    /// A header, then bands of rows from the top.
    Bands { head: Head, band: Band },
}

/// All formats, the usual ones first.
static TABLE: [&Row; 12] = [
    &png::ROW,
    &jpeg::ROW,
    &bmp::ROW,
    &tiff::ROW,
    &tga::ROW,
    &qoi::ROW,
    &webp::ROW,
    &ppm::ROW,
    &pfm::ROW,
    &hdr::ROW,
    &exr::ROW,
    &raw::ROW,
];

/// How a file stores a component.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Depth {
    /// 256 levels of 0 to 1.
    Eight,
    /// 65,536 levels of 0 to 1.
    Sixteen,
    /// A floating-point number, neither clamped nor encoded.
    Float,
}

impl Depth {
    /// Every depth with its name.
    pub const ALL: &[(Self, &'static str)] = &[(Self::Eight, "8"), (Self::Sixteen, "16"), (Self::Float, "float")];
}

impl fmt::Display for Depth {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Eight => "8-bit",
            Self::Sixteen => "16-bit",
            Self::Float => "floating-point",
        })
    }
}

/// Writes rows of a picture as 32-bit floats, the lower byte first.
fn write_floats(picture: &Picture, rows: impl Iterator<Item = u32>, out: &mut dyn Sink) -> Result<(), EncodeError> {
    let mut line = Vec::new();
    for row in rows {
        line.clear();
        let values = picture.row(row).as_flattened();
        line.extend(values.iter().flat_map(|value| value.to_le_bytes()));
        out.write_all(&line)?;
    }
    Ok(())
}

/// A format that pictures are written in.
#[derive(Clone, Copy)]
pub struct Format(&'static Row);

impl Format {
    /// The format for everyone.
    pub const PNG: Self = Self(&png::ROW);

    /// All of them, the usual ones first.
    pub fn all() -> impl Iterator<Item = Self> {
        TABLE.iter().map(|row| Self(row))
    }

    /// The format of this name, in any case: "png".
    #[must_use]
    pub fn from_name(name: &str) -> Option<Self> {
        Self::all().find(|format| format.name().eq_ignore_ascii_case(name))
    }

    /// The format that a path's extension says, in any case.
    #[must_use]
    pub fn from_path(path: &Path) -> Option<Self> {
        let extension = path.extension().and_then(OsStr::to_str)?;
        Self::all().find(|format| {
            format
                .extensions()
                .iter()
                .any(|own| own.eq_ignore_ascii_case(extension))
        })
    }

    /// Its name, lower case.
    #[must_use]
    pub fn name(self) -> &'static str {
        self.0.name
    }

    /// Its extensions, lower case, without the point; the first is the usual one.
    #[must_use]
    pub fn extensions(self) -> &'static [&'static str] {
        self.0.extensions
    }

    /// The depths that it holds; the first is the usual one.
    #[must_use]
    pub fn depths(self) -> &'static [Depth] {
        self.0.depths
    }

    /// The depth that is written unless another is asked for.
    #[must_use]
    pub fn usual_depth(self) -> Depth {
        self.0.depths.first().copied().unwrap_or(Depth::Eight)
    }

    /// Whether the levels that are written are the levels that are read. Radiance's shared exponent is lossy in this
    /// sense, as JPEG is.
    #[must_use]
    pub fn lossless(self) -> bool {
        self.0.lossless
    }

    /// The most rows, and the most columns, that it holds.
    #[must_use]
    pub fn max_side(self) -> u32 {
        self.0.max_side
    }

    pub(crate) fn write(self, picture: &Picture, encoding: &Encoding, out: &mut dyn Sink) -> Result<(), EncodeError> {
        match self.0.write {
            Way::Whole(write) => write(picture, encoding, out),
            Way::Bands { head, band } => {
                let (width, height) = (picture.width(), picture.height());
                let whole = Size { width, height };
                head(whole, encoding, out)?;
                band(picture, Place { whole, first_row: 0 }, encoding, out)
            }
        }
    }

    /// Whether a picture can be written band by band, so that memory need not hold all of it.
    #[must_use]
    pub fn takes_bands(self) -> bool {
        matches!(self.0.write, Way::Bands { .. })
    }

    pub(crate) fn head(self, whole: Size, encoding: &Encoding, out: &mut dyn Sink) -> Result<(), EncodeError> {
        match self.0.write {
            Way::Whole(_) => Err(EncodeError::Memory),
            Way::Bands { head, .. } => head(whole, encoding, out),
        }
    }

    pub(crate) fn band(
        self,
        picture: &Picture,
        place: Place,
        encoding: &Encoding,
        out: &mut dyn Sink,
    ) -> Result<(), EncodeError> {
        match self.0.write {
            Way::Whole(_) => Err(EncodeError::Memory),
            Way::Bands { band, .. } => band(picture, place, encoding, out),
        }
    }

    pub(crate) fn read(self, from: &mut dyn Source) -> Result<Picture, LoadError> {
        (self.0.read)(from)
    }
}

impl PartialEq for Format {
    fn eq(&self, other: &Self) -> bool {
        self.name() == other.name()
    }
}

impl Eq for Format {}

impl fmt::Debug for Format {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl fmt::Display for Format {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}
