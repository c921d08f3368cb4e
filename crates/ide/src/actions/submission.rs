//! A statement that came too late goes before the submission.

use scenec_interpret::Role;
use scenec_syntax::{Form, Statement};
use scenec_text::{Diagnostic, Edit, Span};

use super::Offer;
use crate::Document;
use crate::insert::{new_line_before, whole_line};
use crate::names::statement;
use crate::submission::submission;

/// To move the statement to the line before the submission, if everything that it names is made by then.
pub(super) fn before(document: &Document, finding: &Diagnostic) -> Option<Offer> {
    let line = document.line_at(finding.span().start)?;
    let statement = statement(line)?;
    let submission = submission(document)?;
    if matches!(statement, Statement::Submit { .. }) {
        return None;
    }
    let symbols = &document.interpretation().symbols;
    let made_before = |definition: Option<scenec_interpret::DefinitionId>| {
        let made = definition.and_then(|id| symbols.definitions().get(id.index()));
        made.is_some_and(|made| made.line.start < submission.line.start)
    };
    let places = symbols.occurrences();
    let first = places.partition_point(|place| place.span.start < line.span.start);
    let own = places
        .iter()
        .skip(first)
        .take_while(|place| place.span.start < line.span.end);
    let known = own
        .clone()
        .all(|place| place.role == Role::Define || made_before(place.definition));
    if !known || transforms_combination(document, statement) {
        return None;
    }
    let source = document.source();
    let row = source.line_span(source.line_of(line.span.start))?;
    let moved = row.of(document.text());
    let edits = vec![
        new_line_before(document, submission.line, moved),
        Edit {
            span: whole_line(document, row),
            text: String::new(),
        },
    ];
    Some(("move the statement before the submission".to_owned(), edits))
}

fn transforms_combination(document: &Document, transform: &Statement) -> bool {
    if !matches!(transform.form(), Form::Scale | Form::Rotate | Form::Translate) {
        return false;
    }
    let symbols = &document.interpretation().symbols;
    let made = symbols.at(transform.name().start).and_then(|place| place.definition);
    let line: Option<Span> = made.and_then(|id| Some(symbols.definitions().get(id.index())?.line));
    let made = line.and_then(|line| document.line_at(line.start)).and_then(statement);
    !matches!(made, Some(Statement::Object { .. }))
}
