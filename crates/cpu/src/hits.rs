//! What rays hit, one by one and eight at once.

use scenec_plan::Real;

use crate::lanes::LANES;

/// Where a ball is: its block and its lane there.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Ball {
    pub(crate) block: u32,
    pub(crate) lane: u32,
}

/// A crossing.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Hit<R> {
    /// Along the ray.
    pub(crate) distance: R,
    /// The leaf that owns the surface there.
    pub(crate) leaf: u32,
    /// Whether the ray leaves that leaf (not: the solid).
    pub(crate) leaving: bool,
    /// If the leaf is a ball of a block: the block's number and the lane.
    pub(crate) ball: Option<Ball>,
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
    pub(crate) const NONE: Self = Self {
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
    pub(crate) fn get(&self, lane: usize) -> Option<Hit<R>> {
        (self.met >> lane & 1 == 1).then(|| Hit {
            distance: self.distance[lane],
            leaf: self.leaf[lane],
            leaving: self.leaving >> lane & 1 == 1,
            ball: self.ball(lane),
        })
    }

    #[inline(always)]
    pub(crate) fn set(&mut self, lane: usize, hit: Hit<R>) {
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

    /// Takes one over from others.
    #[inline(always)]
    pub(crate) fn copy(&mut self, lane: usize, from: &Self) {
        if let Some(hit) = from.get(lane) {
            self.set(lane, hit);
        }
    }

    /// Takes a hit if it is nearer; of two at the same distance the left one owns.
    #[inline(always)]
    pub(crate) fn keep(&mut self, lane: usize, hit: Hit<R>) {
        if (hit.distance, hit.leaf) < (self.distance[lane], self.leaf[lane]) {
            self.set(lane, hit);
        }
    }

    /// Takes a hit if it is farther; of two at the same distance the left one owns.
    #[inline(always)]
    pub(crate) fn keep_last(&mut self, lane: usize, hit: Hit<R>) {
        let known = self.get(lane);
        if known.is_none_or(|known| (known.distance, hit.leaf) < (hit.distance, known.leaf)) {
            self.set(lane, hit);
        }
    }
}
