//! What the submitted object is made of.

use scenec_scene::{Base, MaterialId, Scene, SolidKind};

/// Which solids and materials of a scene show in the submitted object, whatever its operators leave of them.
pub(crate) struct Reach {
    solids: Vec<Reached>,
    materials: Vec<bool>,
    steps: Vec<Option<Base>>,
}

/// How a solid is reached; it may be in both ways, since operands are shared.
#[derive(Clone, Copy, Default)]
struct Reached {
    /// Under a paint, which hides the materials further in.
    painted: bool,
    /// Under none.
    bare: bool,
}

impl Reach {
    /// One backward pass: combinations stand behind their operands.
    pub(super) fn of(scene: &Scene) -> Self {
        let mut solids = vec![Reached::default(); scene.solids.len()];
        let mut materials = vec![false; scene.materials.len()];
        let mut show = |id: MaterialId| {
            if let Some(shown) = materials.get_mut(id.index()) {
                *shown = true;
            }
        };
        if let Some(root) = solids.get_mut(scene.root.index()) {
            root.bare = true;
        }
        for (index, solid) in scene.solids.iter().enumerate().rev() {
            let Some(&here) = solids.get(index) else { continue };
            if !here.painted && !here.bare {
                continue;
            }
            let mut pass_on = |id: scenec_scene::SolidId, here: Reached| {
                if let Some(inside) = solids.get_mut(id.index()) {
                    inside.painted |= here.painted;
                    inside.bare |= here.bare;
                }
            };
            match &solid.kind {
                SolidKind::Combine { left, right, .. } => {
                    pass_on(*left, here);
                    pass_on(*right, here);
                }
                SolidKind::Paint { inside, material } => {
                    if here.bare {
                        show(*material);
                    }
                    pass_on(
                        *inside,
                        Reached {
                            painted: true,
                            bare: false,
                        },
                    );
                }
                SolidKind::Leaf(leaf) if here.bare => show(leaf.material),
                SolidKind::Leaf(_) => {}
            }
        }
        let steps = steps(scene, &solids);
        Self {
            solids,
            materials,
            steps,
        }
    }

    /// Whether the solid with this number is part of the submitted object.
    pub(crate) fn solid(&self, index: usize) -> bool {
        self.solids.get(index).is_some_and(|here| here.painted || here.bare)
    }

    /// Whether the material with this number is that of a part of the submitted object.
    pub(crate) fn material(&self, index: usize) -> bool {
        self.materials.get(index).copied().unwrap_or_default()
    }

    /// The base object that the transform with this number moved, if that is part of the submitted object.
    pub(crate) fn step(&self, index: usize) -> Option<Base> {
        self.steps.get(index).copied().flatten()
    }
}

/// Follows every reached leaf's transforms back, up to those that another leaf of the same object had already.
fn steps(scene: &Scene, solids: &[Reached]) -> Vec<Option<Base>> {
    let mut reached = vec![None; scene.steps.len()];
    for (solid, here) in scene.solids.iter().zip(solids) {
        let SolidKind::Leaf(leaf) = &solid.kind else { continue };
        let mut next = leaf.steps.filter(|_| here.painted || here.bare);
        while let Some(id) = next
            && let Some(seen) = reached.get_mut(id.index())
            && seen.replace(leaf.base).is_none()
        {
            next = scene.steps.get(id).and_then(|step| step.previous);
        }
    }
    reached
}
