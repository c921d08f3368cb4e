//! What scale, rotation and translation share: the object must be a base object, and what comes out must be finite.

use scenec_scene::{DVec3, Leaf, SolidKind, Step, StepKind, Transform};
use scenec_syntax::quote;
use scenec_text::{Code, Diagnostic, Span};

use super::operand;
use crate::names::{Gap, NameId};
use crate::state::State;

/// Transforms the object, unless it or a value of the statement is missing.
pub(super) fn apply(state: &mut State<'_>, line: Span, object: Result<NameId, Gap>, kind: Result<StepKind, Gap>) {
    let Ok(id) = object else {
        return;
    };
    if let Some(combined) = combination_of(state, id) {
        let finding = of_a_combination(state.objects.entries[id].name.of(state.text), line, combined);
        state.report(finding);
        return;
    }
    let Ok(kind) = kind else {
        return;
    };
    let Some(leaf) = own_leaf(state, id).copied() else {
        return;
    };
    let step = Step {
        previous: leaf.steps,
        kind,
        span: line,
    };
    match state.steps.push(step) {
        Ok(step) => {
            if let Some(leaf) = own_leaf(state, id) {
                leaf.steps = Some(step);
            }
        }
        Err(transform) => {
            let finding = out_of_range(
                state.objects.entries[id].name.of(state.text),
                line,
                vanishes(&transform),
            );
            state.report(finding);
            return;
        }
    }
    operand::edited(state, id, line);
}

/// The leaf that an object is, to change it: a copy of its own if a combination holds the present one. `None` for a
/// combination.
pub(super) fn own_leaf<'s>(state: &'s mut State<'_>, id: NameId) -> Option<&'s mut Leaf> {
    let object = state.objects.entries[id].bound()?;
    let (solid, frozen) = (object.solid, object.frozen);
    let present = &state.solids[solid.index()];
    let SolidKind::Leaf(leaf) = &present.kind else {
        return None;
    };
    let own = if frozen {
        let (copy, span) = (*leaf, present.span);
        let own = state.push_solid(SolidKind::Leaf(copy), span);
        let object = state.objects.entries[id].bound_mut()?;
        (object.solid, object.frozen) = (own, false);
        own
    } else {
        solid
    };
    match &mut state.solids[own.index()].kind {
        SolidKind::Leaf(leaf) => Some(leaf),
        SolidKind::Combine { .. } | SolidKind::Paint { .. } => None,
    }
}

/// The statement that combined an object, if one did.
fn combination_of(state: &State<'_>, id: NameId) -> Option<Span> {
    let object = state.objects.entries[id].bound()?;
    let solid = &state.solids[object.solid.index()];
    match solid.kind {
        SolidKind::Leaf(_) => None,
        SolidKind::Combine { .. } => Some(solid.span),
        SolidKind::Paint { inside, .. } => Some(state.solids[inside.index()].span),
    }
}

fn of_a_combination(name: &str, line: Span, combined: Span) -> Diagnostic {
    let name = quote(&format!("!{name}"));
    Diagnostic::new(
        Code::TransformedCombination,
        format!("{name} is a combination and can't be transformed"),
        line,
        "only base objects can be transformed",
    )
    .label(combined, "it was combined here")
    .help("transform the base objects instead, on lines before this combination")
}

/// Whether a transform maps everything into a plane, its scales having multiplied to 0.
fn vanishes(transform: &Transform) -> bool {
    let rows = transform.linear.transpose();
    transform.linear.is_finite() && [rows.x_axis, rows.y_axis, rows.z_axis].contains(&DVec3::ZERO)
}

fn out_of_range(name: &str, line: Span, vanished: bool) -> Diagnostic {
    let name = quote(&format!("!{name}"));
    if vanished {
        return Diagnostic::new(
            Code::ZeroScale,
            format!("the scales of {name} multiply to 0"),
            line,
            "with this one the object vanishes",
        )
        .help("make the scales of this object larger");
    }
    Diagnostic::new(
        Code::TransformOverflow,
        format!("the transforms of {name} leave the range of a double"),
        line,
        "with this one a number becomes infinite",
    )
    .help("bring the scales and distances of this object nearer to 1")
}
