//! Geometry that comes to nothing, as far as that is certain.

pub(super) mod buried_eye;
pub(super) mod buried_light;
pub(super) mod coincident_operands;
pub(super) mod covered_solid;
pub(super) mod empty_intersection;
pub(super) mod empty_subtraction;
pub(super) mod idle_intersection;
pub(super) mod idle_subtraction;
pub(super) mod ill_conditioned;
pub(super) mod nothing_in_view;
pub(super) mod too_far_to_resolve;

use scenec_scene::{Scene, SettingInfo, SolidId, SolidKind, setting};
use scenec_syntax::{Statement, quote};
use scenec_text::{Diagnostic, Fix, Span};

use crate::context::Context;
use crate::geometry::{Covered, Member, Operand};

/// A combination as it is written.
struct Written {
    /// The whole statement.
    statement: Span,
    left: Part,
    right: Part,
}

/// An operand as it is written.
struct Part {
    /// Its name in the combination.
    place: Span,
    /// The statement that made it.
    made: Span,
    /// Its name for a message.
    name: String,
}

impl Written {
    /// `None` if the solid is no combination.
    fn of(context: &Context<'_>, scene: &Scene, node: SolidId) -> Option<Self> {
        let solid = scene.solid(node);
        let SolidKind::Combine { left, right, .. } = solid.kind else {
            return None;
        };
        let Some(Statement::Combination {
            left: first,
            right: second,
            ..
        }) = context.statement_at(solid.span)
        else {
            return None;
        };
        let part = |id: SolidId, place: Span| Part {
            place,
            made: scene.solid(id).span,
            name: quote(&format!("!{}", place.of(context.text()))),
        };
        Some(Self {
            statement: solid.span,
            left: part(left, first),
            right: part(right, second),
        })
    }

    fn operand(&self, which: Operand) -> &Part {
        match which {
            Operand::Left => &self.left,
            Operand::Right => &self.right,
        }
    }
}

/// Leaves a member out of a union, and goes without what is there for the union alone, where the other operand has the
/// union's name: `!x := x | ball`. What is seen stays, but its numbers may be rounded otherwise.
fn leave_out(context: &Context<'_>, scene: &Scene, member: Member) -> Option<Fix> {
    let written = Written::of(context, scene, member.taker)?;
    let (part, rest) = match scene.solid(member.taker).kind {
        SolidKind::Combine { right, .. } if right == member.solid => (&written.right, &written.left),
        SolidKind::Combine { left, .. } if left == member.solid => (&written.left, &written.right),
        _ => return None,
    };
    let places: Vec<_> = context.places_on(written.statement).collect();
    let at = |span: Span| places.iter().find(|place| place.span == span);
    let (union, part_at, rest_at) = (places.first()?, at(part.place)?, at(rest.place)?);
    if union.symbol != rest_at.symbol || union.symbol == part_at.symbol {
        return None;
    }
    let mut statements = vec![written.statement];
    let object = part_at.definition?;
    if context.uses(object) == 1 {
        statements.extend(context.definition_and_edits(object));
    }
    let title = format!("leave {} out", part.name);
    let mut fix = context.removal_keeping(title, &statements, rest_at.definition)?;
    fix.safe = false;
    Some(fix)
}

/// Adds the place where something was made, unless the finding names it already.
fn made(finding: Diagnostic, statement: Span, label: impl Into<String>) -> Diagnostic {
    if finding.labels.iter().any(|other| other.span == statement) {
        return finding;
    }
    finding.label(statement, label)
}

/// The name that a solid was made under, for a message.
fn name_of(context: &Context<'_>, scene: &Scene, id: SolidId) -> String {
    let span = scene.solid(id).span;
    let name = context.statement_at(span).map_or(span, |found| found.name());
    quote(&format!("!{}", name.of(context.text())))
}

/// The statement of a setting, or the place that stands for the file as a whole.
fn setting_line(context: &Context<'_>, name: &str) -> Option<Span> {
    let row: &SettingInfo = setting(name)?;
    Some(context.setting(row)?.0)
}

/// The names of a member of a union and of what covers it.
fn names(context: &Context<'_>, scene: &Scene, covered: &Covered) -> [String; 2] {
    let solids = [covered.inner.solid, covered.outer.solid];
    let [inner, outer] = solids.map(|id| name_of(context, scene, id));
    let [one, other] = solids.map(|id| scene.solid(id).span);
    // An object that is edited after it was taken is there in both its states.
    let outer = if one == other {
        format!("another {outer}")
    } else {
        outer
    };
    [inner, outer]
}
