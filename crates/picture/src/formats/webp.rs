//! WebP in its lossless mode. Readers take at most 16383 pixels a side (14 bits in the header, one value kept back).

use image::codecs::webp::WebPEncoder;
use image::{ExtendedColorType, ImageEncoder, ImageFormat};

use super::{Depth, Row, Sink, Way};
use crate::levels::bytes8;
use crate::load::decode;
use crate::{EncodeError, Encoding, Picture};

pub(super) const ROW: Row = Row {
    name: "webp",
    extensions: &["webp"],
    depths: &[Depth::Eight],
    lossless: true,
    max_side: 16_383,
    write: Way::Whole(write),
    read: |from| decode(from, ImageFormat::WebP),
};

fn write(picture: &Picture, encoding: &Encoding, out: &mut dyn Sink) -> Result<(), EncodeError> {
    let bytes = bytes8(picture, encoding.transfer)?;
    WebPEncoder::new_lossless(out).write_image(&bytes, picture.width(), picture.height(), ExtendedColorType::Rgb8)?;
    Ok(())
}
