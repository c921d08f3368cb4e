//! Where up to eight rays run inside a surface's solid: the very numbers that [`crate::shape`] finds for one.

use fearless_simd::{Simd, SimdBase};
use scenec_plan::Instruction;
use scenec_plan::packed_structs::{Island, Shape};

use crate::balls::equal;
use crate::lanes::{LANES, Lanes, bits, load, load3, select, splat, splat3};
use crate::ray::Rays;
use crate::shape::{HALF_SPACE, Slope, approach, other_root, parallel, plane_normal, slope, to_local};
use crate::stage::Stage;
use crate::vector::{Arithmetic, dot, sub};

/// Where rays enter and leave.
pub(crate) type Intervals<R> = [[R; LANES]; 2];

/// Of a ball, ellipsoid or half-space, by rays whose light, if they run to one, lies on no surface.
#[inline(always)]
pub(crate) fn intervals<R: Lanes, S: Simd>(simd: S, shape: &Shape<R>, rays: &Rays<R>) -> (R::Eight<S>, R::Eight<S>) {
    let own = equal(&rays.class, shape.class);
    if shape.kind == HALF_SPACE {
        half_space(simd, shape, rays, own)
    } else {
        quadric(simd, shape, rays, own)
    }
}

#[inline(always)]
fn quadric<R: Lanes, S: Simd>(simd: S, shape: &Shape<R>, rays: &Rays<R>, own: u32) -> (R::Eight<S>, R::Eight<S>) {
    let zero = splat::<R, S>(simd, R::ZERO);
    let mut inverse = [zero; 9];
    for (all, one) in inverse.iter_mut().zip(shape.inverse) {
        *all = splat::<R, S>(simd, one);
    }
    let start = sub(load3(simd, &rays.origin), splat3(simd, shape.centre));
    let direction = to_local(shape.kind, &inverse, load3(simd, &rays.direction));
    let (enter, leave) = approach(to_local(shape.kind, &inverse, start), direction).ends();
    if own == 0 {
        return (enter, leave);
    }
    let other = other_root(dot(load3(simd, &rays.local), direction), direction);
    let other = select::<R, S>(simd, rays.into, other, zero);
    (
        select::<R, S>(simd, own, zero, enter),
        select::<R, S>(simd, own, other, leave),
    )
}

#[inline(always)]
fn half_space<R: Lanes, S: Simd>(simd: S, shape: &Shape<R>, rays: &Rays<R>, own: u32) -> (R::Eight<S>, R::Eight<S>) {
    let normal = splat3(simd, plane_normal(shape));
    let (origin, direction) = (load3(simd, &rays.origin), load3(simd, &rays.direction));
    let Slope { towards, above, terms } = slope(normal, splat3(simd, shape.centre), origin, direction);
    let (zero, ever) = (splat::<R, S>(simd, R::ZERO), splat::<R, S>(simd, R::INFINITY));
    let along = bits(towards.size().simd_le(splat::<R, S>(simd, parallel()) * terms));
    let up = bits(towards.simd_gt(zero));
    let below = bits(above.simd_le(zero));
    let crossing = -above / towards;
    let enter = select::<R, S>(
        simd,
        !along & up | along & below,
        -ever,
        select::<R, S>(simd, along, ever, crossing),
    );
    let leave = select::<R, S>(
        simd,
        !along & up,
        crossing,
        select::<R, S>(simd, along & !below, -ever, ever),
    );
    if own == 0 {
        return (enter, leave);
    }
    // Of one class are this plane's half-spaces on either side, so this product is 1 or -1.
    let above = bits(dot(normal, load3(simd, &rays.local)).simd_ge(zero));
    (
        select::<R, S>(simd, own, select::<R, S>(simd, above, -ever, zero), enter),
        select::<R, S>(simd, own, select::<R, S>(simd, above, zero, ever), leave),
    )
}

/// Finds those of all members of an island, and which of the rays may be in it somewhere between two distances.
#[inline(always)]
pub(crate) fn gather<R: Lanes, S: Simd>(
    stage: Stage<'_, R, S>,
    island: &Island,
    (rays, lanes): (&Rays<R>, u32),
    (from, until): (&[R; LANES], &[R; LANES]),
    found: &mut Vec<Intervals<R>>,
) -> u32 {
    let simd = stage.simd;
    found.clear();
    for leaf in &stage.members[island.members as usize..island.members_end as usize] {
        let shape = &stage.shapes[stage.leaves[*leaf as usize].shape as usize];
        let (enter, leave) = intervals(simd, shape, rays);
        found.push([enter.to_array(), leave.to_array()]);
    }
    if island.product == 0 {
        return lanes;
    }
    // A product is nowhere but where all members are that are not taken away.
    let (mut first, mut last) = (load::<R, S>(simd, from), load::<R, S>(simd, until));
    let mut held = lanes;
    for word in &stage.program[island.program as usize..island.program_end as usize] {
        let (operation, member) = Instruction(*word).parts();
        if operation == 0 {
            let [enter, leave] = &found[member as usize];
            let (enter, leave) = (load::<R, S>(simd, enter), load::<R, S>(simd, leave));
            held &= bits(enter.simd_lt(leave));
            first = first.max(enter);
            last = last.min(leave);
        }
    }
    held & bits(first.simd_le(last))
}
