//! `!x #y= v`

use scenec_scene::StepKind;
use scenec_syntax::{Axis, Value};
use scenec_text::Span;

use super::transform;
use crate::Role;
use crate::state::State;

pub(super) fn run(state: &mut State<'_>, line: Span, name: Span, axis: Axis, angle: Value) {
    let object = state.object(name, Role::Edit);
    let axis = match axis {
        Axis::X => scenec_scene::Axis::X,
        Axis::Y => scenec_scene::Axis::Y,
        Axis::Z => scenec_scene::Axis::Z,
    };
    let kind = state.numbers(&[angle]).map(|[angle]| StepKind::Rotate(axis, angle));
    transform::apply(state, line, object, kind);
}
