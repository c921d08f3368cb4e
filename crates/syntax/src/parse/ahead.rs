//! Reading a large file on threads of its own.

use std::num::NonZeroUsize;
use std::sync::mpsc::sync_channel;
use std::thread;

use scenec_text::{Diagnostic, SourceFile, Span};

use super::Lines;
use crate::Line;
use crate::token::Scanner;

/// Files of fewer bytes are read before a thread has come to life.
const LARGE: u32 = 1 << 22;

/// A piece of a file: the lines that begin within so many bytes. How many pieces of each thread may wait.
const PIECE: u32 = 1 << 17;
const WAITING: usize = 2;

/// Room is made for a line in about so many bytes.
const LINE: u32 = 16;

/// More threads would wait for whoever takes the lines.
const THREADS: usize = 4;

/// Hands the lines of a file to `take`, as [`Lines`] reads them, a piece at once; those of a large file are read ahead meanwhile,
/// a bounded number of them, on several threads. Gives what was found on them.
pub fn read_ahead(source: &SourceFile, mut take: impl FnMut(Vec<Line>)) -> Vec<Diagnostic> {
    let bytes = source.text().len() as u32;
    let pieces = bytes.div_ceil(PIECE);
    let threads = match bytes {
        LARGE.. => thread::available_parallelism()
            .map_or(1, NonZeroUsize::get)
            .min(THREADS),
        _ => 0,
    };
    let mut findings = Vec::new();
    let mut piece = |(lines, found): (Vec<Line>, Vec<Diagnostic>)| {
        take(lines);
        findings.extend(found);
    };
    thread::scope(|scope| {
        // Pieces are dealt out by turns, and asked for by turns.
        let readers: Vec<_> = (0..threads)
            .map(|first| {
                let (give, given) = sync_channel(WAITING);
                scope.spawn(move || {
                    let mut own = (first as u32..pieces).step_by(threads);
                    own.try_for_each(|number| give.send(read(source, number)))
                });
                given
            })
            .collect();
        for number in 0..pieces {
            match readers.get(number as usize % threads.max(1)) {
                None => piece(read(source, number)),
                // One that panicked gives no more; the scope passes that on.
                Some(reader) => reader.iter().take(1).for_each(&mut piece),
            }
        }
    });
    findings
}

/// The lines of a piece and what was found on them.
fn read(source: &SourceFile, number: u32) -> (Vec<Line>, Vec<Diagnostic>) {
    let [first, next] = [number, number + 1].map(|piece| line_from(source, piece.saturating_mul(PIECE)));
    let [start, end] = [first, next].map(|line| {
        let span = source.line_span(line);
        span.map_or(source.text().len() as u32, |span| span.start)
    });
    let mut lines = Lines::of(source, Scanner::within(source.text(), Span::new(start, end)));
    let mut all = Vec::with_capacity((next - first).min(PIECE / LINE) as usize);
    all.extend(&mut lines);
    (all, lines.findings())
}

/// The number of the first line that begins at an offset or behind it.
fn line_from(source: &SourceFile, offset: u32) -> u32 {
    offset.checked_sub(1).map_or(0, |before| source.line_of(before) + 1)
}

#[cfg(test)]
mod tests {
    use scenec_text::SourceFile;

    use super::{LARGE, PIECE, read_ahead};
    use crate::parse;

    fn check(text: &str) {
        let source = SourceFile::new("t", text).unwrap();
        let mut lines = Vec::new();
        let findings = read_ahead(&source, |piece| lines.extend(piece));
        assert!((lines, findings) == parse(&source));
    }

    #[test]
    fn lines_read_ahead_are_the_same() {
        check("");
        check("a := 1\nb :=\n");
        check(&"a := 1 / one\n\n!b := $\n".repeat(LARGE as usize / 20));
    }

    /// The end of a piece in every place of a line, and pieces in which none begins.
    #[test]
    fn pieces_begin_where_lines_do() {
        let line = "é := 1 / one\r\n";
        for before in 0..line.len() {
            let blank = " ".repeat(PIECE as usize - before);
            check(&format!("\u{FEFF}{blank}{line}{line}{blank}{blank}{blank}{line}\n$"));
        }
    }
}
