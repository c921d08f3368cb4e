//! A half-space by itself against up to eight rays from outside: the very numbers that [`crate::event`] computes one by one.

use fearless_simd::{Simd, SimdBase};
use scenec_plan::Packed;
use scenec_plan::packed_structs::{Island, Shape};

use crate::balls::equal;
use crate::hits::Hit;
use crate::lanes::{LANES, Lanes, bits, load, load3, select, splat, splat3};
use crate::ray::Rays;
use crate::shape::{HALF_SPACE, Slope, parallel, plane_normal, slope};

/// An island that is one half-space.
pub(crate) struct Plane<'a, R> {
    shape: &'a Shape<R>,
    leaf: u32,
}

/// The half-space that an island is, if it is one.
#[inline(always)]
pub(crate) fn plane_of<'a, R: Lanes>(scene: &'a Packed<R>, island: &Island) -> Option<Plane<'a, R>> {
    let leaf = scene.lone(island)?;
    let shape = &scene.shapes[scene.leaves[leaf as usize].shape as usize];
    (shape.kind == HALF_SPACE).then_some(Plane { shape, leaf })
}

impl<R: Lanes> Plane<'_, R> {
    /// Which rays enter at a distance of at most `until`, and where: those that go down to it, at 0 if rounding has them start
    /// below. A ray that starts on the plane does not.
    #[inline(always)]
    pub(crate) fn entries<S: Simd>(
        &self,
        simd: S,
        rays: &Rays<R>,
        lanes: u32,
        until: &[R; LANES],
    ) -> (u32, [R; LANES]) {
        let normal = splat3(simd, plane_normal(self.shape));
        let foot = splat3(simd, self.shape.centre);
        let (origin, direction) = (load3(simd, &rays.origin), load3(simd, &rays.direction));
        let Slope { towards, above, terms } = slope(normal, foot, origin, direction);
        let zero = splat::<R, S>(simd, R::ZERO);
        let down = towards.simd_lt(-(splat::<R, S>(simd, parallel()) * terms));
        let distance = -above / towards;
        let within = bits(distance.simd_le(zero) & (-distance).simd_lt(splat::<R, S>(simd, R::INFINITY)));
        let ahead = bits(distance.simd_gt(zero) & distance.simd_le(load::<R, S>(simd, until)));
        let starts_here = equal(&rays.class, self.shape.class);
        let lanes = lanes & bits(down) & (within | ahead) & !starts_here;
        (lanes, select::<R, S>(simd, ahead, distance, zero).to_array())
    }

    /// The entry at a distance.
    #[inline(always)]
    pub(crate) const fn hit(&self, distance: R) -> Hit<R> {
        Hit {
            distance,
            leaf: self.leaf,
            leaving: false,
            ball: None,
        }
    }
}
