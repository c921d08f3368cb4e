//! Eight balls against one ray: first a cheap look at which could matter, then for those the very numbers that
//! [`crate::shape`] computes one by one.

use fearless_simd::{Simd, SimdBase, SimdFloat};
use scenec_plan::packed_structs::Block;

use crate::lanes::{LANES, Lanes, Set, Vector8, bits, dot, fma, load, scale, splat, splat3};
use crate::ray::Ray;

/// A bit for each lane.
const ALL: u32 = (1 << LANES) - 1;

/// A ray in every lane.
pub(crate) struct Line<R: Lanes, S: Simd> {
    pub(crate) simd: S,
    pub(crate) origin: Vector8<R, S>,
    pub(crate) direction: Vector8<R, S>,
}

impl<R: Lanes, S: Simd> Line<R, S> {
    #[inline(always)]
    pub(crate) fn new(simd: S, ray: &Ray<R>) -> Self {
        Self {
            simd,
            origin: splat3(simd, ray.origin),
            direction: splat3(simd, ray.direction),
        }
    }
}

/// Entries into the balls of a block by a ray from outside.
pub(crate) struct Entries<R> {
    /// Which lanes have one.
    pub(crate) lanes: Set,
    /// How far along the ray.
    pub(crate) distance: [R; LANES],
}

/// The balls that the ray's line may meet; none that it does meet is left out.
///
/// The computed distance to a centre is off across the line by a few roundings of itself, and along it by a few of
/// the way to the nearest point: the thousandth in `reach` is worth far more than the first, and the square of that
/// way times 2^-34 far more than the second. Comparing the other way round lets a NaN in.
#[inline(always)]
pub(crate) fn near<R: Lanes, S: Simd>(block: &Block<R>, line: &Line<R, S>) -> Set {
    let simd = line.simd;
    let start = from_centres(block, line);
    let along = dot(start, line.direction);
    let across = fma(line.direction, -along, start);
    let slack = splat::<R, S>(simd, R::of((-34.0_f64).exp2()));
    let bound = (along * along).mul_add_precise(slack, load::<R, S>(simd, &block.reach));
    match !bits(dot(across, across).simd_gt(bound)) & ALL {
        0 => Set(0),
        near => Set(near & block.there),
    }
}

/// Where a ray from outside enters balls at a distance of at most `until`, as [`crate::event`] has it for one: the
/// ball that it starts on is not entered, and one that it starts within by rounding is, at 0, if the crossing behind
/// is the nearer one.
#[inline(always)]
pub(crate) fn entries<R: Lanes, S: Simd>(
    block: &Block<R>,
    line: &Line<R, S>,
    ray: &Ray<R>,
    until: R,
) -> Option<Entries<R>> {
    let near = near(block, line);
    if near.0 == 0 {
        return None;
    }
    let (enter, leave) = intervals(block, line);
    let zero = splat::<R, S>(line.simd, R::ZERO);
    let starts_within = enter.simd_le(zero) & leave.simd_gt(zero) & (-enter).simd_lt(leave);
    let ahead = enter.simd_gt(zero) & enter.simd_lt(leave) & enter.simd_le(splat::<R, S>(line.simd, until));
    let lanes = bits(starts_within | ahead) & near.0;
    if lanes == 0 {
        return None;
    }
    Some(Entries {
        lanes: Set(lanes & !of_class(block, ray.class)),
        distance: enter.max(zero).to_array(),
    })
}

/// The lanes of one class.
#[inline(always)]
pub(crate) fn of_class<R>(block: &Block<R>, class: u32) -> u32 {
    let mut set = 0;
    for lane in 0..LANES {
        set |= u32::from(block.class[lane] == class) << lane;
    }
    set
}

#[inline(always)]
fn from_centres<R: Lanes, S: Simd>(block: &Block<R>, line: &Line<R, S>) -> Vector8<R, S> {
    [
        line.origin[0] - load::<R, S>(line.simd, &block.centre[0]),
        line.origin[1] - load::<R, S>(line.simd, &block.centre[1]),
        line.origin[2] - load::<R, S>(line.simd, &block.centre[2]),
    ]
}

/// As the closest approach of [`crate::shape`], operation by operation.
#[inline(always)]
fn intervals<R: Lanes, S: Simd>(block: &Block<R>, line: &Line<R, S>) -> (R::Eight<S>, R::Eight<S>) {
    let inverse = load::<R, S>(line.simd, &block.inverse);
    let start = scale(from_centres(block, line), inverse);
    let direction = scale(line.direction, inverse);
    let square = dot(direction, direction);
    let first = -dot(start, direction) / square;
    let rough = fma(direction, first, start);
    let rest = -dot(rough, direction) / square;
    let nearest = fma(direction, rest, rough);
    let one = splat::<R, S>(line.simd, R::ONE);
    let discriminant = (-nearest[0]).mul_add_precise(nearest[0], one);
    let discriminant = (-nearest[1]).mul_add_precise(nearest[1], discriminant);
    let discriminant = (-nearest[2]).mul_add_precise(nearest[2], discriminant);
    let half = SimdFloat::sqrt(discriminant / square);
    let distance = first + rest;
    (distance - half, distance + half)
}
