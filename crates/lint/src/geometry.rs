//! Geometry that is certain: what lies inside what, what lies apart, what a point is in, what the camera can't see.
//!
//! Everything is shown in doubles on the scene's own numbers, with allowance for rounding, and where that is not enough to
//! be certain nothing is said. Large scenes are dealt with by boxes and a tree over them, and each question has a bound
//! on its work, beyond which it stays unanswered.

mod bounds;
mod groups;
mod pairs;
mod point;
mod proof;
mod relation;
mod shape;
mod spectral;
mod tree;
mod verdicts;
mod view;

use scenec_scene::{DVec3, Scene, SolidId, SolidKind};

use bounds::Bounds;
use groups::{Group, Groups};
use relation::Prover;

pub(crate) use bounds::{above, below};
pub(crate) use groups::{Covered, Member};
pub(crate) use point::Side;
pub(crate) use proof::figure;
pub(crate) use shape::{Ball, SLACK, frobenius};
pub(crate) use spectral::largest_singular;
pub(crate) use verdicts::{Operand, Outcome, Verdict};
pub(crate) use view::Frustum;

/// What was found out about the submitted solid.
pub(crate) struct Geometry {
    /// Subtractions and intersections that do less than they seem to.
    pub(crate) verdicts: Vec<Verdict>,
    /// Members of unions that add nothing to them.
    pub(crate) covered: Vec<Covered>,
    /// Whether the submitted solid is certain to be empty.
    pub(crate) empty: bool,
    /// What the submitted solid is a union of; itself, if it is no union.
    root: Group,
}

/// Where a point is.
pub(crate) enum Place {
    /// In this member of the submitted union.
    Inside(Member),
    /// In none of them.
    Outside,
    /// That is not certain.
    Unknown,
}

impl Geometry {
    pub(crate) fn of(scene: &Scene) -> Self {
        let reached = reached(scene);
        let bounds = bounds::all(scene);
        let prover = Prover { scene, bounds: &bounds };
        let (verdicts, empty) = verdicts::all(prover, &reached);
        let is_empty = |id: SolidId| empty.get(id.index()).copied().unwrap_or_default();
        let (mut covered, mut root) = (Vec::new(), None);
        Groups::new(scene).each(&reached, |members, repeated| {
            let group = Group::new(members, &bounds);
            covered.extend(repeated);
            covered.extend(group.covered(prover, is_empty));
            root.get_or_insert(group);
        });
        Self {
            verdicts,
            covered,
            empty: is_empty(scene.root),
            root: root.unwrap_or_else(|| Group::new(Vec::new(), &bounds)),
        }
    }

    /// Where a point is. Looking takes `steps`; without any left, nothing is certain.
    pub(crate) fn place(&self, scene: &Scene, point: DVec3, steps: &mut u64) -> Place {
        let around = Bounds {
            low: point.to_array().map(below),
            high: point.to_array().map(above),
        };
        let mut near = self.root.unbounded.clone();
        *steps = steps.saturating_sub(near.len() as u64);
        self.root.tree.holding(&around, steps, |number| near.push(number));
        *steps = steps.saturating_sub(near.len() as u64);
        if *steps == 0 {
            return Place::Unknown;
        }
        let mut certain = true;
        for member in near.into_iter().filter_map(|number| self.root.member(number)) {
            match point::side(scene, member.solid, point) {
                Side::In => return Place::Inside(member),
                Side::Out => {}
                Side::Unknown => certain = false,
            }
        }
        if certain { Place::Outside } else { Place::Unknown }
    }

    /// Enough steps to place a number of points, unless very many members are near each.
    pub(crate) fn steps_for(&self, points: usize) -> u64 {
        (self.root.members.len() as u64 + 1024) * 16 + points as u64 * 1024
    }
}

/// Which solids the submitted one is made of: combinations stand behind their operands.
fn reached(scene: &Scene) -> Vec<bool> {
    let mut reached = vec![false; scene.solids.len()];
    let mark = |id: SolidId, reached: &mut Vec<bool>| {
        if let Some(reached) = reached.get_mut(id.index()) {
            *reached = true;
        }
    };
    mark(scene.root, &mut reached);
    for (index, solid) in scene.solids.iter().enumerate().rev() {
        if reached.get(index) != Some(&true) {
            continue;
        }
        match solid.kind {
            SolidKind::Leaf(_) => {}
            SolidKind::Paint { inside, .. } => mark(inside, &mut reached),
            SolidKind::Combine { left, right, .. } => {
                mark(left, &mut reached);
                mark(right, &mut reached);
            }
        }
    }
    reached
}
