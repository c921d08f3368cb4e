//! QOI, "quite OK": lossless and quick. Both sides are 32-bit numbers in its header.

use image::codecs::qoi::QoiEncoder;
use image::{ExtendedColorType, ImageEncoder, ImageFormat};

use super::{Depth, Row, Sink, Way};
use crate::levels::bytes8;
use crate::load::decode;
use crate::{EncodeError, Encoding, Picture};

pub(super) const ROW: Row = Row {
    name: "qoi",
    extensions: &["qoi"],
    depths: &[Depth::Eight],
    lossless: true,
    max_side: u32::MAX,
    write: Way::Whole(write),
    read: |from| decode(from, ImageFormat::Qoi),
};

fn write(picture: &Picture, encoding: &Encoding, out: &mut dyn Sink) -> Result<(), EncodeError> {
    let bytes = bytes8(picture, encoding.transfer)?;
    QoiEncoder::new(out).write_image(&bytes, picture.width(), picture.height(), ExtendedColorType::Rgb8)?;
    Ok(())
}
