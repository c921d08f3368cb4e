//! Which name stands at a place, on lines that fit no statement too, and every other place where it stands.
//!
//! The symbol table leaves out what a broken line mentions. While a line is being typed it is broken, so an editor has to
//! guess there: the operator on the line tells which name space its names are of.

use scenec_interpret::{DefinitionId, Role};
use scenec_syntax::{Broken, Content, Form, Line, Space, Statement};
use scenec_text::Span;

use crate::Document;

/// A name in its place.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) struct Named {
    /// The name without a sigil.
    pub(crate) span: Span,
    pub(crate) space: Space,
    pub(crate) role: Role,
    /// What it is bound to, if anything.
    pub(crate) definition: Option<DefinitionId>,
}

/// The name at an offset; one just behind a name counts, as a text cursor there does.
pub(crate) fn name_at(document: &Document, offset: u32) -> Option<Named> {
    let symbols = &document.interpretation().symbols;
    if let Some(place) = symbols.at(offset) {
        let space = document.symbol_of(place.symbol)?.space;
        return Some(Named {
            span: place.span,
            space,
            role: place.role,
            definition: place.definition,
        });
    }
    let Content::Broken(broken) = &document.line_at(offset)?.content else {
        return None;
    };
    names_of(document.text(), broken).find(|name| name.span.start <= offset && offset <= name.span.end)
}

/// Every place where the name of `name` stands in its name space, in the order of the file.
pub(crate) fn places(document: &Document, name: Named) -> Vec<Named> {
    let text = document.text();
    let word = name.span.of(text);
    let symbol = document.symbol(name.space, word).into_iter();
    let known = symbol.flat_map(|symbol| document.interpretation().symbols.places(symbol));
    let mut found: Vec<Named> = known
        .map(|place| Named {
            span: place.span,
            space: name.space,
            role: place.role,
            definition: place.definition,
        })
        .collect();
    let count = found.len();
    for line in document.lines() {
        let Content::Broken(broken) = &line.content else {
            continue;
        };
        let same = names_of(text, broken).filter(|other| other.space == name.space && other.span.of(text) == word);
        for other in same {
            let table = found.get(..count).unwrap_or_default();
            if table.binary_search_by_key(&other.span, |place| place.span).is_err() {
                found.push(other);
            }
        }
    }
    found.sort_by_key(|place| place.span);
    found
}

/// The names on a line that fits no statement, each in the name space that it most likely is of.
pub(crate) fn names_of<'a>(text: &'a str, broken: &'a Broken) -> impl Iterator<Item = Named> + 'a {
    let role = match broken.form {
        Some(Form::MaterialSet | Form::Scale | Form::Rotate | Form::Translate) => Role::Edit,
        Some(Form::Submit) => Role::Use,
        _ => Role::Define,
    };
    let first = broken.space.zip(broken.name).map(|(space, span)| (span, space, role));
    let space = mentioned(broken);
    let rest = broken.mentions.iter().map(move |span| (*span, space, Role::Use));
    first
        .into_iter()
        .chain(rest.filter(move |(span, space, _)| *space != Space::Variable || span.of(text) != "pi"))
        .map(|(span, space, role)| Named {
            span,
            space,
            role,
            definition: None,
        })
}

/// The name space of the names that a broken line mentions besides its first.
fn mentioned(broken: &Broken) -> Space {
    match broken.form {
        Some(Form::Object | Form::Combination | Form::Submit) => Space::Object,
        Some(Form::MaterialSet) => Space::Material,
        _ => Space::Variable,
    }
}

/// The statement that a line holds.
pub(crate) const fn statement(line: &Line) -> Option<&Statement> {
    match &line.content {
        Content::Statement(statement) => Some(statement),
        Content::Comment | Content::Broken(_) => None,
    }
}

/// The name that a line begins with, without a sigil.
pub(crate) fn subject(line: &Line) -> Option<Span> {
    match &line.content {
        Content::Statement(statement) => Some(statement.name()),
        Content::Broken(broken) => broken.name,
        Content::Comment => None,
    }
}
