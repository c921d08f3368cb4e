//! Runs of lines that belong together.

use scenec_syntax::{Content, Line, Space};

use crate::Document;
use crate::names::{statement, subject};

/// What a run of lines holds.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum FoldKind {
    /// Comments.
    Comment,
    /// Statements.
    Statements,
}

/// A run of at least two lines, counted from 0.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Fold {
    /// The first line.
    pub first_line: u32,
    /// The last line.
    pub last_line: u32,
    /// What the lines hold.
    pub kind: FoldKind,
}

/// Every run of comments, of statements about one object, and of variables, materials or lights, on lines that follow
/// each other; in the order of the file. No two share a line.
#[must_use]
pub fn folds(document: &Document) -> Vec<Fold> {
    let mut folds = Vec::new();
    let mut open: Option<(Fold, Topic<'_>)> = None;
    for line in document.lines() {
        let number = line_number(document, line);
        let topic = topic(document.text(), line);
        if let (Some((fold, same)), Some(topic)) = (&mut open, topic)
            && *same == topic
            && fold.last_line + 1 == number
        {
            fold.last_line = number;
            continue;
        }
        folds.extend(open.take().map(|(fold, _)| fold));
        open = topic.map(|topic| (begin(number, topic), topic));
    }
    folds.extend(open.map(|(fold, _)| fold));
    folds.retain(|fold| fold.first_line < fold.last_line);
    folds
}

/// What a line is about: lines of one topic fold together.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Topic<'a> {
    Comment,
    Object(&'a str),
    Other(Space),
}

fn topic<'a>(text: &'a str, line: &Line) -> Option<Topic<'a>> {
    let space = match &line.content {
        Content::Comment => return Some(Topic::Comment),
        Content::Statement(_) => statement(line)?.form().info().space,
        Content::Broken(broken) => broken.space?,
    };
    Some(match space {
        Space::Object => Topic::Object(subject(line)?.of(text)),
        other => Topic::Other(other),
    })
}

const fn begin(number: u32, topic: Topic<'_>) -> Fold {
    Fold {
        first_line: number,
        last_line: number,
        kind: match topic {
            Topic::Comment => FoldKind::Comment,
            Topic::Object(_) | Topic::Other(_) => FoldKind::Statements,
        },
    }
}

fn line_number(document: &Document, line: &Line) -> u32 {
    document.source().line_of(line.span.start)
}

/// The run that a line belongs to, found from the line alone.
pub(crate) fn fold_around(document: &Document, number: u32) -> Option<Fold> {
    let lines = document.lines();
    let start = document.source().line_span(number)?.start;
    let here = lines.partition_point(|line| line.span.start < start);
    let line = lines.get(here).filter(|line| line_number(document, line) == number)?;
    let topic_here = topic(document.text(), line)?;
    let same = |line: &&Line| topic(document.text(), line) == Some(topic_here);
    let mut fold = begin(number, topic_here);
    for line in lines.get(here + 1..).unwrap_or_default().iter().take_while(same) {
        if line_number(document, line) != fold.last_line + 1 {
            break;
        }
        fold.last_line += 1;
    }
    for line in lines.get(..here).unwrap_or_default().iter().rev().take_while(same) {
        if line_number(document, line) + 1 != fold.first_line {
            break;
        }
        fold.first_line -= 1;
    }
    (fold.first_line < fold.last_line).then_some(fold)
}

#[cfg(test)]
mod tests {
    use super::folds;
    use crate::tests::document;

    #[test]
    fn runs_without_a_gap_fold() {
        let text = "/ a\n/ b\nwidth := 1\nq := 2\n\nq := 3\n!a := sphere\n!a += 1 1 1\n!b := hp\n!b *= 1 1\n";
        let found: Vec<_> = folds(&document(text))
            .iter()
            .map(|fold| (fold.first_line, fold.last_line))
            .collect();
        assert_eq!(found, [(0, 1), (2, 3), (6, 7), (8, 9)]);
    }
}
