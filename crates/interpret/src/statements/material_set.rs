//! `!x ?= m`

use scenec_scene::SolidKind;
use scenec_text::Span;

use super::{operand, transform};
use crate::Role;
use crate::state::State;

pub(super) fn run(state: &mut State<'_>, line: Span, name: Span, material: Span) {
    let object = state.object(name, Role::Edit);
    let paint = state.paint(material);
    let material = paint.ok().and_then(|id| {
        let paint = state.paints.entries[id].bound_mut()?;
        paint.used = true;
        Some((id, paint.id))
    });
    let (Ok(object), Some((paint, material))) = (object, material) else {
        return;
    };
    if let Some(paint) = state.paints.entries[paint].bound_mut() {
        paint.taken = Some(line);
    }
    if let Some(leaf) = transform::own_leaf(state, object) {
        leaf.material = material;
    } else if let Some(bound) = state.objects.entries[object].bound() {
        // Only the outermost paint of a solid shows, so one over another takes its place.
        let inside = match state.solids[bound.solid.index()].kind {
            SolidKind::Paint { inside, .. } => inside,
            _ => bound.solid,
        };
        let solid = state.push_solid(SolidKind::Paint { inside, material }, line);
        if let Some(bound) = state.objects.entries[object].bound_mut() {
            bound.solid = solid;
        }
    }
    operand::edited(state, object, line);
}
