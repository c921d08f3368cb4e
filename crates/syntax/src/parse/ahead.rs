//! Reading a large file on a thread of its own.

use std::sync::mpsc::sync_channel;
use std::thread;

use scenec_text::{Diagnostic, SourceFile};

use super::Lines;
use crate::Line;

/// Files of fewer bytes are read before a thread has come to life.
const LARGE: usize = 1 << 22;

/// How many lines are handed over at once, and how many times that many may wait.
const BATCH: usize = 4096;
const WAITING: usize = 4;

/// Hands the lines of a file to `take`, as [`Lines`] reads them, some thousands at once; those of a large file are read ahead
/// meanwhile, a bounded number of them. Gives what was found on them.
pub fn read_ahead(source: &SourceFile, mut take: impl FnMut(Vec<Line>)) -> Vec<Diagnostic> {
    let mut lines = Lines::new(source);
    if source.text().len() < LARGE {
        while let Some(batch) = batch(&mut lines) {
            take(batch);
        }
        return lines.findings();
    }
    thread::scope(|scope| {
        let (give, given) = sync_channel(WAITING);
        let reader = scope.spawn(move || {
            while let Some(batch) = batch(&mut lines) {
                if give.send(batch).is_err() {
                    break;
                }
            }
            lines.findings()
        });
        given.into_iter().for_each(take);
        reader.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic))
    })
}

/// The next lines, if there are any.
fn batch(lines: &mut Lines<'_>) -> Option<Vec<Line>> {
    let batch: Vec<Line> = lines.take(BATCH).collect();
    Some(batch).filter(|batch| !batch.is_empty())
}

#[cfg(test)]
mod tests {
    use scenec_text::SourceFile;

    use super::{LARGE, read_ahead};
    use crate::parse;

    fn check(text: &str) {
        let source = SourceFile::new("t", text).unwrap();
        let mut lines = Vec::new();
        let findings = read_ahead(&source, |batch| lines.extend(batch));
        assert!((lines, findings) == parse(&source));
    }

    #[test]
    fn lines_read_ahead_are_the_same() {
        check("");
        check("a := 1\nb :=\n");
        check(&"a := 1 / one\n\n!b := $\n".repeat(LARGE / 20));
    }
}
