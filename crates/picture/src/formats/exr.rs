//! OpenEXR, 32-bit floats. Both sides are signed 32-bit numbers in its header.

use image::codecs::openexr::OpenExrEncoder;
use image::{ExtendedColorType, ImageEncoder, ImageFormat};

use super::{Depth, Row, Sink, Way};
use crate::levels::bytes32;
use crate::load::decode;
use crate::{EncodeError, Encoding, Picture};

pub(super) const ROW: Row = Row {
    name: "exr",
    extensions: &["exr"],
    depths: &[Depth::Float],
    lossless: true,
    max_side: i32::MAX as u32,
    write: Way::Whole(write),
    read: |from| decode(from, ImageFormat::OpenExr),
};

fn write(picture: &Picture, _: &Encoding, out: &mut dyn Sink) -> Result<(), EncodeError> {
    let bytes = bytes32(picture)?;
    OpenExrEncoder::new(out).write_image(&bytes, picture.width(), picture.height(), ExtendedColorType::Rgb32F)?;
    Ok(())
}
