//! Rewrites of a whole scene.

use crate::{Op, Scene, SolidKind};

impl Scene {
    /// The scene as the original program drew it, which had no tree: every base object inside the submitted one shows,
    /// whatever the operators.
    #[must_use]
    pub fn ignoring_operators(mut self) -> Self {
        for solid in &mut self.solids {
            if let SolidKind::Combine { op, .. } = &mut solid.kind {
                *op = Op::Union;
            }
        }
        self
    }
}
