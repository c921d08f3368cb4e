//! Bare numbers: 32-bit floats, the lower byte first, red green blue, rows from the top, no header.

use super::{Depth, Place, Row, Sink, Size, Way, write_floats};
use crate::{EncodeError, Encoding, LoadError, Picture};

pub(super) const ROW: Row = Row {
    name: "raw",
    extensions: &["raw"],
    depths: &[Depth::Float],
    lossless: true,
    max_side: u32::MAX,
    write: Way::Bands { head, band },
    read: |_| {
        Err(LoadError::Broken(
            "raw numbers do not say how many columns they are".to_owned(),
        ))
    },
};

fn head(_: Size, _: &Encoding, _: &mut dyn Sink) -> Result<(), EncodeError> {
    Ok(())
}

fn band(picture: &Picture, _: Place, _: &Encoding, out: &mut dyn Sink) -> Result<(), EncodeError> {
    write_floats(picture, 0..picture.height(), out)
}
