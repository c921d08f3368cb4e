//! A surface in numbers.

use scenec_scene::{DMat3, DVec3};

/// What a surface is.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
#[repr(u32)]
pub enum ShapeKind {
    /// A sphere that stayed one.
    Ball,
    /// Any other image of the unit sphere.
    Ellipsoid,
    /// A half-space.
    HalfSpace,
}

impl ShapeKind {
    /// The number that stands for it among tracers.
    #[must_use]
    pub const fn number(self) -> u32 {
        self as u32
    }
}

/// A surface in numbers. There may be millions of them, most of them balls.
#[derive(Clone, PartialEq, Debug)]
pub struct Shape {
    /// Equal for shapes with the same surface; a half-space and its complement share theirs.
    pub class: u32,
    /// The centre; of a half-space, the foot of the perpendicular from the plan's origin.
    pub centre: DVec3,
    /// What it is, and how large.
    pub form: Form,
}

/// What a surface is, without its place.
#[derive(Clone, PartialEq, Debug)]
pub enum Form {
    /// A sphere that stayed one.
    Ball {
        /// Its radius.
        radius: f64,
    },
    /// Any other image of the unit sphere.
    Ellipsoid(Box<Axes>),
    /// A half-space.
    HalfSpace {
        /// The outward unit normal.
        normal: DVec3,
    },
}

/// What became of the unit sphere.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Axes {
    /// World to object, without the translation.
    pub inverse: DMat3,
    /// Object to world, without the translation.
    pub linear: DMat3,
}

impl Shape {
    /// What it is.
    #[must_use]
    pub const fn kind(&self) -> ShapeKind {
        match self.form {
            Form::Ball { .. } => ShapeKind::Ball,
            Form::Ellipsoid(_) => ShapeKind::Ellipsoid,
            Form::HalfSpace { .. } => ShapeKind::HalfSpace,
        }
    }

    /// World to object, without the translation: of a ball, 1/radius times the identity; of a half-space, the outward unit normal
    /// in the first row and nothing else.
    #[must_use]
    pub fn inverse(&self) -> DMat3 {
        match &self.form {
            Form::Ball { radius } => DMat3::from_diagonal(DVec3::splat(1.0 / radius)),
            Form::Ellipsoid(axes) => axes.inverse,
            Form::HalfSpace { normal } => DMat3::from_cols(*normal, DVec3::ZERO, DVec3::ZERO).transpose(),
        }
    }

    /// Object to world, without the translation; of a half-space, zero.
    #[must_use]
    pub fn linear(&self) -> DMat3 {
        match &self.form {
            Form::Ball { radius } => DMat3::from_diagonal(DVec3::splat(*radius)),
            Form::Ellipsoid(axes) => axes.linear,
            Form::HalfSpace { .. } => DMat3::ZERO,
        }
    }

    /// The outward unit normal of a half-space; zero for anything else.
    #[must_use]
    pub const fn normal(&self) -> DVec3 {
        match self.form {
            Form::HalfSpace { normal } => normal,
            _ => DVec3::ZERO,
        }
    }

    /// An offset from the centre in the coordinates in which a ball or ellipsoid is the unit sphere.
    #[must_use]
    pub(crate) fn local(&self, offset: DVec3) -> DVec3 {
        match &self.form {
            Form::Ball { radius } => offset * (1.0 / radius),
            Form::Ellipsoid(axes) => axes.inverse * offset,
            Form::HalfSpace { .. } => DVec3::ZERO,
        }
    }

    /// Whether the solid behind the surface holds a point in the shape's own coordinates; the surface counts as inside.
    #[must_use]
    pub fn holds(&self, point: DVec3) -> bool {
        let offset = point - self.centre;
        match self.form {
            Form::HalfSpace { normal } => normal.dot(offset) <= 0.0,
            _ => self.local(offset).length_squared() <= 1.0,
        }
    }

    /// Where on its own unit sphere the surface has a point, if it is on the surface to within 2^-48 of the sizes that its
    /// test subtracts: 32 roundings, which leaves room for those of the transform. A point that is nearer than that can't
    /// be told from one on the surface.
    #[must_use]
    pub(crate) fn touched_by(&self, point: DVec3) -> Option<DVec3> {
        let near = (-48.0_f64).exp2();
        let sizes = point.abs().max_element() + self.centre.abs().max_element();
        let offset = point - self.centre;
        let largest = match &self.form {
            Form::HalfSpace { normal } => {
                return (normal.dot(offset).abs() <= near * sizes).then_some(DVec3::ZERO);
            }
            Form::Ball { radius } => 1.0 / radius,
            Form::Ellipsoid(axes) => largest(&axes.inverse),
        };
        let local = self.local(offset);
        ((local.length() - 1.0).abs() <= near * (1.0 + largest * sizes)).then(|| local.normalize())
    }

    /// A bound from below on the shortest half axis of a ball or ellipsoid.
    #[must_use]
    pub fn least_radius(&self) -> f64 {
        let squares: f64 = self.inverse().to_cols_array().into_iter().map(|x| x * x).sum();
        squares.sqrt().recip()
    }

    /// Translates by `-origin`, then scales.
    pub(crate) fn relate(&mut self, origin: DVec3, scale: f64) {
        self.centre = (self.centre - origin) * scale;
        match &mut self.form {
            Form::HalfSpace { normal } => self.centre = *normal * normal.dot(self.centre),
            Form::Ball { radius } => *radius *= scale,
            Form::Ellipsoid(axes) => {
                axes.inverse *= 1.0 / scale;
                axes.linear *= scale;
            }
        }
    }
}

/// The largest of a matrix's numbers, without its sign.
pub(crate) fn largest(matrix: &DMat3) -> f64 {
    matrix
        .to_cols_array()
        .into_iter()
        .fold(0.0_f64, |most, x| most.max(x.abs()))
}
