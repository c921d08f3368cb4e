//! Solids combined with themselves.

use scenec_interpret::{DefinitionId, Role, SymbolId};
use scenec_scene::{Op, Scene, SolidId, SolidKind};
use scenec_text::{Code, Diagnostic, Span};

use super::{Written, leave_out, made, names};
use crate::context::Context;
use crate::findings::Findings;
use crate::geometry::{Covered, Outcome};

rule! {
    /// A solid combined with one that is the same: in a union or an intersection the second one changes nothing, and
    /// a subtraction leaves nothing.
    ///
    /// Two solids are the same if their surfaces agree to 2^-40 of their size, however they got there: a ball turned about
    /// its centre is still the same ball. Where surfaces coincide, the material of the left operand shows.
    ///
    /// A union of an object with itself is the way to copy it, so `!b := a | a` is reported only if nothing comes of the copy: if
    /// it gets no material of its own, and `!a` is neither changed nor bound again afterwards.
    ///
    /// ## Example
    ///
    /// ```scene
    /// !ball := sphere
    /// !ball += 1 0 0
    /// !twin := sphere
    /// !twin += 0 0 1
    /// !twin #y= 1.5707963267948966
    /// !both := ball | twin
    /// !both <=
    /// ```
    ///
    /// ## Fixed
    ///
    /// ```scene
    /// !ball := sphere
    /// !ball += 1 0 0
    /// !twin := sphere
    /// !twin += -1 0 0
    /// !both := ball | twin
    /// !both <=
    /// ```
    CoincidentOperands, check
}

fn check(context: &Context<'_>, findings: &mut Findings) {
    let Some((scene, geometry)) = context.geometry() else {
        return;
    };
    for verdict in &geometry.verdicts {
        if let Outcome::Coincident = verdict.outcome {
            combined(context, scene, verdict.node)
                .into_iter()
                .for_each(|finding| findings.push(finding));
        }
    }
    let mut last = None;
    for covered in geometry.covered.iter().filter(|covered| covered.proof.is_none()) {
        let last = last.get_or_insert_with(|| last_definitions(context));
        united(context, scene, covered, last)
            .into_iter()
            .for_each(|finding| findings.push(finding));
    }
}

/// The number of each symbol's last definition, plus one.
fn last_definitions(context: &Context<'_>) -> Vec<usize> {
    let mut last = vec![0; context.interpretation.symbols.symbols().len()];
    for (number, definition) in (1..).zip(context.definitions()) {
        let SymbolId(symbol) = definition.symbol;
        if let Some(last) = last.get_mut(symbol as usize) {
            *last = number;
        }
    }
    last
}

/// An intersection or a subtraction.
fn combined(context: &Context<'_>, scene: &Scene, node: SolidId) -> Option<Diagnostic> {
    let Written { left, right, statement } = Written::of(context, scene, node)?;
    let empty = matches!(
        scene.solid(node).kind,
        SolidKind::Combine {
            op: Op::Subtraction,
            ..
        }
    );
    let (does, label) = if empty {
        ("leaves nothing", "this is empty")
    } else {
        ("changes nothing", "this is the left operand again")
    };
    let message = if left.name == right.name {
        format!("combining {} with itself {does}", left.name)
    } else {
        format!(
            "{} and {} are the same solid, so combining them {does}",
            left.name, right.name
        )
    };
    let finding = Diagnostic::new(Code::CoincidentOperands, message, statement, label);
    let finding = made(finding, left.made, "the one");
    let finding = made(finding, right.made, "the other");
    Some(finding.help("move or scale one of them, or remove the combination"))
}

/// Two members of a union, or one that it takes twice.
fn united(context: &Context<'_>, scene: &Scene, covered: &Covered, last: &[usize]) -> Option<Diagnostic> {
    let (inner, outer) = (covered.inner.solid, covered.outer.solid);
    let taker = scene.solid(covered.inner.taker).span;
    let [name, other] = names(context, scene, covered);
    if inner != outer {
        let finding = Diagnostic::new(
            Code::CoincidentOperands,
            format!("{name} is the same solid as {other} and adds nothing to their union"),
            scene.solid(inner).span,
            "the same shape in the same place",
        );
        let finding = made(finding, scene.solid(outer).span, "as this one");
        let finding = made(finding, taker, "united here");
        let mut finding = finding.help("move or scale one of them, or remove it");
        finding.fix = leave_out(context, scene, covered.inner);
        return Some(finding);
    }
    if copies(context, taker, last) {
        return None;
    }
    let finding = Diagnostic::new(
        Code::CoincidentOperands,
        format!("{name} is part of this union already"),
        taker,
        "taking it once more adds nothing",
    );
    let mut finding = made(finding, scene.solid(inner).span, "this is taken twice").help("leave it out here");
    finding.fix = leave_out(context, scene, covered.inner);
    Some(finding)
}

/// Whether a statement copies an object to some purpose.
fn copies(context: &Context<'_>, statement: Span, last: &[usize]) -> bool {
    let places = context.places_on(statement);
    let read: Vec<DefinitionId> = places
        .filter(|place| place.role == Role::Use)
        .filter_map(|place| place.definition)
        .collect();
    let [original, again] = read[..] else { return false };
    if original != again {
        return false;
    }
    let painted = context
        .definition_at(statement)
        .is_some_and(|copy| context.edits(copy).next().is_some());
    let changed = context.edits(original).any(|edit| edit.span.start > statement.start);
    let SymbolId(symbol) = context
        .definition(original)
        .map_or(SymbolId(u32::MAX), |made| made.symbol);
    let rebound = last
        .get(symbol as usize)
        .is_some_and(|last| *last > original.index() + 1);
    let onto_itself = context
        .definition_at(statement)
        .and_then(|copy| context.definition(copy))
        .is_some_and(|copy| copy.symbol.0 == symbol);
    painted || changed || (rebound && !onto_itself)
}
