//! From a name to the statement that made it, and to every other place where it stands.

use scenec_interpret::Role;
use scenec_text::Span;

use crate::Document;
use crate::names::{name_at, places, subject};

/// A statement to go to.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Target {
    /// What was pointed at.
    pub origin: Span,
    /// The statement.
    pub line: Span,
    /// The name that it begins with, without a sigil.
    pub name: Span,
}

/// The statement that made what the name at `offset` stands for there; the first one that would, where nothing has.
#[must_use]
pub fn definition(document: &Document, offset: u32) -> Option<Target> {
    let name = name_at(document, offset)?;
    let line = match name.definition.and_then(|id| document.definition_of(id)) {
        Some(definition) => definition.line,
        None => {
            let places = places(document, name);
            // While a line is being typed, what stands before it is what it means.
            let before = places.iter().filter(|place| place.span.start < name.span.start).rev();
            let after = places.iter().filter(|place| place.span.start >= name.span.start);
            let defines = before.chain(after).find(|place| place.role == Role::Define)?;
            document.line_at(defines.span.start)?.span
        }
    };
    target(document, name.span, line)
}

/// Every place where the name at `offset` stands in its name space, in the order of the file, with or without those that
/// bind it.
#[must_use]
pub fn references(document: &Document, offset: u32, declarations: bool) -> Vec<Span> {
    let found = name_at(document, offset).map(|name| places(document, name));
    let found = found.into_iter().flatten();
    found
        .filter(|place| declarations || place.role != Role::Define)
        .map(|place| place.span)
        .collect()
}

/// The statement at `line`, pointed at from `origin`.
pub(crate) fn target(document: &Document, origin: Span, line: Span) -> Option<Target> {
    let name = subject(document.line_at(line.start)?)?;
    Some(Target { origin, line, name })
}
