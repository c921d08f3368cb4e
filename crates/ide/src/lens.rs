//! Remarks above statements that an editor can act on.

use scenec_interpret::Role;
use scenec_syntax::Space;
use scenec_text::Span;

use crate::Document;
use crate::names::statement;
use crate::submission::submission;

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
    let mut uses: Vec<Vec<Span>> = vec![Vec::new(); table.definitions().len()];
    for place in table.occurrences() {
        if place.role != Role::Define
            && let Some(places) = place.definition.and_then(|id| uses.get_mut(id.index()))
        {
            places.push(place.span);
        }
    }
    let mut lenses = Vec::new();
    for (id, definition) in table.numbered_definitions() {
        let material = table
            .symbols()
            .get(definition.symbol.0 as usize)
            .is_some_and(|symbol| symbol.space == Space::Material);
        let name = document.line_at(definition.line.start).and_then(statement);
        if let (true, Some(name)) = (material, name) {
            lenses.push(Lens {
                span: name.name(),
                what: LensKind::Uses {
                    places: uses.get_mut(id.index()).map(std::mem::take).unwrap_or_default(),
                },
            });
        }
    }
    if let Some(submission) = submission(document) {
        let places = uses.get_mut(submission.definition.index()).map(std::mem::take);
        for what in [
            LensKind::Preview,
            LensKind::Uses {
                places: places.unwrap_or_default(),
            },
        ] {
            lenses.push(Lens {
                span: submission.name,
                what,
            });
        }
    }
    lenses.sort_by_key(|lens| lens.span.start);
    lenses
}
