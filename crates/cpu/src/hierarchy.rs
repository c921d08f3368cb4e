//! Where a ray crosses the surface of the whole solid, the union of all islands.

use fearless_simd::Simd;
use scenec_plan::packed_structs::Island;
use scenec_plan::{Child, Real};

use crate::balls::{Line, entries, near, of_class};
use crate::event::{Ball, Hit, entered, entered_leaf, left, left_leaf};
use crate::lanes::{Lanes, Set};
use crate::ray::Ray;
use crate::shape::Interval;
use crate::stage::Stage;
use crate::walk::{Visitor, Waiting, walk};

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
    pub(crate) fn new(lights: usize) -> Self {
        Self {
            intervals: Vec::new(),
            waiting: Waiting::new(),
            blockers: vec![None; lights],
        }
    }
}

/// The first crossing of the solid's surface.
#[inline(always)]
pub(crate) fn first<R: Lanes, S: Simd>(
    stage: Stage<'_, R, S>,
    ray: &Ray<R>,
    scratch: &mut Scratch<R>,
) -> Option<Hit<R>> {
    if ray.inside {
        leave(stage, ray, scratch)
    } else {
        enter(stage, ray, scratch)
    }
}

/// Whether the ray to this light crosses the surface before `until`.
#[inline(always)]
pub(crate) fn blocked<R: Lanes, S: Simd>(
    stage: Stage<'_, R, S>,
    ray: &Ray<R>,
    (light, until): (usize, R),
    scratch: &mut Scratch<R>,
) -> bool {
    if ray.inside {
        return leave(stage, ray, scratch).is_some_and(|hit| hit.distance < until);
    }
    let mut any = Any {
        stage,
        ray,
        intervals: &mut scratch.intervals,
        until,
        found: false,
    };
    let blocker = &mut scratch.blockers[light];
    let found = walk(stage, ray, R::ZERO, *blocker, &mut scratch.waiting, &mut any);
    *blocker = found.or(*blocker);
    any.found
}

/// From outside: a union is entered where the first of its parts is; of two at the same distance the left one owns.
#[inline(always)]
fn enter<R: Lanes, S: Simd>(stage: Stage<'_, R, S>, ray: &Ray<R>, scratch: &mut Scratch<R>) -> Option<Hit<R>> {
    let mut nearest = Nearest {
        stage,
        ray,
        intervals: &mut scratch.intervals,
        until: R::INFINITY,
        hit: None,
    };
    walk(stage, ray, R::ZERO, None, &mut scratch.waiting, &mut nearest);
    nearest.hit
}

/// From inside: a union is left where a point is reached that no part holds. Each round goes to the farthest end among
/// the parts that hold the point reached so far.
// A function of its own, not a part of every place that asks: few rays come here.
#[inline(never)]
fn leave<R: Lanes, S: Simd>(stage: Stage<'_, R, S>, ray: &Ray<R>, scratch: &mut Scratch<R>) -> Option<Hit<R>> {
    stage.simd.vectorize(
        #[inline(always)]
        || {
            let mut reached: Option<Hit<R>> = None;
            loop {
                let at = reached.map_or(R::ZERO, |hit| hit.distance);
                let mut farthest = Farthest {
                    stage,
                    ray,
                    intervals: &mut scratch.intervals,
                    at,
                    hit: None,
                };
                walk(stage, ray, at, None, &mut scratch.waiting, &mut farthest);
                reached = match (farthest.hit, reached) {
                    (Some(hit), _) if hit.distance == R::INFINITY => return None,
                    (Some(hit), _) => Some(hit),
                    (None, Some(hit)) => return Some(hit),
                    // No part holds the start, which lies within rounding of the surface: on to where the solid begins.
                    (None, None) => Some(enter(stage, ray, scratch)?),
                };
            }
        },
    )
}

/// Keeps the first entry.
struct Nearest<'a, R, S> {
    stage: Stage<'a, R, S>,
    ray: &'a Ray<R>,
    intervals: &'a mut Vec<Interval<R>>,
    until: R,
    hit: Option<Hit<R>>,
}

impl<R: Lanes, S: Simd> Nearest<'_, R, S> {
    #[inline(always)]
    fn keep(&mut self, hit: Hit<R>) {
        if self
            .hit
            .is_none_or(|best| (hit.distance, hit.leaf) < (best.distance, best.leaf))
        {
            self.until = hit.distance;
            self.hit = Some(hit);
        }
    }
}

impl<R: Lanes, S: Simd> Visitor<R, S> for Nearest<'_, R, S> {
    const NEAR_FIRST: bool = true;

    #[inline(always)]
    fn until(&self) -> R {
        self.until
    }

    #[inline(always)]
    fn block(&mut self, line: &Line<R, S>, number: usize) -> bool {
        let block = &self.stage.scene.wide.blocks[number];
        if let Some(entries) = entries(block, line, self.ray, self.until) {
            for lane in entries.lanes {
                self.keep(Hit {
                    distance: entries.distance[lane],
                    leaf: block.leaf[lane],
                    leaving: false,
                    ball: Some(Ball {
                        block: number as u32,
                        lane: lane as u32,
                    }),
                });
            }
        }
        false
    }

    #[inline(always)]
    fn island(&mut self, island: &Island) -> bool {
        if let Some(hit) = entered(self.stage.scene, island, self.ray, self.until, self.intervals) {
            self.keep(hit);
        }
        false
    }
}

/// Stops at any entry.
struct Any<'a, R, S> {
    stage: Stage<'a, R, S>,
    ray: &'a Ray<R>,
    intervals: &'a mut Vec<Interval<R>>,
    until: R,
    found: bool,
}

impl<R: Lanes, S: Simd> Visitor<R, S> for Any<'_, R, S> {
    const NEAR_FIRST: bool = false;

    #[inline(always)]
    fn until(&self) -> R {
        self.until
    }

    #[inline(always)]
    fn block(&mut self, line: &Line<R, S>, number: usize) -> bool {
        let block = &self.stage.scene.wide.blocks[number];
        let until = self.until;
        if self.ray.end.is_touching() {
            // What is known of the light decides there, whatever the numbers say.
            for lane in Set(block.there) {
                let hit = entered_leaf(self.stage.scene, block.leaf[lane], self.ray, until);
                self.found = self.found || hit.is_some_and(|hit| hit.distance < until);
            }
        } else if let Some(entries) = entries(block, line, self.ray, until) {
            for lane in entries.lanes {
                self.found = self.found || entries.distance[lane] < until;
            }
        }
        self.found
    }

    #[inline(always)]
    fn island(&mut self, island: &Island) -> bool {
        let hit = entered(self.stage.scene, island, self.ray, self.until, self.intervals);
        self.found = hit.is_some_and(|hit| hit.distance < self.until);
        self.found
    }
}

/// Keeps the last end among the parts that hold a point of the ray.
struct Farthest<'a, R, S> {
    stage: Stage<'a, R, S>,
    ray: &'a Ray<R>,
    intervals: &'a mut Vec<Interval<R>>,
    at: R,
    hit: Option<Hit<R>>,
}

impl<R: Lanes, S: Simd> Farthest<'_, R, S> {
    /// Whether there is no end at all, so that no other matters.
    #[inline(always)]
    fn keep(&mut self, hit: Option<Hit<R>>) -> bool {
        if let Some(hit) = hit
            && self
                .hit
                .is_none_or(|best| (best.distance, hit.leaf) < (hit.distance, best.leaf))
        {
            self.hit = Some(hit);
        }
        hit.is_some_and(|hit| hit.distance == R::INFINITY)
    }
}

impl<R: Lanes, S: Simd> Visitor<R, S> for Farthest<'_, R, S> {
    const NEAR_FIRST: bool = false;

    #[inline(always)]
    fn until(&self) -> R {
        self.at
    }

    #[inline(always)]
    fn block(&mut self, line: &Line<R, S>, number: usize) -> bool {
        let block = &self.stage.scene.wide.blocks[number];
        // The same of the light, and of the ball that the ray starts on.
        let lanes = if self.ray.end.is_touching() {
            block.there
        } else {
            near(block, line).0 | of_class(block, self.ray.class) & block.there
        };
        let mut enough = false;
        for lane in Set(lanes) {
            enough = enough || self.keep(left_leaf(self.stage.scene, block.leaf[lane], self.ray, self.at));
        }
        enough
    }

    #[inline(always)]
    fn island(&mut self, island: &Island) -> bool {
        let hit = left(self.stage.scene, island, self.ray, self.at, self.intervals);
        self.keep(hit)
    }
}
