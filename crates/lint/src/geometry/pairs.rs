//! What can be shown about two leaves.
//!
//! Each answer is a proof or nothing: where rounding could tip the balance, or the test is not the sharpest one, there
//! is no answer.

use scenec_scene::{DMat3, DVec3};

use super::proof::Fact;
use super::shape::{Ball, Half, SLACK, Shape, frobenius};
use super::spectral::largest_singular;

/// Why `inner` lies inside `outer`, without touching its surface.
pub(super) fn inside(inner: &Shape, outer: &Shape) -> Option<Fact> {
    match (inner, outer) {
        (Shape::Ball(inner), Shape::Ball(outer)) => ball_in_ball(inner, outer),
        (Shape::Ball(inner), Shape::Half(outer)) => ball_in_half(inner, outer),
        (Shape::Half(inner), Shape::Half(outer)) => half_in_half(inner, outer),
        (Shape::Half(_), Shape::Ball(_)) => None,
    }
}

/// Why the two have no point in common.
pub(super) fn apart(a: &Shape, b: &Shape) -> Option<Fact> {
    match (a, b) {
        (Shape::Ball(a), Shape::Ball(b)) => balls_apart(a, b),
        (Shape::Ball(ball), Shape::Half(half)) | (Shape::Half(half), Shape::Ball(ball)) => ball_off_half(ball, half),
        (Shape::Half(a), Shape::Half(b)) => halves_apart(a, b),
    }
}

/// Whether the two are one solid, to 2^-40 of their size.
pub(super) fn same(a: &Shape, b: &Shape) -> bool {
    match (a, b) {
        (Shape::Ball(a), Shape::Ball(b)) => {
            let map = b.inverse * a.linear;
            let off = map * map.transpose() - DMat3::IDENTITY;
            let aside = b.inverse * (a.centre - b.centre);
            frobenius(&off) <= SLACK && aside.length() <= SLACK
        }
        (Shape::Half(a), Shape::Half(b)) => {
            let far = a.point.length() + b.point.length();
            (a.normal - b.normal).length() <= SLACK && b.height(a.point).abs() <= SLACK * far
        }
        _ => false,
    }
}

/// The farthest point of the inner one, measured by the outer, is at most |M d| + |M L| from its centre: the distance of
/// the centres and the largest half-axis of the inner one, both as the outer one's own coordinates have them. For balls
/// this is exact.
fn ball_in_ball(inner: &Ball, outer: &Ball) -> Option<Fact> {
    let apart = inner.centre - outer.centre;
    let offset = (outer.inverse * apart).length();
    if offset >= 1.0 {
        return None;
    }
    let reach = offset + largest_singular(&(outer.inverse * inner.linear)) * (1.0 + inner.slop);
    let sizes = 1.0 + frobenius(&outer.inverse) * (frobenius(&inner.linear) + apart.length());
    let certain = reach < 1.0 - outer.slop - SLACK * sizes;
    certain.then(|| match (inner.radius(), outer.radius()) {
        (Some(small), Some(large)) => Fact::Radii {
            distance: apart.length(),
            inner: small,
            outer: large,
        },
        _ => Fact::Reach { reach },
    })
}

fn ball_in_half(ball: &Ball, half: &Half) -> Option<Fact> {
    let apart = (ball.centre - half.point).length();
    let reach = ball.reach(half.normal);
    let depth = -half.height(ball.centre) - reach;
    (depth > SLACK * (apart + reach)).then_some(Fact::Depth { depth })
}

fn ball_off_half(ball: &Ball, half: &Half) -> Option<Fact> {
    let apart = (ball.centre - half.point).length();
    let reach = ball.reach(half.normal);
    let gap = half.height(ball.centre) - reach;
    let along = half.normal;
    (gap > SLACK * (apart + reach)).then_some(Fact::Gap { along, gap })
}

/// Planes that are not parallel cross somewhere, so only the very same normal will do.
fn half_in_half(inner: &Half, outer: &Half) -> Option<Fact> {
    let apart = (inner.point - outer.point).length();
    let depth = -outer.height(inner.point);
    (inner.normal == outer.normal && depth > SLACK * apart).then_some(Fact::Parallel { depth })
}

fn halves_apart(a: &Half, b: &Half) -> Option<Fact> {
    let apart = (b.point - a.point).length();
    let gap = a.height(b.point);
    let along = a.normal;
    (a.normal == -b.normal && gap > SLACK * apart).then_some(Fact::Gap { along, gap })
}

/// Any direction along which both end before they meet will do; tried are the line through the centres, which is the
/// best one for balls, and the best one for the ellipsoid of the summed Gram matrices.
fn balls_apart(a: &Ball, b: &Ball) -> Option<Fact> {
    let apart = b.centre - a.centre;
    let distance = apart.length();
    let clear = |along: DVec3| {
        let reach = a.reach(along) + b.reach(along);
        let gap = along.dot(apart) - reach;
        (gap > SLACK * (distance + reach)).then_some(Fact::Gap { along, gap })
    };
    if let Some(fact) = apart.try_normalize().and_then(clear) {
        return Some(match (a.radius(), b.radius()) {
            (Some(one), Some(other)) => Fact::Between {
                distance,
                radii: one + other,
            },
            _ => fact,
        });
    }
    let gram = a.linear * a.linear.transpose() + b.linear * b.linear.transpose();
    (gram.inverse() * apart).try_normalize().and_then(clear)
}

#[cfg(test)]
mod tests {
    use scenec_scene::{Axis, Base, DVec3, Transform};

    use super::super::shape::Shape;
    use super::{apart, inside, same};

    fn shape(base: Base, transform: Transform) -> Shape {
        Shape::placed(base, &transform).unwrap()
    }

    fn ball(radius: f64, centre: DVec3) -> Shape {
        shape(
            Base::Sphere,
            Transform::IDENTITY.scaled(DVec3::splat(radius)).translated(centre),
        )
    }

    fn half(by: f64, turn: f64, height: f64) -> Shape {
        let turned = Transform::IDENTITY
            .scaled(DVec3::new(1.0, by, 1.0))
            .rotated(Axis::X, turn);
        shape(Base::HalfSpace, turned.translated(DVec3::Y * height))
    }

    /// Whether each of the two is shown inside the other, and both apart.
    fn check(a: &Shape, b: &Shape, expect: [bool; 3]) {
        let found = [inside(a, b).is_some(), inside(b, a).is_some(), apart(a, b).is_some()];
        assert_eq!(found, expect, "{a:?} {b:?}");
        assert_eq!(apart(b, a).is_some(), expect[2], "{a:?} {b:?}");
    }

    #[test]
    fn balls_nest_and_part_but_for_a_touch() {
        let x = DVec3::X;
        let unit = ball(1.0, DVec3::ZERO);
        check(&ball(0.3, x * 0.69), &unit, [true, false, false]);
        check(&ball(0.3, x * 0.7), &unit, [false; 3]);
        check(&ball(0.3, x * 0.71), &unit, [false; 3]);
        check(&ball(0.3, x * 1.29), &unit, [false; 3]);
        check(&ball(0.3, x * 1.3), &unit, [false; 3]);
        check(&ball(0.3, x * 1.31), &unit, [false, false, true]);
        check(&unit, &unit, [false; 3]);
    }

    #[test]
    fn ellipsoids_nest_and_part() {
        let long = shape(
            Base::Sphere,
            Transform::IDENTITY
                .scaled(DVec3::new(4.0, 1.0, 1.0))
                .rotated(Axis::Z, 0.5),
        );
        check(&ball(0.9, DVec3::ZERO), &long, [true, false, false]);
        check(&ball(4.01, DVec3::ZERO), &long, [false, true, false]);
        let tip = DVec3::new(0.5_f64.cos(), 0.5_f64.sin(), 0.0) * 4.0;
        check(&ball(0.1, tip * 1.02), &long, [false; 3]);
        check(&ball(0.1, tip * 1.03), &long, [false, false, true]);
        // Beside it, where the line through the centres separates nothing.
        let side = DVec3::new(3.0 - 1.2 * 0.5_f64.sin(), 0.0, 0.0);
        check(&ball(0.1, side + DVec3::Y * -0.6), &long, [false, false, true]);
    }

    #[test]
    fn half_spaces_hold_and_miss() {
        let ground = half(1.0, 0.0, 0.0);
        check(&ball(1.0, DVec3::Y * -1.01), &ground, [true, false, false]);
        check(&ball(1.0, DVec3::Y * -1.0), &ground, [false; 3]);
        check(&ball(1.0, DVec3::Y * 1.0), &ground, [false; 3]);
        check(&ball(1.0, DVec3::Y * 1.01), &ground, [false, false, true]);
        check(&half(1.0, 0.0, -1.0), &ground, [true, false, false]);
        check(&half(-1.0, 0.0, 1.0), &ground, [false, false, true]);
        check(&half(-1.0, 0.0, -1.0), &ground, [false; 3]);
        check(&half(1.0, 1e-9, -1.0), &ground, [false; 3]);
    }

    #[test]
    fn a_turned_ball_is_the_same_one() {
        let id = Transform::IDENTITY;
        let turned = id.rotated(Axis::X, 0.3).rotated(Axis::Y, 1.0).translated(DVec3::X);
        assert!(same(&shape(Base::Sphere, turned), &ball(1.0, DVec3::X)));
        assert!(!same(&ball(1.0, DVec3::X), &ball(1.0, DVec3::X * (1.0 + 1e-11))));
        assert!(!same(&ball(1.0, DVec3::X), &ball(1.0 + 1e-11, DVec3::X)));
        let long = id.scaled(DVec3::new(2.0, 1.0, 1.0));
        let mirrored = id.scaled(DVec3::new(-2.0, 1.0, -1.0));
        assert!(same(&shape(Base::Sphere, long), &shape(Base::Sphere, mirrored)));
        assert!(!same(
            &shape(Base::Sphere, long),
            &shape(Base::Sphere, long.rotated(Axis::Y, 0.1))
        ));
        assert!(same(&half(1.0, 0.0, 2.0), &half(7.0, 0.0, 2.0)));
        assert!(!same(&half(1.0, 0.0, 2.0), &half(-1.0, 0.0, 2.0)));
        assert!(!same(&half(1.0, 0.0, 2.0), &ball(1.0, DVec3::ZERO)));
    }
}
