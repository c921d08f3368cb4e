//! Affine transforms, composed and inverted factor by factor.

use crate::{DMat3, DVec3};

/// A coordinate axis of the world.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Axis {
    /// The first.
    X,
    /// The second.
    Y,
    /// The third.
    Z,
}

/// World point = `linear` * object point + `centre`.
///
/// The inverse is kept beside the map as the product of the factors' own inverses, so no elimination ever meets an
/// ill-conditioned matrix; and the translation is kept as the image of the origin, so that an intersection can subtract
/// it before anything is multiplied.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Transform {
    /// Object to world, without the translation.
    pub linear: DMat3,
    /// World to object: the inverse of `linear`.
    pub inverse: DMat3,
    /// Where the object's origin goes, world units.
    pub centre: DVec3,
}

impl Transform {
    /// Leaves everything where it is.
    pub const IDENTITY: Self = Self {
        linear: DMat3::IDENTITY,
        inverse: DMat3::IDENTITY,
        centre: DVec3::ZERO,
    };

    /// Followed by a scale along the world's axes; no component may be zero.
    #[must_use]
    pub fn scaled(mut self, by: DVec3) -> Self {
        self.scale(by);
        self
    }

    /// Followed by a right-handed rotation about a world axis, in radians.
    #[must_use]
    pub fn rotated(mut self, axis: Axis, angle: f64) -> Self {
        self.rotate(axis, angle);
        self
    }

    /// Followed by a translation, world units.
    #[must_use]
    pub fn translated(mut self, by: DVec3) -> Self {
        self.translate(by);
        self
    }

    /// As [`Self::scaled`], in place: of the factor's matrix only the diagonal is not 0.
    #[inline]
    pub(crate) fn scale(&mut self, by: DVec3) {
        let [x, y, z] = by.recip().to_array();
        for column in [
            &mut self.linear.x_axis,
            &mut self.linear.y_axis,
            &mut self.linear.z_axis,
            &mut self.centre,
        ] {
            *column *= by;
        }
        self.inverse.x_axis *= x;
        self.inverse.y_axis *= y;
        self.inverse.z_axis *= z;
    }

    /// As [`Self::rotated`], in place.
    pub(crate) fn rotate(&mut self, axis: Axis, angle: f64) {
        let turn = match axis {
            Axis::X => DMat3::from_rotation_x(angle),
            Axis::Y => DMat3::from_rotation_y(angle),
            Axis::Z => DMat3::from_rotation_z(angle),
        };
        self.linear = turn * self.linear;
        self.inverse *= turn.transpose();
        self.centre = turn * self.centre;
    }

    /// As [`Self::translated`], in place.
    #[inline]
    pub(crate) fn translate(&mut self, by: DVec3) {
        self.centre += by;
    }

    /// Whether every number in it is finite; a long chain of scales can leave the range of a double.
    #[must_use]
    pub fn is_finite(&self) -> bool {
        self.linear.is_finite() && self.inverse.is_finite() && self.centre.is_finite()
    }
}

#[cfg(test)]
mod tests {
    use super::{Axis, Transform};
    use crate::{DMat3, DVec3};

    fn check(transform: Transform, point: DVec3, expect: DVec3) {
        let world = transform.linear * point + transform.centre;
        assert!((world - expect).length() < 1e-12, "{world} is not {expect}");
        let back = transform.inverse * (world - transform.centre);
        assert!((back - point).length() < 1e-12, "{back} is not {point}");
    }

    #[test]
    fn transforms_act_in_the_order_written_in_world_axes() {
        let quarter = std::f64::consts::FRAC_PI_2;
        let id = Transform::IDENTITY;
        check(
            id.translated(DVec3::X).rotated(Axis::Y, quarter),
            DVec3::ZERO,
            -DVec3::Z,
        );
        check(id.rotated(Axis::Y, quarter).translated(DVec3::X), DVec3::ZERO, DVec3::X);
        check(id.rotated(Axis::Z, quarter), DVec3::X, DVec3::Y);
        check(id.rotated(Axis::X, quarter), DVec3::Y, DVec3::Z);
        check(
            id.translated(DVec3::ONE).scaled(DVec3::new(2.0, 3.0, -4.0)),
            DVec3::ONE,
            DVec3::new(4.0, 6.0, -8.0),
        );
    }

    #[test]
    fn long_chains_keep_their_inverse() {
        let mut turned = Transform::IDENTITY;
        for _ in 0..200 {
            turned = turned.rotated(Axis::X, std::f64::consts::TAU / 200.0);
        }
        let mut scaled = Transform::IDENTITY;
        for _ in 0..5000 {
            scaled = scaled.scaled(DVec3::splat(2.0)).scaled(DVec3::splat(0.5));
        }
        for transform in [turned, scaled] {
            assert!(
                (transform.linear - DMat3::IDENTITY)
                    .to_cols_array()
                    .iter()
                    .all(|x| x.abs() < 1e-13)
            );
            assert!(
                (transform.linear * transform.inverse - DMat3::IDENTITY)
                    .to_cols_array()
                    .iter()
                    .all(|x| x.abs() < 1e-13)
            );
        }
    }

    #[test]
    fn overflow_is_noticed() {
        let huge = DVec3::splat(1e300);
        assert!(!Transform::IDENTITY.scaled(huge).scaled(huge).is_finite());
        assert!(
            !Transform::IDENTITY
                .scaled(huge.recip())
                .scaled(huge.recip())
                .is_finite()
        );
    }
}
