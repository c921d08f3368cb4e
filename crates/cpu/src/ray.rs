//! A ray and the surface that it leaves.

use scenec_plan::Real;

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
    /// The light that it runs to, if that lies on a surface.
    pub(crate) end: End<R>,
}

/// Where a ray to a light ends, and which surfaces the light lies on.
#[derive(Clone, Copy, Debug)]
pub(crate) struct End<R> {
    /// Along the ray.
    pub(crate) distance: R,
    /// First of the light's touches.
    pub(crate) touches: u32,
    /// One past the last of them.
    pub(crate) touches_end: u32,
}

impl<R: Real> End<R> {
    /// The end of a ray that runs to no light.
    pub(crate) const NONE: Self = Self {
        distance: R::INFINITY,
        touches: 0,
        touches_end: 0,
    };

    /// Whether it lies on a surface.
    #[inline(always)]
    pub(crate) const fn is_touching(&self) -> bool {
        self.touches != self.touches_end
    }
}
