//! Names, and what else may stand for an object or a number.

use scenec_interpret::{DefinitionId, Symbol, SymbolId};
use scenec_scene::{Base, setting};
use scenec_syntax::{Space, Statement};

use super::{Completion, CompletionKind, Cursor, MOST_NAMES};
use crate::look::Shape;
use crate::words::{code, figure, hex, look};

impl Cursor<'_> {
    /// The names of a space that are bound on earlier lines, the nearest first; where there are too many, those that
    /// begin as the typed word does.
    pub(super) fn names(&self, space: Space) -> Vec<Completion> {
        let symbols = self.document.interpretation().symbols.symbols();
        let before = symbols.partition_point(|symbol| symbol.name.start < self.line);
        let numbered = || {
            let earlier = symbols.iter().enumerate().take(before).rev();
            earlier.filter(|(_, symbol)| symbol.space == space)
        };
        let few = numbered().nth(MOST_NAMES).is_none();
        let fits = |symbol: &Symbol| few || begins(self.document.words(symbol.name), self.typed);
        numbered()
            .filter(|(_, symbol)| fits(symbol))
            .filter_map(|(number, symbol)| {
                let id = SymbolId(u32::try_from(number).ok()?);
                let definition = self.document.binding(id, self.line)?;
                Some(self.name(space, self.document.words(symbol.name), definition))
            })
            .take(MOST_NAMES)
            .collect()
    }

    fn name(&self, space: Space, name: &str, id: DefinitionId) -> Completion {
        let document = self.document;
        let line = document.definition_of(id).map(|found| found.line).unwrap_or_default();
        let statement = document.statement_at(line.start).map(|(statement, _)| statement);
        let (kind, detail) = match space {
            Space::Variable => {
                let value = document.facts().value(id).map_or(String::new(), figure);
                let kind = if setting(name).is_some() {
                    CompletionKind::Setting
                } else {
                    CompletionKind::Variable
                };
                (kind, format!("= {value}"))
            }
            Space::Material => {
                let words = document
                    .material(id)
                    .map(|material| format!("{} {}", hex(material.colour), look(&material)));
                (CompletionKind::Material, words.unwrap_or_default())
            }
            Space::Light => (CompletionKind::Light, "light".to_owned()),
            Space::Object => {
                let detail = match statement {
                    Some(Statement::Object { base, .. }) => document.words(*base).to_owned(),
                    _ => "combination".to_owned(),
                };
                (CompletionKind::Object, detail)
            }
        };
        Completion {
            detail,
            documentation: format!(
                "{}, line {}",
                code(document.words(line)),
                document.line_number(line.start)
            ),
            ..self.item(kind, name)
        }
    }

    /// The base objects.
    pub(super) fn bases(&self) -> Vec<Completion> {
        let words = |base: &Base| match base {
            Base::Sphere => "the unit sphere at the origin",
            Base::HalfSpace => "the half-space under y = 0",
        };
        let list = Base::ALL.iter().map(|(base, word)| Completion {
            detail: words(base).to_owned(),
            ..self.item(CompletionKind::Base, *word)
        });
        list.collect()
    }

    /// Whatever may stand for a number.
    pub(super) fn values(&self) -> Vec<Completion> {
        let pi = Completion {
            detail: "3.14159…, half a turn".to_owned(),
            ..self.item(CompletionKind::Constant, "pi")
        };
        let mut list = self.names(Space::Variable);
        list.push(pi);
        list
    }

    /// What a variable may be bound to; a usual value first where it is a setting.
    pub(super) fn values_of(&self, shape: &Shape<'_>) -> Vec<Completion> {
        let name = shape.name.map_or("", |name| self.document.words(name));
        let usual = setting(name).map(|row| Completion {
            detail: format!("{}, {}", row.meaning, row.range.words()),
            ..self.item(CompletionKind::Constant, self.document.proposed(row))
        });
        usual.into_iter().chain(self.values()).collect()
    }
}

/// Whether a name begins with what was typed, capital letters aside.
fn begins(name: &str, typed: &str) -> bool {
    let mut name = name.chars().flat_map(char::to_lowercase);
    typed
        .chars()
        .flat_map(char::to_lowercase)
        .all(|typed| name.next() == Some(typed))
}
