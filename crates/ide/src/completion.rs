//! What may be written at the cursor: statements, operators, names, values, settings.

mod form;
mod names;
mod whole;

use scenec_scene::Base;
use scenec_syntax::{Form, Space, Token};
use scenec_text::Span;

use crate::Document;
use crate::look::{Look, Piece, Shape, is_joint};

/// Something that may be written at the cursor.
#[derive(Clone, PartialEq, Debug)]
pub struct Completion {
    /// What the list shows.
    pub label: String,
    /// What typed letters are compared with.
    pub filter: String,
    /// What it is.
    pub kind: CompletionKind,
    /// A short phrase beside the label; may be empty.
    pub detail: String,
    /// More about it, in Markdown; may be empty.
    pub documentation: String,
    /// What is replaced: the word or the operator at the cursor, or nothing.
    pub replace: Span,
    /// What stands there afterwards.
    pub insert: String,
    /// Whether `insert` is a snippet with places to fill in, rather than plain text.
    pub snippet: bool,
    /// Its place in the list; smaller numbers first.
    pub order: u32,
}

/// What a completion writes.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum CompletionKind {
    /// A statement, or the rest of one.
    Statement,
    /// An operator.
    Operator,
    /// A base object.
    Base,
    /// The name of an object.
    Object,
    /// The name of a material.
    Material,
    /// The name of a light.
    Light,
    /// The name of a variable.
    Variable,
    /// A variable that the language reads.
    Setting,
    /// The constant `pi`, or a number.
    Constant,
}

/// The most names that are offered at once: a list with so many may lack some, and is worth asking for again when more
/// letters are typed.
pub const MOST_NAMES: usize = 100;

/// What may be written at an offset. Names are those that are bound on earlier lines.
#[must_use]
pub fn completions(document: &Document, offset: u32) -> Vec<Completion> {
    let offset = document.cursor(offset);
    let Some(look) = Look::at(document.source(), offset).filter(|look| !look.in_comment(offset)) else {
        return Vec::new();
    };
    if look.is_typing_number(offset) {
        return Vec::new();
    }
    let cursor = Cursor::new(document, &look, offset);
    let mut list = cursor.list();
    for (order, item) in (0..).zip(&mut list) {
        item.order = order;
    }
    list
}

/// Where the cursor is on its line.
struct Cursor<'a> {
    document: &'a Document,
    /// Where the line begins: names must be bound before it.
    line: u32,
    /// The tokens before what is being typed.
    before: Vec<Piece>,
    /// Whether other tokens follow.
    more: bool,
    /// What is being typed, which a completion replaces; empty where that is nothing.
    replace: Span,
    /// The part of it before the cursor.
    typed: &'a str,
}

impl<'a> Cursor<'a> {
    fn new(document: &'a Document, look: &Look, offset: u32) -> Self {
        let typing = look.pieces.iter().position(|piece| {
            let inside = piece.span.start < offset && offset <= piece.span.end;
            inside && is_unfinished(look, piece)
        });
        let replace = typing
            .and_then(|index| look.pieces.get(index))
            .map_or(Span::at(offset), |piece| piece.span);
        let before = look
            .pieces
            .iter()
            .take_while(|piece| piece.span.end <= replace.start)
            .copied();
        Self {
            document,
            line: look.line.start,
            before: before.collect(),
            more: look
                .pieces
                .iter()
                .any(|piece| piece.span.start >= replace.end.max(offset)),
            replace,
            typed: document.words(Span::new(replace.start, offset)),
        }
    }

    fn list(&self) -> Vec<Completion> {
        let shape = Shape::of(&self.before);
        match (shape.space, shape.name) {
            (None, _) if self.before.is_empty() => self.line_start(),
            (None, _) => Vec::new(),
            (Some(space), None) => self.subjects(space),
            (Some(space), Some(_)) if shape.operator.is_none() && shape.tail.is_empty() => self.operators(space),
            (Some(_), Some(_)) => shape.form().map(|form| self.parts(form, &shape)).unwrap_or_default(),
        }
    }

    /// What may stand behind an operator.
    fn parts(&self, form: Form, shape: &Shape<'_>) -> Vec<Completion> {
        let names = |space| self.names(space);
        match (form, shape.tail) {
            (Form::Object, []) => {
                let mut list = self.bases();
                list.extend(names(Space::Object));
                list
            }
            (Form::Object, [operand]) if operand.token == Token::Name => {
                let word = self.document.words(operand.span);
                let is_base = Base::ALL.iter().any(|(_, base)| *base == word);
                if is_base { Vec::new() } else { self.joints() }
            }
            (Form::Combination, [_, joint]) if is_joint(joint.token) => names(Space::Object),
            (Form::MaterialSet, []) => names(Space::Material),
            (Form::Variable, []) => self.values_of(shape),
            (_, _) if shape.values().len() < form.info().fields.len() || self.ends_in_sign(shape) => self.values(),
            _ => Vec::new(),
        }
    }

    fn ends_in_sign(&self, shape: &Shape<'_>) -> bool {
        let fields = shape.form().map_or(0, |form| form.info().fields.len());
        let values = shape.values();
        let last = values.last().map(|spot| spot.piece.token);
        values.len() == fields && matches!(last, Some(Token::Plus | Token::Minus))
    }

    fn item(&self, kind: CompletionKind, label: impl Into<String>) -> Completion {
        let label = label.into();
        Completion {
            insert: label.clone(),
            filter: label.clone(),
            label,
            kind,
            detail: String::new(),
            documentation: String::new(),
            replace: self.replace,
            snippet: false,
            order: 0,
        }
    }
}

/// Whether a token may become another one as more is typed: a name, or what may be the start of an operator.
fn is_unfinished(look: &Look, piece: &Piece) -> bool {
    match piece.token {
        Token::Name | Token::Bad => true,
        Token::Question | Token::Star | Token::Plus => {
            let third = look.pieces.get(2) == Some(piece);
            third && look.pieces.first().is_some_and(|first| first.token == Token::Bang)
        }
        _ => false,
    }
}

#[cfg(test)]
mod tests;
