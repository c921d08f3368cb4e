//! The submitted object and its parts.

use scenec_interpret::{Definition, DefinitionId, SymbolId};
use scenec_syntax::{Operator, Space, Statement};
use scenec_text::Span;

use super::{DEEPEST, MOST, MOST_PARTS, OutlineItem, OutlineKind, more};
use crate::Document;
use crate::names::statement;

/// The tree under the submitted object.
pub(super) fn submitted(document: &Document) -> Option<OutlineItem> {
    let submission = document.facts().submission()?;
    Made::of(document).tree(submission.object)
}

/// What every definition of an object takes.
struct Made<'a> {
    document: &'a Document,
    definitions: &'a [Definition],
    kinds: Vec<Kind>,
}

#[derive(Clone, Copy)]
enum Kind {
    Base,
    Combination(Operator, [Option<DefinitionId>; 2]),
    Other,
}

/// A part as its combination takes it.
#[derive(Clone, Copy)]
struct Part {
    definition: DefinitionId,
    operator: Option<Operator>,
}

/// An item and where it hangs.
struct Hung {
    item: OutlineItem,
    parent: Option<usize>,
}

impl<'a> Made<'a> {
    fn of(document: &'a Document) -> Self {
        let symbols = &document.interpretation().symbols;
        let definitions = symbols.definitions();
        let operand = |name: Span| symbols.at(name.start).and_then(|place| place.definition);
        let kind = |definition: &Definition| match document.line_at(definition.line.start).and_then(statement) {
            Some(Statement::Object { .. }) => Kind::Base,
            Some(Statement::Combination {
                operator, left, right, ..
            }) => Kind::Combination(*operator, [operand(*left), operand(*right)]),
            _ => Kind::Other,
        };
        let kinds = definitions.iter().map(kind).collect();
        Self {
            document,
            definitions,
            kinds,
        }
    }

    fn kind(&self, id: DefinitionId) -> Kind {
        self.kinds.get(id.index()).copied().unwrap_or(Kind::Other)
    }

    fn symbol(&self, id: DefinitionId) -> Option<SymbolId> {
        self.definitions.get(id.index()).map(|definition| definition.symbol)
    }

    /// How many parts an object has that is put together step by step under one name.
    fn counts(&self) -> Vec<usize> {
        let mut counts: Vec<usize> = Vec::with_capacity(self.kinds.len());
        for (index, kind) in self.kinds.iter().enumerate() {
            let symbol = self.definitions.get(index).map(|definition| definition.symbol);
            let count = match kind {
                Kind::Combination(_, [left, right]) => {
                    let same = left.filter(|left| self.is_step(*left, symbol));
                    let before = same.and_then(|left| counts.get(left.index()).copied());
                    before.unwrap_or(usize::from(left.is_some())) + usize::from(right.is_some())
                }
                Kind::Base | Kind::Other => 0,
            };
            counts.push(count);
        }
        counts
    }

    /// Whether an operand is an earlier step of the object of the same name.
    fn is_step(&self, operand: DefinitionId, symbol: Option<SymbolId>) -> bool {
        self.symbol(operand) == symbol && matches!(self.kind(operand), Kind::Combination(..))
    }

    /// The last parts of an object, in the order in which they were taken; at most `most`.
    fn parts(&self, id: DefinitionId, most: usize) -> Vec<Part> {
        let symbol = self.symbol(id);
        let mut parts = Vec::new();
        let mut next = Some(id);
        while let Some(id) = next.take()
            && let Kind::Combination(operator, [left, right]) = self.kind(id)
        {
            let part = |definition, operator| Part { definition, operator };
            parts.extend(right.map(|right| part(right, Some(operator))));
            match left {
                Some(left) if self.is_step(left, symbol) => next = Some(left),
                left => parts.extend(left.map(|left| part(left, None))),
            }
            if parts.len() >= most {
                break;
            }
        }
        parts.truncate(most);
        parts.reverse();
        parts
    }

    fn tree(&self, root: DefinitionId) -> Option<OutlineItem> {
        let counts = self.counts();
        let count = |id: DefinitionId| counts.get(id.index()).copied().unwrap_or_default();
        let mut hung = vec![Hung {
            item: self.item(root, None)?,
            parent: None,
        }];
        let mut taken_apart = vec![false; self.kinds.len()];
        // Items whose parts are still to come, each with its depth.
        let mut open = vec![(0, root, 0)];
        while let Some((parent, id, depth)) = open.pop() {
            if count(id) == 0 {
                continue;
            }
            let seen = taken_apart
                .get_mut(id.index())
                .is_none_or(|apart| std::mem::replace(apart, true));
            let room = if seen || depth == DEEPEST {
                0
            } else {
                MOST.min(MOST_PARTS.saturating_sub(hung.len()))
            };
            if seen {
                if let Some(parent) = hung.get_mut(parent) {
                    parent.item.detail.push_str(", shown before");
                }
                continue;
            }
            let parts = self.parts(id, room);
            let left_out = count(id) - parts.len();
            if left_out > 0
                && let Some(above) = hung.get(parent).map(|parent| (parent.item.line, parent.item.name_span))
            {
                hung.push(Hung {
                    item: more(left_out, above.0, above.1),
                    parent: Some(parent),
                });
            }
            for part in parts {
                if let Some(item) = self.item(part.definition, part.operator) {
                    open.push((hung.len(), part.definition, depth + 1));
                    hung.push(Hung {
                        item,
                        parent: Some(parent),
                    });
                }
            }
        }
        assemble(hung)
    }

    fn item(&self, id: DefinitionId, operator: Option<Operator>) -> Option<OutlineItem> {
        let text = self.document.text();
        let line = self.definitions.get(id.index())?.line;
        let statement = statement(self.document.line_at(line.start)?)?;
        let (kind, what) = describe(text, statement)?;
        let taken = match operator {
            Some(Operator::Intersection) => "cut to ",
            Some(Operator::Subtraction) => "less ",
            Some(Operator::Union) | None => "",
        };
        Some(OutlineItem {
            name: format!("{}{}", Space::Object.sigil(), statement.name().of(text)),
            detail: format!("{taken}{what}"),
            kind,
            line,
            name_span: statement.name(),
            children: Vec::new(),
        })
    }
}

/// What an object's statement makes, in a word.
pub(super) fn describe<'a>(text: &'a str, statement: &Statement) -> Option<(OutlineKind, &'a str)> {
    match statement {
        Statement::Object { base, .. } => Some((OutlineKind::Base, base.of(text))),
        Statement::Combination { operator, .. } => Some((
            OutlineKind::Combination,
            match operator {
                Operator::Union => "union",
                Operator::Intersection => "intersection",
                Operator::Subtraction => "subtraction",
            },
        )),
        _ => None,
    }
}

/// Hangs every item under its parent. Parents stand before their children.
fn assemble(mut hung: Vec<Hung>) -> Option<OutlineItem> {
    while hung.len() > 1 {
        let Hung { mut item, parent } = hung.pop()?;
        item.children.reverse();
        if let Some(parent) = parent.and_then(|parent| hung.get_mut(parent)) {
            parent.item.children.push(item);
        }
    }
    let mut root = hung.pop()?.item;
    root.children.reverse();
    Some(root)
}
