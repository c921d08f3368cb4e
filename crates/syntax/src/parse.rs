//! The parser: a line of tokens becomes a statement, or a broken line and its report.

mod again;
mod ahead;
mod cursor;
mod line;
mod values;

use scenec_text::{Diagnostic, Severity, SourceFile, Span};

use crate::token::{Scanner, Token, Word};
use crate::{Broken, Content, Line, characters, number};
pub use again::parse_again;
pub use ahead::read_ahead;
use line::LineParser;

/// Reads a whole file; the lines and findings are those of [`Lines`].
#[must_use]
pub fn parse(source: &SourceFile) -> (Vec<Line>, Vec<Diagnostic>) {
    let mut lines = Lines::new(source);
    let all = lines.by_ref().collect();
    (all, lines.findings())
}

/// Reads one line again, by its number as in [`SourceFile::line_span`]; `None` if it is blank. What is wrong with it is not
/// reported.
#[must_use]
pub fn line(source: &SourceFile, number: u32) -> Option<Line> {
    let span = source.line_span(number)?;
    Lines::of(source, Scanner::within(source.text(), span)).next()
}

/// Reads a file line by line. Every line that isn't blank gives one [`Line`]; one that fits no statement is
/// [`Content::Broken`] and reported, unless its fault is a byte that was no UTF-8, which the file's reader has reported.
pub struct Lines<'a> {
    source: &'a SourceFile,
    scanner: Scanner<'a>,
    /// The tokens of the current line.
    words: Vec<Word>,
    comment: Option<Span>,
    /// Whether every token of the current line is one.
    sound: bool,
    diagnostics: Vec<Diagnostic>,
}

impl<'a> Lines<'a> {
    /// The lines of a file, from the first one.
    #[must_use]
    pub fn new(source: &'a SourceFile) -> Self {
        Self::of(source, Scanner::new(source.text()))
    }

    const fn of(source: &'a SourceFile, scanner: Scanner<'a>) -> Self {
        Self {
            source,
            scanner,
            words: Vec::new(),
            comment: None,
            sound: true,
            diagnostics: Vec::new(),
        }
    }

    /// What was found on the lines that were read, in their order.
    #[must_use]
    pub fn findings(self) -> Vec<Diagnostic> {
        self.diagnostics
    }
}

impl Iterator for Lines<'_> {
    type Item = Line;

    fn next(&mut self) -> Option<Line> {
        while let Some(word) = self.scanner.next() {
            match word.token {
                Token::Newline => {
                    if let Some(line) = self.end_line() {
                        return Some(line);
                    }
                }
                Token::Comment => self.comment = Some(without_carriage_return(self.source.text(), word.span)),
                _ => self.push(word),
            }
        }
        self.end_line()
    }
}

impl Lines<'_> {
    fn push(&mut self, mut word: Word) {
        match word.token {
            Token::Number => {
                let (value, finding) = number::read(word.span.of(self.source.text()), word.span);
                word.number = value;
                if let Some(finding) = finding {
                    self.sound &= finding.severity() != Severity::Error;
                    self.diagnostics.push(finding);
                }
            }
            Token::Bad => self.sound = false,
            _ => {}
        }
        self.words.push(word);
    }

    /// The line whose tokens have all been read, unless it is blank.
    fn end_line(&mut self) -> Option<Line> {
        let comment = self.comment.take();
        let (span, content) = match (self.words.first(), self.words.last()) {
            (Some(first), Some(last)) => (first.span.to(last.span), self.content()),
            _ => (Span::at(comment?.start), Content::Comment),
        };
        self.words.clear();
        self.sound = true;
        Some(Line { span, content, comment })
    }

    fn content(&mut self) -> Content {
        let mut parser = LineParser::new(self.source.text(), &self.words);
        let parsed = parser.statement();
        let finding = match parsed {
            Ok(statement) if self.sound => return Content::Statement(statement),
            Ok(_) => None,
            Err(finding) => Some(finding),
        };
        let broken = Broken {
            space: parser.space,
            name: parser.name,
            form: parser.form,
            mentions: self.mentions(parser.name),
        };
        if self.sound {
            self.diagnostics.extend(finding.map(|finding| *finding));
        } else {
            // A bad token is cause enough; what the statement lacks besides may be due to it.
            characters::report(self.source, &self.words, &mut self.diagnostics);
        }
        Content::Broken(Box::new(broken))
    }

    fn mentions(&self, name: Option<Span>) -> Vec<Span> {
        let names = self.words.iter().filter(|word| word.token == Token::Name);
        names.map(|word| word.span).filter(|span| Some(*span) != name).collect()
    }
}

/// A comment takes everything up to the line feed; the carriage return of a CRLF is no part of it.
fn without_carriage_return(text: &str, comment: Span) -> Span {
    let before_line_feed = text.as_bytes().get(comment.end as usize) == Some(&b'\n');
    let cr = u32::from(before_line_feed && comment.of(text).ends_with('\r'));
    Span::new(comment.start, comment.end - cr)
}
