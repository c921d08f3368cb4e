//! Truevision TGA. Both sides are 16-bit numbers in its header.

use image::codecs::tga::TgaEncoder;
use image::{ExtendedColorType, ImageEncoder, ImageFormat};

use super::{Depth, Row, Sink, Way};
use crate::levels::bytes8;
use crate::load::decode;
use crate::{EncodeError, Encoding, Picture};

pub(super) const ROW: Row = Row {
    name: "tga",
    extensions: &["tga"],
    depths: &[Depth::Eight],
    lossless: true,
    max_side: 65_535,
    write: Way::Whole(write),
    read: |from| decode(from, ImageFormat::Tga),
};

fn write(picture: &Picture, encoding: &Encoding, out: &mut dyn Sink) -> Result<(), EncodeError> {
    let bytes = bytes8(picture, encoding.transfer)?;
    TgaEncoder::new(out).write_image(&bytes, picture.width(), picture.height(), ExtendedColorType::Rgb8)?;
    Ok(())
}
