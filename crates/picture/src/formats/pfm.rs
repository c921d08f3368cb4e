//! PFM, the portable float map: a text header, then 32-bit floats, rows from the bottom.

use std::io::SeekFrom;

use super::{Depth, Place, Row, Sink, Size, Source, Way, write_floats};
use crate::{EncodeError, Encoding, LoadError, Picture};

pub(super) const ROW: Row = Row {
    name: "pfm",
    extensions: &["pfm"],
    depths: &[Depth::Float],
    lossless: true,
    max_side: u32::MAX,
    write: Way::Bands { head, band },
    read,
};

fn head(whole: Size, _: &Encoding, out: &mut dyn Sink) -> Result<(), EncodeError> {
    out.write_all(words(whole).as_bytes())?;
    Ok(())
}

/// The header. A negative scale says that the lower byte comes first.
fn words(whole: Size) -> String {
    format!("PF\n{} {}\n-1.0\n", whole.width, whole.height)
}

/// The first rows of a picture are the last of the file.
fn band(picture: &Picture, place: Place, _: &Encoding, out: &mut dyn Sink) -> Result<(), EncodeError> {
    let below = place.whole.height - place.first_row - picture.height();
    let start = words(place.whole).len() as u64 + u64::from(below) * u64::from(place.whole.width) * 12;
    if start != out.stream_position()? {
        out.seek(SeekFrom::Start(start))?;
    }
    write_floats(picture, (0..picture.height()).rev(), out)
}

fn read(from: &mut dyn Source) -> Result<Picture, LoadError> {
    if word(from)? != "PF" {
        return Err(broken("it does not begin with PF, the sign of a colour map"));
    }
    let mut side = || word(from)?.parse().map_err(|_| broken("a side is not a whole number"));
    let (width, height): (u32, u32) = (side()?, side()?);
    let scale: f32 = word(from)?.parse().map_err(|_| broken("the scale is not a number"))?;
    if width == 0 || height == 0 || scale == 0.0 {
        return Err(broken("a side or the scale is 0"));
    }
    let value = if scale < 0.0 {
        f32::from_le_bytes
    } else {
        f32::from_be_bytes
    };
    let mut picture = Picture::black(width, height)?;
    let mut bytes = [0; 12];
    for row in picture.pixels_mut().chunks_mut(width as usize).rev() {
        for pixel in row {
            from.read_exact(&mut bytes)?;
            let [r, g, b] = [0, 4, 8].map(|at| [bytes[at], bytes[at + 1], bytes[at + 2], bytes[at + 3]]);
            *pixel = [value(r), value(g), value(b)];
        }
    }
    Ok(picture)
}

/// The next word of the header and the one white space after it; nothing in it is as long as 40 bytes.
fn word(from: &mut dyn Source) -> Result<String, LoadError> {
    let mut word = String::new();
    while word.len() < 40 {
        let mut byte = [0];
        from.read_exact(&mut byte)?;
        match byte[0] {
            space if space.is_ascii_whitespace() && !word.is_empty() => return Ok(word),
            space if space.is_ascii_whitespace() => {}
            letter => word.push(char::from(letter)),
        }
    }
    Err(broken("its header is too long"))
}

fn broken(how: &str) -> LoadError {
    LoadError::Broken(format!("not a picture in PFM: {how}"))
}

#[cfg(test)]
mod tests {
    use std::io::Cursor;

    use crate::{Encoding, Format, Picture, encode};

    fn check(file: &[u8], expect: &[[f32; 3]]) {
        let format = Format::from_name("pfm").unwrap();
        assert_eq!(format.read(&mut Cursor::new(file)).unwrap().pixels(), expect);
    }

    #[test]
    fn rows_stand_from_the_bottom_and_the_lower_byte_first() {
        let mut picture = Picture::black(1, 2).unwrap();
        picture.pixels_mut()[0] = [1.0, 2.0, 3.0];
        let mut out = Cursor::new(Vec::new());
        encode(&picture, &Encoding::of(Format::from_name("pfm").unwrap()), &mut out).unwrap();
        let file = out.into_inner();
        assert!(file.starts_with(b"PF\n1 2\n-1.0\n"));
        assert_eq!(file[12..24], [0; 12]);
        assert_eq!(file[24..28], [0, 0, 0x80, 0x3F]);
        check(&file, &[[1.0, 2.0, 3.0], [0.0; 3]]);
    }

    #[test]
    fn the_upper_byte_may_come_first() {
        check(b"PF 1 1 1.0\n\x3F\x80\0\0\x40\0\0\0\0\0\0\0", &[[1.0, 2.0, 0.0]]);
    }
}
