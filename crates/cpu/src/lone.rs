//! A surface by itself against up to eight rays: the very numbers that [`crate::event`] computes one by one.

use fearless_simd::{Simd, SimdBase};
use scenec_plan::Packed;
use scenec_plan::packed_structs::{Island, Shape};

use crate::balls::equal;
use crate::hits::Hit;
use crate::lanes::{LANES, Lanes, Vector8, bits, load, load3, select, splat, splat3};
use crate::ray::Rays;
use crate::shape::{Approach, HALF_SPACE, Slope, approach, other_root, parallel, plane_normal, slope, to_local};
use crate::vector::{dot, sub};

/// An island that is one leaf.
pub(crate) struct Lone<'a, R> {
    shape: &'a Shape<R>,
    leaf: u32,
}

/// The leaf that an island is, if it is one.
#[inline(always)]
pub(crate) fn lone<'a, R: Lanes>(scene: &'a Packed<R>, island: &Island) -> Option<Lone<'a, R>> {
    let leaf = scene.lone(island)?;
    let shape = &scene.shapes[scene.leaves[leaf as usize].shape as usize];
    Some(Lone { shape, leaf })
}

impl<R: Lanes> Lone<'_, R> {
    /// Which rays from outside enter at a distance of at most `until`, and where. A ray that starts on the surface does not,
    /// and one that starts within by rounding does at 0, if the crossing behind is the nearer one.
    #[inline(always)]
    pub(crate) fn entries<S: Simd>(
        &self,
        simd: S,
        rays: &Rays<R>,
        lanes: u32,
        until: &[R; LANES],
    ) -> (u32, [R; LANES]) {
        let zero = splat::<R, S>(simd, R::ZERO);
        let (enter, leave) = if self.shape.kind == HALF_SPACE {
            let plane = self.slope(simd, rays);
            // The other rays come from below, or go past it.
            let down = plane.towards.simd_lt(-(splat::<R, S>(simd, parallel()) * plane.terms));
            let never = splat::<R, S>(simd, R::INFINITY);
            (
                select::<R, S>(simd, bits(down), -plane.above / plane.towards, never),
                never,
            )
        } else {
            self.approach(simd, rays).0.ends()
        };
        let within = bits(enter.simd_le(zero) & leave.simd_gt(zero) & (-enter).simd_lt(leave));
        let ahead = bits(enter.simd_gt(zero) & enter.simd_lt(leave) & enter.simd_le(load::<R, S>(simd, until)));
        let lanes = lanes & (within | ahead) & !equal(&rays.class, self.shape.class);
        (lanes, select::<R, S>(simd, ahead, enter, zero).to_array())
    }

    /// Which rays it holds at a distance, and where these leave it.
    #[inline(always)]
    pub(crate) fn ends<S: Simd>(&self, simd: S, rays: &Rays<R>, lanes: u32, at: &[R; LANES]) -> (u32, [R; LANES]) {
        let own = equal(&rays.class, self.shape.class);
        let zero = splat::<R, S>(simd, R::ZERO);
        let at = load::<R, S>(simd, at);
        if self.shape.kind != HALF_SPACE {
            let (approach, direction) = self.approach(simd, rays);
            let (enter, leave) = approach.ends();
            let other = other_root(dot(load3(simd, &rays.local), direction), direction);
            let enter = select::<R, S>(simd, own, zero, enter);
            let leave = select::<R, S>(simd, own, other, leave);
            let held = bits(enter.simd_le(at) & at.simd_lt(leave)) & (!own | rays.into);
            return (lanes & held, leave.to_array());
        }
        let plane = self.slope(simd, rays);
        let never = splat::<R, S>(simd, R::INFINITY);
        let least = splat::<R, S>(simd, parallel()) * plane.terms;
        let (up, down) = (bits(plane.towards.simd_gt(least)), bits(plane.towards.simd_lt(-least)));
        let crossing = -plane.above / plane.towards;
        let before = bits(at.simd_lt(crossing));
        let after = bits(crossing.simd_le(at));
        let below = bits(plane.above.simd_le(zero));
        // Of one class are this plane's half-spaces on either side, so this product is 1 or -1.
        let side = bits(dot(splat3(simd, plane_normal(self.shape)), load3(simd, &rays.local)).simd_lt(zero));
        let held = up & before | down & after | !(up | down) & below;
        let lanes = lanes & (!own & held | own & side);
        (lanes, select::<R, S>(simd, up & !own, crossing, never).to_array())
    }

    #[inline(always)]
    fn slope<S: Simd>(&self, simd: S, rays: &Rays<R>) -> Slope<R::Eight<S>> {
        let (origin, direction) = (load3(simd, &rays.origin), load3(simd, &rays.direction));
        let (normal, foot) = (splat3(simd, plane_normal(self.shape)), splat3(simd, self.shape.centre));
        slope(normal, foot, origin, direction)
    }

    /// Of a ball or ellipsoid; and the rays' directions in its own coordinates.
    #[inline(always)]
    fn approach<S: Simd>(&self, simd: S, rays: &Rays<R>) -> (Approach<R::Eight<S>>, Vector8<R, S>) {
        let m = &self.shape.inverse;
        let mut inverse = [splat::<R, S>(simd, R::ZERO); 9];
        for i in 0..9 {
            inverse[i] = splat::<R, S>(simd, m[i]);
        }
        let (origin, direction) = (load3(simd, &rays.origin), load3(simd, &rays.direction));
        let start = sub(origin, splat3(simd, self.shape.centre));
        let direction = to_local(self.shape.kind, &inverse, direction);
        (
            approach(to_local(self.shape.kind, &inverse, start), direction),
            direction,
        )
    }

    /// The hit at an end.
    #[inline(always)]
    pub(crate) const fn hit(&self, distance: R, leaving: bool) -> Hit<R> {
        Hit {
            distance,
            leaf: self.leaf,
            leaving,
            ball: None,
        }
    }
}
