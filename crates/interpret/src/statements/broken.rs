//! A line that fits no statement: it has been reported, and whatever it may have meant is no cause for another report.

use scenec_syntax::{Broken, Form, Space};
use scenec_text::Span;

use super::operand;
use crate::Role;
use crate::names::Binding;
use crate::state::State;

/// Notes what a broken line may have bound, used or submitted.
pub(crate) fn broken(state: &mut State<'_>, line: Span, broken: &Broken) {
    state.failed = true;
    for name in &broken.mentions {
        mark_used(state, name.of(state.text));
    }
    let (Some(space), Some(name)) = (broken.space, broken.name) else {
        return;
    };
    match broken.form {
        Some(Form::Submit) => state.submission.poisoned = true,
        Some(Form::Scale | Form::Rotate | Form::Translate | Form::MaterialSet) => {}
        Some(_) | None => poison(state, space, name),
    }
    // An object line that broke off before its operator may have been the submission.
    if space == Space::Object && broken.form.is_none() && line.end > name.end {
        state.submission.poisoned = true;
    }
}

fn poison(state: &mut State<'_>, space: Space, name: Span) {
    let symbols = &mut state.symbols;
    match space {
        Space::Variable => {
            let id = state.variables.mention(name, Role::Define, symbols);
            state.variables.entries[id].binding = Binding::Poisoned;
        }
        Space::Material => {
            let id = state.paints.mention(name, Role::Define, symbols);
            state.paints.entries[id].binding = Binding::Poisoned;
        }
        Space::Object => {
            let id = state.objects.mention(name, Role::Define, symbols);
            operand::poison(state, id);
        }
        // Nothing refers to a light.
        Space::Light => {}
    }
}

/// Which name space the broken line meant is not known, so the name counts as used in all of them.
fn mark_used(state: &mut State<'_>, name: &str) {
    if let Some(variable) = state.variables.find_mut(name).and_then(|entry| entry.bound_mut()) {
        variable.used = true;
    }
    if let Some(paint) = state.paints.find_mut(name).and_then(|entry| entry.bound_mut()) {
        paint.used = true;
    }
    if let Some(id) = state.objects.number(name)
        && let Some(object) = state.objects.entries[id].bound_mut()
    {
        object.used = true;
        state.stale.remove(&id);
    }
}
