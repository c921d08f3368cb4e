//! Windows bitmap. Both sides are signed 32-bit numbers in its header.

use image::codecs::bmp::BmpEncoder;
use image::{ExtendedColorType, ImageEncoder, ImageFormat};

use super::{Depth, Row, Sink, Way};
use crate::levels::bytes8;
use crate::load::decode;
use crate::{EncodeError, Encoding, Picture};

pub(super) const ROW: Row = Row {
    name: "bmp",
    extensions: &["bmp"],
    depths: &[Depth::Eight],
    lossless: true,
    max_side: i32::MAX as u32,
    write: Way::Whole(write),
    read: |from| decode(from, ImageFormat::Bmp),
};

fn write(picture: &Picture, encoding: &Encoding, mut out: &mut dyn Sink) -> Result<(), EncodeError> {
    let bytes = bytes8(picture, encoding.transfer)?;
    BmpEncoder::new(&mut out).write_image(&bytes, picture.width(), picture.height(), ExtendedColorType::Rgb8)?;
    Ok(())
}
