//! What one forward pass over the solids tells about each of them.

use scenec_scene::{Op, Scene, SolidId, SolidKind};

use crate::Box3;

/// Facts of one solid; operands stand before their combinations, so one pass gathers them all.
#[derive(Clone, Copy, Debug)]
pub(crate) struct NodeFacts {
    /// What holds it, world units.
    pub(crate) bounds: Box3,
    /// How many leaves its tree has, every use counted; saturates.
    pub(crate) leaves: u64,
    /// How many solids have it as an operand.
    pub(crate) uses: u32,
}

const UNREACHED: NodeFacts = NodeFacts {
    bounds: Box3::EMPTY,
    leaves: 0,
    uses: 0,
};

/// The facts of every solid up to the root; those that the root does not reach are left blank.
pub(crate) fn gather(scene: &Scene) -> Vec<NodeFacts> {
    let count = scene.root.index() + 1;
    let mut uses = vec![0_u32; count];
    uses[count - 1] = 1;
    for index in (0..count).rev() {
        if uses[index] > 0 {
            let mut used = |operand: SolidId| uses[operand.index()] = uses[operand.index()].saturating_add(1);
            match scene.solids[index].kind {
                SolidKind::Leaf(_) => {}
                SolidKind::Paint { inside, .. } => used(inside),
                SolidKind::Combine { op, left, right } => {
                    used(left);
                    if left != right || op == Op::Subtraction {
                        used(right);
                    }
                }
            }
        }
    }
    let mut facts = vec![UNREACHED; count];
    for (index, solid) in scene.solids.iter().take(count).enumerate() {
        if uses[index] > 0 {
            let uses = uses[index];
            facts[index] = NodeFacts {
                uses,
                ..of(scene, &solid.kind, &facts)
            };
        }
    }
    facts
}

fn of(scene: &Scene, kind: &SolidKind, facts: &[NodeFacts]) -> NodeFacts {
    match kind {
        SolidKind::Leaf(leaf) => NodeFacts {
            bounds: Box3::of_leaf(leaf.base, &scene.transform(leaf)),
            leaves: 1,
            uses: 0,
        },
        SolidKind::Paint { inside, .. } => facts[inside.index()],
        // A solid with itself: see the walks.
        SolidKind::Combine { op, left, right } if left == right => match op {
            Op::Subtraction => NodeFacts {
                bounds: Box3::EMPTY,
                leaves: facts[left.index()].leaves.saturating_mul(2),
                uses: 0,
            },
            Op::Union | Op::Intersection => facts[left.index()],
        },
        SolidKind::Combine { op, left, right } => {
            let (left, right) = (facts[left.index()], facts[right.index()]);
            NodeFacts {
                bounds: match op {
                    Op::Union => left.bounds.hull(right.bounds),
                    Op::Intersection => left.bounds.intersection(right.bounds),
                    Op::Subtraction => left.bounds,
                },
                leaves: left.leaves.saturating_add(right.leaves),
                uses: 0,
            }
        }
    }
}
