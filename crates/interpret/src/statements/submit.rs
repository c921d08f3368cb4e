//! `!x <=`, and what comes after it.

use scenec_syntax::{Form, Statement, ValueKind};
use scenec_text::{Code, Diagnostic, Span};

use super::operand;
use crate::Role;
use crate::names::Gap;
use crate::state::State;

pub(super) fn run(state: &mut State<'_>, line: Span, name: Span) {
    match state.object(name, Role::Use) {
        Ok(id) => {
            state.submission.done = operand::take(state, id, line).map(|root| (root, line));
        }
        Err(Gap::Unknown) => state.submission.ignored = Some(line),
        Err(Gap::Poisoned) => state.submission.poisoned = true,
    }
}

/// An object statement after the submission: it is ignored, and its names count as used, since one report is enough.
pub(super) fn after(state: &mut State<'_>, line: Span, statement: &Statement, submitted: Span) {
    state.report(
        Diagnostic::new(
            Code::AfterSubmission,
            "this statement comes after the submission and is ignored",
            line,
            "ignored",
        )
        .label(submitted, "this is what is rendered")
        .help("move the submission behind it"),
    );
    let role = match statement.form() {
        Form::Object | Form::Combination => Role::Define,
        Form::Submit => Role::Use,
        _ => Role::Edit,
    };
    let symbols = &mut state.symbols;
    state.objects.mention(statement.name(), role, symbols);
    match statement {
        Statement::Combination { left, right, .. } => {
            for operand in [left, right] {
                let id = state.objects.mention(*operand, Role::Use, symbols);
                if let Some(object) = state.objects.entries[id].bound_mut() {
                    object.used = true;
                }
            }
        }
        Statement::MaterialSet { material, .. } => {
            let id = state.paints.mention(*material, Role::Use, symbols);
            if let Some(paint) = state.paints.entries[id].bound_mut() {
                paint.used = true;
            }
        }
        _ => {
            for value in statement.values() {
                if let ValueKind::Name(name) = value.kind {
                    let id = state.variables.mention(name, Role::Use, symbols);
                    if let Some(variable) = state.variables.entries[id].bound_mut() {
                        variable.used = true;
                    }
                }
            }
        }
    }
}
