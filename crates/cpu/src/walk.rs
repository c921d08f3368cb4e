//! The way of one ray through the wide hierarchy.

use fearless_simd::{Simd, SimdBase};
use scenec_plan::packed_structs::{Island, WideNode};
use scenec_plan::{Child, HIERARCHY_DEPTH, Kind, Real};

use crate::balls::Line;
use crate::lanes::{LANES, Lanes, Set, Vector8, bits, splat, splat3};
use crate::ray::Ray;
use crate::stage::Stage;

/// Room for the children that wait, in [`Waiting`]: on each level of the hierarchy all but one of a node's.
const ROOM: usize = (HIERARCHY_DEPTH * LANES).next_power_of_two();

/// Children that wait, each with the distance at which the ray enters it.
pub(crate) struct Waiting<R> {
    list: Box<[(R, Child); ROOM]>,
    count: usize,
}

impl<R: Real> Waiting<R> {
    pub(crate) fn new() -> Self {
        Self {
            list: Box::new([(R::ZERO, Child::NONE); ROOM]),
            count: 0,
        }
    }

    /// The place of a number, which is never beyond the room; said so that it need not be looked at.
    #[inline(always)]
    const fn at(number: usize) -> usize {
        number % ROOM
    }

    #[inline(always)]
    fn push(&mut self, entry: R, child: Child) {
        self.list[Self::at(self.count)] = (entry, child);
        self.count += 1;
    }

    /// Lets the last one sink among those from `base` on, which come farther to nearer.
    #[inline(always)]
    fn sink(&mut self, base: usize) {
        let mut at = self.count - 1;
        let sinking = self.list[Self::at(at)];
        while at > base && self.list[Self::at(at - 1)].0 < sinking.0 {
            self.list[Self::at(at)] = self.list[Self::at(at - 1)];
            at -= 1;
        }
        self.list[Self::at(at)] = sinking;
    }

    #[inline(always)]
    fn pop(&mut self) -> Option<(R, Child)> {
        self.count = self.count.checked_sub(1)?;
        Some(self.list[Self::at(self.count)])
    }
}

/// Is shown what the ray may meet.
pub(crate) trait Visitor<R: Lanes, S: Simd> {
    /// Whether it gains from seeing near things first.
    const NEAR_FIRST: bool;
    /// Beyond this distance nothing matters.
    fn until(&self) -> R;
    /// The balls of a block; whether it has seen enough.
    fn block(&mut self, line: &Line<R, S>, number: usize) -> bool;
    /// An island; whether it has seen enough.
    fn island(&mut self, island: &Island) -> bool;
}

/// Shows the visitor everything that the ray may meet at a distance from `from` up to what the visitor says, first `guess`.
/// Returns the child of the hierarchy that was enough for it, if one was.
#[inline(always)]
pub(crate) fn walk<R: Lanes, S: Simd, V: Visitor<R, S>>(
    stage: Stage<'_, R, S>,
    ray: &Ray<R>,
    from: R,
    guess: Option<Child>,
    waiting: &mut Waiting<R>,
    visitor: &mut V,
) -> Option<Child> {
    let (outside, root) = stage.wide.start.split_at(stage.wide.outside);
    for child in outside {
        if show(stage, ray, *child, visitor) {
            return None;
        }
    }
    let root = *root.first()?;
    if let Some(child) = guess
        && show(stage, ray, child, visitor)
    {
        return guess;
    }
    descend(stage, ray, from, root, waiting, visitor)
}

/// The same of the hierarchy alone.
// A function of its own, so that what it needs all the way has the registers to itself.
#[inline(never)]
fn descend<R: Lanes, S: Simd, V: Visitor<R, S>>(
    stage: Stage<'_, R, S>,
    ray: &Ray<R>,
    from: R,
    root: Child,
    waiting: &mut Waiting<R>,
    visitor: &mut V,
) -> Option<Child> {
    stage.simd.vectorize(
        #[inline(always)]
        || {
            let line = Line::new(stage.simd, ray);
            let slabs = Slabs::new(stage.simd, ray, from);
            waiting.count = 0;
            let mut next = Some(root);
            while let Some(child) = next {
                next = match child.kind() {
                    Kind::Node(index) => slabs.next(&line, &stage.wide.nodes[index], visitor, waiting),
                    Kind::Block(index) if visitor.block(&line, index) => return Some(child),
                    Kind::Run(_) if show(stage, ray, child, visitor) => return Some(child),
                    _ => None,
                };
                while next.is_none() {
                    let (entry, child) = waiting.pop()?;
                    // The visitor may have come nearer since this was put aside.
                    next = (!V::NEAR_FIRST || entry <= visitor.until() * slack::<R>()).then_some(child);
                }
            }
            None
        },
    )
}

/// Shows the visitor what is in a block or run; whether it has seen enough.
#[inline(always)]
fn show<R: Lanes, S: Simd, V: Visitor<R, S>>(
    stage: Stage<'_, R, S>,
    ray: &Ray<R>,
    child: Child,
    visitor: &mut V,
) -> bool {
    match child.kind() {
        Kind::Block(index) => visitor.block(&Line::new(stage.simd, ray), index),
        Kind::Run(index) => {
            let [first, end] = stage.wide.runs[index];
            let mut enough = false;
            for island in &stage.islands[first as usize..end as usize] {
                enough = enough || visitor.island(island);
            }
            enough
        }
        Kind::Node(_) => false,
    }
}

/// What a ray needs for boxes.
struct Slabs<R: Lanes, S: Simd> {
    inverse: Vector8<R, S>,
    /// By axis, which corner the ray comes to first.
    near: [usize; 3],
    from: R,
}

impl<R: Lanes, S: Simd> Slabs<R, S> {
    /// No component of the direction counts as smaller than the largest number's inverse, so that no product is 0 times
    /// infinity. Boxes are wider than what is in them, so that a ray along a face meets nothing there.
    #[inline(always)]
    fn new(simd: S, ray: &Ray<R>, from: R) -> Self {
        let largest = R::of_f32(f32::MAX);
        let [x, y, z] = ray.direction;
        let inverse = [
            (R::ONE / x).max(-largest).min(largest),
            (R::ONE / y).max(-largest).min(largest),
            (R::ONE / z).max(-largest).min(largest),
        ];
        Self {
            inverse: splat3(simd, inverse),
            near: [
                usize::from(inverse[0] < R::ZERO),
                usize::from(inverse[1] < R::ZERO),
                usize::from(inverse[2] < R::ZERO),
            ],
            from,
        }
    }

    /// The child to go on with; others wait.
    #[inline(always)]
    fn next<V: Visitor<R, S>>(
        &self,
        line: &Line<R, S>,
        node: &WideNode,
        visitor: &V,
        waiting: &mut Waiting<R>,
    ) -> Option<Child> {
        let (met, entry) = self.meets(line, node, visitor.until());
        let mut met = Set(met);
        let first = met.next()?;
        if met.0 == 0 {
            return Some(node.children[first]);
        }
        let entry = entry.to_array();
        let base = waiting.count;
        waiting.push(entry[first], node.children[first]);
        for lane in met {
            waiting.push(entry[lane], node.children[lane]);
            if V::NEAR_FIRST {
                waiting.sink(base);
            }
        }
        let (_, next) = waiting.pop()?;
        Some(next)
    }

    /// Which boxes the ray is in somewhere between `from` and `until`, and where it enters them.
    #[inline(always)]
    fn meets(&self, line: &Line<R, S>, node: &WideNode, until: R) -> (u32, R::Eight<S>) {
        let [i, j, k] = self.near;
        let (x, y, z) = (
            self.to(line, node, i, 0),
            self.to(line, node, j, 1),
            self.to(line, node, k, 2),
        );
        let near = x.max(y).max(z.max(splat::<R, S>(line.simd, self.from)));
        let (x, y, z) = (
            self.to(line, node, 1 - i, 0),
            self.to(line, node, 1 - j, 1),
            self.to(line, node, 1 - k, 2),
        );
        let widened = splat::<R, S>(line.simd, slack());
        let far = x.min(y).min(z.min(splat::<R, S>(line.simd, until))) * widened;
        (bits(near.simd_le(far)), near)
    }

    /// The distances to one side of the boxes: of their lower or upper corner, across an axis.
    #[inline(always)]
    fn to(&self, line: &Line<R, S>, node: &WideNode, corner: usize, axis: usize) -> R::Eight<S> {
        (R::of_singles(line.simd, &node.bounds[corner][axis]) - line.origin[axis]) * self.inverse[axis]
    }
}

/// 1 + 2 gamma(3), rounded up: what the three roundings of a box distance can be worth (Ize 2013).
#[inline(always)]
fn slack<R: Real>() -> R {
    let eight = R::TWO * R::TWO * R::TWO;
    R::ONE + eight * R::ROUNDOFF
}
