//! How wide the columns of like statements are.

use super::cells::{Cell, cells};
use crate::{Content, Line};

/// The most words of a statement: a material's name, its operator and ten values.
const MOST: usize = 12;

/// A word wider than this has no say in how wide its column is, so that one long name can't blow up a large file.
const WIDEST: usize = 32;

/// The widths of the columns; all 0, as by default, for a line that stands alone.
#[derive(Default)]
pub(super) struct Columns([Column; MOST]);

#[derive(Clone, Copy, Default)]
struct Column {
    /// The most characters of a number before its point, a sign included.
    head: usize,
    /// The most characters of a number from its point on.
    tail: usize,
    /// The most characters of any other word.
    word: usize,
}

/// Spaces around a word.
pub(super) struct Padding {
    pub(super) before: usize,
    pub(super) after: usize,
}

impl Columns {
    /// The columns of lines that hold statements of one form.
    pub(super) fn of(text: &str, lines: &[Line]) -> Self {
        let mut columns = Self::default();
        for line in lines {
            let Content::Statement(statement) = &line.content else {
                continue;
            };
            let mut rest = columns.0.iter_mut();
            cells(text, statement, |cell| {
                if let Some(column) = rest.next() {
                    column.take(&cell);
                }
            });
        }
        columns
    }

    /// What stands around a word of the column at `index`.
    pub(super) fn padding(&self, index: usize, cell: &Cell) -> Padding {
        let column = self.0.get(index).copied().unwrap_or_default();
        let whole = column.word.max(column.head + column.tail);
        // Alone on its line a word needs no measure.
        if whole == 0 {
            return Padding { before: 0, after: 0 };
        }
        let (head, tail) = measure(cell);
        let before = if cell.number {
            column.head.saturating_sub(head)
        } else {
            0
        };
        let after = whole.saturating_sub(before + head + tail);
        Padding { before, after }
    }
}

impl Column {
    fn take(&mut self, cell: &Cell) {
        let (head, tail) = measure(cell);
        if head + tail > WIDEST {
            return;
        }
        if cell.number {
            self.head = self.head.max(head);
            self.tail = self.tail.max(tail);
        } else {
            self.word = self.word.max(head);
        }
    }
}

/// Characters before the point of a number and from it on; of any other word, all and none.
fn measure(cell: &Cell) -> (usize, usize) {
    let head = match cell.word.split_once('.') {
        Some((whole, _)) if cell.number => whole,
        _ => cell.word,
    };
    let all = cell.word.chars().count();
    let head = head.chars().count();
    (cell.prefix.len() + head, all - head)
}
