//! The way of up to eight rays through the wide hierarchy: each step is taken once by all that take it, so that none of them
//! waits for its own results.

use fearless_simd::{Select, Simd, SimdBase};
use scenec_plan::packed_structs::{Island, WideNode};
use scenec_plan::{Child, HIERARCHY_DEPTH, Kind, Real};

use crate::lanes::{LANES, Lanes, Set, Triple, bits, load, splat, store3, turned};
use crate::ray::Rays;
use crate::stage::Stage;

/// Room for the children that wait, in [`Waiting`]: on each level of the hierarchy all but one of a node's.
const ROOM: usize = (HIERARCHY_DEPTH * LANES).next_power_of_two();

/// A child and the rays that are to go there.
#[derive(Clone, Copy)]
struct Step<R> {
    /// No ray enters it before this distance.
    entry: R,
    child: Child,
    lanes: u32,
}

/// Steps that wait.
pub(crate) struct Waiting<R> {
    list: Box<[Step<R>; ROOM]>,
    count: usize,
}

impl<R: Real> Waiting<R> {
    pub(crate) fn new() -> Self {
        let nothing = Step {
            entry: R::ZERO,
            child: Child::NONE,
            lanes: 0,
        };
        Self {
            list: Box::new([nothing; ROOM]),
            count: 0,
        }
    }

    /// The place of a number, which is never beyond the room; said so that it need not be looked at.
    #[inline(always)]
    const fn at(number: usize) -> usize {
        number % ROOM
    }

    #[inline(always)]
    const fn push(&mut self, step: Step<R>) {
        self.list[Self::at(self.count)] = step;
        self.count += 1;
    }

    /// Lets the last one sink among those from `base` on, which come farther to nearer.
    #[inline(always)]
    fn sink(&mut self, base: usize) {
        let mut at = self.count - 1;
        let sinking = self.list[Self::at(at)];
        while at > base && self.list[Self::at(at - 1)].entry < sinking.entry {
            self.list[Self::at(at)] = self.list[Self::at(at - 1)];
            at -= 1;
        }
        self.list[Self::at(at)] = sinking;
    }

    #[inline(always)]
    const fn pop(&mut self) -> Option<Step<R>> {
        if self.count == 0 {
            return None;
        }
        self.count -= 1;
        Some(self.list[Self::at(self.count)])
    }
}

/// Is shown what rays may meet.
pub(crate) trait Visitor<R: Lanes, S: Simd> {
    /// Whether it gains from seeing near things first.
    const NEAR_FIRST: bool;
    /// Before this distance nothing matters to a ray.
    fn from(&self, lane: usize) -> R;
    /// Beyond these distances nothing matters.
    fn until(&self) -> &[R; LANES];
    /// The balls of a block, to these rays; which rays have seen enough, these and any others.
    fn block(&mut self, lanes: u32, number: usize) -> u32;
    /// An island; the same.
    fn island(&mut self, lanes: u32, island: &Island) -> u32;
}

/// Shows the visitor everything that some of the rays may meet at distances that matter to it, first `guess`. Returns the last child of the hierarchy that was enough for any of them.
#[inline(always)]
pub(crate) fn walk<R: Lanes, S: Simd, V: Visitor<R, S>>(
    stage: Stage<'_, R, S>,
    (rays, mut lanes): (&Rays<R>, u32),
    guess: Option<Child>,
    waiting: &mut Waiting<R>,
    visitor: &mut V,
) -> Option<Child> {
    let (outside, root) = stage.wide.start.split_at(stage.wide.outside);
    let mut found = None;
    // One place that shows things, since the whole test of them becomes a part of each.
    for (number, child) in outside.iter().copied().chain(guess).enumerate() {
        if lanes != 0 {
            let enough = show(stage, lanes, child, visitor);
            lanes &= !enough;
            if enough != 0 && number == outside.len() {
                found = Some(child);
            }
        }
    }
    match root.first() {
        Some(root) if lanes != 0 => descend(stage, (rays, lanes), *root, waiting, visitor).or(found),
        _ => found,
    }
}

/// The same of the hierarchy alone.
// A function of its own, so that what it needs all the way has the registers to itself.
#[inline(never)]
fn descend<R: Lanes, S: Simd, V: Visitor<R, S>>(
    stage: Stage<'_, R, S>,
    (rays, mut open): (&Rays<R>, u32),
    root: Child,
    waiting: &mut Waiting<R>,
    visitor: &mut V,
) -> Option<Child> {
    stage.simd.vectorize(
        #[inline(always)]
        || {
            let slabs = Slabs::new(stage.simd, rays);
            waiting.count = 0;
            let mut found = None;
            let mut next = Some((root, open));
            while let Some((child, lanes)) = next {
                next = if let Kind::Node(index) = child.kind() {
                    slabs.next(lanes, &stage.wide.nodes[index], visitor, waiting)
                } else {
                    let enough = show(stage, lanes, child, visitor);
                    if enough != 0 {
                        found = Some(child);
                        open &= !enough;
                        if open == 0 {
                            return found;
                        }
                    }
                    None
                };
                while next.is_none() {
                    let Some(Step { entry, child, lanes }) = waiting.pop() else {
                        return found;
                    };
                    let mut lanes = lanes & open;
                    if V::NEAR_FIRST {
                        // The visitor may have come nearer since this was put aside.
                        let until = load::<R, S>(stage.simd, visitor.until()) * splat::<R, S>(stage.simd, slack());
                        lanes &= bits(splat::<R, S>(stage.simd, entry).simd_le(until));
                    }
                    next = (lanes != 0).then_some((child, lanes));
                }
            }
            found
        },
    )
}

/// Shows the visitor what is in a block or run; which of the rays have seen enough.
#[inline(always)]
fn show<R: Lanes, S: Simd, V: Visitor<R, S>>(stage: Stage<'_, R, S>, lanes: u32, child: Child, visitor: &mut V) -> u32 {
    let mut enough = 0;
    match child.kind() {
        Kind::Block(index) => enough = visitor.block(lanes, index),
        Kind::Run(index) => {
            let [first, end] = stage.wide.runs[index];
            for island in &stage.islands[first as usize..end as usize] {
                if lanes & !enough != 0 {
                    enough |= visitor.island(lanes & !enough, island);
                }
            }
        }
        Kind::Node(_) => {}
    }
    enough & lanes
}

/// What rays need for boxes.
struct Slabs<'a, R, S> {
    simd: S,
    origin: &'a Triple<R>,
    inverse: Triple<R>,
    /// By axis, the rays that come to the upper corner first.
    downwards: [u32; 3],
}

impl<'a, R: Lanes, S: Simd> Slabs<'a, R, S> {
    /// No component of the direction counts as smaller than the largest number's inverse, so that no product is 0 times
    /// infinity. Boxes are wider than what is in them, so that a ray along a face meets nothing there.
    #[inline(always)]
    fn new(simd: S, rays: &'a Rays<R>) -> Self {
        let largest = splat::<R, S>(simd, R::of_f32(f32::MAX));
        let (zero, one) = (splat::<R, S>(simd, R::ZERO), splat::<R, S>(simd, R::ONE));
        let (mut inverse, mut downwards) = ([zero; 3], [0; 3]);
        for axis in 0..3 {
            inverse[axis] = (one / load::<R, S>(simd, &rays.direction[axis]))
                .max(-largest)
                .min(largest);
            downwards[axis] = bits(inverse[axis].simd_lt(zero));
        }
        Self {
            simd,
            origin: &rays.origin,
            inverse: store3(inverse),
            downwards,
        }
    }

    /// The child to go on with, and which rays do; others wait.
    #[inline(always)]
    fn next<V: Visitor<R, S>>(
        &self,
        lanes: u32,
        node: &WideNode,
        visitor: &V,
        waiting: &mut Waiting<R>,
    ) -> Option<(Child, u32)> {
        let mut entry = splat::<R, S>(self.simd, R::INFINITY);
        // Which boxes a ray meets, a byte to each.
        let (mut sets, mut any) = (0, 0);
        for lane in Set(lanes) {
            let met = self.meets(lane, node, (visitor.from(lane), visitor.until()[lane]), &mut entry);
            any |= met;
            sets |= u64::from(met) << (LANES * lane);
        }
        // And which rays meet a box.
        let sets = turned(sets);
        let to = |child: usize| (sets >> (LANES * child)) as u32 & 0xff;
        let mut met = Set(any);
        let first = met.next()?;
        if met.0 == 0 {
            return Some((node.children[first], to(first)));
        }
        let entry = entry.to_array();
        let base = waiting.count;
        for child in Set(any) {
            waiting.push(Step {
                entry: entry[child],
                child: node.children[child],
                lanes: to(child),
            });
            if V::NEAR_FIRST {
                waiting.sink(base);
            }
        }
        waiting.pop().map(|step| (step.child, step.lanes))
    }

    /// Which boxes a ray is in somewhere between `from` and `until`; lowers to where it enters them.
    #[inline(always)]
    fn meets(&self, lane: usize, node: &WideNode, (from, until): (R, R), entry: &mut R::Eight<S>) -> u32 {
        let simd = self.simd;
        let corner = |axis: usize| (self.downwards[axis] >> lane & 1) as usize;
        let (i, j, k) = (corner(0), corner(1), corner(2));
        let (x, y, z) = (
            self.to(lane, node, i, 0),
            self.to(lane, node, j, 1),
            self.to(lane, node, k, 2),
        );
        let near = x.max(y).max(z.max(splat::<R, S>(simd, from)));
        let (x, y, z) = (
            self.to(lane, node, 1 - i, 0),
            self.to(lane, node, 1 - j, 1),
            self.to(lane, node, 1 - k, 2),
        );
        let widened = splat::<R, S>(simd, slack());
        let far = x.min(y).min(z.min(splat::<R, S>(simd, until))) * widened;
        let met = near.simd_le(far);
        *entry = entry.min(met.select(near, *entry));
        bits(met)
    }

    /// The distances to one side of the boxes: of their lower or upper corner, across an axis.
    #[inline(always)]
    fn to(&self, lane: usize, node: &WideNode, corner: usize, axis: usize) -> R::Eight<S> {
        let origin = splat::<R, S>(self.simd, self.origin[axis][lane]);
        (R::of_singles(self.simd, &node.bounds[corner][axis]) - origin)
            * splat::<R, S>(self.simd, self.inverse[axis][lane])
    }
}

/// 1 + 2 gamma(3), rounded up: what the three roundings of a box distance can be worth (Ize 2013).
#[inline(always)]
fn slack<R: Real>() -> R {
    let eight = R::TWO * R::TWO * R::TWO;
    R::ONE + eight * R::ROUNDOFF
}
