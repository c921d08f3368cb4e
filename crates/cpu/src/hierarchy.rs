//! Where a ray crosses the surface of the whole solid, the union of all islands.

use scenec_plan::packed_structs::{Island, Node};
use scenec_plan::{HIERARCHY_DEPTH, Packed, Real};

use crate::event::{Crossings, Hit, Scratch};
use crate::ray::Ray;
use crate::vector::Vector;

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
    let mut blocked = false;
    visit(scene, ray, R::ZERO, until, |island, _| {
        let hit = Crossings::new(scene, island, ray, scratch).change(R::ZERO, until, false);
        blocked = hit.is_some_and(|hit| hit.distance < until);
        blocked
    });
    blocked
}

/// From outside: a union is entered where the first of its parts is; of two at the same distance the left one owns.
#[inline(always)]
fn enter<R: Real>(scene: &Packed<R>, ray: &Ray<R>, scratch: &mut Scratch<R>) -> Option<Hit<R>> {
    let mut nearest: Option<Hit<R>> = None;
    visit(scene, ray, R::ZERO, R::INFINITY, |island, until| {
        if let Some(hit) = Crossings::new(scene, island, ray, scratch).change(R::ZERO, *until, false)
            && nearest.is_none_or(|best| (hit.distance, hit.leaf) < (best.distance, best.leaf))
        {
            *until = hit.distance;
            nearest = Some(hit);
        }
        false
    });
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
        let mut endless = false;
        visit(scene, ray, at, at, |island, _| {
            let crossings = Crossings::new(scene, island, ray, scratch);
            if crossings.holds(at) {
                match crossings.change(at, R::INFINITY, true) {
                    None => endless = true,
                    Some(hit) => {
                        let later = |best: Hit<R>| {
                            hit.distance > best.distance || (hit.distance == best.distance && hit.leaf < best.leaf)
                        };
                        if farthest.is_none_or(later) {
                            farthest = Some(hit);
                        }
                    }
                }
            }
            endless
        });
        if endless {
            return None;
        }
        match (farthest, reached) {
            (Some(hit), _) => {
                at = hit.distance;
                reached = Some(hit);
            }
            (None, Some(hit)) => return Some(hit),
            // No part holds the start, which lies within rounding of the surface: on to where the solid begins.
            (None, None) => {
                let begin = enter(scene, ray, scratch)?;
                at = begin.distance;
                reached = Some(begin);
            }
        }
    }
}

/// Calls `visit` with every island whose box the ray meets between `from` and `until`, near ones first, until it says
/// to stop; it may lower `until`.
#[inline(always)]
fn visit<R: Real>(
    scene: &Packed<R>,
    ray: &Ray<R>,
    from: R,
    mut until: R,
    mut visit: impl FnMut(&Island, &mut R) -> bool,
) {
    for island in &scene.islands[..scene.frame.linear as usize] {
        if visit(island, &mut until) {
            return;
        }
    }
    let Some(root) = scene.nodes.first() else {
        return;
    };
    let inverse = ray.direction.map(|d| R::ONE / d);
    let mut waiting = [(R::ZERO, 0_u32); HIERARCHY_DEPTH];
    let mut count = 0;
    let Some(mut entry) = meets(root, ray.origin, inverse, from, until) else {
        return;
    };
    let mut index = 0_u32;
    loop {
        let node = &scene.nodes[index as usize];
        // `until` may have come nearer since the node was put aside.
        if entry <= until * slack() {
            if node.count > 0 {
                for island in &scene.islands[node.first as usize..(node.first + node.count) as usize] {
                    if visit(island, &mut until) {
                        return;
                    }
                }
            } else {
                let (a, b) = (node.first, node.first + 1);
                let meets = |child: u32| meets(&scene.nodes[child as usize], ray.origin, inverse, from, until);
                let next = match (meets(a), meets(b)) {
                    (Some(near), Some(far)) => {
                        let (near, far) = if far < near {
                            ((far, b), (near, a))
                        } else {
                            ((near, a), (far, b))
                        };
                        waiting[count] = far;
                        count += 1;
                        Some(near)
                    }
                    (Some(near), None) => Some((near, a)),
                    (None, Some(far)) => Some((far, b)),
                    (None, None) => None,
                };
                if let Some(next) = next {
                    (entry, index) = next;
                    continue;
                }
            }
        }
        if count == 0 {
            return;
        }
        count -= 1;
        (entry, index) = waiting[count];
    }
}

/// 1 + 2 gamma(3), rounded up: what the three roundings of a box distance can be worth (Ize 2013).
#[inline(always)]
fn slack<R: Real>() -> R {
    let eight = R::TWO * R::TWO * R::TWO;
    R::ONE + eight * R::ROUNDOFF
}

/// Where the ray enters the node's box, if it is in it somewhere between `from` and `until`. A component of the direction
/// that is 0 gives infinities, or a NaN that `min` and `max` pass over.
#[inline(always)]
fn meets<R: Real>(node: &Node, origin: Vector<R>, inverse: Vector<R>, from: R, until: R) -> Option<R> {
    let (mut near, mut far) = (-R::INFINITY, R::INFINITY);
    for axis in 0..3 {
        let low = (R::of(f64::from(node.low[axis])) - origin[axis]) * inverse[axis];
        let high = (R::of(f64::from(node.high[axis])) - origin[axis]) * inverse[axis];
        near = near.max(low.min(high));
        far = far.min(low.max(high));
    }
    let far = far * slack();
    (near <= far && near <= until * slack() && far >= from).then_some(near)
}
