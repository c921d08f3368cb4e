//! A statement that came too late goes before the submission.

use scenec_interpret::Role;
use scenec_syntax::{Form, Statement};
use scenec_text::{Diagnostic, Edit};

use super::Offer;
use crate::Document;
use crate::insert::{new_line_before, whole_line};

/// To move the statement to the line before the submission, if everything that it names is made by then.
pub(super) fn before(document: &Document, finding: &Diagnostic) -> Option<Offer> {
    let (statement, line) = document.statement_at(finding.span().start)?;
    let submission = document.facts().submission()?.line;
    let known = document.places_on(line).iter().all(|place| {
        let made = place.definition.and_then(|id| document.definition_of(id));
        place.role == Role::Define || made.is_some_and(|made| made.line.start < submission.start)
    });
    if !known || statement.form() == Form::Submit || transforms_combination(document, statement) {
        return None;
    }
    let source = document.source();
    let row = source.line_span(source.line_of(line.start))?;
    let edits = vec![
        new_line_before(document, submission, row.of(document.text())),
        Edit {
            span: whole_line(document, row),
            text: String::new(),
        },
    ];
    Some(("move the statement before the submission".to_owned(), edits))
}

fn transforms_combination(document: &Document, statement: &Statement) -> bool {
    let transforms = matches!(statement.form(), Form::Scale | Form::Rotate | Form::Translate);
    let place = document.occurrence(statement.name());
    let made = place.and_then(|place| document.definition_of(place.definition?));
    let made = made.and_then(|made| document.statement_at(made.line.start));
    transforms && !matches!(made, Some((Statement::Object { .. }, _)))
}
