//! Reading a large file on a thread of its own.

use std::sync::mpsc::{Receiver, sync_channel};
use std::thread;

use scenec_text::{Diagnostic, SourceFile};

use super::Lines;
use crate::Line;

/// Files of fewer bytes are read before a thread has come to life.
const LARGE: usize = 1 << 22;

/// How many lines are handed over at once, and how many times that many may wait.
const BATCH: usize = 4096;
const WAITING: usize = 4;

/// Hands the lines of a file to `work`, as [`Lines`] reads them; those of a large file are read ahead meanwhile, a bounded
/// number of them. Gives what `work` makes of them, and the findings; if it leaves lines unread, those are not read.
pub fn read_ahead<R>(
    source: &SourceFile,
    work: impl FnOnce(&mut dyn Iterator<Item = Line>) -> R,
) -> (R, Vec<Diagnostic>) {
    if source.text().len() < LARGE {
        let mut lines = Lines::new(source);
        let made = work(&mut lines);
        return (made, lines.findings());
    }
    thread::scope(|scope| {
        let (give, take) = sync_channel(WAITING);
        let reader = scope.spawn(move || {
            let mut lines = Lines::new(source);
            loop {
                let batch: Vec<Line> = lines.by_ref().take(BATCH).collect();
                if batch.is_empty() || give.send(batch).is_err() {
                    return lines.findings();
                }
            }
        });
        let made = work(&mut handed(take));
        let findings = reader.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic));
        (made, findings)
    })
}

fn handed(batches: Receiver<Vec<Line>>) -> impl Iterator<Item = Line> {
    batches.into_iter().flatten()
}

#[cfg(test)]
mod tests {
    use scenec_text::SourceFile;

    use super::{LARGE, read_ahead};
    use crate::parse;

    fn check(text: &str) {
        let source = SourceFile::new("t", text).unwrap();
        let (lines, findings) = read_ahead(&source, |lines| lines.collect::<Vec<_>>());
        assert!((lines, findings) == parse(&source));
        // Whoever has enough is not kept waiting.
        let (first, _) = read_ahead(&source, |lines| lines.next());
        assert_eq!(first, parse(&source).0.into_iter().next());
    }

    #[test]
    fn lines_read_ahead_are_the_same() {
        check("");
        check("a := 1\nb :=\n");
        check(&"a := 1 / one\n\n!b := $\n".repeat(LARGE / 20));
    }
}
