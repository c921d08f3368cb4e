//! What is looked for on the way through the hierarchy.

use fearless_simd::Simd;
use scenec_plan::packed_structs::{Block, Island};

use crate::balls::Pairs;
use crate::hits::{Ball, Hit, Hits};
use crate::island::{Question, Room, changes};
use crate::lanes::{LANES, Lanes, Set, load, splat};
use crate::lone::Lone;
use crate::ray::Rays;
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
    pub(crate) room: &'a mut Room<R>,
    pub(crate) kept: K,
}

/// Where a ray enters or leaves a ball of a block.
#[inline(always)]
const fn at_ball<R>(block: &Block<R>, (number, place): (usize, usize), distance: R, leaving: bool) -> Hit<R> {
    Hit {
        distance,
        leaf: block.leaf[place],
        leaving,
        ball: Some(Ball {
            block: number as u32,
            lane: place as u32,
        }),
    }
}

impl<R: Lanes, S: Simd, K: Keeper<R>> Entries<'_, R, S, K> {
    /// An island that is a leaf.
    #[inline(always)]
    fn lone(&mut self, lanes: u32, leaf: u32) {
        let lone = Lone::new(self.stage.scene, leaf);
        let (lanes, distance) = lone.entries(self.stage.simd, self.rays, lanes, self.kept.until());
        for lane in Set(lanes) {
            self.kept.keep(lane, lone.hit(distance[lane], false));
        }
    }
}

impl<R: Lanes, S: Simd, K: Keeper<R>> Visitor<R, S> for Entries<'_, R, S, K> {
    const NEAR_FIRST: bool = K::NEAR_FIRST;

    #[inline(always)]
    fn from(&self, _: usize) -> R {
        R::ZERO
    }

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
            for place in Set(block.there) {
                self.lone(lanes, block.leaf[place]);
            }
        } else if lanes.count_ones() > block.there.count_ones() {
            for place in Set(block.there) {
                let pairs = Pairs::of_ball(simd, block, place, rays, lanes & !self.kept.enough());
                let (lanes, distance) = pairs.entries(load::<R, S>(simd, self.until()));
                for lane in Set(lanes) {
                    self.kept
                        .keep(lane, at_ball(block, (number, place), distance[lane], false));
                }
            }
        } else {
            for lane in Set(lanes) {
                let pairs = Pairs::of_block(simd, block, rays, lane);
                let (places, distance) = pairs.entries(splat::<R, S>(simd, self.until()[lane]));
                for place in Set(places) {
                    self.kept
                        .keep(lane, at_ball(block, (number, place), distance[place], false));
                }
            }
        }
        self.kept.enough()
    }

    #[inline(always)]
    fn island(&mut self, lanes: u32, island: &Island) -> u32 {
        if let Some(leaf) = self.stage.scene.lone(island) {
            self.lone(lanes, leaf);
            return self.kept.enough();
        }
        let question = Question {
            rays: self.rays,
            lanes,
            from: &[R::ZERO; LANES],
            until: self.kept.until(),
            inside: false,
        };
        let changes = changes(self.stage, island, question, self.room);
        for lane in Set(lanes) {
            if let Some(hit) = changes.hits[lane] {
                self.kept.keep(lane, hit);
            }
        }
        self.kept.enough()
    }
}

/// Keeps the last ends among the parts that hold points of rays.
pub(crate) struct Farthest<'a, R, S> {
    pub(crate) stage: Stage<'a, R, S>,
    pub(crate) rays: &'a Rays<R>,
    pub(crate) room: &'a mut Room<R>,
    /// Where along the rays the points are.
    pub(crate) at: &'a [R; LANES],
    pub(crate) hits: Hits<R>,
    /// Rays that have no end at all, so that no other part matters.
    endless: u32,
}

impl<'a, R: Lanes, S> Farthest<'a, R, S> {
    pub(crate) const fn new(
        stage: Stage<'a, R, S>,
        rays: &'a Rays<R>,
        at: &'a [R; LANES],
        room: &'a mut Room<R>,
    ) -> Self {
        Self {
            stage,
            rays,
            room,
            at,
            hits: Hits::NONE,
            endless: 0,
        }
    }

    #[inline(always)]
    fn keep(&mut self, lane: usize, hit: Hit<R>) {
        self.hits.keep_last(lane, hit);
        self.endless |= u32::from(hit.distance == R::INFINITY) << lane;
    }
}

impl<R: Lanes, S: Simd> Farthest<'_, R, S> {
    /// An island that is a leaf.
    #[inline(always)]
    fn lone(&mut self, lanes: u32, leaf: u32) {
        let lone = Lone::new(self.stage.scene, leaf);
        let (lanes, distance) = lone.ends(self.stage.simd, self.rays, lanes, self.at);
        for lane in Set(lanes) {
            self.keep(lane, lone.hit(distance[lane], true));
        }
    }
}

impl<R: Lanes, S: Simd> Visitor<R, S> for Farthest<'_, R, S> {
    const NEAR_FIRST: bool = false;

    #[inline(always)]
    fn from(&self, lane: usize) -> R {
        self.at[lane]
    }

    #[inline(always)]
    fn until(&self) -> &[R; LANES] {
        self.at
    }

    #[inline(always)]
    fn block(&mut self, lanes: u32, number: usize) -> u32 {
        let block = &self.stage.scene.wide.blocks[number];
        let (simd, rays) = (self.stage.simd, self.rays);
        if rays.is_touching() {
            for place in Set(block.there) {
                self.lone(lanes, block.leaf[place]);
            }
        } else if lanes.count_ones() > block.there.count_ones() {
            for place in Set(block.there) {
                let pairs = Pairs::of_ball(simd, block, place, rays, lanes);
                let (lanes, distance) = pairs.ends(load::<R, S>(simd, self.at));
                for lane in Set(lanes) {
                    self.keep(lane, at_ball(block, (number, place), distance[lane], true));
                }
            }
        } else {
            for lane in Set(lanes) {
                let pairs = Pairs::of_block(simd, block, rays, lane);
                let (places, distance) = pairs.ends(splat::<R, S>(simd, self.at[lane]));
                for place in Set(places) {
                    self.keep(lane, at_ball(block, (number, place), distance[place], true));
                }
            }
        }
        self.endless
    }

    #[inline(always)]
    fn island(&mut self, lanes: u32, island: &Island) -> u32 {
        if let Some(leaf) = self.stage.scene.lone(island) {
            self.lone(lanes, leaf);
            return self.endless;
        }
        let question = Question {
            rays: self.rays,
            lanes,
            from: self.at,
            until: &[R::INFINITY; LANES],
            inside: true,
        };
        let changes = changes(self.stage, island, question, self.room);
        for lane in Set(changes.held) {
            let endless = Hit {
                distance: R::INFINITY,
                leaf: self.stage.members[island.members as usize],
                leaving: true,
                ball: None,
            };
            self.keep(lane, changes.hits[lane].unwrap_or(endless));
        }
        self.endless
    }
}
