//! Walking over the tokens of one line, and the wording of what was expected and what was found.

use scenec_text::{Code, Diagnostic, Span};

use crate::quote;
use crate::token::{Token, Word};

/// A place among the tokens of a line that has at least one.
pub(crate) struct Cursor<'a> {
    text: &'a str,
    words: &'a [Word],
    at: usize,
}

impl<'a> Cursor<'a> {
    pub(crate) const fn new(text: &'a str, words: &'a [Word]) -> Self {
        Self { text, words, at: 0 }
    }

    /// The token here, or `None` at the end of the line.
    pub(crate) fn peek(&self) -> Option<&'a Word> {
        self.words.get(self.at)
    }

    pub(crate) fn advance(&mut self) {
        self.at += 1;
    }

    /// The name here, if there is one, and past it.
    pub(crate) fn name(&mut self) -> Option<Span> {
        let word = self.peek().filter(|word| word.token == Token::Name)?;
        self.advance();
        Some(word.span)
    }

    /// Everything from here to the end of the line.
    pub(crate) fn rest(&self) -> Option<Span> {
        let first = self.words.get(self.at)?;
        Some(self.words.last().map_or(first.span, |last| first.span.to(last.span)))
    }

    /// The last token before this place, or the first of the line.
    pub(crate) fn before(&self) -> Span {
        let index = self.at.min(self.words.len()).saturating_sub(1);
        self.words.get(index).map_or_else(Span::default, |word| word.span)
    }

    pub(crate) fn word(&self, span: Span) -> &'a str {
        span.of(self.text)
    }

    /// A report that something else than `expected` stands here.
    pub(crate) fn unexpected(&self, expected: &str, help: impl Into<String>) -> Box<Diagnostic> {
        let finding = match self.peek() {
            Some(word) => Diagnostic::new(
                Code::UnexpectedToken,
                format!("expected {expected}, found {}", quote(self.word(word.span))),
                word.span,
                format!("expected {expected}"),
            ),
            None => Diagnostic::new(
                Code::UnexpectedToken,
                format!("expected {expected}, found the end of the line"),
                self.before(),
                format!("expected {expected} after this"),
            ),
        };
        Box::new(finding.help(help))
    }
}
