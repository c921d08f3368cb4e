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

/// What becomes of crossings.
pub(crate) trait Keeper<R> {
    /// Whether near ones spare it others.
    const NEAR_FIRST: bool;
    /// Whether it wants to know where rays leave what they are in at a distance, not where they enter.
    const INSIDE: bool;
    /// Beyond these distances nothing matters; or these are the distances at which the rays are inside.
    fn until(&self) -> &[R; LANES];
    /// Is told of a crossing of a ray.
    fn keep(&mut self, lane: usize, hit: Hit<R>);
    /// The rays that it wants no more of.
    fn enough(&self) -> u32;
}

/// Keeps the first entries.
impl<R: Lanes> Keeper<R> for Hits<R> {
    const NEAR_FIRST: bool = true;
    const INSIDE: bool = false;

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
    const INSIDE: bool = false;

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

/// Keeps the last ends among the parts that hold points of rays.
pub(crate) struct Farthest<'a, R> {
    /// Where along the rays the points are.
    at: &'a [R; LANES],
    pub(crate) hits: Hits<R>,
    /// Rays that have no end at all, so that no other part matters.
    endless: u32,
}

impl<'a, R: Lanes> Farthest<'a, R> {
    pub(crate) const fn new(at: &'a [R; LANES]) -> Self {
        Self {
            at,
            hits: Hits::NONE,
            endless: 0,
        }
    }
}

impl<R: Lanes> Keeper<R> for Farthest<'_, R> {
    const NEAR_FIRST: bool = false;
    const INSIDE: bool = true;

    #[inline(always)]
    fn until(&self) -> &[R; LANES] {
        self.at
    }

    #[inline(always)]
    fn keep(&mut self, lane: usize, hit: Hit<R>) {
        self.hits.keep_last(lane, hit);
        self.endless |= u32::from(hit.distance == R::INFINITY) << lane;
    }

    #[inline(always)]
    fn enough(&self) -> u32 {
        self.endless
    }
}

/// Finds crossings.
pub(crate) struct Seeker<'a, R, S, K> {
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

/// Of these pairs those that a keeper asks for, by its distances.
#[inline(always)]
fn met<R: Lanes, S: Simd, K: Keeper<R>>(pairs: &Pairs<R, S>, until: R::Eight<S>) -> (u32, [R; LANES]) {
    if K::INSIDE {
        pairs.ends(until)
    } else {
        pairs.entries(until)
    }
}

impl<R: Lanes, S: Simd, K: Keeper<R>> Seeker<'_, R, S, K> {
    /// An island that is a leaf.
    #[inline(always)]
    fn lone(&mut self, lanes: u32, leaf: u32) {
        let (simd, lone) = (self.stage.simd, Lone::new(self.stage.scene, leaf));
        let (lanes, distance) = if K::INSIDE {
            lone.ends(simd, self.rays, lanes, self.kept.until())
        } else {
            lone.entries(simd, self.rays, lanes, self.kept.until())
        };
        for lane in Set(lanes) {
            self.kept.keep(lane, lone.hit(distance[lane], K::INSIDE));
        }
    }
}

impl<R: Lanes, S: Simd, K: Keeper<R>> Visitor<R, S> for Seeker<'_, R, S, K> {
    const NEAR_FIRST: bool = K::NEAR_FIRST;

    #[inline(always)]
    fn from(&self, lane: usize) -> R {
        if K::INSIDE { self.kept.until()[lane] } else { R::ZERO }
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
                let (lanes, distance) = met::<R, S, K>(&pairs, load::<R, S>(simd, self.until()));
                for lane in Set(lanes) {
                    let hit = at_ball(block, (number, place), distance[lane], K::INSIDE);
                    self.kept.keep(lane, hit);
                }
            }
        } else {
            for lane in Set(lanes) {
                let pairs = Pairs::of_block(simd, block, rays, lane);
                let (places, distance) = met::<R, S, K>(&pairs, splat::<R, S>(simd, self.until()[lane]));
                for place in Set(places) {
                    let hit = at_ball(block, (number, place), distance[place], K::INSIDE);
                    self.kept.keep(lane, hit);
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
        let (start, end) = ([R::ZERO; LANES], [R::INFINITY; LANES]);
        let (from, until) = if K::INSIDE {
            (self.kept.until(), &end)
        } else {
            (&start, self.kept.until())
        };
        let question = Question {
            rays: self.rays,
            lanes,
            from,
            until,
            inside: K::INSIDE,
        };
        let changes = changes(self.stage, island, question, self.room);
        for lane in Set(lanes) {
            let endless = (K::INSIDE && changes.held >> lane & 1 == 1).then(|| Hit {
                distance: R::INFINITY,
                leaf: self.stage.members[island.members as usize],
                leaving: true,
                ball: None,
            });
            if let Some(hit) = changes.hits[lane].or(endless) {
                self.kept.keep(lane, hit);
            }
        }
        self.kept.enough()
    }
}
