//! A picture that is too large for memory into the bytes of a file, band by band.

use std::io::{Seek, Write};

use crate::formats::{Place, Sink, Size};
use crate::{EncodeError, Encoding, Picture};

/// A file that bands of rows are written to, from the top.
pub struct Bands<'a> {
    out: &'a mut dyn Sink,
    encoding: Encoding,
    whole: Size,
    next: u32,
}

impl<'a> Bands<'a> {
    /// Begins a file for a picture of so many columns and rows.
    ///
    /// # Errors
    /// Those of [`Encoding::check`]; `Memory` for a format that does not take bands; `Io` from `out`.
    pub fn begin(
        width: u32,
        height: u32,
        encoding: &Encoding,
        out: &'a mut (impl Write + Seek),
    ) -> Result<Self, EncodeError> {
        encoding.check(width, height)?;
        let whole = Size { width, height };
        encoding.format.head(whole, encoding, out)?;
        Ok(Self {
            out,
            encoding: *encoding,
            whole,
            next: 0,
        })
    }

    /// Writes the next rows: as many as the band has, each as wide as the picture.
    ///
    /// # Errors
    /// `Io`; `Codec` for a band that does not fit.
    pub fn push(&mut self, band: &Picture) -> Result<(), EncodeError> {
        let fits = band.width() == self.whole.width && band.height() <= self.whole.height - self.next;
        if !fits {
            return Err(EncodeError::Codec("a band does not fit into its picture".to_owned()));
        }
        let place = Place {
            whole: self.whole,
            first_row: self.next,
        };
        self.encoding.format.band(band, place, &self.encoding, self.out)?;
        self.next += band.height();
        Ok(())
    }

    /// Ends the file.
    ///
    /// # Errors
    /// `Io`; `Codec` if rows are missing.
    pub fn finish(self) -> Result<(), EncodeError> {
        if self.next < self.whole.height {
            return Err(EncodeError::Codec("rows are missing from a picture".to_owned()));
        }
        self.out.flush().map_err(EncodeError::Io)
    }
}

#[cfg(test)]
mod tests {
    use std::io::Cursor;

    use super::Bands;
    use crate::{Depth, EncodeError, Encoding, Format, Picture, encode};

    fn picture(width: u32, rows: std::ops::Range<u32>) -> Picture {
        let mut picture = Picture::black(width, rows.len() as u32).unwrap();
        let pixels = picture.pixels_mut().iter_mut().zip(rows.start * width..);
        pixels.for_each(|(pixel, number)| *pixel = [0.01, 0.02, 0.003].map(|step| step * number as f32));
        picture
    }

    /// Bands that begin at these rows become the same file as the whole picture.
    fn check(encoding: &Encoding, cuts: &[u32]) {
        let mut expect = Cursor::new(Vec::new());
        encode(&picture(5, 0..7), encoding, &mut expect).unwrap();
        let mut out = Cursor::new(Vec::new());
        let mut bands = Bands::begin(5, 7, encoding, &mut out).unwrap();
        for cut in cuts.windows(2) {
            bands.push(&picture(5, cut[0]..cut[1])).unwrap();
        }
        bands.finish().unwrap();
        assert!(out.into_inner() == expect.into_inner(), "{encoding:?} {cuts:?}");
    }

    #[test]
    fn bands_make_the_file_that_the_whole_picture_makes() {
        let mut some = 0;
        for format in Format::all().filter(|format| format.takes_bands()) {
            for depth in format.depths() {
                let encoding = Encoding {
                    depth: Some(*depth),
                    ..Encoding::of(format)
                };
                check(&encoding, &[0, 7]);
                check(&encoding, &[0, 1, 4, 7]);
                some += 1;
            }
        }
        assert!(some >= 4);
    }

    #[test]
    fn bands_that_do_not_make_a_picture_are_refused() {
        let raw = Encoding::of(Format::from_name("raw").unwrap());
        let mut out = Cursor::new(Vec::new());
        let mut bands = Bands::begin(5, 7, &raw, &mut out).unwrap();
        assert!(matches!(bands.push(&picture(4, 0..1)), Err(EncodeError::Codec(_))));
        assert!(matches!(bands.push(&picture(5, 0..8)), Err(EncodeError::Codec(_))));
        bands.push(&picture(5, 0..6)).unwrap();
        assert!(matches!(bands.finish(), Err(EncodeError::Codec(_))));
        let deep = Encoding {
            depth: Some(Depth::Sixteen),
            ..raw
        };
        assert!(matches!(
            Bands::begin(5, 7, &deep, &mut out),
            Err(EncodeError::Depth { .. })
        ));
        let png = Encoding::of(Format::PNG);
        assert!(matches!(Bands::begin(5, 7, &png, &mut out), Err(EncodeError::Memory)));
    }
}
