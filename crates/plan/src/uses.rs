//! How often each solid is an operand.

use scenec_scene::{Op, Scene, SolidId, SolidKind};

/// How many solids have each as an operand, of those that make up the root; none of a solid that the root does not reach. The
/// root has one. Operands stand before their combinations, so one pass backwards counts them all.
pub(crate) fn uses(scene: &Scene) -> Vec<u32> {
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
    uses
}
