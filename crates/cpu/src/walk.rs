//! The way of one ray through the wide hierarchy.

use fearless_simd::{Simd, SimdBase};
use scenec_plan::packed_structs::{Block, Island, WideNode};
use scenec_plan::{Child, Kind, Real};

use crate::balls::Line;
use crate::lanes::{Lanes, Set, Vector8, bits, splat, splat3};
use crate::ray::Ray;
use crate::stage::Stage;

/// Children that wait, each with the distance at which the ray enters it.
pub(crate) type Waiting<R> = Vec<(R, Child)>;

/// Is shown what the ray may meet.
pub(crate) trait Visitor<R: Lanes, S: Simd> {
    /// Whether it gains from seeing near things first.
    const NEAR_FIRST: bool;
    /// Beyond this distance nothing matters.
    fn until(&self) -> R;
    /// Some balls; whether it has seen enough.
    fn block(&mut self, line: &Line<R, S>, block: &Block<R>) -> bool;
    /// An island; whether it has seen enough.
    fn island(&mut self, island: &Island) -> bool;
}

/// Shows the visitor everything that the ray may meet at a distance from `from` up to what the visitor says.
#[inline(always)]
pub(crate) fn walk<R: Lanes, S: Simd, V: Visitor<R, S>>(
    stage: Stage<'_, R, S>,
    ray: &Ray<R>,
    from: R,
    waiting: &mut Waiting<R>,
    visitor: &mut V,
) {
    let line = Line::new(stage.simd, ray);
    let slabs = Slabs::new(stage.simd, ray, from);
    waiting.clear();
    for child in stage.wide.start.iter().rev() {
        waiting.push((R::ZERO, *child));
    }
    while let Some((entry, child)) = waiting.pop() {
        // The visitor may have come nearer since this was put aside.
        if V::NEAR_FIRST && entry > visitor.until() * slack::<R>() {
            continue;
        }
        let mut next = Some(child);
        while let Some(child) = next {
            next = None;
            let enough = match child.kind() {
                Kind::Node(index) => {
                    next = slabs.descend(&line, &stage.wide.nodes[index], visitor, waiting);
                    false
                }
                Kind::Block(index) => visitor.block(&line, &stage.wide.blocks[index]),
                Kind::Run(index) => {
                    let [first, end] = stage.wide.runs[index];
                    let mut enough = false;
                    for island in &stage.islands[first as usize..end as usize] {
                        enough = enough || visitor.island(island);
                    }
                    enough
                }
            };
            if enough {
                return;
            }
        }
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
    fn descend<V: Visitor<R, S>>(
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
        let base = waiting.len();
        waiting.push((entry[first], node.children[first]));
        for lane in met {
            waiting.push((entry[lane], node.children[lane]));
            if V::NEAR_FIRST {
                // Few: the nearest comes to stand last.
                let mut at = waiting.len() - 1;
                while at > base && waiting[at - 1].0 < waiting[at].0 {
                    waiting.swap(at - 1, at);
                    at -= 1;
                }
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
