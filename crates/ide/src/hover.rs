//! What is at the cursor, in Markdown.

mod material;
mod number;
mod object;
mod other;

use scenec_interpret::{DefinitionId, Occurrence};
use scenec_scene::Material;
use scenec_syntax::{Space, Token};
use scenec_text::Span;

use crate::Document;
use crate::look::{Look, Piece, Shape};

/// What is at the cursor.
#[derive(Clone, PartialEq, Debug)]
pub struct Hover {
    /// The words that it is about.
    pub span: Span,
    /// What there is to say, in Markdown.
    pub markdown: String,
    /// A material that may be shown as a ball of it.
    pub ball: Option<Material>,
}

/// What is at an offset; `None` for blanks and comments.
#[must_use]
pub fn hover(document: &Document, offset: u32) -> Option<Hover> {
    let offset = document.cursor(offset);
    let look = Look::at(document.source(), offset).filter(|look| !look.in_comment(offset))?;
    let piece = look.piece_at(offset)?;
    let place = Place {
        document,
        look: &look,
        piece,
    };
    place.hover()
}

/// A token on its line.
struct Place<'a> {
    document: &'a Document,
    look: &'a Look,
    piece: Piece,
}

/// What a hover says, before its span is known.
struct Said {
    markdown: String,
    ball: Option<Material>,
}

impl From<String> for Said {
    fn from(markdown: String) -> Self {
        Self { markdown, ball: None }
    }
}

impl Place<'_> {
    fn hover(&self) -> Option<Hover> {
        let shape = self.look.shape();
        let (span, said) = self.value(&shape).or_else(|| {
            let said = match self.piece.token {
                Token::Name => self.name(&shape),
                Token::Bang | Token::Question | Token::Star if self.is_first() => {
                    return Some((self.piece.span, self.named(&shape, shape.name?)?));
                }
                Token::Number | Token::Bad => None,
                _ => other::operator(&shape, self.piece.token).map(Said::from),
            };
            Some((self.piece.span, said?))
        })?;
        Some(Hover {
            span,
            markdown: said.markdown,
            ball: said.ball,
        })
    }

    fn is_first(&self) -> bool {
        self.look.pieces.first() == Some(&self.piece)
    }

    /// A name that is no value.
    fn name(&self, shape: &Shape<'_>) -> Option<Said> {
        self.named(shape, self.piece.span)
    }

    fn named(&self, shape: &Shape<'_>, name: Span) -> Option<Said> {
        let document = self.document;
        if let Some(place) = document.occurrence(name) {
            let space = document.symbol_of(place.symbol)?.space;
            return self.known(space, name, place.definition, Some(place));
        }
        let space = self.space_of(shape, name)?;
        if space == Space::Object
            && shape.name != Some(name)
            && let Some(base) = crate::solid::base_of(document.words(name))
        {
            return Some(other::base(base, document.words(name)).into());
        }
        let symbol = document.symbol(space, document.words(name));
        let id = symbol.and_then(|symbol| document.binding(symbol, self.look.line.start));
        self.known(space, name, id, None)
    }

    /// The name space of a name on a line that fits no statement, and of a base object's word.
    fn space_of(&self, shape: &Shape<'_>, name: Span) -> Option<Space> {
        if shape.name == Some(name) {
            return shape.space;
        }
        match shape.operator?.token {
            Token::Assign if shape.space == Some(Space::Object) => Some(Space::Object),
            Token::SetMaterial => Some(Space::Material),
            _ => None,
        }
    }

    fn known(&self, space: Space, name: Span, id: Option<DefinitionId>, place: Option<&Occurrence>) -> Option<Said> {
        match space {
            Space::Variable => Some(self.variable(name, id).into()),
            Space::Light => other::light(self.document, name, id).map(Said::from),
            Space::Material => Some(material::said(self.document, name, id, place)),
            Space::Object => Some(object::said(self.document, name, id, place).into()),
        }
    }
}

#[cfg(test)]
mod tests;
