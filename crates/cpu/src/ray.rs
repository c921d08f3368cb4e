//! A ray and the surface that it leaves.

use crate::vector::Vector;

/// No surface: the ray comes from the eye.
pub(crate) const NO_CLASS: u32 = u32::MAX;

/// A half-line, with what is known exactly about its start.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Ray<R> {
    /// Where it starts.
    pub(crate) origin: Vector<R>,
    /// Where it goes; of length 1.
    pub(crate) direction: Vector<R>,
    /// The start on its surface's own unit sphere.
    pub(crate) local: Vector<R>,
    /// The class of the surface that it starts on, or [`NO_CLASS`].
    pub(crate) class: u32,
    /// Whether it runs inside the solid at first.
    pub(crate) inside: bool,
}
