//! What one forward pass over the solids tells about each of them.

use scenec_scene::{Op, Scene, SolidKind};

use crate::Box3;

/// Facts of one solid; operands stand before their combinations, so one pass gathers them all.
#[derive(Clone, Copy, Debug)]
pub(crate) struct NodeFacts {
    /// What holds it, world units.
    pub(crate) bounds: Box3,
    /// How many leaves its tree has, every use counted; saturates.
    pub(crate) leaves: u64,
    /// How many intermediate truths its evaluation must hold at once (Sethi and Ullman 1970): at most 1 + log2(leaves).
    pub(crate) height: u32,
}

const UNREACHED: NodeFacts = NodeFacts {
    bounds: Box3::EMPTY,
    leaves: 0,
    height: 0,
};

/// The facts of every solid up to the root; those that the root does not reach are left blank.
pub(crate) fn gather(scene: &Scene) -> Vec<NodeFacts> {
    let count = scene.root.index() + 1;
    let mut reached = vec![false; count];
    reached[count - 1] = true;
    for index in (0..count).rev() {
        if reached[index] {
            match scene.solids[index].kind {
                SolidKind::Leaf(_) => {}
                SolidKind::Paint { inside, .. } => reached[inside.index()] = true,
                SolidKind::Combine { left, right, .. } => {
                    reached[left.index()] = true;
                    reached[right.index()] = true;
                }
            }
        }
    }
    let mut facts = vec![UNREACHED; count];
    for (index, solid) in scene.solids.iter().take(count).enumerate() {
        if reached[index] {
            facts[index] = of(scene, &solid.kind, &facts);
        }
    }
    facts
}

fn of(scene: &Scene, kind: &SolidKind, facts: &[NodeFacts]) -> NodeFacts {
    match kind {
        SolidKind::Leaf(leaf) => NodeFacts {
            bounds: Box3::of_leaf(leaf.base, &scene.transform(leaf)),
            leaves: 1,
            height: 1,
        },
        SolidKind::Paint { inside, .. } => facts[inside.index()],
        // A solid with itself: see the walks.
        SolidKind::Combine { op, left, right } if left == right => match op {
            Op::Subtraction => NodeFacts {
                bounds: Box3::EMPTY,
                leaves: facts[left.index()].leaves.saturating_mul(2),
                height: facts[left.index()].height + 1,
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
                height: if left.height == right.height {
                    left.height + 1
                } else {
                    left.height.max(right.height)
                },
            }
        }
    }
}
