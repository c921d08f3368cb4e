//! Where rays cross the surface of the whole solid, the union of all islands.

use fearless_simd::Simd;
use scenec_plan::packed_structs::Island;
use scenec_plan::{Child, Real};

use crate::balls::Pairs;
use crate::event::{Ball, Hit, entered, entered_leaf, left, left_leaf};
use crate::lanes::{LANES, Lanes, Set, load, splat};
use crate::planes::plane_of;
use crate::ray::Rays;
use crate::shape::Interval;
use crate::stage::{Prepared, Stage};
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
    pub(crate) fn new(scene: &Prepared<R>) -> Self {
        Self {
            intervals: Vec::new(),
            waiting: Waiting::new(),
            blockers: vec![None; scene.lights.len()],
        }
    }
}

/// Crossings of up to eight rays.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Hits<R> {
    /// Along the rays; infinity where nothing is met.
    pub(crate) distance: [R; LANES],
    /// The leaves that own the surfaces there.
    pub(crate) leaf: [u32; LANES],
    /// Where these leaves are, if they are balls of blocks.
    ball: [Ball; LANES],
    /// The rays that meet something, ...
    pub(crate) met: u32,
    /// ... those that leave the leaf there (not: the solid), ...
    pub(crate) leaving: u32,
    /// ... and those whose leaf is a ball of a block.
    in_block: u32,
}

impl<R: Real> Hits<R> {
    const NONE: Self = Self {
        distance: [R::INFINITY; LANES],
        leaf: [u32::MAX; LANES],
        ball: [Ball { block: 0, lane: 0 }; LANES],
        met: 0,
        leaving: 0,
        in_block: 0,
    };

    /// Where the leaf of one of them is, if it is a ball of a block.
    #[inline(always)]
    pub(crate) fn ball(&self, lane: usize) -> Option<Ball> {
        (self.in_block >> lane & 1 == 1).then_some(self.ball[lane])
    }

    #[inline(always)]
    fn get(&self, lane: usize) -> Option<Hit<R>> {
        (self.met >> lane & 1 == 1).then(|| Hit {
            distance: self.distance[lane],
            leaf: self.leaf[lane],
            leaving: self.leaving >> lane & 1 == 1,
            ball: self.ball(lane),
        })
    }

    #[inline(always)]
    fn set(&mut self, lane: usize, hit: Hit<R>) {
        let bit = 1 << lane;
        self.distance[lane] = hit.distance;
        self.leaf[lane] = hit.leaf;
        self.met |= bit;
        self.leaving = self.leaving & !bit | u32::from(hit.leaving) << lane;
        self.in_block = self.in_block & !bit | u32::from(hit.ball.is_some()) << lane;
        if let Some(ball) = hit.ball {
            self.ball[lane] = ball;
        }
    }

    /// Takes a hit if it is nearer; of two at the same distance the left one owns.
    #[inline(always)]
    fn keep(&mut self, lane: usize, hit: Hit<R>) {
        if (hit.distance, hit.leaf) < (self.distance[lane], self.leaf[lane]) {
            self.set(lane, hit);
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
    let mut any = Any {
        stage,
        rays,
        intervals: &mut scratch.intervals,
        found: 0,
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
            &mut any,
        );
        *blocker = found.or(*blocker);
    }
    let mut found = any.found;
    for lane in Set(lanes & rays.inside) {
        let hit = leave(stage, rays, lane, scratch);
        found |= u32::from(hit.is_some_and(|hit| hit.distance < rays.end[lane])) << lane;
    }
    found
}

/// From outside: a union is entered where the first of its parts is.
#[inline(always)]
fn enter<R: Lanes, S: Simd>(stage: Stage<'_, R, S>, rays: &Rays<R>, lanes: u32, scratch: &mut Scratch<R>) -> Hits<R> {
    let mut nearest = Nearest {
        stage,
        rays,
        intervals: &mut scratch.intervals,
        hits: Hits::NONE,
    };
    if lanes != 0 {
        walk(stage, (rays, lanes), R::ZERO, None, &mut scratch.waiting, &mut nearest);
    }
    nearest.hits
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

/// Keeps the first entries.
struct Nearest<'a, R, S> {
    stage: Stage<'a, R, S>,
    rays: &'a Rays<R>,
    intervals: &'a mut Vec<Interval<R>>,
    hits: Hits<R>,
}

impl<R: Lanes, S: Simd> Nearest<'_, R, S> {
    /// Takes an entry into a ball of a block if it is nearer.
    #[inline(always)]
    fn keep(&mut self, lane: usize, (number, place): (usize, usize), distance: R) {
        let ball = Ball {
            block: number as u32,
            lane: place as u32,
        };
        let hit = Hit {
            distance,
            leaf: self.stage.scene.wide.blocks[number].leaf[place],
            leaving: false,
            ball: Some(ball),
        };
        self.hits.keep(lane, hit);
    }
}

impl<R: Lanes, S: Simd> Visitor<R, S> for Nearest<'_, R, S> {
    const NEAR_FIRST: bool = true;

    #[inline(always)]
    fn until(&self) -> &[R; LANES] {
        &self.hits.distance
    }

    #[inline(always)]
    fn block(&mut self, lanes: u32, number: usize) -> u32 {
        let block = &self.stage.scene.wide.blocks[number];
        let (simd, rays) = (self.stage.simd, self.rays);
        if lanes.count_ones() > block.there.count_ones() {
            for place in Set(block.there) {
                let pairs = Pairs::of_ball(simd, block, place, rays, lanes);
                let (lanes, distance) = pairs.entries(load::<R, S>(simd, &self.hits.distance));
                for lane in Set(lanes) {
                    self.keep(lane, (number, place), distance[lane]);
                }
            }
        } else {
            for lane in Set(lanes) {
                let pairs = Pairs::of_block(simd, block, rays, lane);
                let (places, distance) = pairs.entries(splat::<R, S>(simd, self.hits.distance[lane]));
                for place in Set(places) {
                    self.keep(lane, (number, place), distance[place]);
                }
            }
        }
        0
    }

    #[inline(always)]
    fn island(&mut self, lanes: u32, island: &Island) -> u32 {
        if let Some(plane) = plane_of(self.stage.scene, island) {
            let (lanes, distance) = plane.entries(self.stage.simd, self.rays, lanes, &self.hits.distance);
            for lane in Set(lanes) {
                self.hits.keep(lane, plane.hit(distance[lane]));
            }
            return 0;
        }
        for lane in Set(lanes) {
            let (ray, until) = (self.rays.get(lane), self.hits.distance[lane]);
            if let Some(hit) = entered(self.stage.scene, island, &ray, until, self.intervals) {
                self.hits.keep(lane, hit);
            }
        }
        0
    }
}

/// Stops at any entry.
struct Any<'a, R, S> {
    stage: Stage<'a, R, S>,
    rays: &'a Rays<R>,
    intervals: &'a mut Vec<Interval<R>>,
    found: u32,
}

impl<R: Lanes, S: Simd> Visitor<R, S> for Any<'_, R, S> {
    const NEAR_FIRST: bool = false;

    #[inline(always)]
    fn until(&self) -> &[R; LANES] {
        &self.rays.end
    }

    #[inline(always)]
    fn block(&mut self, lanes: u32, number: usize) -> u32 {
        let block = &self.stage.scene.wide.blocks[number];
        let (simd, rays) = (self.stage.simd, self.rays);
        let mut found = 0;
        if rays.is_touching() {
            // What is known of the light decides there, whatever the numbers say.
            for lane in Set(lanes) {
                let (ray, until) = (rays.get(lane), rays.end[lane]);
                for place in Set(block.there) {
                    let hit = entered_leaf(self.stage.scene, block.leaf[place], &ray, until);
                    found |= u32::from(hit.is_some_and(|hit| hit.distance < until)) << lane;
                }
            }
        } else if lanes.count_ones() > block.there.count_ones() {
            for place in Set(block.there) {
                let pairs = Pairs::of_ball(simd, block, place, rays, lanes & !found);
                let (lanes, distance) = pairs.entries(load::<R, S>(simd, &rays.end));
                for lane in Set(lanes) {
                    found |= u32::from(distance[lane] < rays.end[lane]) << lane;
                }
            }
        } else {
            for lane in Set(lanes) {
                let until = rays.end[lane];
                let pairs = Pairs::of_block(simd, block, rays, lane);
                let (places, distance) = pairs.entries(splat::<R, S>(simd, until));
                for place in Set(places) {
                    found |= u32::from(distance[place] < until) << lane;
                }
            }
        }
        self.found |= found;
        found
    }

    #[inline(always)]
    fn island(&mut self, lanes: u32, island: &Island) -> u32 {
        let until = &self.rays.end;
        let mut found = 0;
        if let Some(plane) = plane_of(self.stage.scene, island)
            && !self.rays.is_touching()
        {
            let (lanes, distance) = plane.entries(self.stage.simd, self.rays, lanes, until);
            for lane in Set(lanes) {
                found |= u32::from(distance[lane] < until[lane]) << lane;
            }
        } else {
            for lane in Set(lanes) {
                let ray = self.rays.get(lane);
                let hit = entered(self.stage.scene, island, &ray, until[lane], self.intervals);
                found |= u32::from(hit.is_some_and(|hit| hit.distance < until[lane])) << lane;
            }
        }
        self.found |= found;
        found
    }
}

/// Keeps the last end among the parts that hold a point of a ray.
struct Farthest<'a, R, S> {
    stage: Stage<'a, R, S>,
    rays: &'a Rays<R>,
    lane: usize,
    intervals: &'a mut Vec<Interval<R>>,
    /// The same in all lanes.
    at: [R; LANES],
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
    fn until(&self) -> &[R; LANES] {
        &self.at
    }

    #[inline(always)]
    fn block(&mut self, lanes: u32, number: usize) -> u32 {
        let block = &self.stage.scene.wide.blocks[number];
        let (ray, at) = (self.rays.get(self.lane), self.at[self.lane]);
        // The same of the light, and of the ball that the ray starts on.
        let places = if self.rays.is_touching() {
            block.there
        } else {
            Pairs::of_block(self.stage.simd, block, self.rays, self.lane).near_or_own()
        };
        let mut enough = false;
        for place in Set(places) {
            enough = enough || self.keep(left_leaf(self.stage.scene, block.leaf[place], &ray, at));
        }
        if enough { lanes } else { 0 }
    }

    #[inline(always)]
    fn island(&mut self, lanes: u32, island: &Island) -> u32 {
        let (ray, at) = (self.rays.get(self.lane), self.at[self.lane]);
        let hit = left(self.stage.scene, island, &ray, at, self.intervals);
        if self.keep(hit) { lanes } else { 0 }
    }
}
