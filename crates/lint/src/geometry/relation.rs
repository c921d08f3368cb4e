//! What can be shown about two solids of several parts, by what is shown about their leaves.

use scenec_scene::{Op, Scene, SolidId, SolidKind};

use super::bounds::Bounds;
use super::pairs;
use super::proof::{Fact, Proof};
use super::shape::Shape;

/// The most pairs of parts that one question may look at. It is also how deep the search can go, so that neither a deep
/// tree nor a wide one takes long; what would need more remains unproved.
const MOST_STEPS: u32 = 64;

/// Asks about solids of one scene.
#[derive(Clone, Copy)]
pub(super) struct Prover<'a> {
    pub(super) scene: &'a Scene,
    pub(super) bounds: &'a [Bounds],
}

impl Prover<'_> {
    /// Why `inner` lies inside `outer` and nowhere touches its surface.
    pub(super) fn inside(self, inner: SolidId, outer: SolidId) -> Option<Proof> {
        self.search_inside(inner, outer, &mut MOST_STEPS.clone())
    }

    /// Why the two have no point in common.
    pub(super) fn apart(self, a: SolidId, b: SolidId) -> Option<Proof> {
        self.search_apart(a, b, &mut MOST_STEPS.clone())
    }

    /// Whether the two are one solid: the same one, or leaves that agree to 2^-40.
    pub(super) fn same(self, a: SolidId, b: SolidId) -> bool {
        let (a, b) = (bare(self.scene, a), bare(self.scene, b));
        a == b || self.leaves(a, b).is_some_and(|(a, b)| pairs::same(&a, &b))
    }

    /// How `inner` lies in `outer`: why it lies inside, as [`Self::inside`] shows, or `None` where the two are the same.
    pub(super) fn within(self, inner: SolidId, outer: SolidId) -> Option<Option<Proof>> {
        let (a, b) = (bare(self.scene, inner), bare(self.scene, outer));
        // Mostly it is one leaf in another, and their shapes take longer to make than to compare.
        if let Some((a, b)) = self.leaves(a, b) {
            let inside = pairs::inside(&a, &b).map(|fact| Some(fact.alone()));
            return inside.or_else(|| pairs::same(&a, &b).then_some(None));
        }
        let inside = self.inside(a, b).map(Some);
        inside.or_else(|| (a == b).then_some(None))
    }

    fn box_of(self, id: SolidId) -> Bounds {
        self.bounds.get(id.index()).copied().unwrap_or(Bounds::EVERYWHERE)
    }

    fn leaves(self, a: SolidId, b: SolidId) -> Option<(Shape, Shape)> {
        let shape = |id| Shape::of(self.scene, self.scene.solid(id));
        Some((shape(a)?, shape(b)?))
    }

    fn parts(self, id: SolidId) -> Option<(Op, SolidId, SolidId)> {
        match self.scene.solid(id).kind {
            SolidKind::Combine { op, left, right } => Some((op, left, right)),
            SolidKind::Leaf(_) | SolidKind::Paint { .. } => None,
        }
    }

    /// At most as deep as there are steps left.
    fn search_inside(self, a: SolidId, b: SolidId, steps: &mut u32) -> Option<Proof> {
        *steps = steps.checked_sub(1)?;
        let (a, b) = (bare(self.scene, a), bare(self.scene, b));
        let (whole, other) = (self.parts(a), self.parts(b));
        if let Some((Op::Union, left, right)) = whole {
            let first = self.search_inside(left, b, steps)?;
            return self.search_inside(right, b, steps).map(|_| first.and_others());
        }
        match other {
            Some((Op::Intersection, left, right)) => {
                let first = self.search_inside(a, left, steps)?;
                return self.search_inside(a, right, steps).map(|_| first.and_others());
            }
            Some((Op::Subtraction, left, right)) => {
                let first = self.search_inside(a, left, steps)?;
                return self.search_apart(a, right, steps).map(|_| first.and_others());
            }
            Some((Op::Union, left, right)) => {
                let either = self.search_inside(a, left, steps);
                if either.is_some() {
                    return either;
                }
                let either = self.search_inside(a, right, steps);
                if either.is_some() {
                    return either;
                }
            }
            None => {}
        }
        match whole {
            Some((Op::Intersection, left, right)) => self
                .search_inside(left, b, steps)
                .or_else(|| self.search_inside(right, b, steps)),
            Some((Op::Subtraction, left, _)) => self.search_inside(left, b, steps),
            Some((Op::Union, ..)) => None,
            None => {
                let (a, b) = self.leaves(a, b)?;
                pairs::inside(&a, &b).map(Fact::alone)
            }
        }
    }

    /// At most as deep as there are steps left.
    fn search_apart(self, a: SolidId, b: SolidId, steps: &mut u32) -> Option<Proof> {
        *steps = steps.checked_sub(1)?;
        let (a, b) = (bare(self.scene, a), bare(self.scene, b));
        let leaves = self.leaves(a, b).and_then(|(a, b)| pairs::apart(&a, &b));
        if let Some(fact) = leaves.or_else(|| self.box_of(a).apart(&self.box_of(b))) {
            return Some(fact.alone());
        }
        for (whole, other) in [(a, b), (b, a)] {
            if let Some((Op::Union, left, right)) = self.parts(whole) {
                let first = self.search_apart(left, other, steps)?;
                return self.search_apart(right, other, steps).map(|_| first.and_others());
            }
        }
        [(a, b), (b, a)].into_iter().find_map(|(whole, other)| {
            let (op, left, right) = self.parts(whole)?;
            self.search_apart(left, other, steps).or_else(|| match op {
                Op::Intersection => self.search_apart(right, other, steps),
                Op::Subtraction => self.search_inside(other, right, steps),
                Op::Union => None,
            })
        })
    }
}

/// The solid under its paint, which has the same shape.
pub(crate) fn bare(scene: &Scene, mut id: SolidId) -> SolidId {
    while let SolidKind::Paint { inside, .. } = scene.solid(id).kind {
        id = inside;
    }
    id
}
