//! Repairs for what the earlier stages reported: they know what a statement means, not how to take one away.

use scenec_interpret::Role;
use scenec_syntax::Space;
use scenec_text::{Code, Diagnostic, Edit, Fix, Span};

use crate::context::Context;

/// Attaches a repair to every finding that has a mechanical one.
pub(crate) fn mend(context: &Context<'_>, findings: &mut [Diagnostic]) {
    for finding in findings.iter_mut() {
        let place = finding.span();
        if let Some(fix) = &mut finding.fix {
            rename_all(context, place, fix);
            continue;
        }
        finding.fix = match finding.code {
            Code::AfterSubmission => context.removal("remove the ignored statement", &[place]),
            Code::OperandEdited => context.removal("remove the edit", &[place]),
            Code::MaterialRedefined => context.removal("remove the definition", &[place]),
            Code::UnusedVariable => context.removal("remove the variable", &[place]),
            Code::OverwrittenUnused => overwritten(context, finding),
            Code::NumberUnderflow => Some(Fix {
                title: "write 0".to_owned(),
                edits: vec![Edit {
                    span: place,
                    text: "0".to_owned(),
                }],
                safe: true,
            }),
            _ => None,
        };
    }
}

/// A statement that names the same missing thing twice is reported once, and is mended in both places.
fn rename_all(context: &Context<'_>, place: Span, fix: &mut Fix) {
    let (Some(line), Some(first)) = (context.line_at(place), fix.edits.first().cloned()) else {
        return;
    };
    let places = context.places_on(line.span);
    let symbol = places
        .clone()
        .find(|other| other.span == first.span)
        .map(|other| other.symbol);
    let again = places.filter(|other| Some(other.symbol) == symbol && other.span != first.span);
    fix.edits
        .extend(again.filter(|other| other.role == Role::Use).map(|other| Edit {
            span: other.span,
            text: first.text.clone(),
        }));
}

/// Removes what a later statement overwrites, with its edits.
fn overwritten(context: &Context<'_>, finding: &Diagnostic) -> Option<Fix> {
    let id = context.definition_at(finding.span())?;
    let mut fix = context.removal("remove the first one", &context.definition_and_edits(id))?;
    // A light keeps the place in the list where its name first stood, and the order in which lights are added up shows
    // in the last bits of a colour.
    let space = context
        .definition(id)
        .and_then(|definition| context.named(definition).1);
    fix.safe = space != Some(Space::Light);
    Some(fix)
}
