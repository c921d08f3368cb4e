//! Bare numbers: 32-bit floats, the lower byte first, red green blue, rows from the top, no header.

use super::{Depth, Row, Sink, write_floats};
use crate::{EncodeError, Encoding, LoadError, Picture};

pub(super) const ROW: Row = Row {
    name: "raw",
    extensions: &["raw"],
    depths: &[Depth::Float],
    lossless: true,
    max_side: u32::MAX,
    write,
    read: |_| {
        Err(LoadError::Broken(
            "raw numbers do not say how many columns they are".to_owned(),
        ))
    },
};

fn write(picture: &Picture, _: &Encoding, out: &mut dyn Sink) -> Result<(), EncodeError> {
    write_floats(picture, 0..picture.height(), out)
}
