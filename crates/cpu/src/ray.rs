//! Rays and the surfaces that they leave, one by one and eight at once.

use scenec_plan::packed_structs::Touch;
use scenec_plan::{Packed, Real};

use crate::lanes::{LANES, Triple, lane3, set3};
use crate::vector::Vector;

/// A half-line, with what is known exactly about its start.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Ray<R> {
    /// Where it starts.
    pub(crate) origin: Vector<R>,
    /// Where it goes; of length 1.
    pub(crate) direction: Vector<R>,
    /// Of a start on a ball or ellipsoid: where on the unit sphere. On a plane: the unit normal on the side of the ray.
    pub(crate) local: Vector<R>,
    /// The class of the surface that it starts on; no surface has the largest number.
    pub(crate) class: u32,
    /// Whether it runs into the ball or ellipsoid that it starts on. The kind of crossing that sent it says so, not a
    /// product that rounding may turn over.
    pub(crate) into: bool,
    /// Whether it runs inside the solid at first.
    pub(crate) inside: bool,
    /// How far the light is that it runs to, if to one.
    pub(crate) end: R,
}

/// Up to eight rays, which end at the same light if at any. A bit tells of a lane what a `bool` tells of a [`Ray`].
#[derive(Clone, Copy, Debug)]
#[repr(align(64))]
pub(crate) struct Rays<R> {
    pub(crate) origin: Triple<R>,
    pub(crate) direction: Triple<R>,
    pub(crate) local: Triple<R>,
    /// How far the light is.
    pub(crate) end: [R; LANES],
    pub(crate) class: [u32; LANES],
    pub(crate) into: u32,
    pub(crate) inside: u32,
    /// First of the light's touches.
    pub(crate) touches: u32,
    /// One past the last of them.
    pub(crate) touches_end: u32,
}

impl<R: Real> Rays<R> {
    /// Room for rays that run to no light.
    pub(crate) const EMPTY: Self = Self {
        origin: [[R::ZERO; LANES]; 3],
        direction: [[R::ZERO; LANES]; 3],
        local: [[R::ZERO; LANES]; 3],
        end: [R::INFINITY; LANES],
        class: [u32::MAX; LANES],
        into: 0,
        inside: 0,
        touches: 0,
        touches_end: 0,
    };

    /// One of them.
    #[inline(always)]
    pub(crate) const fn get(&self, lane: usize) -> Ray<R> {
        Ray {
            origin: lane3(&self.origin, lane),
            direction: lane3(&self.direction, lane),
            local: lane3(&self.local, lane),
            class: self.class[lane],
            into: self.into >> lane & 1 == 1,
            inside: self.inside >> lane & 1 == 1,
            end: self.end[lane],
        }
    }

    /// Changes one of them.
    #[inline(always)]
    pub(crate) fn set(&mut self, lane: usize, ray: &Ray<R>) {
        set3(&mut self.origin, lane, ray.origin);
        set3(&mut self.direction, lane, ray.direction);
        set3(&mut self.local, lane, ray.local);
        self.class[lane] = ray.class;
        let bit = 1 << lane;
        self.into = self.into & !bit | u32::from(ray.into) << lane;
        self.inside = self.inside & !bit | u32::from(ray.inside) << lane;
    }

    /// Whether the light that they run to lies on a surface.
    #[inline(always)]
    pub(crate) const fn is_touching(&self) -> bool {
        self.touches != self.touches_end
    }
}

/// The surfaces that the light lies on that rays run to.
#[inline(always)]
pub(crate) fn touches<'a, R>(scene: &'a Packed<R>, rays: &Rays<R>) -> &'a [Touch<R>] {
    &scene.touches[rays.touches as usize..rays.touches_end as usize]
}
