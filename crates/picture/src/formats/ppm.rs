//! Netpbm's PPM, binary, 8 or 16 bits. Its header is text, so the sides have no limit of their own.

use image::ImageFormat;

use super::{Depth, Place, Row, Sink, Size, Way};
use crate::levels::level;
use crate::load::decode;
use crate::{EncodeError, Encoding, Picture};

pub(super) const ROW: Row = Row {
    name: "ppm",
    extensions: &["ppm"],
    depths: &[Depth::Eight, Depth::Sixteen],
    lossless: true,
    max_side: u32::MAX,
    write: Way::Bands { head, band },
    read: |from| decode(from, ImageFormat::Pnm),
};

/// The level of a component of 1.
fn top(encoding: &Encoding) -> u16 {
    match encoding.depth() {
        Depth::Sixteen => u16::MAX,
        Depth::Eight | Depth::Float => 255,
    }
}

fn head(whole: Size, encoding: &Encoding, out: &mut dyn Sink) -> Result<(), EncodeError> {
    write!(out, "P6\n{} {}\n{}\n", whole.width, whole.height, top(encoding))?;
    Ok(())
}

fn band(picture: &Picture, _: Place, encoding: &Encoding, out: &mut dyn Sink) -> Result<(), EncodeError> {
    let top = top(encoding);
    let mut line = Vec::new();
    for row in 0..picture.height() {
        line.clear();
        for &value in picture.row(row).as_flattened() {
            let level = level(value, encoding.transfer, top);
            // The upper byte first, as Netpbm says; at 8 bits the lower one is all there is.
            let [upper, lower] = level.to_be_bytes();
            if top > 255 {
                line.push(upper);
            }
            line.push(lower);
        }
        out.write_all(&line)?;
    }
    Ok(())
}
