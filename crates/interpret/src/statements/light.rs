//! `*x := a b c r g b`

use scenec_scene::{DVec3, Light};
use scenec_syntax::{Space, Value};
use scenec_text::Span;

use crate::Role;
use crate::bindings::Lamp;
use crate::state::State;

pub(super) fn run(state: &mut State<'_>, line: Span, name: Span, values: &[Value; 6]) {
    let id = state.lamps.mention(name, Role::Define, &mut state.symbols);
    let numbers = state.numbers(values);
    let entry = &mut state.lamps.entries[id];
    // Nothing refers to a light, so one that is left out leaves nothing behind.
    let Ok([x, y, z, r, g, b]) = numbers else {
        return;
    };
    let light = Light {
        position: DVec3::new(x, y, z),
        colour: DVec3::new(r, g, b),
        span: line,
    };
    // A light of the same name takes the place of the one before it.
    let before = entry.bound().map(|lamp| (lamp.index, lamp.line));
    let index = before.map_or(state.lights.len(), |(index, _)| index);
    entry.bind(line, Lamp { index, line }, &mut state.symbols);
    match state.lights.get_mut(index) {
        Some(place) => *place = light,
        None => state.lights.push(light),
    }
    if let Some((_, first)) = before {
        let name = entry.name.of(state.text);
        state.overwritten(Space::Light, name, first, line);
    }
}
