//! What is looked for on the way through the hierarchy.

use fearless_simd::Simd;
use scenec_plan::packed_structs::Island;

use crate::balls::Pairs;
use crate::event::{entered, entered_leaf, left, left_leaf};
use crate::hits::{Ball, Hit, Hits};
use crate::lanes::{LANES, Lanes, Set, load, splat};
use crate::planes::plane_of;
use crate::ray::Rays;
use crate::shape::Interval;
use crate::stage::Stage;
use crate::walk::Visitor;

/// What becomes of entries.
pub(crate) trait Keeper<R> {
    /// Whether near ones spare it others.
    const NEAR_FIRST: bool;
    /// Beyond these distances nothing matters.
    fn until(&self) -> &[R; LANES];
    /// Is told of an entry of a ray.
    fn keep(&mut self, lane: usize, hit: Hit<R>);
    /// The rays that it wants no more of.
    fn enough(&self) -> u32;
}

impl<R: Lanes> Keeper<R> for Hits<R> {
    const NEAR_FIRST: bool = true;

    #[inline(always)]
    fn until(&self) -> &[R; LANES] {
        &self.distance
    }

    #[inline(always)]
    fn keep(&mut self, lane: usize, hit: Hit<R>) {
        Self::keep(self, lane, hit);
    }

    #[inline(always)]
    fn enough(&self) -> u32 {
        0
    }
}

/// Which rays enter anything before their end.
pub(crate) struct Blocked<'a, R> {
    ends: &'a [R; LANES],
    pub(crate) rays: u32,
}

impl<'a, R> Blocked<'a, R> {
    pub(crate) const fn new(ends: &'a [R; LANES]) -> Self {
        Self { ends, rays: 0 }
    }
}

impl<R: Lanes> Keeper<R> for Blocked<'_, R> {
    const NEAR_FIRST: bool = false;

    #[inline(always)]
    fn until(&self) -> &[R; LANES] {
        self.ends
    }

    #[inline(always)]
    fn keep(&mut self, lane: usize, hit: Hit<R>) {
        self.rays |= u32::from(hit.distance < self.ends[lane]) << lane;
    }

    #[inline(always)]
    fn enough(&self) -> u32 {
        self.rays
    }
}

/// Finds entries of rays from outside.
pub(crate) struct Entries<'a, R, S, K> {
    pub(crate) stage: Stage<'a, R, S>,
    pub(crate) rays: &'a Rays<R>,
    pub(crate) intervals: &'a mut Vec<Interval<R>>,
    pub(crate) kept: K,
}

impl<R: Lanes, S: Simd, K: Keeper<R>> Entries<'_, R, S, K> {
    /// An entry into a ball of a block.
    #[inline(always)]
    fn keep_ball(&mut self, lane: usize, (block, place): (usize, usize), distance: R) {
        let ball = Ball {
            block: block as u32,
            lane: place as u32,
        };
        let hit = Hit {
            distance,
            leaf: self.stage.scene.wide.blocks[block].leaf[place],
            leaving: false,
            ball: Some(ball),
        };
        self.kept.keep(lane, hit);
    }
}

impl<R: Lanes, S: Simd, K: Keeper<R>> Visitor<R, S> for Entries<'_, R, S, K> {
    const NEAR_FIRST: bool = K::NEAR_FIRST;

    #[inline(always)]
    fn until(&self) -> &[R; LANES] {
        self.kept.until()
    }

    /// Ball by ball or ray by ray, whichever there are fewer of.
    #[inline(always)]
    fn block(&mut self, lanes: u32, number: usize) -> u32 {
        let block = &self.stage.scene.wide.blocks[number];
        let (simd, rays) = (self.stage.simd, self.rays);
        if rays.is_touching() {
            // What is known of the light decides there, whatever the numbers say.
            for lane in Set(lanes) {
                let (ray, until) = (rays.get(lane), self.until()[lane]);
                for place in Set(block.there) {
                    if let Some(hit) = entered_leaf(self.stage.scene, block.leaf[place], &ray, until) {
                        self.kept.keep(lane, hit);
                    }
                }
            }
        } else if lanes.count_ones() > block.there.count_ones() {
            for place in Set(block.there) {
                let pairs = Pairs::of_ball(simd, block, place, rays, lanes & !self.kept.enough());
                let (lanes, distance) = pairs.entries(load::<R, S>(simd, self.until()));
                for lane in Set(lanes) {
                    self.keep_ball(lane, (number, place), distance[lane]);
                }
            }
        } else {
            for lane in Set(lanes) {
                let pairs = Pairs::of_block(simd, block, rays, lane);
                let (places, distance) = pairs.entries(splat::<R, S>(simd, self.until()[lane]));
                for place in Set(places) {
                    self.keep_ball(lane, (number, place), distance[place]);
                }
            }
        }
        self.kept.enough()
    }

    #[inline(always)]
    fn island(&mut self, lanes: u32, island: &Island) -> u32 {
        if let Some(plane) = plane_of(self.stage.scene, island)
            && !self.rays.is_touching()
        {
            let (lanes, distance) = plane.entries(self.stage.simd, self.rays, lanes, self.until());
            for lane in Set(lanes) {
                self.kept.keep(lane, plane.hit(distance[lane]));
            }
        } else {
            for lane in Set(lanes) {
                let (ray, until) = (self.rays.get(lane), self.until()[lane]);
                if let Some(hit) = entered(self.stage.scene, island, &ray, until, self.intervals) {
                    self.kept.keep(lane, hit);
                }
            }
        }
        self.kept.enough()
    }
}

/// Keeps the last end among the parts that hold a point of a ray.
pub(crate) struct Farthest<'a, R, S> {
    pub(crate) stage: Stage<'a, R, S>,
    pub(crate) rays: &'a Rays<R>,
    pub(crate) lane: usize,
    pub(crate) intervals: &'a mut Vec<Interval<R>>,
    /// The point, the same in all lanes.
    pub(crate) at: [R; LANES],
    pub(crate) hit: Option<Hit<R>>,
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
