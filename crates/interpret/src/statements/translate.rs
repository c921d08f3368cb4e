//! `!x += a b c`

use scenec_scene::{DVec3, StepKind};
use scenec_syntax::Value;
use scenec_text::Span;

use super::transform;
use crate::Role;
use crate::state::State;

pub(super) fn run(state: &mut State<'_>, line: Span, name: Span, by: &[Value; 3]) {
    let object = state.object(name, Role::Edit);
    let kind = state.numbers(by).map(|by| StepKind::Translate(DVec3::from_array(by)));
    transform::apply(state, line, object, kind);
}
