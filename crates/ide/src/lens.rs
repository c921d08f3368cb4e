//! Remarks above statements that an editor can act on.

use scenec_interpret::DefinitionId;
use scenec_syntax::Statement;
use scenec_text::Span;

use crate::Document;

/// A remark about a statement.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Lens {
    /// The name that the statement begins with, without a sigil.
    pub span: Span,
    /// What it offers.
    pub what: LensKind,
}

/// What a remark offers.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum LensKind {
    /// To render what is submitted here.
    Preview,
    /// To go through the places that use what is made here.
    Uses {
        /// The places, in the order of the file.
        places: Vec<Span>,
    },
}

/// At the submission: the picture, and the statements about the submitted object. At every material that was made: the
/// objects that take it.
#[must_use]
pub fn lenses(document: &Document) -> Vec<Lens> {
    let table = &document.interpretation().symbols;
    let materials = table.numbered_definitions().filter_map(|(id, definition)| {
        let (statement, _) = document.statement_at(definition.line.start)?;
        matches!(statement, Statement::Material { .. }).then(|| Lens {
            span: statement.name(),
            what: LensKind::Uses {
                places: places(document, id),
            },
        })
    });
    let mut lenses: Vec<Lens> = materials.collect();
    if let Some(submission) = document.facts().submission()
        && let Some((statement, _)) = document.statement_at(submission.line.start)
    {
        let uses = LensKind::Uses {
            places: places(document, submission.object),
        };
        let span = statement.name();
        lenses.extend([LensKind::Preview, uses].map(|what| Lens { span, what }));
    }
    lenses.sort_by_key(|lens| lens.span.start);
    lenses
}

/// The places that edit or read what a definition made, in the order of the file.
fn places(document: &Document, id: DefinitionId) -> Vec<Span> {
    let facts = document.facts();
    let all = facts.edits(document, id).chain(facts.uses(document, id));
    let mut places: Vec<Span> = all.map(|place| place.span).collect();
    places.sort_unstable();
    places
}

#[cfg(test)]
mod tests {
    use super::{LensKind, lenses};
    use crate::tests::document;

    #[test]
    fn the_submission_and_the_materials_have_one() {
        let text = "?m := 1 1 1 1 1 1 1 1 1 1\n!a := sphere\n!a ?= m\n!u := a | a\n!u ?= m\n!u <=\n!a <=";
        let document = document(text);
        let found: Vec<_> = lenses(&document)
            .into_iter()
            .map(|lens| {
                let line = document.source().line_of(lens.span.start);
                match lens.what {
                    LensKind::Preview => (line, None),
                    LensKind::Uses { places } => (line, Some(places.len())),
                }
            })
            .collect();
        assert_eq!(found, [(0, Some(2)), (5, None), (5, Some(2))]);
    }
}
