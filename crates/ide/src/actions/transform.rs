//! A transform of a combination goes to the base objects in it, where that is the same.
//!
//! Transforming a union, an intersection or a subtraction is transforming every base object in it. The file keeps its
//! meaning if nothing but this tree takes a part of it from there on.

use std::collections::BTreeMap;

use scenec_interpret::{DefinitionId, Role};
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
    let whole = document.occurrence(transform.name())?.definition?;
    let leaves = leaves(document, whole, line.span)?;
    let earliest = leaves.iter().map(|leaf| leaf.before.start).min()?;
    if !values_known(document, line.span, earliest) {
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

/// The base objects of a combination; `None` if one of them, or anything between, counts elsewhere too.
fn leaves(document: &Document, whole: DefinitionId, transform: Span) -> Option<Vec<Leaf>> {
    let mut others = takers(document, whole).filter(|place| place.start < transform.start);
    if others.next().is_some() {
        return None;
    }
    let mut leaves = Vec::new();
    let mut open = vec![document.definition_of(whole)?.line];
    let mut seen = 0;
    while let Some(line) = open.pop() {
        let (Statement::Combination { left, right, .. }, _) = document.statement_at(line.start)? else {
            return None;
        };
        let mut taken: Option<DefinitionId> = None;
        for name in [*left, *right] {
            let operand = document.occurrence(name)?.definition?;
            if taken.replace(operand) == Some(operand) {
                continue;
            }
            let made = document.definition_of(operand)?.line;
            // What took a base object before keeps it as it was; a combination would not stay the same for others.
            let mut takers = takers(document, operand).filter(|place| place.start >= line.start);
            let later = takers.any(|place| place.start >= line.end);
            match document.statement_at(made.start)? {
                (Statement::Object { .. }, _) if !later => leaves.push(Leaf { name, before: line }),
                (Statement::Combination { .. }, _) if !later && is_only_in(document, operand, line) => open.push(made),
                _ => return None,
            }
        }
        seen += 1;
        if leaves.len() > MOST || seen > MOST {
            return None;
        }
    }
    Some(leaves)
}

/// Whether no statement before `line` takes or transforms the object.
fn is_only_in(document: &Document, definition: DefinitionId, line: Span) -> bool {
    takers(document, definition).all(|place| place.start >= line.start)
}

/// The places that take an object or transform it; giving it a material is all the same to a transform.
fn takers(document: &Document, definition: DefinitionId) -> impl Iterator<Item = Span> {
    let facts = document.facts();
    let all = facts
        .edits(document, definition)
        .chain(facts.uses(document, definition));
    let is_paint = |span: Span| {
        let statement = document.statement_at(span.start);
        statement.is_some_and(|(statement, _)| statement.form() == Form::MaterialSet)
    };
    all.map(|place| place.span).filter(move |span| !is_paint(*span))
}

/// Whether every variable on a line is set before `place`.
fn values_known(document: &Document, line: Span, place: u32) -> bool {
    let read = document.places_on(line).iter().filter(|other| other.role == Role::Use);
    let mut made = read.map(|other| document.definition_of(other.definition?));
    made.all(|made| made.is_some_and(|made| made.line.start < place))
}
