//! The formatter: one canonical way to write the statements and comments of a file.
//!
//! Owns white space and line ends, and nothing else: words stay as written. It must not know what a name means.

mod cells;
mod columns;

use scenec_text::{SourceFile, Span};

use crate::{Content, Line};
use cells::{Cell, cells};
use columns::Columns;

/// What stands between a statement and the comment behind it.
const BEFORE_COMMENT: &str = "  ";

/// What the canonical way leaves open.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct FormatStyle {
    /// Whether like statements on lines that follow each other have their parts one below the other.
    pub align: bool,
}

/// Why a file is not formatted: a line fits no statement, or some bytes are not UTF-8.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Refused {
    /// The first such place.
    pub span: Span,
}

/// Writes out the lines that [`crate::parse`] made of `source`.
///
/// Statements and comments stay in their order, every word as it was written. One space separates the words of a
/// statement, a sign touches its value, a comment behind a statement stands two spaces away. Blank lines come one at a
/// time and never first or last. Every line ends as most lines of the source do. A byte-order mark is dropped.
///
/// # Errors
/// [`Refused`] where part of the source would be lost, since it could not be read.
pub fn format(source: &SourceFile, lines: &[Line], style: FormatStyle) -> Result<String, Refused> {
    if let Some(span) = unreadable(source, lines) {
        return Err(Refused { span });
    }
    let text = source.text();
    let mut writer = Writer {
        text,
        end: line_end(text),
        out: String::with_capacity(text.len() + 2),
        cells: Vec::new(),
    };
    let mut rest = lines;
    let mut before = None;
    while !rest.is_empty() {
        let count = if style.align { run(text, rest) } else { 1 };
        let (like, later) = rest.split_at(count);
        let columns = if count > 1 {
            Columns::of(text, like)
        } else {
            Columns::default()
        };
        for line in like {
            if before.is_some_and(|before| blank_between(text, before, line)) {
                writer.out.push_str(writer.end);
            }
            writer.line(line, &columns);
            before = Some(line);
        }
        rest = later;
    }
    Ok(writer.out)
}

/// The first place that has no meaning to keep.
fn unreadable(source: &SourceFile, lines: &[Line]) -> Option<Span> {
    let broken = lines.iter().find(|line| matches!(line.content, Content::Broken(_)));
    let hole = source.holes().first().copied();
    broken.map(|line| line.span).into_iter().chain(hole).min()
}

/// The line end that most lines have; LF where neither is ahead.
fn line_end(text: &str) -> &'static str {
    let crlf = text.matches("\r\n").count();
    let all = text.bytes().filter(|byte| *byte == b'\n').count();
    if crlf * 2 > all { "\r\n" } else { "\n" }
}

/// How many lines from the first on are like statements with nothing between them; at least one.
fn run(text: &str, lines: &[Line]) -> usize {
    let like = |pair: &&[Line]| match pair {
        [a, b] => form(a).is_some() && form(a) == form(b) && !blank_between(text, a, b),
        _ => false,
    };
    1 + lines.windows(2).take_while(like).count()
}

fn form(line: &Line) -> Option<crate::Form> {
    match &line.content {
        Content::Statement(statement) => Some(statement.form()),
        Content::Comment | Content::Broken(_) => None,
    }
}

fn blank_between(text: &str, before: &Line, after: &Line) -> bool {
    let end = before.comment.unwrap_or(before.span).end;
    let between = Span::new(end, after.span.start).of(text);
    between.bytes().filter(|byte| *byte == b'\n').nth(1).is_some()
}

struct Writer<'a> {
    text: &'a str,
    end: &'static str,
    out: String,
    /// The parts of the statement at hand; kept so that not every line needs room of its own.
    cells: Vec<Cell<'a>>,
}

impl Writer<'_> {
    fn line(&mut self, line: &Line, columns: &Columns) {
        let comment = line.comment.map(|comment| comment.of(self.text).trim_end());
        if let Content::Statement(statement) = &line.content {
            self.cells.clear();
            cells(self.text, statement, |cell| self.cells.push(cell));
            for (index, cell) in self.cells.iter().enumerate() {
                if index > 0 {
                    self.out.push(' ');
                }
                let last = index + 1 == self.cells.len();
                let padding = columns.padding(index, cell);
                self.out.extend(std::iter::repeat_n(' ', padding.before));
                self.out.push_str(cell.prefix);
                self.out.push_str(cell.word);
                if !last || comment.is_some() {
                    self.out.extend(std::iter::repeat_n(' ', padding.after));
                }
            }
            if comment.is_some() {
                self.out.push_str(BEFORE_COMMENT);
            }
        }
        self.out.push_str(comment.unwrap_or_default());
        self.out.push_str(self.end);
    }
}
