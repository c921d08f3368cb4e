//! What all object statements share: binding, taking, editing, and the edits that came too late.

use scenec_scene::SolidId;
use scenec_syntax::{Space, quote};
use scenec_text::{Code, Diagnostic, Span};

use crate::bindings::Object;
use crate::names::{Binding, NameId};
use crate::state::State;

/// Binds an object's name, and reports what the old binding leaves undone.
pub(super) fn bind(state: &mut State<'_>, id: NameId, solid: SolidId, line: Span) {
    let entry = &mut state.objects.entries[id];
    let (name, made) = (entry.name.of(state.text), entry.last_bound(&state.symbols));
    let Some(before) = entry.bind(line, Object::new(solid), &mut state.symbols) else {
        return;
    };
    if let Some(made) = made.filter(|_| !before.used) {
        state.overwritten(Space::Object, name, made, line);
    }
    report_stale(state, id, &before);
}

/// Takes an object's meaning away because of an error.
pub(super) fn poison(state: &mut State<'_>, id: NameId) {
    if let Some(before) = state.objects.entries[id].replace(Binding::Poisoned) {
        report_stale(state, id, &before);
    }
}

/// An object as it stands on `line`, for a combination or a submission.
pub(super) fn take(state: &mut State<'_>, id: NameId, line: Span) -> Option<SolidId> {
    let object = state.objects.entries[id].bound_mut()?;
    object.used = true;
    object.frozen = true;
    object.taken = Some(line);
    state.stale.remove(&id);
    Some(object.solid)
}

/// Notes an edit of an object, which is lost if nothing takes the object again.
pub(super) fn edited(state: &mut State<'_>, id: NameId, line: Span) {
    let object = state.objects.entries[id].bound();
    if object.is_some_and(|object| object.taken.is_some()) {
        state.stale.entry(id).or_default().push(line);
    }
}

/// Warns about each edit of an object that came after the last combination took it.
pub(crate) fn report_stale(state: &mut State<'_>, id: NameId, object: &Object) {
    let (Some(edits), Some(taken)) = (state.stale.remove(&id), object.taken) else {
        return;
    };
    let name = quote(&format!("!{}", state.objects.entries[id].name.of(state.text)));
    for edit in edits {
        state.report(
            Diagnostic::new(
                Code::OperandEdited,
                format!("this edit of {name} reaches no combination"),
                edit,
                "the edited object is never taken",
            )
            .label(taken, format!("{name} was taken here as it stood"))
            .help("move the edit before the combination, or combine again after it"),
        );
    }
}
