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

#[cfg(test)]
mod tests {
    use super::{definition, references};
    use crate::marked::marked;

    /// The line from 1 that the definition stands on, and the lines of the references without it.
    fn check(text: &str, expect: Option<u32>, uses: &[u32]) {
        let (document, offset) = marked(text);
        let line = |span: scenec_text::Span| document.source().line_of(span.start) + 1;
        assert_eq!(
            definition(&document, offset).map(|target| line(target.line)),
            expect,
            "{text}"
        );
        let found: Vec<u32> = references(&document, offset, false).into_iter().map(line).collect();
        assert_eq!(found, uses, "{text}");
    }

    #[test]
    fn a_name_leads_to_what_it_is_bound_to_there() {
        check("!a := sphere\n!a := hp\n!u := $0a | a\n!a := sphere", Some(2), &[3, 3]);
        check("a := 1\n!a := sphere\n!a += a$0 0 0", Some(1), &[3]);
        check("?m := 1 1 1 1 1 1 1 1 1 1\n!a ?= m$0", Some(1), &[2]);
        check("!u := $0a | b\n!a := sphere", Some(2), &[1]);
        check("!u := $0sphere", None, &[]);
        check("b := 1 $0/ b", None, &[]);
    }

    #[test]
    fn half_a_line_leads_on_too() {
        check("!a := sphere\n!u := a$0 |", Some(1), &[2]);
        check("?m := 1 1 1 1 1 1 1 1 1 1\n!a ?= m$0 m", Some(1), &[2, 2]);
        check("q := 1\n*l := 1 q$0", Some(1), &[2]);
    }
}
