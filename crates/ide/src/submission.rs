//! Which statement submits.

use scenec_interpret::DefinitionId;
use scenec_syntax::Statement;
use scenec_text::Span;

use crate::Document;
use crate::names::statement;

/// The statement that submits an object.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) struct Submission {
    /// The statement.
    pub(crate) line: Span,
    /// The object's name without a sigil.
    pub(crate) name: Span,
    /// What made the object.
    pub(crate) definition: DefinitionId,
}

/// The first submission of an object that exists.
pub(crate) fn submission(document: &Document) -> Option<Submission> {
    let symbols = &document.interpretation().symbols;
    document.lines().iter().find_map(|line| {
        let Statement::Submit { name } = statement(line)? else {
            return None;
        };
        Some(Submission {
            line: line.span,
            name: *name,
            definition: symbols.at(name.start)?.definition?,
        })
    })
}
