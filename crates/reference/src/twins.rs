//! Leaves that are the same solid, or have the same plane as their surface, however they got there.
//!
//! Two spheres that were turned differently are one solid, though their transforms differ; and a plane may bound two
//! half-spaces, one on each side. Such leaves form a family and are all intersected by the numbers of its first one, so
//! that what coincides does so in every bit.

use std::collections::HashMap;

use scenec_scene::{Base, DVec3, Transform};

use crate::shape::Shape;

/// Numbers that are equal for one family and no other.
type Key = [u64; 11];

/// The families seen so far.
#[derive(Default)]
pub(crate) struct Families {
    known: HashMap<Key, (u32, Shape)>,
}

impl Families {
    /// The number of a placed base object's family, and its shape by the numbers of that family.
    pub(crate) fn place(&mut self, base: Base, transform: &Transform) -> (u32, Shape) {
        let next = self.known.len() as u32;
        match Shape::of(base, transform) {
            own @ Shape::Ball(transform) => *self.known.entry(ball(&transform)).or_insert((next, own)),
            Shape::Half { normal, centre, .. } => {
                let (normal, turned) = oriented(normal);
                let own = Shape::Half {
                    normal,
                    centre,
                    below: true,
                };
                let (family, mut shape) = *self.known.entry(plane(normal, centre)).or_insert((next, own));
                if let Shape::Half { below, .. } = &mut shape {
                    *below = !turned;
                }
                (family, shape)
            }
        }
    }
}

/// An ellipsoid is its centre and L L^T, for its linear map L: a turn or a mirror in front of L leaves both.
///
/// Numbers count as equal where they agree to 2^-40 of the ellipsoid's size, which is far above the rounding of the
/// transforms and far below anything that shows. Where one axis is much shorter than another that would not be far
/// below; there, only equal bits count.
fn ball(transform: &Transform) -> Key {
    let gram = transform.linear * transform.linear.transpose();
    let dual = transform.inverse.transpose() * transform.inverse;
    let trace = gram.x_axis.x + gram.y_axis.y + gram.z_axis.z;
    let round = trace * (dual.x_axis.x + dual.y_axis.y + dual.z_axis.z) < 1024.0;
    let square = if round { step(trace) } else { 0.0 };
    let length = if round { step(trace.sqrt()) } else { 0.0 };
    let [a, b, c, _, d, e, _, _, f] = gram.to_cols_array().map(|value| rounded(value, square));
    let [x, y, z] = transform.centre.to_array().map(|value| rounded(value, length));
    [0, square.to_bits(), a, b, c, d, e, f, x, y, z]
}

/// A plane is its unit normal and its distance from the origin; to 2^-40 each.
fn plane(normal: DVec3, centre: DVec3) -> Key {
    let distance = normal.dot(centre);
    let [x, y, z] = normal.to_array().map(|value| rounded(value, step(1.0)));
    let unit = step(distance.abs());
    // Which step it is counts as well: 1 and 2 are as many steps of their own.
    [1, unit.to_bits(), x, y, z, rounded(distance, unit), 0, 0, 0, 0, 0]
}

/// Of a normal and its opposite always the same one, and whether it is the opposite.
fn oriented(normal: DVec3) -> (DVec3, bool) {
    let leading = normal.to_array().into_iter().find(|value| value.abs() > step(1.0));
    let turned = leading.is_some_and(|value| value < 0.0);
    (if turned { -normal } else { normal }, turned)
}

/// 2^-40 of a power of two near `size`. It changes at odd multiples of the root of 2 and not at powers of two, which
/// people write, and on whose two sides the same plane may come out.
fn step(size: f64) -> f64 {
    2f64.powi(-40) * 2f64.powf((size * std::f64::consts::SQRT_2).log2().floor())
}

/// The bits of the nearest multiple of `step`; of the value itself where there is none. Either zero is the same one.
fn rounded(value: f64, step: f64) -> u64 {
    let count = (value / step).round();
    let number = if count.is_finite() { count } else { value };
    (number + 0.0).to_bits()
}

#[cfg(test)]
mod tests {
    use scenec_scene::{Axis, Base, DVec3, Transform};

    use super::Families;

    fn check(base: Base, first: Transform, second: Transform, expect: bool) {
        let mut families = Families::default();
        let (a, b) = (families.place(base, &first), families.place(base, &second));
        assert_eq!(a.0 == b.0, expect, "{base:?} {first:?} {second:?}");
    }

    #[test]
    fn the_same_solid_is_one_family_however_it_got_there() {
        let id = Transform::IDENTITY;
        let long = id.scaled(DVec3::new(1.0, 2.0, 3.0));
        for (a, b, expect) in [
            (id, id, true),
            (id, id.rotated(Axis::X, 0.3).rotated(Axis::Y, 1.0), true),
            (
                id.translated(DVec3::X),
                id.rotated(Axis::Z, 2.0).translated(DVec3::X),
                true,
            ),
            (long, id.scaled(DVec3::new(-1.0, 2.0, -3.0)), true),
            (long, id.rotated(Axis::Y, 0.1).scaled(DVec3::new(1.0, 2.0, 3.0)), true),
            (long, long.rotated(Axis::Y, 0.1), false),
            (id, id.scaled(DVec3::splat(1.0 - 1e-10)), false),
            (id, id.translated(DVec3::Y * 1e-10), false),
            (
                id.scaled(DVec3::new(1.0, 1.0, 1e-9)),
                id.scaled(DVec3::new(1.0, 1.0, 2e-9)),
                false,
            ),
        ] {
            check(Base::Sphere, a, b, expect);
        }
    }

    #[test]
    fn both_sides_of_a_plane_are_one_family() {
        let id = Transform::IDENTITY;
        let up = id.translated(DVec3::Y);
        for (a, b, expect) in [
            (id, id.rotated(Axis::X, std::f64::consts::PI), true),
            (id, id.scaled(DVec3::new(2.0, -3.0, 1.0)), true),
            (up, up.translated(DVec3::new(5.0, 0.0, -7.0)), true),
            (
                up,
                id.scaled(DVec3::splat(7.0)).rotated(Axis::Y, 1.0).translated(DVec3::Y),
                true,
            ),
            (up, id.translated(-DVec3::Y), false),
            (up, id.translated(DVec3::Y * 2.0), false),
            (
                id.rotated(Axis::X, std::f64::consts::FRAC_PI_2)
                    .rotated(Axis::Z, std::f64::consts::FRAC_PI_2)
                    .translated(DVec3::new(0.0, -1.0, 0.5)),
                id.rotated(Axis::X, -std::f64::consts::FRAC_PI_2)
                    .rotated(Axis::Z, std::f64::consts::FRAC_PI_2)
                    .translated(DVec3::new(-1.0, -0.5, 0.5)),
                true,
            ),
            (id, id.rotated(Axis::X, 1e-9), false),
        ] {
            check(Base::HalfSpace, a, b, expect);
        }
    }
}
