//! Lists of intervals against the plain question whether a point is in the solid.

use scenec_scene::{Axis, Base, DVec3, MaterialId, Op, Scene, SolidId, SolidKind, Transform};

use super::{Build, scene};
use crate::shape::Line;
use crate::tree::Tree;

/// Numbers without a pattern, the same on every run (Marsaglia's xorshift64).
struct Dice(u64);

impl Dice {
    /// Below `sides`.
    fn roll(&mut self, sides: u64) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) % sides
    }

    /// From -1 to 1.
    fn number(&mut self) -> f64 {
        self.roll(1 << 40) as f64 / f64::from(1 << 20) / f64::from(1 << 19) - 1.0
    }

    fn vector(&mut self) -> DVec3 {
        DVec3::new(self.number(), self.number(), self.number())
    }
}

/// A tree over this many leaves; later operands are as likely earlier leaves as earlier combinations.
fn tree(dice: &mut Dice, leaves: u32, half_spaces_in_ten: u64) -> Scene {
    let mut scene = scene();
    for _ in 0..leaves {
        let flat = dice.roll(10) < half_spaces_in_ten;
        let size = DVec3::ONE + dice.vector() * 0.7;
        let transform = Transform::IDENTITY
            .scaled(size)
            .rotated(Axis::Z, dice.number() * 3.0)
            .rotated(Axis::X, dice.number() * 3.0)
            .translated(dice.vector() * 2.0);
        let base = if flat { Base::HalfSpace } else { Base::Sphere };
        scene.leaf(base, transform, MaterialId::DEFAULT);
    }
    for count in leaves..2 * leaves {
        let mut operand = || SolidId(dice.roll(u64::from(count)) as u32);
        let (left, right) = (operand(), operand());
        let op = [Op::Union, Op::Intersection, Op::Subtraction][dice.roll(3) as usize];
        scene.combine(op, left, right);
    }
    scene
}

/// Whether the point is in the submitted solid; `None` if it is so near a surface that rounding decides.
fn holds(scene: &Scene, point: DVec3) -> Option<bool> {
    let mut members: Vec<bool> = Vec::new();
    for solid in &scene.solids {
        members.push(match &solid.kind {
            SolidKind::Leaf(leaf) => {
                let transform = scene.transform(leaf);
                let p = transform.inverse * (point - transform.centre);
                let depth = match leaf.base {
                    Base::Sphere => 1.0 - p.length(),
                    Base::HalfSpace => -p.y,
                };
                if depth.abs() < 1e-9 {
                    return None;
                }
                depth > 0.0
            }
            SolidKind::Combine { op, left, right } => {
                let (left, right) = (members[left.index()], members[right.index()]);
                match op {
                    Op::Union => left | right,
                    Op::Intersection => left & right,
                    Op::Subtraction => left & !right,
                }
            }
            SolidKind::Paint { inside, .. } => members[inside.index()],
        });
    }
    members.last().copied()
}

fn check(seed: u64, leaves: u32, half_spaces_in_ten: u64) {
    let mut dice = Dice(seed);
    let mut seen = [0; 2];
    for _ in 0..40 {
        let scene = tree(&mut dice, leaves, half_spaces_in_ten);
        let tree = Tree::new(&scene);
        for _ in 0..50 {
            let line = Line::new(dice.vector() * 2.0, dice.vector());
            let list = tree.along(&line);
            for _ in 0..20 {
                let t = dice.number() * 3.0;
                let passed = list.edges.iter().filter(|edge| edge.t <= t).count();
                let inside = list.before ^ (passed % 2 == 1);
                if let Some(expect) = holds(&scene, line.origin + t * line.direction) {
                    assert_eq!(inside, expect, "seed {seed}, {leaves} leaves, {line:?}, t = {t}");
                    seen[usize::from(inside)] += 1;
                }
            }
            assert!(list.edges.windows(2).all(|pair| pair[0].t < pair[1].t));
            for (index, edge) in list.edges.iter().enumerate() {
                let entering = list.before ^ (index % 2 == 0);
                assert_eq!(edge.normal.dot(line.direction) < 0.0, entering, "{edge:?}");
            }
        }
    }
    assert!(seen[0] > 200 && seen[1] > 200, "{seen:?}: too few of one kind to tell");
}

#[test]
fn lists_say_of_every_point_what_the_tree_says() {
    for (seed, leaves, half_spaces_in_ten) in [(1, 2, 0), (2, 2, 5), (3, 8, 3), (4, 64, 3), (5, 64, 0), (6, 16, 10)] {
        check(seed, leaves, half_spaces_in_ten);
    }
}
