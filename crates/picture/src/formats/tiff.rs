//! TIFF, 8 or 16 bits or floats. Both sides are 32-bit numbers; a picture of the most pixels stays below its 4 GiB.

use image::codecs::tiff::TiffEncoder;
use image::{ExtendedColorType, ImageEncoder, ImageFormat};

use super::{Depth, Row, Sink, Way};
use crate::levels::{bytes8, bytes16, bytes32};
use crate::load::decode;
use crate::{EncodeError, Encoding, Picture};

pub(super) const ROW: Row = Row {
    name: "tiff",
    extensions: &["tiff", "tif"],
    depths: &[Depth::Eight, Depth::Sixteen, Depth::Float],
    lossless: true,
    max_side: u32::MAX,
    write: Way::Whole(write),
    read: |from| decode(from, ImageFormat::Tiff),
};

fn write(picture: &Picture, encoding: &Encoding, out: &mut dyn Sink) -> Result<(), EncodeError> {
    let (bytes, colour) = match encoding.depth() {
        Depth::Eight => (bytes8(picture, encoding.transfer)?, ExtendedColorType::Rgb8),
        Depth::Sixteen => (bytes16(picture, encoding.transfer)?, ExtendedColorType::Rgb16),
        Depth::Float => (bytes32(picture)?, ExtendedColorType::Rgb32F),
    };
    TiffEncoder::new(out).write_image(&bytes, picture.width(), picture.height(), colour)?;
    Ok(())
}
