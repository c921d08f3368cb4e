//! Balls and rays, eight at once: first a cheap look at which could matter, then for those the very numbers that
//! [`crate::shape`] computes one by one.

use fearless_simd::{Simd, SimdBase};
use scenec_plan::packed_structs::Block;

use crate::intervals::{ends, entries};
use crate::lanes::{LANES, Lanes, Vector8, bits, lane3, load, load3, select, splat, splat3};
use crate::ray::Rays;
use crate::shape::{Approach, approach, other_root};
use crate::vector::{Arithmetic, dot, fma, scale, sub};

/// A bit for each lane.
const ALL: u32 = (1 << LANES) - 1;

/// A ball and a ray in every lane: one ray and the balls of a block, or one of these and many rays.
pub(crate) struct Pairs<R: Lanes, S: Simd> {
    simd: S,
    /// From the centres to where the rays start.
    start: Vector8<R, S>,
    direction: Vector8<R, S>,
    /// Of balls that rays start on: where on the unit sphere.
    local: Vector8<R, S>,
    /// The square of the radius and a thousandth more.
    reach: R::Eight<S>,
    /// 1 / radius.
    inverse: R::Eight<S>,
    /// Which lanes there are, but for balls that rays start on, ...
    others: u32,
    /// ... and those that their rays run into.
    into: u32,
}

impl<R: Lanes, S: Simd> Pairs<R, S> {
    /// The balls of a block and one of the rays.
    #[inline(always)]
    pub(crate) fn of_block(simd: S, block: &Block<R>, rays: &Rays<R>, lane: usize) -> Self {
        let own = equal(&block.class, rays.class[lane]) & block.there;
        Self {
            simd,
            start: sub(splat3(simd, lane3(&rays.origin, lane)), load3(simd, &block.centre)),
            direction: splat3(simd, lane3(&rays.direction, lane)),
            local: splat3(simd, lane3(&rays.local, lane)),
            reach: load::<R, S>(simd, &block.reach),
            inverse: load::<R, S>(simd, &block.inverse),
            others: block.there & !own,
            into: if rays.into >> lane & 1 == 1 { own } else { 0 },
        }
    }

    /// One of the balls of a block and some rays.
    #[inline(always)]
    pub(crate) fn of_ball(simd: S, block: &Block<R>, place: usize, rays: &Rays<R>, lanes: u32) -> Self {
        let own = equal(&rays.class, block.class[place]) & lanes;
        Self {
            simd,
            start: sub(load3(simd, &rays.origin), splat3(simd, lane3(&block.centre, place))),
            direction: load3(simd, &rays.direction),
            local: load3(simd, &rays.local),
            reach: splat::<R, S>(simd, block.reach[place]),
            inverse: splat::<R, S>(simd, block.inverse[place]),
            others: lanes & !own,
            into: own & rays.into,
        }
    }

    /// The balls that the rays' lines may meet; none that a line does meet is left out.
    ///
    /// The computed distance to a centre is off across the line by a few roundings of itself, and along it by a few of
    /// the way to the nearest point: the thousandth in `reach` is worth far more than the first, and the square of that
    /// way times 2^-34 far more than the second. Comparing the other way round lets a NaN in.
    #[inline(always)]
    fn near(&self) -> u32 {
        let along = dot(self.start, self.direction);
        let across = fma(self.direction, -along, self.start);
        let slack = splat::<R, S>(self.simd, R::of((-34.0_f64).exp2()));
        let bound = (along * along).fused(slack, self.reach);
        !bits(dot(across, across).simd_gt(bound)) & ALL
    }

    /// Where rays from outside enter balls at distances of at most `until`, as [`crate::lone`] has it for one: the ball that a
    /// ray starts on is not entered, and one that it starts within by rounding is, at 0, if the crossing behind is the
    /// nearer one.
    #[inline(always)]
    pub(crate) fn entries(&self, until: R::Eight<S>) -> (u32, [R; LANES]) {
        let near = self.near() & self.others;
        if near == 0 {
            return (0, [R::ZERO; LANES]);
        }
        let (lanes, distance) = entries::<R, S>(self.simd, self.approach().0.ends(), until);
        (lanes & near, distance)
    }

    /// Which rays are in balls at these distances, and where they leave them.
    #[inline(always)]
    pub(crate) fn ends(&self, at: R::Eight<S>) -> (u32, [R; LANES]) {
        let near = self.near() & self.others;
        if near | self.into == 0 {
            return (0, [R::ZERO; LANES]);
        }
        let (approach, direction) = self.approach();
        let (enter, leave) = approach.ends();
        let zero = splat::<R, S>(self.simd, R::ZERO);
        let other = other_root(dot(self.local, direction), direction);
        let enter = select::<R, S>(self.simd, self.into, zero, enter);
        let leave = select::<R, S>(self.simd, self.into, other, leave);
        let (lanes, distance) = ends::<R, S>((enter, leave), at);
        (lanes & (near | self.into), distance)
    }

    /// And the directions in the balls' own coordinates.
    #[inline(always)]
    fn approach(&self) -> (Approach<R::Eight<S>>, Vector8<R, S>) {
        let direction = scale(self.direction, self.inverse);
        (approach(scale(self.start, self.inverse), direction), direction)
    }
}

/// The lanes that hold a number.
#[inline(always)]
pub(crate) fn equal(numbers: &[u32; LANES], number: u32) -> u32 {
    let mut set = 0;
    for (lane, other) in numbers.iter().enumerate() {
        set |= u32::from(*other == number) << lane;
    }
    set
}
