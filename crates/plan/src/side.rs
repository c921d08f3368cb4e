//! On which side of a surface a box lies.

use scenec_scene::DVec3;

use crate::Box3;
use crate::shape::{Axes, Form, Shape};

/// Where the points of a box are.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Side {
    /// None of them is in the solid.
    Outside,
    /// All of them are in the solid.
    Inside,
    /// Both, or it can't be told.
    Across,
}

/// The side of a box, all of whose points stay `slack` away from the surface if it is not across.
///
/// A box that reaches to infinity is judged by the walls that it has. NaN and infinity make a comparison fail, which
/// leaves the box across.
pub(crate) fn side(shape: &Shape, bounds: &Box3, slack: f64) -> Side {
    match &shape.form {
        Form::HalfSpace { normal } => of_half_space(*normal, shape.centre, bounds, slack),
        Form::Ball { radius } => of_ball(*radius, shape.centre, bounds, slack),
        Form::Ellipsoid(axes) => of_ellipsoid(axes, shape.centre, bounds, slack),
    }
}

fn of_half_space(normal: DVec3, foot: DVec3, bounds: &Box3, slack: f64) -> Side {
    let offset = normal.dot(foot);
    let (mut least, mut most) = (-offset, -offset);
    for axis in 0..3 {
        let n = normal[axis];
        // A zero times an infinite wall would be no number.
        if n != 0.0 {
            let (a, b) = (n * bounds.min[axis], n * bounds.max[axis]);
            least += a.min(b);
            most += a.max(b);
        }
    }
    if most < -slack {
        Side::Inside
    } else if least > slack {
        Side::Outside
    } else {
        Side::Across
    }
}

fn of_ball(radius: f64, centre: DVec3, bounds: &Box3, slack: f64) -> Side {
    let near = bounds.nearest(centre).distance(centre);
    let far = (bounds.max - centre).max(centre - bounds.min).length();
    if near > radius + slack {
        Side::Outside
    } else if far < radius - slack {
        Side::Inside
    } else {
        Side::Across
    }
}

fn of_ellipsoid(axes: &Axes, centre: DVec3, bounds: &Box3, slack: f64) -> Side {
    let rows = axes.linear.transpose();
    let reach = DVec3::new(rows.x_axis.length(), rows.y_axis.length(), rows.z_axis.length()) + slack;
    let apart = bounds.min.cmpgt(centre + reach) | bounds.max.cmplt(centre - reach);
    if apart.any() {
        return Side::Outside;
    }
    // In the shape's own coordinates, where it is the unit ball.
    let stretch = axes
        .inverse
        .to_cols_array()
        .into_iter()
        .map(|x| x * x)
        .sum::<f64>()
        .sqrt();
    let slack = slack * stretch;
    let middle = axes.inverse * (bounds.min / 2.0 + bounds.max / 2.0 - centre);
    let half = bounds.max / 2.0 - bounds.min / 2.0;
    let edges = [
        axes.inverse.x_axis * half.x,
        axes.inverse.y_axis * half.y,
        axes.inverse.z_axis * half.z,
    ];
    // No corner is farther from the middle than this.
    let spread: f64 = edges.iter().map(|edge| edge.length()).sum();
    if middle.length() - spread > 1.0 + slack {
        return Side::Outside;
    }
    let corner = |signs: u32| {
        let sign = |axis: u32| if signs >> axis & 1 == 1 { 1.0 } else { -1.0 };
        (middle + edges[0] * sign(0) + edges[1] * sign(1) + edges[2] * sign(2)).length()
    };
    if (0..8).all(|signs| corner(signs) < 1.0 - slack) {
        Side::Inside
    } else {
        Side::Across
    }
}

#[cfg(test)]
mod tests {
    use scenec_scene::{Axis, Base, DVec3, Transform};

    use super::{Side, side};
    use crate::Box3;
    use crate::shapes::Shapes;

    fn check(base: Base, transform: Transform, min: [f64; 3], max: [f64; 3], expect: Side) {
        let mut shapes = Shapes::default();
        shapes.intern(shapes.sought(base, &transform));
        let bounds = Box3 {
            min: min.into(),
            max: max.into(),
        };
        let found = side(&shapes.list[0], &bounds, 1e-6);
        assert_eq!(found, expect, "{base:?} {transform:?} {bounds:?}");
    }

    #[test]
    fn boxes_have_a_side_of_every_shape() {
        let id = Transform::IDENTITY;
        let egg = id.scaled(DVec3::new(2.0, 1.0, 0.5)).rotated(Axis::Z, 0.3);
        let slope = id.rotated(Axis::X, 0.5);
        let all = f64::INFINITY;
        check(Base::Sphere, id, [-0.5; 3], [0.5; 3], Side::Inside);
        check(Base::Sphere, id, [-0.6; 3], [0.6; 3], Side::Across);
        check(Base::Sphere, id, [0.6; 3], [0.9; 3], Side::Outside);
        check(Base::Sphere, id, [1.0, -all, -all], [all; 3], Side::Across);
        check(Base::Sphere, id, [1.1, -all, -all], [all; 3], Side::Outside);
        check(Base::Sphere, id, [-all; 3], [all; 3], Side::Across);
        check(Base::Sphere, egg, [-0.2; 3], [0.2; 3], Side::Inside);
        check(Base::Sphere, egg, [-0.45; 3], [0.45; 3], Side::Across);
        check(Base::Sphere, egg, [1.0, -1.0, -0.01], [1.2, -0.8, 0.01], Side::Outside);
        check(Base::Sphere, egg, [-all, -all, 0.6], [all; 3], Side::Outside);
        check(Base::Sphere, egg, [-all; 3], [all; 3], Side::Across);
        check(Base::HalfSpace, id, [-all, -all, -all], [all, -0.1, all], Side::Inside);
        check(Base::HalfSpace, id, [-all, 0.1, -all], [all; 3], Side::Outside);
        check(Base::HalfSpace, id, [-all, 0.0, -all], [all; 3], Side::Across);
        check(
            Base::HalfSpace,
            slope,
            [-1.0, -9.0, -1.0],
            [1.0, -1.0, 1.0],
            Side::Inside,
        );
        check(
            Base::HalfSpace,
            slope,
            [-all, -9.0, -1.0],
            [all, -1.0, 1.0],
            Side::Inside,
        );
        check(
            Base::HalfSpace,
            slope,
            [-all, -9.0, -1.0],
            [all, -1.0, all],
            Side::Across,
        );
    }
}
