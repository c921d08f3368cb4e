//! The scene model: settings, materials, lights and the tree of solids, each node with the place that made it.
//!
//! It is what a file *means*, in f64 and nothing narrower. It must not know how a file is written, what traces it, or
//! any file or device.

mod camera;
mod combine;
mod material;
mod settings;
mod solid;
mod steps;
mod transform;

pub use camera::{Camera, View, view};
pub use glam::{DMat3, DVec3};
pub use material::{DEFAULT_MATERIAL, Light, MATERIAL_FIELDS, Material, MaterialField};
pub use settings::{SETTINGS, SettingInfo, SettingRange, Settings, setting};
pub use solid::{Base, Leaf, MaterialId, Op, Solid, SolidId, SolidKind};
pub use steps::{Step, StepId, StepKind, Steps};
pub use transform::{Axis, Transform};

/// A whole, valid scene.
#[derive(Clone, Debug)]
pub struct Scene {
    /// The variables that the language itself reads.
    pub settings: Settings,
    /// Every material ever defined, in the order of the file; number 0 is the default one.
    pub materials: Vec<Material>,
    /// The lights as they stand at the end of the file, in the order in which their names first appeared.
    pub lights: Vec<Light>,
    /// The solids: operands stand before the combinations that take them, so one forward pass sees children first.
    /// Nodes that `root` does not reach may be present.
    pub solids: Vec<Solid>,
    /// The transforms of the leaves as they were written; each names the one before it.
    pub steps: Steps,
    /// The submitted solid.
    pub root: SolidId,
}

impl Scene {
    /// The solid with this number.
    ///
    /// # Panics
    /// If the number is of another scene: ids are only ever made with the scene that holds them.
    #[must_use]
    pub fn solid(&self, id: SolidId) -> &Solid {
        &self.solids[id.index()]
    }

    /// Where a leaf of this scene went.
    #[must_use]
    pub fn transform(&self, leaf: &Leaf) -> Transform {
        self.steps.transform(leaf.steps)
    }

    /// The material with this number.
    ///
    /// # Panics
    /// If the number is of another scene.
    #[must_use]
    pub fn material(&self, id: MaterialId) -> &Material {
        &self.materials[id.index()]
    }
}
