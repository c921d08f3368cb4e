//! A look at one line as its tokens, whether or not it fits a statement: a line that is being typed rarely does.
//!
//! It knows the shape of statements and nothing of what the names on them stand for.

use scenec_syntax::{Form, Space, Token, scan};
use scenec_text::{SourceFile, Span};

/// The most tokens that are looked at: a material with signs before all its values has 23.
const MOST: usize = 64;

/// A token in its place.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) struct Piece {
    pub(crate) token: Token,
    pub(crate) span: Span,
}

/// A value as it stands on the line: its sign, if there is one, and the token behind it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) struct Spot {
    /// The whole value.
    pub(crate) span: Span,
    /// What follows the sign; the sign itself where nothing does.
    pub(crate) piece: Piece,
}

/// The tokens of a line.
pub(crate) struct Look {
    /// The line without its end.
    pub(crate) line: Span,
    /// Its tokens without the comment.
    pub(crate) pieces: Vec<Piece>,
    /// Where its comment begins.
    pub(crate) comment: Option<u32>,
}

impl Look {
    /// The line at an offset; `None` past the end of the text.
    pub(crate) fn at(source: &SourceFile, offset: u32) -> Option<Self> {
        let line = source.line_span(source.line_of(offset))?;
        let mut look = Self {
            line,
            pieces: Vec::new(),
            comment: None,
        };
        for (token, span) in scan(line.of(source.text())).take(MOST) {
            let span = Span::new(line.start + span.start, line.start + span.end);
            match token {
                Token::Comment => look.comment = Some(span.start),
                Token::Newline => {}
                _ => look.pieces.push(Piece { token, span }),
            }
        }
        Some(look)
    }

    /// Whether an offset lies in the comment.
    pub(crate) fn in_comment(&self, offset: u32) -> bool {
        self.comment.is_some_and(|start| offset > start)
    }

    /// Whether the cursor is in or just behind a number.
    pub(crate) fn is_typing_number(&self, offset: u32) -> bool {
        let mut pieces = self.pieces.iter();
        pieces.any(|piece| piece.token == Token::Number && piece.span.start < offset && offset <= piece.span.end)
    }

    /// The token at an offset; of two that touch there, the word rather than the sign.
    pub(crate) fn piece_at(&self, offset: u32) -> Option<Piece> {
        let touching = |piece: &&Piece| piece.span.start <= offset && offset <= piece.span.end;
        let mut found = self.pieces.iter().filter(touching).copied();
        let first = found.next()?;
        let second = found.next();
        let is_word = |piece: &Piece| matches!(piece.token, Token::Name | Token::Number);
        Some(
            second
                .filter(|second| is_word(second) || !is_word(&first))
                .unwrap_or(first),
        )
    }

    /// What the line says so far.
    pub(crate) fn shape(&self) -> Shape<'_> {
        Shape::of(&self.pieces)
    }
}

/// What a run of tokens from the start of a line says.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Shape<'a> {
    /// The name space that the line is about; `None` where it is empty or begins with something else.
    pub(crate) space: Option<Space>,
    /// The name that it begins with.
    pub(crate) name: Option<Span>,
    /// The token behind the name, if it is an operator that makes a statement.
    pub(crate) operator: Option<Piece>,
    /// Everything behind the operator; everything behind the name where there is none.
    pub(crate) tail: &'a [Piece],
}

impl<'a> Shape<'a> {
    pub(crate) fn of(pieces: &'a [Piece]) -> Self {
        let first = pieces.first().map(|piece| piece.token);
        let (space, rest) = match first {
            Some(Token::Bang) => (Some(Space::Object), pieces.get(1..)),
            Some(Token::Question) => (Some(Space::Material), pieces.get(1..)),
            Some(Token::Star) => (Some(Space::Light), pieces.get(1..)),
            Some(Token::Name) => (Some(Space::Variable), Some(pieces)),
            _ => (None, Some(pieces)),
        };
        let mut tail = rest.unwrap_or_default();
        let name = take(&mut tail, |token| token == Token::Name).map(|piece| piece.span);
        let operator = name.and_then(|_| take(&mut tail, |token| form_of(space, token).is_some()));
        Self {
            space,
            name,
            operator,
            tail,
        }
    }

    /// The kind of statement that the operator makes; an object is a combination once an operator joins two names.
    pub(crate) fn form(&self) -> Option<Form> {
        let form = form_of(self.space, self.operator?.token)?;
        let joined = self.tail.get(1).is_some_and(|piece| is_joint(piece.token));
        Some(if form == Form::Object && joined {
            Form::Combination
        } else {
            form
        })
    }

    /// The values behind the operator. A token that is no value stands for one all the same, since others are counted
    /// from the left.
    pub(crate) fn values(&self) -> Vec<Spot> {
        let mut spots: Vec<Spot> = Vec::new();
        let mut sign: Option<Piece> = None;
        for piece in self.tail.iter().copied() {
            let before = sign.take();
            if matches!(piece.token, Token::Plus | Token::Minus) {
                spots.extend(before.map(Spot::from));
                sign = Some(piece);
            } else {
                let span = before.map_or(piece.span, |sign| sign.span.to(piece.span));
                spots.push(Spot { span, piece });
            }
        }
        spots.extend(sign.map(Spot::from));
        spots
    }
}

impl From<Piece> for Spot {
    fn from(piece: Piece) -> Self {
        Self {
            span: piece.span,
            piece,
        }
    }
}

/// Whether a token joins two objects to a combination.
pub(crate) const fn is_joint(token: Token) -> bool {
    matches!(token, Token::Or | Token::And | Token::Minus)
}

fn take(rest: &mut &[Piece], wanted: impl Fn(Token) -> bool) -> Option<Piece> {
    let (first, after) = rest.split_first()?;
    wanted(first.token).then(|| {
        *rest = after;
        *first
    })
}

fn form_of(space: Option<Space>, token: Token) -> Option<Form> {
    match (space?, token) {
        (Space::Variable, Token::Assign) => Some(Form::Variable),
        (Space::Light, Token::Assign) => Some(Form::Light),
        (Space::Material, Token::Assign) => Some(Form::Material),
        (Space::Object, Token::Assign) => Some(Form::Object),
        (Space::Object, Token::SetMaterial) => Some(Form::MaterialSet),
        (Space::Object, Token::Scale) => Some(Form::Scale),
        (Space::Object, Token::Translate) => Some(Form::Translate),
        (Space::Object, Token::Submit) => Some(Form::Submit),
        (Space::Object, Token::RotateX | Token::RotateY | Token::RotateZ) => Some(Form::Rotate),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use scenec_syntax::Form;
    use scenec_text::SourceFile;

    use super::Look;

    fn check(line: &str, form: Option<Form>, values: &[&str]) {
        let source = SourceFile::new("t", line).unwrap();
        let look = Look::at(&source, 0).unwrap();
        let shape = look.shape();
        let found: Vec<_> = shape.values().iter().map(|spot| spot.span.of(line)).collect();
        assert_eq!((shape.form(), found.as_slice()), (form, values), "{line:?}");
    }

    #[test]
    fn half_a_line_has_a_shape() {
        check("", None, &[]);
        check("!", None, &[]);
        check("!a := ", Some(Form::Object), &[]);
        check("!a := b | ", Some(Form::Combination), &["b", "|"]);
        check("!a += - 1 -x 3 / 4", Some(Form::Translate), &["- 1", "-x", "3"]);
        check("!a += 1 - - 2", Some(Form::Translate), &["1", "-", "- 2"]);
        check("!a += 1 - -", Some(Form::Translate), &["1", "-", "-"]);
        check("?m := 1 $ 3", Some(Form::Material), &["1", "$", "3"]);
        check("x := pi", Some(Form::Variable), &["pi"]);
        check("x ?= pi", None, &["?=", "pi"]);
    }
}
