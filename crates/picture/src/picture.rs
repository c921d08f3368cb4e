//! Numbers in rows.

use std::fmt;

/// The most pixels that one picture in memory may have: 2^28, which is 3 GiB of f32 RGB.
pub const MAX_PIXELS: u64 = 1 << 28;

/// Linear RGB, not clamped; rows from the top, pixels from the left.
#[derive(Clone, PartialEq, Debug)]
pub struct Picture {
    width: u32,
    height: u32,
    rgb: Vec<[f32; 3]>,
}

/// A picture that would not fit into memory.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct TooManyPixels {
    /// Columns asked for.
    pub width: u32,
    /// Rows asked for.
    pub height: u32,
}

impl fmt::Display for TooManyPixels {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { width, height } = *self;
        let gib = |pixels: u64| pixels as f64 * 12.0 / f64::from(1 << 30);
        write!(
            f,
            "a picture of {width} x {height} pixels takes {:.1} GiB; at most {:.0} GiB are held at once",
            gib(u64::from(width) * u64::from(height)),
            gib(MAX_PIXELS),
        )
    }
}

impl std::error::Error for TooManyPixels {}

impl Picture {
    /// A black picture.
    ///
    /// # Errors
    /// `TooManyPixels` above [`MAX_PIXELS`], or if the memory is not there.
    pub fn black(width: u32, height: u32) -> Result<Self, TooManyPixels> {
        let refused = TooManyPixels { width, height };
        let pixels = u64::from(width) * u64::from(height);
        if pixels > MAX_PIXELS {
            return Err(refused);
        }
        let pixels = usize::try_from(pixels).map_err(|_| refused)?;
        let mut rgb = Vec::new();
        rgb.try_reserve_exact(pixels).map_err(|_| refused)?;
        rgb.resize(pixels, [0.0; 3]);
        Ok(Self { width, height, rgb })
    }

    /// Columns.
    #[must_use]
    pub const fn width(&self) -> u32 {
        self.width
    }

    /// Rows.
    #[must_use]
    pub const fn height(&self) -> u32 {
        self.height
    }

    /// All pixels, row by row; `width * height` of them.
    #[must_use]
    pub fn pixels(&self) -> &[[f32; 3]] {
        &self.rgb
    }

    /// All pixels, to be written.
    pub fn pixels_mut(&mut self) -> &mut [[f32; 3]] {
        &mut self.rgb
    }

    /// One row, from the left; empty past the last one.
    #[must_use]
    pub fn row(&self, row: u32) -> &[[f32; 3]] {
        let width = self.width as usize;
        let start = row as usize * width;
        self.rgb.get(start..start + width).unwrap_or_default()
    }

    /// How many pixels hold a number that is not finite.
    #[must_use]
    pub fn non_finite(&self) -> usize {
        self.rgb
            .iter()
            .filter(|pixel| !pixel.iter().all(|value| value.is_finite()))
            .count()
    }
}

#[cfg(test)]
mod tests {
    use super::Picture;

    #[test]
    fn a_picture_too_large_is_refused_with_the_figure() {
        let error = Picture::black(65535, 65535).unwrap_err();
        assert!(error.to_string().contains("48.0 GiB"), "{error}");
        let picture = Picture::black(3, 2).unwrap();
        assert_eq!(
            (picture.pixels().len(), picture.row(1).len(), picture.row(2).len()),
            (6, 3, 0)
        );
    }
}
