//! A picture into the bytes of a file.

use std::io::{Seek, Write};

use crate::formats::Sink;
use crate::{Depth, EncodeError, Format, Picture, Transfer};

/// How a picture is to be written.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Encoding {
    /// In which format.
    pub format: Format,
    /// How a component is stored; `None` takes the format's usual one.
    pub depth: Option<Depth>,
    /// How components become integers.
    pub transfer: Transfer,
    /// 1 (small) to 100 (faithful), for formats that lose something.
    pub quality: u8,
}

impl Encoding {
    /// The usual way to write this format: its first depth, components as they are, quality 90.
    #[must_use]
    pub const fn of(format: Format) -> Self {
        Self {
            format,
            depth: None,
            transfer: Transfer::Linear,
            quality: 90,
        }
    }

    /// The depth that will be written.
    #[must_use]
    pub fn depth(&self) -> Depth {
        self.depth.unwrap_or_else(|| self.format.usual_depth())
    }

    /// Whether a picture of this size can be written so; asked before anything is traced, it saves the wait.
    ///
    /// # Errors
    /// `Quality`, `Depth` and `TooLarge`.
    pub fn check(&self, width: u32, height: u32) -> Result<(), EncodeError> {
        let Self { format, quality, .. } = *self;
        let depth = self.depth();
        if !(1..=100).contains(&quality) {
            return Err(EncodeError::Quality(quality));
        }
        if !format.depths().contains(&depth) {
            return Err(EncodeError::Depth { format, depth });
        }
        if width.max(height) > format.max_side() {
            return Err(EncodeError::TooLarge {
                format,
                depth,
                width,
                height,
            });
        }
        Ok(())
    }
}

/// Writes the picture as a whole file of the format.
///
/// # Errors
/// Those of [`Encoding::check`] before the first byte; later `Io` from `out`, `Memory`, or `Codec`.
pub fn encode(picture: &Picture, encoding: &Encoding, out: &mut (impl Write + Seek)) -> Result<(), EncodeError> {
    encoding.check(picture.width(), picture.height())?;
    let out: &mut dyn Sink = out;
    encoding.format.write(picture, encoding, out)?;
    out.flush().map_err(EncodeError::Io)
}

#[cfg(test)]
mod tests {
    use std::io::{self, Cursor, Seek, SeekFrom, Write};

    use super::{Encoding, encode};
    use crate::{Depth, EncodeError, Format, Picture};

    fn check(encoding: Encoding, width: u32, height: u32, expect: &str) {
        let picture = Picture::black(width, height).unwrap();
        let mut out = Cursor::new(Vec::new());
        let error = encode(&picture, &encoding, &mut out).unwrap_err();
        assert_eq!(error.to_string(), expect);
        assert!(out.get_ref().is_empty(), "bytes of a refused picture");
    }

    #[test]
    fn what_a_format_cannot_hold_is_refused_before_the_first_byte() {
        let of = |name: &str| Encoding::of(Format::from_name(name).unwrap());
        let deep = |name: &str, depth| Encoding {
            depth: Some(depth),
            ..of(name)
        };
        check(
            of("jpeg"),
            65536,
            1,
            "jpeg holds at most 65535 pixels a side, not 65536 x 1; png, bmp, tiff, qoi, ppm would",
        );
        check(
            of("webp"),
            1,
            16384,
            "webp holds at most 16383 pixels a side, not 1 x 16384; png, jpeg, bmp, tiff, tga, qoi, ppm would",
        );
        check(
            deep("tga", Depth::Sixteen),
            1,
            1,
            "tga does not hold 16-bit components; png, tiff, ppm would",
        );
        check(
            deep("png", Depth::Float),
            1,
            1,
            "png does not hold floating-point components; tiff, pfm, hdr, exr, raw would",
        );
        check(
            Encoding {
                quality: 0,
                ..of("jpeg")
            },
            1,
            1,
            "a quality is 1 to 100, not 0",
        );
    }

    /// A disk with room for this many bytes.
    struct Full(usize);

    impl Write for Full {
        fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
            if bytes.len() > self.0 {
                return Err(io::ErrorKind::StorageFull.into());
            }
            self.0 -= bytes.len();
            Ok(bytes.len())
        }

        fn flush(&mut self) -> io::Result<()> {
            Ok(())
        }
    }

    impl Seek for Full {
        fn seek(&mut self, _: SeekFrom) -> io::Result<u64> {
            Ok(0)
        }
    }

    #[test]
    fn a_full_disk_is_an_error_in_every_format() {
        let picture = Picture::black(64, 64).unwrap();
        for format in Format::all() {
            let result = encode(&picture, &Encoding::of(format), &mut Full(20));
            assert!(
                matches!(result, Err(EncodeError::Io(_) | EncodeError::Codec(_))),
                "{format}: {result:?}"
            );
        }
    }
}
