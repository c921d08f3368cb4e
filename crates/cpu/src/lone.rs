//! A surface by itself against up to eight rays: where they enter and leave it.

use fearless_simd::Simd;
use scenec_plan::Packed;
use scenec_plan::packed_structs::Shape;

use crate::balls::equal;
use crate::hits::Hit;
use crate::intervals::{ends, entries, intervals};
use crate::lanes::{LANES, Lanes, load};
use crate::ray::{Rays, touches};

/// A leaf that is an island.
pub(crate) struct Lone<'a, R> {
    scene: &'a Packed<R>,
    leaf: u32,
}

impl<'a, R: Lanes> Lone<'a, R> {
    #[inline(always)]
    pub(crate) const fn new(scene: &'a Packed<R>, leaf: u32) -> Self {
        Self { scene, leaf }
    }

    #[inline(always)]
    fn shape(&self) -> &'a Shape<R> {
        &self.scene.shapes[self.scene.leaves[self.leaf as usize].shape as usize]
    }

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
        let interval = intervals(simd, self.shape(), rays, touches(self.scene, rays));
        let (entering, distance) = entries::<R, S>(simd, interval, load::<R, S>(simd, until));
        (lanes & entering & !equal(&rays.class, self.shape().class), distance)
    }

    /// Which rays it holds at a distance, and where these leave it.
    #[inline(always)]
    pub(crate) fn ends<S: Simd>(&self, simd: S, rays: &Rays<R>, lanes: u32, at: &[R; LANES]) -> (u32, [R; LANES]) {
        let interval = intervals(simd, self.shape(), rays, touches(self.scene, rays));
        let (held, distance) = ends::<R, S>(interval, load::<R, S>(simd, at));
        (lanes & held, distance)
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
