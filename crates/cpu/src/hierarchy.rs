//! Where a ray crosses the surface of the whole solid, the union of all islands.

use std::ops::Range;

use scenec_plan::packed_structs::{Island, Node};
use scenec_plan::{HIERARCHY_DEPTH, Packed, Real};

use crate::event::{Hit, entered, left};
use crate::ray::Ray;
use crate::shape::Interval;
use crate::vector::Vector;

/// Room that one thread uses again and again.
pub(crate) struct Scratch<R> {
    /// The intervals of one island's members along one ray.
    intervals: Vec<Interval<R>>,
    /// Nodes that wait, each with the distance at which the ray enters it.
    waiting: Vec<(R, u32)>,
}

impl<R> Scratch<R> {
    pub(crate) fn new() -> Self {
        Self {
            intervals: Vec::new(),
            waiting: Vec::with_capacity(HIERARCHY_DEPTH),
        }
    }
}

/// The first crossing of the solid's surface.
#[inline(always)]
pub(crate) fn first<R: Real>(scene: &Packed<R>, ray: &Ray<R>, scratch: &mut Scratch<R>) -> Option<Hit<R>> {
    if ray.inside {
        leave(scene, ray, scratch)
    } else {
        enter(scene, ray, scratch)
    }
}

/// Whether the ray crosses the surface before `until`.
#[inline(always)]
pub(crate) fn blocked<R: Real>(scene: &Packed<R>, ray: &Ray<R>, until: R, scratch: &mut Scratch<R>) -> bool {
    if ray.inside {
        return leave(scene, ray, scratch).is_some_and(|hit| hit.distance < until);
    }
    let mut cursor = Cursor::new(scene, ray, R::ZERO, until, &mut scratch.waiting);
    while let Some(island) = cursor.next() {
        if let Some(hit) = entered(scene, island, ray, until, &mut scratch.intervals)
            && hit.distance < until
        {
            return true;
        }
    }
    false
}

/// From outside: a union is entered where the first of its parts is; of two at the same distance the left one owns.
#[inline(always)]
fn enter<R: Real>(scene: &Packed<R>, ray: &Ray<R>, scratch: &mut Scratch<R>) -> Option<Hit<R>> {
    let mut nearest: Option<Hit<R>> = None;
    let mut cursor = Cursor::new(scene, ray, R::ZERO, R::INFINITY, &mut scratch.waiting);
    while let Some(island) = cursor.next() {
        if let Some(hit) = entered(scene, island, ray, cursor.until, &mut scratch.intervals)
            && nearest.is_none_or(|best| (hit.distance, hit.leaf) < (best.distance, best.leaf))
        {
            cursor.until = hit.distance;
            nearest = Some(hit);
        }
    }
    nearest
}

/// From inside: a union is left where a point is reached that no part holds. Each round goes to the farthest end among
/// the parts that hold the point reached so far.
#[inline(always)]
fn leave<R: Real>(scene: &Packed<R>, ray: &Ray<R>, scratch: &mut Scratch<R>) -> Option<Hit<R>> {
    let mut at = R::ZERO;
    let mut reached: Option<Hit<R>> = None;
    loop {
        let mut farthest: Option<Hit<R>> = None;
        let mut cursor = Cursor::new(scene, ray, at, at, &mut scratch.waiting);
        while let Some(island) = cursor.next() {
            let Some(hit) = left(scene, island, ray, at, &mut scratch.intervals) else {
                continue;
            };
            if hit.distance == R::INFINITY {
                return None;
            }
            if farthest.is_none_or(|best| (best.distance, hit.leaf) < (hit.distance, best.leaf)) {
                farthest = Some(hit);
            }
        }
        reached = match (farthest, reached) {
            (Some(hit), _) => Some(hit),
            (None, Some(hit)) => return Some(hit),
            // No part holds the start, which lies within rounding of the surface: on to where the solid begins.
            (None, None) => Some(enter(scene, ray, scratch)?),
        };
        at = reached.map_or(at, |hit| hit.distance);
    }
}

/// Hands out the islands whose box the ray meets between `from` and `until`, near ones first; its user may lower `until`
/// on the way.
struct Cursor<'a, R> {
    scene: &'a Packed<R>,
    origin: Vector<R>,
    inverse: Vector<R>,
    from: R,
    until: R,
    /// The islands that come next.
    islands: Range<u32>,
    waiting: &'a mut Vec<(R, u32)>,
}

impl<'a, R: Real> Cursor<'a, R> {
    #[inline(always)]
    fn new(scene: &'a Packed<R>, ray: &Ray<R>, from: R, until: R, waiting: &'a mut Vec<(R, u32)>) -> Self {
        waiting.clear();
        let [x, y, z] = ray.direction;
        let cursor = Self {
            scene,
            origin: ray.origin,
            inverse: [R::ONE / x, R::ONE / y, R::ONE / z],
            from,
            until,
            islands: 0..scene.frame.linear,
            waiting,
        };
        if let Some(root) = scene.nodes.first()
            && let Some(entry) = cursor.meets(root)
        {
            cursor.waiting.push((entry, 0));
        }
        cursor
    }

    #[inline(always)]
    fn next(&mut self) -> Option<&'a Island> {
        while self.islands.is_empty() {
            let (entry, index) = self.waiting.pop()?;
            // `until` may have come nearer since the node was put aside.
            if entry <= self.until * slack() {
                self.descend(index);
            }
        }
        let index = self.islands.start;
        self.islands.start += 1;
        self.scene.islands.get(index as usize)
    }

    /// Goes down to the nearest leaf below a node and puts the farther children aside.
    #[inline(always)]
    fn descend(&mut self, index: u32) {
        let mut node = &self.scene.nodes[index as usize];
        while node.count == 0 {
            let (a, b) = (node.first, node.first + 1);
            let (near, far) = match (self.meets_child(a), self.meets_child(b)) {
                (Some(x), Some(y)) if y < x => (b, Some((x, a))),
                (Some(_), Some(y)) => (a, Some((y, b))),
                (Some(_), None) => (a, None),
                (None, Some(_)) => (b, None),
                (None, None) => return,
            };
            if let Some(far) = far {
                self.waiting.push(far);
            }
            node = &self.scene.nodes[near as usize];
        }
        self.islands = node.first..node.first + node.count;
    }

    #[inline(always)]
    fn meets_child(&self, index: u32) -> Option<R> {
        self.meets(&self.scene.nodes[index as usize])
    }

    /// Where the ray enters the node's box, if it is in it somewhere between `from` and `until`. A component of the
    /// direction that is 0 gives infinities, or a NaN that `min` and `max` pass over.
    #[inline(always)]
    fn meets(&self, node: &Node) -> Option<R> {
        let (mut near, mut far) = (-R::INFINITY, R::INFINITY);
        for axis in 0..3 {
            let low = (R::of_f32(node.low[axis]) - self.origin[axis]) * self.inverse[axis];
            let high = (R::of_f32(node.high[axis]) - self.origin[axis]) * self.inverse[axis];
            near = near.max(low.min(high));
            far = far.min(low.max(high));
        }
        let far = far * slack();
        (near <= far && near <= self.until * slack() && far >= self.from).then_some(near)
    }
}

/// 1 + 2 gamma(3), rounded up: what the three roundings of a box distance can be worth (Ize 2013).
#[inline(always)]
fn slack<R: Real>() -> R {
    let eight = R::TWO * R::TWO * R::TWO;
    R::ONE + eight * R::ROUNDOFF
}
