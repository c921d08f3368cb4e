//! Whether single precision can tell what a plan describes, found out before anything is traced.

use std::fmt;

use crate::frame::View;
use crate::key::Key;
use crate::register::{AT_ONCE, Register};
use crate::shape::{Form, Shape};
use crate::together::together;
use crate::{Leaf, Plan};

/// Why single precision does not suffice for a plan.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum BeyondSingle {
    /// A surface, seen from the eye, may lie this many pixels beside its place.
    Displaced {
        /// A bound on how many.
        pixels: f64,
        /// The scene's number of the solid that it belongs to.
        solid: u32,
    },
    /// Two surfaces that are not the same differ by less than single precision keeps apart.
    NearlyCoincident {
        /// The scene's numbers of the solids that they belong to.
        solids: (u32, u32),
    },
    /// A surface is so large or so flat that its numbers leave the range of singles.
    OutOfRange,
}

impl fmt::Display for BeyondSingle {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Displaced { pixels, .. } if *pixels > 1000.0 => {
                f.write_str("f32 could place a surface anywhere in the picture")
            }
            Self::Displaced { pixels, .. } => {
                write!(f, "f32 could place a surface {pixels:.1} pixels beside where it is")
            }
            Self::NearlyCoincident { .. } => f.write_str("two surfaces lie closer together than f32 can tell"),
            Self::OutOfRange => f.write_str("the sizes in the scene span more than f32 can hold"),
        }
    }
}

/// The most that an outline may be displaced, in pixels, before doubles are called for: well below what one sample in a
/// pixel's centre can show.
const TOLERANCE: f64 = 1.0 / 16.0;

/// The grid on which surfaces count as nearly coincident, in steps of their size: 64 roundings of single precision each. An
/// intersection is off by a handful of roundings of each of two surfaces, and its point by as much again.
const NEAR: f64 = (1 << 18) as f64;

/// The largest number that single precision may meet in a shape: an intersection multiplies up to two of them.
const LARGEST: f64 = (1_u64 << 60) as f64;

/// Half the distance from 1 to the next single.
const UNIT: f64 = 1.0 / (1 << 24) as f64;

impl Plan {
    /// Why single precision does not suffice for this plan, if it does not. A plan that passes has every outline, as the
    /// eye sees it, within a sixteenth of a pixel, and no two surfaces that single precision might confuse; what mirrors
    /// and glass make of that is magnified by them, in any precision.
    #[must_use]
    pub const fn beyond_single(&self) -> Option<BeyondSingle> {
        self.beyond_single
    }

    /// How many pixels beside its place any surface may appear to the eye, with this unit roundoff; at most 1, for that is
    /// anywhere in its pixel. A surface that the eye is on does not count: its rays start on it exactly.
    #[must_use]
    pub fn displaced(&self, roundoff: f64) -> f64 {
        let worst = self.shapes.iter().fold(0.0_f64, |worst, shape| {
            let pixels = displacement(&self.view, shape, roundoff);
            if pixels.is_finite() { worst.max(pixels) } else { worst }
        });
        worst.min(1.0)
    }
}

/// See [`Plan::beyond_single`].
pub(crate) fn beyond_single(view: &View, shapes: &[Shape], leaves: &[Leaf]) -> Option<BeyondSingle> {
    if !shapes.iter().all(in_range) {
        return Some(BeyondSingle::OutOfRange);
    }
    far_displaced(view, shapes, leaves).or_else(|| nearly_coincident(shapes, leaves))
}

fn far_displaced(view: &View, shapes: &[Shape], leaves: &[Leaf]) -> Option<BeyondSingle> {
    leaves.iter().find_map(|leaf| {
        let pixels = displacement(view, &shapes[leaf.shape as usize], UNIT);
        (pixels > TOLERANCE).then_some(BeyondSingle::Displaced {
            pixels,
            solid: leaf.solid,
        })
    })
}

/// How many pixels beside its place a surface may appear: the eye, the surface's centre and the ray's direction are
/// each rounded once, which moves the surface by u times their sizes, as seen over the least distance from which the
/// eye can see it.
fn displacement(view: &View, shape: &Shape, roundoff: f64) -> f64 {
    let pixel = 2.0 * view.right.length() / f64::from(view.width);
    let moved = roundoff * (shape.centre.length() + view.eye.length());
    let offset = view.eye - shape.centre;
    let distance = match shape.form {
        Form::HalfSpace { normal } => normal.dot(offset).abs(),
        _ => (shape.local(offset).length() - 1.0).abs() * shape.least_radius(),
    };
    (roundoff + moved / distance) / pixel
}

/// The first two surfaces that are not the same, and yet nearly.
fn nearly_coincident(shapes: &[Shape], leaves: &[Leaf]) -> Option<BeyondSingle> {
    let shape_of = |leaf: u32| &shapes[leaves[leaf as usize].shape as usize];
    // On each of two grids, half a step apart: numbers that differ by less than half a step share a cell of one.
    let crowded = |shift: f64| {
        let mut cells = Register::with_room(leaves.len());
        let cell = |leaf: u32| Key::cell(shape_of(leaf), NEAR, shift);
        let mut halves = Vec::with_capacity(AT_ONCE);
        (0..leaves.len() as u32).step_by(AT_ONCE).find_map(|start| {
            let end = leaves.len().min(start as usize + AT_ONCE) as u32;
            halves.clear();
            halves.extend((start..end).map(|leaf| cells.half(&cell(leaf))));
            halves.iter().for_each(|half| cells.expect(*half));
            (start..end).zip(&halves).find_map(|(leaf, half)| {
                let Some(first) = cells.find(*half, |first| cell(first) == cell(leaf)) else {
                    cells.file(*half, leaf);
                    return None;
                };
                let solids = [first, leaf].map(|leaf| leaves[leaf as usize].solid);
                (shape_of(first).class != shape_of(leaf).class)
                    .then_some(BeyondSingle::NearlyCoincident { solids: solids.into() })
            })
        })
    };
    let (first, second) = together(leaves.len(), || crowded(0.0), || crowded(0.5));
    first.or(second)
}

fn in_range(shape: &Shape) -> bool {
    let range = |x: f64| x.abs() <= LARGEST;
    let form = match &shape.form {
        Form::Ball { radius } => range(*radius) && range(1.0 / radius),
        Form::Ellipsoid(axes) => [axes.inverse, axes.linear]
            .iter()
            .all(|matrix| matrix.to_cols_array().into_iter().all(range)),
        Form::HalfSpace { .. } => true,
    };
    form && shape.centre.to_array().into_iter().all(range)
}
