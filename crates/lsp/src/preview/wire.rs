//! How two processes talk: a length, a header of JSON, a payload of bytes.
//!
//! | bytes | what |
//! |---|---|
//! | 4 | [`MARK`] |
//! | 4 | bytes of the header, little-endian |
//! | 4 | bytes of the payload, little-endian |
//! | .. | the header: one order or one answer as JSON |
//! | .. | the payload: a scene's text, a picture |
//!
//! It knows nothing of what is said. What comes in is believed only as far as its bounds allow.

use std::fmt;
use std::io::{self, Read, Write};

use serde::Serialize;
use serde::de::DeserializeOwned;

/// Which words are spoken; counted up when their meaning changes.
pub const PROTOCOL: u32 = 1;
/// What every message begins with: anything else on the line is noticed at once.
const MARK: [u8; 4] = *b"scn1";
/// The longest header.
const MAX_HEADER: u32 = 1 << 20;
/// The longest payload.
pub const MAX_PAYLOAD: u32 = 1 << 30;

/// Why a message can't be passed on or understood.
#[derive(Debug)]
pub enum WireError {
    /// The other side, or the line, is gone.
    Io(io::Error),
    /// What came is no message, or what is to be sent is none; the words say why.
    Broken(String),
}

impl fmt::Display for WireError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Io(error) => error.fmt(f),
            Self::Broken(why) => f.write_str(why),
        }
    }
}

impl std::error::Error for WireError {}

impl From<io::Error> for WireError {
    fn from(error: io::Error) -> Self {
        Self::Io(error)
    }
}

/// Writes one message and sends it off.
///
/// # Errors
/// `Broken` before the first byte if the message is beyond the bounds, `Io` if the line fails.
pub fn send(out: &mut impl Write, header: &impl Serialize, payload: &[u8]) -> Result<(), WireError> {
    let header = serde_json::to_vec(header).map_err(|error| WireError::Broken(error.to_string()))?;
    let header_length = bounded(header.len(), MAX_HEADER, "header")?;
    let payload_length = bounded(payload.len(), MAX_PAYLOAD, "payload")?;
    let mut head = Vec::with_capacity(12 + header.len());
    head.extend_from_slice(&MARK);
    head.extend_from_slice(&header_length.to_le_bytes());
    head.extend_from_slice(&payload_length.to_le_bytes());
    head.extend_from_slice(&header);
    out.write_all(&head)?;
    out.write_all(payload)?;
    Ok(out.flush()?)
}

fn bounded(length: usize, most: u32, what: &str) -> Result<u32, WireError> {
    let fits = u32::try_from(length).ok().filter(|length| *length <= most);
    fits.ok_or_else(|| WireError::Broken(format!("a {what} of {length} bytes is longer than {most}")))
}

/// Reads the next message; `None` where the line ends between two messages.
///
/// # Errors
/// `Broken` for what is no message, `Io` if the line fails or ends inside one.
pub fn receive<T: DeserializeOwned>(from: &mut impl Read) -> Result<Option<(T, Vec<u8>)>, WireError> {
    let mut head = [0; 12];
    // Told apart by the first byte: the end between two messages, and the end inside one.
    if !first_byte(from, &mut head)? {
        return Ok(None);
    }
    from.read_exact(&mut head[1..])?;
    let [a, b, c, d, rest @ ..] = head;
    if [a, b, c, d] != MARK {
        return Err(WireError::Broken(format!(
            "{:02x?} is no beginning of a message",
            [a, b, c, d]
        )));
    }
    let [a, b, c, d, e, f, g, h] = rest;
    let header = exactly(from, u32::from_le_bytes([a, b, c, d]), MAX_HEADER, "header")?;
    let payload = exactly(from, u32::from_le_bytes([e, f, g, h]), MAX_PAYLOAD, "payload")?;
    let header = serde_json::from_slice(&header).map_err(|error| WireError::Broken(error.to_string()))?;
    Ok(Some((header, payload)))
}

fn first_byte(from: &mut impl Read, head: &mut [u8; 12]) -> Result<bool, WireError> {
    loop {
        match from.read(&mut head[..1]) {
            Ok(count) => return Ok(count == 1),
            Err(error) if error.kind() == io::ErrorKind::Interrupted => {}
            Err(error) => return Err(error.into()),
        }
    }
}

/// So many bytes. Memory grows with what really comes, not with what was announced.
fn exactly(from: &mut impl Read, length: u32, most: u32, what: &str) -> Result<Vec<u8>, WireError> {
    bounded(length as usize, most, what)?;
    let mut bytes = Vec::new();
    from.take(length.into()).read_to_end(&mut bytes)?;
    if bytes.len() == length as usize {
        Ok(bytes)
    } else {
        Err(io::Error::from(io::ErrorKind::UnexpectedEof).into())
    }
}

#[cfg(test)]
mod tests {
    use std::io::Cursor;

    use super::{MARK, WireError, receive, send};

    /// `expect` is what is read, or a part of the error.
    fn check(bytes: &[u8], expect: Result<Option<(&str, &[u8])>, &str>) {
        let got = receive::<String>(&mut Cursor::new(bytes));
        match (got, expect) {
            (Ok(got), Ok(expect)) => {
                let got = got
                    .as_ref()
                    .map(|(header, payload)| (header.as_str(), payload.as_slice()));
                assert_eq!(got, expect, "{bytes:?}");
            }
            (Err(error), Err(part)) => assert!(error.to_string().contains(part), "{bytes:?}: {error}"),
            (got, expect) => panic!("{bytes:?}: {got:?} instead of {expect:?}"),
        }
    }

    fn message(header: u32, payload: u32, rest: &[u8]) -> Vec<u8> {
        [&MARK, header.to_le_bytes().as_slice(), &payload.to_le_bytes(), rest].concat()
    }

    #[test]
    fn what_is_sent_is_received() {
        let mut line = Vec::new();
        send(&mut line, &"draw", b"text").unwrap();
        send(&mut line, &"", b"").unwrap();
        check(&line, Ok(Some(("draw", b"text"))));
        let mut line = Cursor::new(line);
        for expect in [
            Some(("draw".to_owned(), b"text".to_vec())),
            Some((String::new(), Vec::new())),
            None,
        ] {
            assert_eq!(receive::<String>(&mut line).unwrap(), expect);
        }
    }

    #[test]
    fn a_line_that_ends_inside_a_message_is_an_error() {
        let mut whole = Vec::new();
        send(&mut whole, &"draw", b"text").unwrap();
        check(b"", Ok(None));
        for length in 1..whole.len() {
            let error = receive::<String>(&mut Cursor::new(&whole[..length])).unwrap_err();
            assert!(matches!(error, WireError::Io(_)), "{length} bytes: {error}");
        }
    }

    #[test]
    fn garbage_and_giants_are_refused_before_memory_is_taken() {
        check(b"hello, worker", Err("no beginning of a message"));
        check(
            &message(u32::MAX, 0, b""),
            Err("a header of 4294967295 bytes is longer"),
        );
        check(
            &message(2, u32::MAX, b"\"\""),
            Err("a payload of 4294967295 bytes is longer"),
        );
        check(&message(2, 1 << 30, b"\"\"abc"), Err(""));
        check(&message(2, 0, b"{]"), Err("expected"));
        check(&message(2, 0, b"\xFF\xFF"), Err("expected value"));
        check(&message(0, 0, b""), Err("EOF"));
        let long = "x".repeat(1 << 20);
        assert!(send(&mut Vec::new(), &long, b"").is_err());
    }
}
