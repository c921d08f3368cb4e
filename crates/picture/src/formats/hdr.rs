//! Radiance HDR: a byte a component and an exponent shared by the three (Ward, "Real Pixels", Graphics Gems II, 1991).

use image::ImageFormat;

use super::{Depth, Place, Row, Sink, Size, Way};
use crate::load::decode;
use crate::{EncodeError, Encoding, Picture};

pub(super) const ROW: Row = Row {
    name: "hdr",
    extensions: &["hdr"],
    depths: &[Depth::Float],
    lossless: false,
    max_side: i32::MAX as u32,
    write: Way::Bands { head, band },
    read: |from| decode(from, ImageFormat::Hdr),
};

fn head(whole: Size, _: &Encoding, out: &mut dyn Sink) -> Result<(), EncodeError> {
    let Size { width, height } = whole;
    write!(out, "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y {height} +X {width}\n")?;
    Ok(())
}

/// Scan lines are written plain, which every reader takes: the largest mantissa is 128 or more, so that no pixel looks
/// like the mark of a compressed line.
fn band(picture: &Picture, _: Place, _: &Encoding, out: &mut dyn Sink) -> Result<(), EncodeError> {
    let mut line = Vec::new();
    for row in 0..picture.height() {
        line.clear();
        line.extend(picture.row(row).iter().flat_map(|&pixel| shared(pixel)));
        out.write_all(&line)?;
    }
    Ok(())
}

/// Mantissas and exponent: a component is mantissa * 2^(exponent - 136), to the nearest. The format has no negative
/// numbers (0 here), nothing above 255 * 2^119 (that, here) and nothing that is not a number (0 here).
fn shared(pixel: [f32; 3]) -> [u8; 4] {
    let pixel = pixel.map(|value| f64::from(value).max(0.0).min(255.0 * 2f64.powi(119)));
    let largest = pixel.iter().copied().fold(0.0, f64::max);
    let mut exponent = (largest.log2().floor() + 1.0).clamp(-127.0, 127.0) as i32;
    // What rounds up to 256 needs the next exponent.
    if (largest * 2f64.powi(8 - exponent)).round() > 255.0 {
        exponent += 1;
    }
    let scale = 2f64.powi(8 - exponent);
    if (largest * scale).round() < 128.0 {
        return [0; 4];
    }
    let [r, g, b] = pixel.map(|value| (value * scale).round() as u8);
    [r, g, b, (exponent + 128) as u8]
}

#[cfg(test)]
mod tests {
    use super::shared;

    fn check(pixel: [f32; 3], expect: [u8; 4]) {
        assert_eq!(shared(pixel), expect, "{pixel:?}");
    }

    #[test]
    fn the_largest_component_fills_its_byte() {
        check([1.0, 0.5, 0.25], [128, 64, 32, 129]);
        check([0.998, 0.0, 0.0], [255, 0, 0, 128]);
        check([0.9999, 0.0, 0.0], [128, 0, 0, 129]);
        check([0.0; 3], [0; 4]);
        check([-1.0, f32::NAN, 1e-45], [0; 4]);
        check([f32::INFINITY, 0.0, 0.0], [255, 0, 0, 255]);
    }
}
