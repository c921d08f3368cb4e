//! Where rays cross the surface of the whole solid, the union of all islands.

use fearless_simd::Simd;
use scenec_plan::{Child, Real};

use crate::hits::Hits;
use crate::island::Room;
use crate::lanes::{LANES, Lanes, Set};
use crate::ray::Rays;
use crate::stage::{Prepared, Stage};
use crate::visitors::{Blocked, Farthest, Seeker};
use crate::walk::{Waiting, walk};

/// Room that one thread uses again and again.
pub(crate) struct Scratch<R> {
    /// For islands.
    room: Room<R>,
    /// What waits on a way through the hierarchy.
    waiting: Waiting<R>,
    /// What stood before each light the last time: it often stands before it again.
    blockers: Vec<Option<Child>>,
}

impl<R: Real> Scratch<R> {
    pub(crate) fn new(scene: &Prepared<R>) -> Self {
        Self {
            room: Room::new(),
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
    if lanes & rays.inside != 0 {
        let left = leave(stage, rays, lanes & rays.inside, scratch);
        for lane in Set(left.met) {
            hits.copy(lane, &left);
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
    let mut seeker = Seeker {
        stage,
        rays,
        room: &mut scratch.room,
        kept: Blocked::new(&rays.end),
    };
    let outside = lanes & !rays.inside;
    if outside != 0 {
        let blocker = &mut scratch.blockers[light];
        let found = walk(stage, (rays, outside), *blocker, &mut scratch.waiting, &mut seeker);
        *blocker = found.or(*blocker);
    }
    let mut found = seeker.kept.rays;
    if lanes & rays.inside != 0 {
        let left = leave(stage, rays, lanes & rays.inside, scratch);
        for lane in Set(left.met) {
            found |= u32::from(left.distance[lane] < rays.end[lane]) << lane;
        }
    }
    found
}

/// From outside: a union is entered where the first of its parts is.
// A function of its own, not a part of both places that ask.
#[inline(never)]
fn enter<R: Lanes, S: Simd>(stage: Stage<'_, R, S>, rays: &Rays<R>, lanes: u32, scratch: &mut Scratch<R>) -> Hits<R> {
    stage.simd.vectorize(
        #[inline(always)]
        || {
            let mut seeker = Seeker {
                stage,
                rays,
                room: &mut scratch.room,
                kept: Hits::NONE,
            };
            if lanes != 0 {
                walk(stage, (rays, lanes), None, &mut scratch.waiting, &mut seeker);
            }
            seeker.kept
        },
    )
}

/// From inside: a union is left where a point is reached that no part holds. Each round goes to the farthest end among
/// the parts that hold the point reached so far.
// A function of its own, not a part of every place that asks: few rays come here.
#[inline(never)]
fn leave<R: Lanes, S: Simd>(stage: Stage<'_, R, S>, rays: &Rays<R>, lanes: u32, scratch: &mut Scratch<R>) -> Hits<R> {
    stage.simd.vectorize(
        #[inline(always)]
        || {
            let (mut open, mut hits) = (lanes, Hits::NONE);
            let mut at = [R::ZERO; LANES];
            while open != 0 {
                let mut seeker = Seeker {
                    stage,
                    rays,
                    room: &mut scratch.room,
                    kept: Farthest::new(&at),
                };
                walk(stage, (rays, open), None, &mut scratch.waiting, &mut seeker);
                let mut reached = seeker.kept.hits;
                // No part holds the start, which lies within rounding of the surface: on to where the solid begins.
                let astray = open & !reached.met & !hits.met;
                if astray != 0 {
                    let entered = enter(stage, rays, astray, scratch);
                    open &= !(astray & !entered.met);
                    for lane in Set(entered.met) {
                        reached.copy(lane, &entered);
                    }
                }
                // Those are out that were in a part and are in none now.
                open &= reached.met;
                for lane in Set(open) {
                    at[lane] = reached.distance[lane];
                    hits.copy(lane, &reached);
                    if at[lane] == R::INFINITY {
                        hits.met &= !(1 << lane);
                        open &= !(1 << lane);
                    }
                }
            }
            hits
        },
    )
}
