//! Where rays cross the surface of the whole solid, the union of all islands.

use fearless_simd::Simd;
use scenec_plan::{Child, Real};

use crate::hits::{Hit, Hits};
use crate::lanes::{LANES, Lanes, Set};
use crate::ray::Rays;
use crate::shape::Interval;
use crate::stage::{Prepared, Stage};
use crate::visitors::{Blocked, Entries, Farthest};
use crate::walk::{Waiting, walk};

/// Room that one thread uses again and again.
pub(crate) struct Scratch<R> {
    /// The intervals of one island's members along one ray.
    intervals: Vec<Interval<R>>,
    /// What waits on a way through the hierarchy.
    waiting: Waiting<R>,
    /// What stood before each light the last time: it often stands before it again.
    blockers: Vec<Option<Child>>,
}

impl<R: Real> Scratch<R> {
    pub(crate) fn new(scene: &Prepared<R>) -> Self {
        Self {
            intervals: Vec::new(),
            waiting: Waiting::new(),
            blockers: vec![None; scene.lights.len()],
        }
    }
}

/// The first crossings of the solid's surface by some of the rays.
#[inline(always)]
pub(crate) fn first<R: Lanes, S: Simd>(
    stage: Stage<'_, R, S>,
    rays: &Rays<R>,
    lanes: u32,
    scratch: &mut Scratch<R>,
) -> Hits<R> {
    let mut hits = enter(stage, rays, lanes & !rays.inside, scratch);
    for lane in Set(lanes & rays.inside) {
        if let Some(hit) = leave(stage, rays, lane, scratch) {
            hits.set(lane, hit);
        }
    }
    hits
}

/// Which of the rays to this light cross the surface before it.
#[inline(always)]
pub(crate) fn blocked<R: Lanes, S: Simd>(
    stage: Stage<'_, R, S>,
    rays: &Rays<R>,
    lanes: u32,
    light: usize,
    scratch: &mut Scratch<R>,
) -> u32 {
    let mut entries = Entries {
        stage,
        rays,
        intervals: &mut scratch.intervals,
        kept: Blocked::new(&rays.end),
    };
    let outside = lanes & !rays.inside;
    if outside != 0 {
        let blocker = &mut scratch.blockers[light];
        let found = walk(
            stage,
            (rays, outside),
            R::ZERO,
            *blocker,
            &mut scratch.waiting,
            &mut entries,
        );
        *blocker = found.or(*blocker);
    }
    let mut found = entries.kept.rays;
    for lane in Set(lanes & rays.inside) {
        let hit = leave(stage, rays, lane, scratch);
        found |= u32::from(hit.is_some_and(|hit| hit.distance < rays.end[lane])) << lane;
    }
    found
}

/// From outside: a union is entered where the first of its parts is.
#[inline(always)]
fn enter<R: Lanes, S: Simd>(stage: Stage<'_, R, S>, rays: &Rays<R>, lanes: u32, scratch: &mut Scratch<R>) -> Hits<R> {
    let mut entries = Entries {
        stage,
        rays,
        intervals: &mut scratch.intervals,
        kept: Hits::NONE,
    };
    if lanes != 0 {
        walk(stage, (rays, lanes), R::ZERO, None, &mut scratch.waiting, &mut entries);
    }
    entries.kept
}

/// From inside: a union is left where a point is reached that no part holds. Each round goes to the farthest end among
/// the parts that hold the point reached so far.
// A function of its own, not a part of every place that asks: few rays come here.
#[inline(never)]
fn leave<R: Lanes, S: Simd>(
    stage: Stage<'_, R, S>,
    rays: &Rays<R>,
    lane: usize,
    scratch: &mut Scratch<R>,
) -> Option<Hit<R>> {
    stage.simd.vectorize(
        #[inline(always)]
        || {
            let mut reached: Option<Hit<R>> = None;
            loop {
                let at = reached.map_or(R::ZERO, |hit| hit.distance);
                let mut farthest = Farthest {
                    stage,
                    rays,
                    lane,
                    intervals: &mut scratch.intervals,
                    at: [at; LANES],
                    hit: None,
                };
                walk(stage, (rays, 1 << lane), at, None, &mut scratch.waiting, &mut farthest);
                reached = match (farthest.hit, reached) {
                    (Some(hit), _) if hit.distance == R::INFINITY => return None,
                    (Some(hit), _) => Some(hit),
                    (None, Some(hit)) => return Some(hit),
                    // No part holds the start, which lies within rounding of the surface: on to where the solid begins.
                    (None, None) => Some(enter(stage, rays, 1 << lane, scratch).get(lane)?),
                };
            }
        },
    )
}
