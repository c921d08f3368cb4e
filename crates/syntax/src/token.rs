//! The scanner: bytes to tokens. A newline is a token, since it ends a statement; so is a comment, which the formatter
//! keeps.

use logos::Logos;
use scenec_text::Span;

/// A token of the language.
///
/// A number takes every letter, digit and point that touches it, so that a misspelt one is one token; and the sign is
/// a token of its own, so that `a -b` subtracts and `1 -2` is two values.
#[derive(Logos, Clone, Copy, PartialEq, Eq, Debug)]
#[logos(skip(r"[\p{White_Space}--[\r\n]]+"))]
pub enum Token {
    /// The end of a line.
    #[regex(r"\r?\n")]
    Newline,
    /// A slash and everything up to the line feed, a carriage return before that included.
    #[regex(r"/[^\n]*", allow_greedy = true)]
    Comment,
    /// A name, `pi` included, without a sigil; the words for base objects are names.
    #[regex(r"[\p{XID_Start}_]\p{XID_Continue}*")]
    Name,
    /// A number without its sign, or what looks like one.
    #[regex(r"[0-9.]([eE][+-]|[.\p{XID_Continue}])*")]
    Number,
    /// `!`
    #[token("!")]
    Bang,
    /// `?`
    #[token("?")]
    Question,
    /// `*`
    #[token("*")]
    Star,
    /// `:=`
    #[token(":=")]
    Assign,
    /// `?=`
    #[token("?=")]
    SetMaterial,
    /// `*=`
    #[token("*=")]
    Scale,
    /// `+=`
    #[token("+=")]
    Translate,
    /// `<=`
    #[token("<=")]
    Submit,
    /// `#x=`
    #[token("#x=")]
    RotateX,
    /// `#y=`
    #[token("#y=")]
    RotateY,
    /// `#z=`
    #[token("#z=")]
    RotateZ,
    /// `|`
    #[token("|")]
    Or,
    /// `&`
    #[token("&")]
    And,
    /// `-`
    #[token("-")]
    Minus,
    /// `+`
    #[token("+")]
    Plus,
    /// A run of characters that are no token; a rotation about no axis is one run, not two.
    #[regex(r"#\p{XID_Continue}*=?", priority = 1)]
    Bad,
}

/// A token in its place.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct Word {
    pub(crate) token: Token,
    pub(crate) span: Span,
    /// The value of a number; 0 for anything else.
    pub(crate) number: f64,
}

/// Every token of a text with its place, in order; touching bad characters come as one. It is for what fits no
/// statement: [`crate::parse`] tells what the rest says.
pub fn scan(text: &str) -> impl Iterator<Item = (Token, Span)> + '_ {
    Scanner::new(text).map(|word| (word.token, word.span))
}

/// The tokens of a text as the parser takes them.
pub(crate) struct Scanner<'a> {
    lexer: logos::Lexer<'a, Token>,
    /// What was read beyond a run of bad characters; its place is the lexer's.
    ahead: Option<Token>,
}

impl<'a> Scanner<'a> {
    /// A whole file, which a byte-order mark may begin.
    pub(crate) fn new(text: &'a str) -> Self {
        let mark = if text.starts_with('\u{FEFF}') {
            '\u{FEFF}'.len_utf8()
        } else {
            0
        };
        Self::from(text, mark)
    }

    /// Only what is at a place, between characters; the offsets are those of the whole text.
    pub(crate) fn within(text: &'a str, place: Span) -> Self {
        let text = text.get(..place.end as usize).unwrap_or_default();
        Self::from(text, text.len().min(place.start as usize))
    }

    fn from(text: &'a str, start: usize) -> Self {
        let mut lexer = Token::lexer(text);
        lexer.bump(start);
        Self { lexer, ahead: None }
    }

    #[inline]
    fn read(&mut self) -> Option<Token> {
        Some(self.lexer.next()?.unwrap_or(Token::Bad))
    }

    /// The place of what was read last.
    #[inline]
    fn span(&self) -> Span {
        let range = self.lexer.span();
        let offset = |at: usize| u32::try_from(at).unwrap_or(u32::MAX);
        Span::new(offset(range.start), offset(range.end))
    }

    /// A bad token with those that touch it.
    #[cold]
    fn run_from(&mut self, mut span: Span) -> Span {
        self.ahead = self.read();
        while self.ahead == Some(Token::Bad) && self.span().start == span.end {
            span.end = self.span().end;
            self.ahead = self.read();
        }
        span
    }
}

impl Iterator for Scanner<'_> {
    type Item = Word;

    /// In place, since a word on its way through memory, written in parts and read as a whole, makes the processor wait.
    #[inline(always)]
    fn next(&mut self) -> Option<Word> {
        let token = match self.ahead.take() {
            Some(token) => token,
            None => self.read()?,
        };
        let mut span = self.span();
        if token == Token::Bad {
            span = self.run_from(span);
        }
        Some(Word {
            token,
            span,
            number: 0.0,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::{Scanner, Token};

    fn check(text: &str, expect: &[(Token, &str)]) {
        let found: Vec<_> = Scanner::new(text)
            .map(|word| (word.token, word.span.of(text)))
            .collect();
        assert_eq!(found, expect, "{text:?}");
    }

    #[test]
    fn signs_stand_alone_and_numbers_take_what_touches_them() {
        use Token::{Minus, Name, Number};
        check("a -b", &[(Name, "a"), (Minus, "-"), (Name, "b")]);
        check("1 -2", &[(Number, "1"), (Minus, "-"), (Number, "2")]);
        check("1-2", &[(Number, "1"), (Minus, "-"), (Number, "2")]);
        for number in [
            "1.2.3", "2e", "3abc", "2e+", "1.5e-3", "2.", ".5", ".", "0xFF", "6.02e23",
        ] {
            check(number, &[(Number, number)]);
        }
    }

    #[test]
    fn operators_need_no_space() {
        use Token::{Assign, Bang, Name, Question, RotateY, SetMaterial, Submit};
        check(
            "!s:=sphere",
            &[(Bang, "!"), (Name, "s"), (Assign, ":="), (Name, "sphere")],
        );
        check("!é?=_m", &[(Bang, "!"), (Name, "é"), (SetMaterial, "?="), (Name, "_m")]);
        check("!u<=", &[(Bang, "!"), (Name, "u"), (Submit, "<=")]);
        check(
            "#w= #x #",
            &[(Token::Bad, "#w="), (Token::Bad, "#x"), (Token::Bad, "#")],
        );
        check("?x#y=", &[(Question, "?"), (Name, "x"), (RotateY, "#y=")]);
    }

    #[test]
    fn white_space_is_unicode_and_a_lone_carriage_return_is_none() {
        use Token::{Bad, Comment, Name, Newline};
        check(
            "\u{FEFF}a\u{3000}\u{2028}\u{85}\u{B}b\r\n",
            &[(Name, "a"), (Name, "b"), (Newline, "\r\n")],
        );
        check("a\rb", &[(Name, "a"), (Bad, "\r"), (Name, "b")]);
        check("a/ b\r\n", &[(Name, "a"), (Comment, "/ b\r"), (Newline, "\n")]);
        check("=\0\u{1b}; =", &[(Bad, "=\0\u{1b};"), (Bad, "=")]);
    }
}
