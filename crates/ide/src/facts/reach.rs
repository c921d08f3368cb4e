//! Which objects the submitted one is made of, and whose materials show in it.

use scenec_interpret::DefinitionId;
use scenec_syntax::Statement;
use scenec_text::Span;

use super::Facts;
use crate::Document;

/// How the submitted object takes what a definition made. One object may be taken more than once, as it stood each time.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Taken {
    /// The last statement that takes it: the edits after that are lost.
    pub(crate) last: Span,
    /// Whether the material that it had itself shows somewhere.
    pub(crate) bare: bool,
    /// A material set of a combination around it that hides its own.
    pub(crate) painted: Option<Span>,
    /// The same two for what it is made of.
    inside: Show,
}

/// Whose material shows: that of what is taken, or that of a paint around it, or each somewhere.
#[derive(Clone, Copy, Debug, Default)]
struct Show {
    bare: bool,
    painted: Option<Span>,
}

/// From the submission back: combinations stand behind what they take.
pub(super) fn of(document: &Document, facts: &Facts) -> Vec<Option<Taken>> {
    let symbols = &document.interpretation().symbols;
    let mut taken = vec![None; symbols.definitions().len()];
    let Some(submission) = facts.submission else {
        return taken;
    };
    let whole = Show {
        bare: true,
        painted: None,
    };
    take(document, facts, &mut taken, submission.object, submission.line, whole);
    let numbered: Vec<_> = symbols.numbered_definitions().collect();
    for (id, definition) in numbered.into_iter().rev() {
        let here = taken.get(id.index()).copied().flatten();
        if let (Some(Taken { inside, .. }), Some(operands)) = (here, facts.operands(id)) {
            for operand in operands.into_iter().flatten() {
                take(document, facts, &mut taken, operand, definition.line, inside);
            }
        }
    }
    taken
}

/// Notes that the statement at `by` takes what a definition made, as it stood there.
fn take(document: &Document, facts: &Facts, taken: &mut [Option<Taken>], id: DefinitionId, by: Span, show: Show) {
    let inside = match own_paint(document, facts, id, by) {
        Some(painted) => Show {
            bare: false,
            painted: Some(show.painted.unwrap_or(painted)),
        },
        None => show,
    };
    let Some(place) = taken.get_mut(id.index()) else {
        return;
    };
    let before = place.unwrap_or(Taken {
        last: by,
        bare: false,
        painted: None,
        inside: Show::default(),
    });
    *place = Some(Taken {
        last: if by.start > before.last.start { by } else { before.last },
        bare: before.bare || show.bare,
        painted: before.painted.or(show.painted),
        inside: Show {
            bare: before.inside.bare || inside.bare,
            painted: before.inside.painted.or(inside.painted),
        },
    });
}

/// The last material set of a combination before it is taken.
fn own_paint(document: &Document, facts: &Facts, id: DefinitionId, by: Span) -> Option<Span> {
    facts.operands(id)?;
    let edits = facts.edits(document, id).rev();
    edits
        .filter(|edit| edit.span.start < by.start)
        .filter_map(|edit| document.statement_at(edit.span.start))
        .find(|(statement, line)| {
            matches!(statement, Statement::MaterialSet { .. }) && document.used_on(*line).is_some()
        })
        .map(|(_, line)| line)
}
