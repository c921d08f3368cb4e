//! Scenes whose answers are known in closed form.

mod frames;
mod light;
mod membership;
mod solids;

use scenec_picture::NOTHING;
use scenec_scene::{
    Base, DEFAULT_MATERIAL, DVec3, Leaf, Light, Material, MaterialId, Op, Scene, Settings, Solid, SolidId, SolidKind,
    Steps, Transform,
};

use crate::shade::{Sight, World};
use crate::tally::Tally;

/// Gives back nothing but what passes through it or is mirrored.
const CLEAR: Material = Material {
    ambient: 0.0,
    diffuse: 0.0,
    specular: 0.0,
    ..DEFAULT_MATERIAL
};

/// A scene with a sky that is white below and black above, so that a ray that ends in it tells how steep it is.
fn scene() -> Scene {
    let mut settings = Settings::gather(|_| None);
    settings.ambient_int = DVec3::ONE;
    settings.lookat = -DVec3::Z;
    settings.raydepth = 8;
    Scene {
        settings,
        materials: vec![DEFAULT_MATERIAL],
        lights: Vec::new(),
        solids: Vec::new(),
        steps: Steps::default(),
        root: SolidId(0),
    }
}

/// Every new solid is the submitted one.
trait Build {
    fn add(&mut self, kind: SolidKind) -> SolidId;

    fn leaf(&mut self, base: Base, transform: Transform, material: MaterialId) -> SolidId;

    fn ball(&mut self, centre: [f64; 3], radius: f64) -> SolidId {
        self.leaf(Base::Sphere, at(centre, radius), MaterialId::DEFAULT)
    }

    fn combine(&mut self, op: Op, left: SolidId, right: SolidId) -> SolidId {
        self.add(SolidKind::Combine { op, left, right })
    }

    fn paint(&mut self, inside: SolidId, material: MaterialId) -> SolidId {
        self.add(SolidKind::Paint { inside, material })
    }

    fn define(&mut self, material: Material) -> MaterialId;

    fn light(&mut self, position: [f64; 3], colour: f64);
}

impl Build for Scene {
    fn add(&mut self, kind: SolidKind) -> SolidId {
        self.root = SolidId(self.solids.len() as u32);
        self.solids.push(Solid {
            kind,
            span: Default::default(),
        });
        self.root
    }

    fn leaf(&mut self, base: Base, transform: Transform, material: MaterialId) -> SolidId {
        let steps = Some(self.steps.place(transform));
        self.add(SolidKind::Leaf(Leaf { base, steps, material }))
    }

    fn define(&mut self, material: Material) -> MaterialId {
        self.materials.push(material);
        MaterialId(self.materials.len() as u32 - 1)
    }

    fn light(&mut self, position: [f64; 3], colour: f64) {
        self.lights.push(Light {
            position: position.into(),
            colour: DVec3::splat(colour),
            span: Default::default(),
        });
    }
}

fn at(centre: [f64; 3], radius: f64) -> Transform {
    Transform::IDENTITY
        .scaled(DVec3::splat(radius))
        .translated(centre.into())
}

/// What one ray sees, and with which account.
fn look(scene: &Scene, eye: [f64; 3], direction: [f64; 3]) -> (Sight, Tally) {
    let mut tally = Tally::new(65_536);
    let sight = World::new(scene).look(eye.into(), DVec3::from(direction).normalize(), &mut tally);
    (sight, tally)
}

/// A ray hits this leaf first and brings back this red, to 12 digits.
fn check(scene: &Scene, eye: [f64; 3], direction: [f64; 3], leaf: Option<SolidId>, red: f64) {
    let (sight, _) = look(scene, eye, direction);
    assert_eq!(sight.leaf, leaf.map_or(NOTHING, |leaf| leaf.0), "{eye:?} {direction:?}");
    let off = (sight.colour.x - red).abs();
    assert!(
        off <= 1e-12 * red.abs().max(1.0),
        "{eye:?} {direction:?}: {} is not {red}",
        sight.colour.x
    );
}

/// The sky's red in this direction.
fn sky(direction: [f64; 3]) -> f64 {
    0.5 - DVec3::from(direction).normalize().y / 2.0
}

/// A material that glows by this much and does nothing else, in a scene whose ambient light is 1.
fn glow(scene: &mut Scene, red: f64) -> MaterialId {
    scene.settings.ambient = DVec3::ONE;
    scene.define(Material {
        ambient: red,
        colour: DVec3::ONE,
        ..CLEAR
    })
}
