//! Netpbm's PPM, binary, 8 or 16 bits. Its header is text, so the sides have no limit of their own.

use image::ImageFormat;

use super::{Depth, Row, Sink};
use crate::levels::level;
use crate::load::decode;
use crate::{EncodeError, Encoding, Picture};

pub(super) const ROW: Row = Row {
    name: "ppm",
    extensions: &["ppm"],
    depths: &[Depth::Eight, Depth::Sixteen],
    lossless: true,
    max_side: u32::MAX,
    write,
    read: |from| decode(from, ImageFormat::Pnm),
};

fn write(picture: &Picture, encoding: &Encoding, out: &mut dyn Sink) -> Result<(), EncodeError> {
    let top = match encoding.depth() {
        Depth::Sixteen => u16::MAX,
        Depth::Eight | Depth::Float => 255,
    };
    write!(out, "P6\n{} {}\n{top}\n", picture.width(), picture.height())?;
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
