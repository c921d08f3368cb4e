//! PNG, 8 or 16 bits. Both sides are 31-bit numbers in its header.

use image::codecs::png::PngEncoder;
use image::{ExtendedColorType, ImageEncoder, ImageFormat};

use super::{Depth, Row, Sink, Way};
use crate::levels::{bytes8, bytes16};
use crate::load::decode;
use crate::{EncodeError, Encoding, Picture};

pub(super) const ROW: Row = Row {
    name: "png",
    extensions: &["png"],
    depths: &[Depth::Eight, Depth::Sixteen],
    lossless: true,
    max_side: i32::MAX as u32,
    write: Way::Whole(write),
    read: |from| decode(from, ImageFormat::Png),
};

fn write(picture: &Picture, encoding: &Encoding, out: &mut dyn Sink) -> Result<(), EncodeError> {
    let (bytes, colour) = match encoding.depth() {
        Depth::Sixteen => (bytes16(picture, encoding.transfer)?, ExtendedColorType::Rgb16),
        Depth::Eight | Depth::Float => (bytes8(picture, encoding.transfer)?, ExtendedColorType::Rgb8),
    };
    PngEncoder::new(out).write_image(&bytes, picture.width(), picture.height(), colour)?;
    Ok(())
}
