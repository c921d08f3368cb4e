//! What is certain about the subtractions and intersections of a scene.

use scenec_scene::{Op, SolidId, SolidKind};

use super::proof::Proof;
use super::relation::{Prover, bare};

/// What a combination comes to.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Verdict {
    /// The combination.
    pub(crate) node: SolidId,
    pub(crate) outcome: Outcome,
}

/// Which of two operands.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Operand {
    Left,
    Right,
}

/// Why a combination does less than it seems to.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Outcome {
    /// Both operands are the same solid.
    Coincident,
    /// The operands of a subtraction have no point in common.
    RemovesNothing(Proof),
    /// The left operand of a subtraction lies inside the right one.
    RemovesAll(Proof),
    /// The operands of an intersection have no point in common.
    Empty(Proof),
    /// This operand of an intersection holds the other.
    Idle(Operand, Proof),
}

/// The verdicts on what is reached, operands first, and for every solid whether it is certain to be empty. About what has an
/// empty operand nothing more is said.
pub(super) fn all(prover: Prover<'_>, reached: &[bool]) -> (Vec<Verdict>, Vec<bool>) {
    let mut verdicts = Vec::new();
    let mut empty: Vec<bool> = Vec::with_capacity(prover.scene.solids.len());
    for (index, solid) in prover.scene.solids.iter().enumerate() {
        let at = |id: SolidId| empty.get(id.index()).copied().unwrap_or_default();
        let here = match solid.kind {
            SolidKind::Leaf(_) => false,
            SolidKind::Paint { inside, .. } => at(inside),
            SolidKind::Combine { op, left, right } => match (op, at(left), at(right)) {
                _ if reached.get(index) != Some(&true) => false,
                (Op::Union, left, right) => left && right,
                (_, true, _) => true,
                (op, false, true) => op == Op::Intersection,
                (op, false, false) => {
                    let outcome = judge(prover, op, left, right);
                    let node = SolidId(index as u32);
                    verdicts.extend(outcome.map(|outcome| Verdict { node, outcome }));
                    match outcome {
                        Some(Outcome::RemovesAll(_) | Outcome::Empty(_)) => true,
                        Some(Outcome::Coincident) => op == Op::Subtraction,
                        _ => false,
                    }
                }
            },
        };
        empty.push(here);
    }
    (verdicts, empty)
}

fn judge(prover: Prover<'_>, op: Op, left: SolidId, right: SolidId) -> Option<Outcome> {
    let [left, right] = [left, right].map(|id| bare(prover.scene, id));
    if prover.same(left, right) {
        return Some(Outcome::Coincident);
    }
    let apart = prover.apart(left, right);
    let left_in_right = || prover.inside(left, right);
    if op == Op::Subtraction {
        return apart
            .map(Outcome::RemovesNothing)
            .or_else(|| left_in_right().map(Outcome::RemovesAll));
    }
    apart
        .map(Outcome::Empty)
        .or_else(|| left_in_right().map(|proof| Outcome::Idle(Operand::Right, proof)))
        .or_else(|| {
            prover
                .inside(right, left)
                .map(|proof| Outcome::Idle(Operand::Left, proof))
        })
}
