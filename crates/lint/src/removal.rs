//! Taking statements away without leaving a trace.

use std::collections::{HashMap, HashSet};

use scenec_interpret::{DefinitionId, Role};
use scenec_scene::setting;
use scenec_text::{Edit, Fix, Span};

use crate::context::Context;

impl Context<'_> {
    /// Removes statements that do nothing; comments on their lines stay. `None` if something would be left that nothing
    /// reads any more: a repair that causes the next finding is no repair.
    pub(crate) fn removal(&self, title: impl Into<String>, statements: &[Span]) -> Option<Fix> {
        self.removal_keeping(title, statements, None)
    }

    /// The same, where something else reads `kept` afterwards.
    pub(crate) fn removal_keeping(
        &self,
        title: impl Into<String>,
        statements: &[Span],
        kept: Option<DefinitionId>,
    ) -> Option<Fix> {
        let removed: HashSet<DefinitionId> = statements
            .iter()
            .filter_map(|statement| self.definition_at(*statement))
            .collect();
        let mut lost: HashMap<DefinitionId, u32> = HashMap::new();
        for place in statements.iter().flat_map(|statement| self.places_on(*statement)) {
            if let (Role::Use, Some(definition)) = (place.role, place.definition) {
                *lost.entry(definition).or_default() += 1;
            }
        }
        let orphaned = |(id, lost): (&DefinitionId, &u32)| {
            let named = self.definition(*id).map(|definition| self.named(definition).0);
            let goes_or_stays = removed.contains(id) || kept == Some(*id);
            self.uses(*id) <= *lost && named.and_then(setting).is_none() && !goes_or_stays
        };
        if lost.iter().any(orphaned) {
            return None;
        }
        Some(Fix {
            title: title.into(),
            edits: statements.iter().map(|statement| self.without(*statement)).collect(),
            safe: true,
        })
    }

    /// The edit that removes a statement: the line with it, unless a comment stands there too.
    fn without(&self, statement: Span) -> Edit {
        let comment = self.line_at(statement).and_then(|line| line.comment);
        let span = match comment {
            Some(comment) => Span::new(statement.start, comment.start),
            None => self.whole_line(statement),
        };
        Edit {
            span,
            text: String::new(),
        }
    }

    /// The line that holds a place, its line end included.
    pub(crate) fn whole_line(&self, place: Span) -> Span {
        let number = self.source.line_of(place.start);
        let line = self.source.line_span(number).unwrap_or(place);
        let end = self.source.line_span(number + 1).map_or(line.end, |next| next.start);
        Span::new(line.start, end)
    }
}
