//! A transform of a combination goes to the base objects in it, where that is the same.
//!
//! Transforming a union, an intersection or a subtraction is transforming every base object in it. The file keeps its
//! meaning if nothing but this tree takes a part of it from there on.

use std::collections::BTreeMap;

use scenec_interpret::{Definition, DefinitionId, Occurrence, Role};
use scenec_syntax::{Form, Statement};
use scenec_text::{Diagnostic, Edit, Span};

use super::Offer;
use crate::Document;
use crate::insert::{line_end, new_line_before, whole_line};
use crate::names::statement;

/// The most base objects that one transform is written for.
const MOST: usize = 64;

/// To write the transform for every base object, before the combination that takes it.
pub(super) fn to_the_base_objects(document: &Document, finding: &Diagnostic) -> Option<Offer> {
    let line = document.line_at(finding.span().start)?;
    let transform = statement(line)?;
    let parts = Parts::of(document);
    let whole = parts.at(transform.name())?.definition?;
    let leaves = parts.leaves(whole, line.span)?;
    let earliest = leaves.iter().map(|leaf| leaf.before.start).min()?;
    if !parts.values_known(line.span, earliest) {
        return None;
    }
    let text = document.text();
    let rest = Span::new(transform.name().end, line.span.end).of(text);
    let mut written: BTreeMap<Span, Vec<String>> = BTreeMap::new();
    for leaf in &leaves {
        let lines = written.entry(leaf.before).or_default();
        lines.push(format!("!{}{rest}", leaf.name.of(text)));
    }
    let end = line_end(document);
    let new = written
        .iter()
        .map(|(before, lines)| new_line_before(document, *before, &lines.join(end)));
    let mut edits: Vec<Edit> = new.collect();
    edits.push(Edit {
        // A comment on the line stays.
        span: match line.comment {
            Some(comment) => Span::new(line.span.start, comment.start),
            None => whole_line(document, line.span),
        },
        text: String::new(),
    });
    let title = match leaves.len() {
        1 => "transform the base object before the combination instead".to_owned(),
        count => format!("transform the {count} base objects before they are combined instead"),
    };
    Some((title, edits))
}

/// A base object and the combination that takes it.
struct Leaf {
    /// Its name, without a sigil.
    name: Span,
    /// The combination.
    before: Span,
}

/// What is known of every definition.
struct Parts<'a> {
    document: &'a Document,
    definitions: &'a [Definition],
    places: &'a [Occurrence],
    /// The places that edit or read each definition.
    about: Vec<Vec<Occurrence>>,
}

impl<'a> Parts<'a> {
    fn of(document: &'a Document) -> Self {
        let symbols = &document.interpretation().symbols;
        let definitions = symbols.definitions();
        let places = symbols.occurrences();
        let mut about = vec![Vec::new(); definitions.len()];
        for place in places.iter().filter(|place| place.role != Role::Define) {
            if let Some(about) = place.definition.and_then(|id| about.get_mut(id.index())) {
                about.push(*place);
            }
        }
        Self {
            document,
            definitions,
            places,
            about,
        }
    }

    fn at(&self, name: Span) -> Option<Occurrence> {
        let index = self.places.binary_search_by_key(&name, |place| place.span).ok()?;
        self.places.get(index).copied()
    }

    fn statement(&self, line: Span) -> Option<&'a Statement> {
        statement(self.document.line_at(line.start)?)
    }

    /// The base objects of a combination; `None` if one of them, or anything between, counts elsewhere too.
    fn leaves(&self, whole: DefinitionId, transform: Span) -> Option<Vec<Leaf>> {
        let made = self.definitions.get(whole.index())?.line;
        let between = |place: &&Occurrence| place.span.start < transform.start;
        if self
            .about(whole)
            .iter()
            .filter(between)
            .any(|place| !self.is_paint(place))
        {
            return None;
        }
        let mut leaves = Vec::new();
        let mut open = vec![made];
        let mut seen = 0;
        while let Some(line) = open.pop() {
            let Some(Statement::Combination { left, right, .. }) = self.statement(line) else {
                return None;
            };
            seen += 1;
            let mut taken: Option<DefinitionId> = None;
            for name in [*left, *right] {
                let operand = self.at(name)?.definition?;
                if taken.replace(operand) == Some(operand) {
                    continue;
                }
                let made = self.definitions.get(operand.index())?.line;
                match self.statement(made)? {
                    Statement::Object { .. } if self.ends_with(operand, line) => {
                        leaves.push(Leaf { name, before: line })
                    }
                    Statement::Combination { .. } if self.is_only_in(operand, line) => open.push(made),
                    _ => return None,
                }
            }
            if leaves.len() > MOST || seen > MOST {
                return None;
            }
        }
        Some(leaves)
    }

    fn about(&self, definition: DefinitionId) -> &[Occurrence] {
        self.about
            .get(definition.index())
            .map(Vec::as_slice)
            .unwrap_or_default()
    }

    /// Whether nothing takes the object after the statement at `line`.
    fn ends_with(&self, definition: DefinitionId, line: Span) -> bool {
        let places = self.about(definition).iter();
        places
            .filter(|place| place.role == Role::Use)
            .all(|place| place.span.end <= line.end)
    }

    /// Whether nothing but the statement at `line` takes the object or transforms it.
    fn is_only_in(&self, definition: DefinitionId, line: Span) -> bool {
        let inside = |place: &Occurrence| line.start <= place.span.start && place.span.end <= line.end;
        let places = self.about(definition).iter();
        places.filter(|place| !self.is_paint(place)).all(inside)
    }

    /// Whether a place is that of an object that is given a material, which no transform bears on.
    fn is_paint(&self, place: &Occurrence) -> bool {
        self.statement(place.span)
            .is_some_and(|statement| statement.form() == Form::MaterialSet)
    }

    /// Whether every variable on a line is set before `place`.
    fn values_known(&self, line: Span, place: u32) -> bool {
        let first = self.places.partition_point(|other| other.span.start < line.start);
        let own = self
            .places
            .iter()
            .skip(first)
            .take_while(|other| other.span.start < line.end);
        own.filter(|other| other.role == Role::Use).all(|other| {
            let made = other.definition.and_then(|id| self.definitions.get(id.index()));
            made.is_some_and(|made| made.line.start < place)
        })
    }
}
