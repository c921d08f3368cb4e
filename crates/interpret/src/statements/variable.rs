//! `x := v`

use scenec_syntax::{Space, Value};
use scenec_text::Span;

use crate::Role;
use crate::bindings::Variable;
use crate::names::{Binding, Gap};
use crate::state::State;

pub(super) fn run(state: &mut State<'_>, line: Span, name: Span, value: Value) {
    let id = state.variables.mention(name, Role::Define, &mut state.symbols);
    let number = state.numbers(&[value]);
    let entry = &mut state.variables.entries[id];
    match number {
        Ok([number]) => {
            let last_read = entry.bound().and_then(|variable| variable.last_read);
            let variable = Variable {
                value: number,
                written: value.span,
                line,
                used: false,
                last_read,
            };
            if let Some(before) = entry.bind(line, variable, &mut state.symbols)
                && !before.used
            {
                let name = entry.name.of(state.text);
                state.overwritten(Space::Variable, name, before.line, line);
            }
        }
        Err(Gap::Unknown) => state.variables.ignore(id, line),
        Err(Gap::Poisoned) => entry.binding = Binding::Poisoned,
    }
}
