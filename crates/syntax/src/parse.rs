//! The parser: a line of tokens becomes a statement, or a broken line and its report.

mod cursor;
mod line;
mod values;

use scenec_text::{Diagnostic, Severity, SourceFile, Span};

use crate::token::{Scanner, Token, Word};
use crate::{Broken, Content, Line, characters, number};
use line::LineParser;

/// Reads a whole file. Every line that isn't blank gives one [`Line`]; one that fits no statement is
/// [`Content::Broken`] and reported, unless its fault is a byte that was no UTF-8, which the file's reader has reported.
/// The findings stand in the order of the file.
#[must_use]
pub fn parse(source: &SourceFile) -> (Vec<Line>, Vec<Diagnostic>) {
    let mut file = FileParser {
        source,
        words: Vec::new(),
        comment: None,
        sound: true,
        lines: Vec::new(),
        diagnostics: Vec::new(),
    };
    for word in Scanner::new(source.text()) {
        match word.token {
            Token::Newline => file.end_line(),
            Token::Comment => file.comment = Some(without_carriage_return(source.text(), word.span)),
            _ => file.push(word),
        }
    }
    file.end_line();
    (file.lines, file.diagnostics)
}

struct FileParser<'a> {
    source: &'a SourceFile,
    /// The tokens of the current line.
    words: Vec<Word>,
    comment: Option<Span>,
    /// Whether every token of the current line is one.
    sound: bool,
    lines: Vec<Line>,
    diagnostics: Vec<Diagnostic>,
}

impl FileParser<'_> {
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

    fn end_line(&mut self) {
        let comment = self.comment.take();
        let content = match (self.words.first(), self.words.last()) {
            (Some(first), Some(last)) => Some((first.span.to(last.span), self.content())),
            _ => comment.map(|comment| (Span::at(comment.start), Content::Comment)),
        };
        if let Some((span, content)) = content {
            self.lines.push(Line { span, content, comment });
        }
        self.words.clear();
        self.sound = true;
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
