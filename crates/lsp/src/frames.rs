//! Messages as they travel: a header that tells the length of the body, and the body.
//!
//! Whatever stands between two frames is passed over, so a stream that went wrong finds its way back at the next header.
//! It must not know what a body says.

use std::io::{self, BufRead, Read};

/// The largest body that is taken; what promises more is no header.
const MAX_BODY: u64 = 256 << 20;
/// How much of a line is looked at, from its end: a header may follow a broken body without a line feed between.
const MAX_LINE: usize = 4096;
/// The one header that matters.
const LENGTH: &[u8] = b"content-length:";

/// Reads up to the end of the next body; `None` where the stream ends. Headers may be written in any case, in any
/// order, among others, and end in LF or CRLF.
///
/// # Errors
/// What the stream reports.
pub(crate) fn read_frame(stream: &mut impl BufRead) -> io::Result<Option<Vec<u8>>> {
    let mut length = None;
    loop {
        let Some(line) = read_line(stream)? else {
            return Ok(None);
        };
        if let Some(found) = length_in(&line) {
            length = Some(found).filter(|length| *length <= MAX_BODY);
        } else if let (true, Some(length)) = (line.is_empty(), length) {
            return read_body(stream, length);
        }
    }
}

/// A frame around a body.
pub(crate) fn write_frame(body: &[u8]) -> Vec<u8> {
    let mut frame = format!("Content-Length: {}\r\n\r\n", body.len()).into_bytes();
    frame.extend_from_slice(body);
    frame
}

/// The next line without its end; only its last bytes if it is long.
fn read_line(stream: &mut impl BufRead) -> io::Result<Option<Vec<u8>>> {
    let mut line = Vec::new();
    loop {
        let before = line.len();
        let room = MAX_LINE as u64;
        let read = stream.by_ref().take(room).read_until(b'\n', &mut line)?;
        if read == 0 {
            return Ok(None);
        }
        if line.last() == Some(&b'\n') {
            line.pop();
            if line.last() == Some(&b'\r') {
                line.pop();
            }
            return Ok(Some(line));
        }
        // What was read a whole round ago is too far from the end to matter.
        line.drain(..before);
    }
}

/// What a line says of a length, if it does.
fn length_in(line: &[u8]) -> Option<u64> {
    let at = line
        .windows(LENGTH.len())
        .rposition(|window| window.eq_ignore_ascii_case(LENGTH))?;
    let value = std::str::from_utf8(line.get(at + LENGTH.len()..)?).ok()?;
    value.trim().parse().ok()
}

/// Reads a body. Memory is taken as the bytes arrive, whatever was promised.
fn read_body(stream: &mut impl BufRead, length: u64) -> io::Result<Option<Vec<u8>>> {
    let mut body = Vec::new();
    let read = stream.by_ref().take(length).read_to_end(&mut body)?;
    Ok((read as u64 == length).then_some(body))
}

#[cfg(test)]
mod tests {
    use std::io::BufReader;

    use super::{MAX_LINE, read_frame, write_frame};

    /// Which bodies are found, whatever the size of the reader's pieces.
    fn check(stream: &[u8], expect: &[&str]) {
        for piece in [1, 7, 8192] {
            let mut reader = BufReader::with_capacity(piece, stream);
            let mut found = Vec::new();
            while let Some(body) = read_frame(&mut reader).unwrap() {
                found.push(String::from_utf8_lossy(&body).into_owned());
            }
            assert_eq!(found, expect, "{:?}", String::from_utf8_lossy(stream));
        }
    }

    #[test]
    fn headers_come_in_many_shapes() {
        check(&write_frame(b"{}"), &["{}"]);
        check(b"content-length:2\r\n\r\n{}", &["{}"]);
        check(b"CONTENT-LENGTH:  2 \n\n{}", &["{}"]);
        check(
            b"X-A: b\r\nContent-Length: 2\r\nContent-Type: text/plain; charset=latin1\r\nX-C: d\r\n\r\n{}",
            &["{}"],
        );
        check(b"Content-Length: 0\r\n\r\nContent-Length: 1\r\n\r\nx", &["", "x"]);
    }

    #[test]
    fn a_stream_that_went_wrong_is_found_again() {
        let good = b"Content-Length: 2\r\n\r\n{}";
        let after = |bad: &[u8]| [bad, good].concat();
        check(&after(b"garbage"), &["{}"]);
        check(&after(b"\r\n\r\n\n"), &["{}"]);
        check(&after(b"Content-Length: many\r\n\r\n{\"a\":1}"), &["{}"]);
        check(&after(b"Content-Length: -4\r\n\r\n"), &["{}"]);
        check(&after(b"Content-Length: 99999999999999999999999\r\n\r\n{}"), &["{}"]);
        check(&after(b"Content-Length: 9999999999999\r\n\r\n{\"a\":1}"), &["{}"]);
        check(&after(b"Content-Length: 1\r\n\r\n{\"a\":1}"), &["{", "{}"]);
        check(&after(&vec![b'x'; 3 * MAX_LINE + 5]), &["{}"]);
    }

    #[test]
    fn a_stream_that_ends_early_gives_nothing_more() {
        check(b"", &[]);
        check(b"Content-Length: 5\r\n\r\nabc", &[]);
        check(b"Content-Length: 5", &[]);
    }
}
