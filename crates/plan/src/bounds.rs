//! Axis-aligned boxes in f64, possibly unbounded or empty.

use scenec_scene::{Base, DVec3, Transform};

/// The points between two corners, both included; empty where a lower corner lies above its upper one.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Box3 {
    /// Lower corner.
    pub min: DVec3,
    /// Upper corner.
    pub max: DVec3,
}

impl Box3 {
    /// No point.
    pub const EMPTY: Self = Self {
        min: DVec3::INFINITY,
        max: DVec3::NEG_INFINITY,
    };
    /// Every point.
    pub const ALL: Self = Self {
        min: DVec3::NEG_INFINITY,
        max: DVec3::INFINITY,
    };

    /// The box of a leaf, world units.
    ///
    /// A ball's image reaches |row i of the linear map| from its centre along axis i. The figures are widened by their
    /// own rounding: a row's length takes 3 products, 2 sums and a root (under 2^-50 relative), the sum with the centre
    /// one more. A half-space is bounded only where its plane is exactly square to an axis; the general one is unbounded.
    #[must_use]
    pub fn of_leaf(base: Base, transform: &Transform) -> Self {
        match base {
            Base::Sphere => {
                let rows = transform.linear.transpose();
                let reach = DVec3::new(rows.x_axis.length(), rows.y_axis.length(), rows.z_axis.length());
                let slack = (reach + transform.centre.abs()) * (-48.0_f64).exp2();
                Self {
                    min: transform.centre - reach - slack,
                    max: transform.centre + reach + slack,
                }
            }
            Base::HalfSpace => half_space(transform.inverse.transpose().y_axis, transform.centre),
        }
    }

    /// One point.
    #[must_use]
    pub const fn point(point: DVec3) -> Self {
        Self { min: point, max: point }
    }

    /// The box of a leaf's complement: the rest of the world, but for a half-space, whose complement is one as well.
    #[must_use]
    pub fn of_complement(base: Base, transform: &Transform) -> Self {
        match base {
            Base::Sphere => Self::ALL,
            Base::HalfSpace => half_space(-transform.inverse.transpose().y_axis, transform.centre),
        }
    }

    /// The points of both.
    #[must_use]
    pub fn intersection(self, other: Self) -> Self {
        Self {
            min: self.min.max(other.min),
            max: self.max.min(other.max),
        }
    }

    /// The smallest box that holds both.
    #[must_use]
    pub fn hull(self, other: Self) -> Self {
        Self {
            min: self.min.min(other.min),
            max: self.max.max(other.max),
        }
    }

    /// Whether there is no point in it.
    #[must_use]
    pub fn is_empty(self) -> bool {
        !self.min.cmple(self.max).all()
    }

    /// Whether it ends on every side.
    #[must_use]
    pub fn is_finite(self) -> bool {
        self.min.is_finite() && self.max.is_finite()
    }

    /// Whether the point lies in it.
    #[must_use]
    pub fn holds(self, point: DVec3) -> bool {
        self.min.cmple(point).all() && point.cmple(self.max).all()
    }

    /// The point of the box nearest to `point`.
    #[must_use]
    pub fn nearest(self, point: DVec3) -> DVec3 {
        point.max(self.min).min(self.max)
    }

    /// The box after a translation by `-origin` and a scale.
    #[must_use]
    pub fn relative(self, origin: DVec3, scale: f64) -> Self {
        Self {
            min: (self.min - origin) * scale,
            max: (self.max - origin) * scale,
        }
    }
}

/// The half-space on the side of `point` that `normal` (any length) leaves.
fn half_space(normal: DVec3, point: DVec3) -> Box3 {
    let mut bounds = Box3::ALL;
    for axis in 0..3 {
        let others = (0..3).filter(|other| *other != axis);
        if others.into_iter().all(|other| normal[other] == 0.0) {
            let slack = point[axis].abs() * (-48.0_f64).exp2();
            if normal[axis] > 0.0 {
                bounds.max[axis] = point[axis] + slack;
            } else if normal[axis] < 0.0 {
                bounds.min[axis] = point[axis] - slack;
            }
        }
    }
    bounds
}
