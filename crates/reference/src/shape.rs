//! Where a line crosses a base object.

use scenec_scene::{Base, DVec3, Transform};

use crate::list::Spot;

/// A straight line, both ways from its origin.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct Line {
    /// Where t is 0, world units.
    pub(crate) origin: DVec3,
    /// Where t is 1, from there.
    pub(crate) direction: DVec3,
    /// The surface that the origin is on, if it is known to be on one.
    pub(crate) start: Option<Spot>,
    /// Which light stands where t is 1, if one does.
    pub(crate) light: Option<usize>,
}

impl Line {
    /// From anywhere.
    pub(crate) fn new(origin: DVec3, direction: DVec3) -> Self {
        Self {
            origin,
            direction,
            start: None,
            light: None,
        }
    }

    /// From a point of a surface.
    pub(crate) fn from_surface(spot: Spot, direction: DVec3) -> Self {
        Self {
            origin: spot.point,
            direction,
            start: Some(spot),
            light: None,
        }
    }

    /// The same line, of which a light stands at t = 1.
    pub(crate) fn to_light(self, number: usize) -> Self {
        Self {
            light: Some(number),
            ..self
        }
    }
}

/// A base object in the world.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) enum Shape {
    /// The unit sphere's image.
    Ball(Transform),
    /// All that is on one side of a plane.
    Half {
        /// Unit normal of the plane.
        normal: DVec3,
        /// A point on it.
        centre: DVec3,
        /// Whether the solid is on the side that the normal leaves, or on the other.
        below: bool,
    },
}

/// A crossing of a line with a shape: where along the line, and where in the shape's own coordinates.
type Crossing = (f64, DVec3);

impl Shape {
    /// The shape of a base object that went this way.
    pub(crate) fn of(base: Base, transform: &Transform) -> Self {
        match base {
            Base::Sphere => Self::Ball(*transform),
            Base::HalfSpace => Self::Half {
                // Normals go by the inverse transpose, of which this is the column of the object's y axis.
                normal: unit(transform.inverse.row(1)).unwrap_or(DVec3::Y),
                centre: transform.centre,
                below: true,
            },
        }
    }

    /// Whether the line begins in the shape at t = -infinity, and its crossings in order. `start` is the place where
    /// t is 0, if the origin is on this very surface, and `end` the place where t is 1, if the light there is.
    pub(crate) fn cross(&self, line: &Line, start: Option<DVec3>, end: Option<DVec3>) -> (bool, Vec<Crossing>) {
        match *self {
            Self::Ball(transform) => {
                let crossings =
                    ball(&transform, line, start, end).filter(|[a, b]| a.0 < b.0 && a.0.is_finite() && b.0.is_finite());
                (false, crossings.map_or_else(Vec::new, |both| both.to_vec()))
            }
            Self::Half { normal, centre, below } => half(normal, centre, below, line, start, end),
        }
    }

    /// The place of a world point that is on the surface, to 2^-48 of the numbers that tell: they are rounded a few times
    /// on the way.
    pub(crate) fn place(&self, point: DVec3) -> Option<DVec3> {
        let near = 2f64.powi(-48);
        match *self {
            Self::Ball(transform) => {
                let place = transform.inverse * (point - transform.centre);
                let rows = transform.inverse.transpose();
                let stretch = rows.x_axis.length().max(rows.y_axis.length()).max(rows.z_axis.length());
                let sizes = stretch * (point.length() + transform.centre.length());
                ((place.length() - 1.0).abs() <= near * (1.0 + sizes)).then(|| place.normalize())
            }
            Self::Half { normal, centre, .. } => {
                let (offset, sizes) = (point - centre, point.length() + centre.length());
                let height = normal.dot(offset);
                (height.abs() <= near * sizes).then(|| offset - height * normal)
            }
        }
    }

    /// The world point of a place.
    pub(crate) fn point(&self, place: DVec3) -> DVec3 {
        match *self {
            Self::Ball(transform) => transform.linear * place + transform.centre,
            Self::Half { centre, .. } => centre + place,
        }
    }

    /// The outward unit normal at a place.
    pub(crate) fn normal(&self, place: DVec3) -> DVec3 {
        match *self {
            Self::Ball(transform) => unit(transform.inverse.transpose() * place).unwrap_or(DVec3::Y),
            Self::Half {
                normal, below: true, ..
            } => normal,
            Self::Half {
                normal, below: false, ..
            } => -normal,
        }
    }
}

/// Places are points of the unit sphere.
///
/// From a known place p on the sphere, |p + s d| = 1 says s (2 p.d + s d.d) = 0, as |p| = 1: one root is 0, exactly, and
/// the other is -2 p.d / d.d. Otherwise the roots stand at equal distances from the point of the line that is nearest to the
/// centre, found twice: the second time takes away what rounding left along the line the first time.
///
/// The same holds from a known place at t = 1, where s counts from there; from two known places, both roots are known.
fn ball(transform: &Transform, line: &Line, start: Option<DVec3>, end: Option<DVec3>) -> Option<[Crossing; 2]> {
    let direction = transform.inverse * line.direction;
    // By its largest component, so that no square leaves the range of a double.
    let size = direction.abs().max_element();
    if size == 0.0 || !size.is_finite() {
        return None;
    }
    let d = direction / size;
    let square = d.dot(d);
    let known = |t: f64, place: DVec3| {
        let s = -2.0 * place.dot(d) / square;
        let other = (t + s / size, unit(place + s * d)?);
        let here = (t, place);
        Some(if s < 0.0 { [other, here] } else { [here, other] })
    };
    match (start, end) {
        // Outwards from the start the light on the same ball is out of sight, and the crossing behind counts.
        (Some(start), Some(end)) if start.dot(d) < 0.0 => return Some([(0.0, start), (1.0, end)]),
        (Some(start), _) => return known(0.0, start),
        (None, Some(end)) => return known(1.0, end),
        (None, None) => {}
    }
    let origin = transform.inverse * (line.origin - transform.centre);
    let along = -origin.dot(d) / square;
    let foot = origin + along * d;
    let rest = -foot.dot(d) / square;
    let foot = foot + rest * d;
    let room = 1.0 - foot.dot(foot);
    if room.is_nan() || room <= 0.0 {
        return None;
    }
    let half = (room / square).sqrt();
    let crossing = |half: f64| Some(((along + rest + half) / size, unit(foot + half * d)?));
    Some([crossing(-half)?, crossing(half)?])
}

/// Places are offsets in the plane from its point `centre`.
fn half(
    normal: DVec3,
    centre: DVec3,
    below: bool,
    line: &Line,
    start: Option<DVec3>,
    end: Option<DVec3>,
) -> (bool, Vec<Crossing>) {
    let rate = normal.dot(line.direction);
    let offset = line.origin - centre;
    let height = if start.is_some() { 0.0 } else { normal.dot(offset) };
    // With a known end the plane is crossed at t = 1, from the side of the origin to the other.
    let (rate, t) = match (start, end) {
        (None, Some(_)) if height != 0.0 => (-height, 1.0),
        _ => (rate, -height / rate),
    };
    if rate == 0.0 || !t.is_finite() {
        // Along the plane, or as good as that: all of the line or nothing.
        let all = if below { height <= 0.0 } else { height >= 0.0 };
        return (all, Vec::new());
    }
    let place = start.or(end).unwrap_or_else(|| {
        let reached = offset + t * line.direction;
        reached - normal * normal.dot(reached)
    });
    (below == (rate > 0.0), vec![(t, place)])
}

/// The unit vector of this direction, however long it is; `None` without one.
pub(crate) fn unit(v: DVec3) -> Option<DVec3> {
    let largest = v.abs().max_element();
    (largest > 0.0 && largest.is_finite()).then(|| (v / largest).normalize())
}

#[cfg(test)]
mod tests {
    use scenec_scene::{DVec3, Transform};

    use super::{Line, Shape};

    const GROUND: Shape = Shape::Half {
        normal: DVec3::Y,
        centre: DVec3::ZERO,
        below: true,
    };

    fn check(shape: Shape, origin: [f64; 3], direction: [f64; 3], before: bool, expect: &[f64]) {
        let line = Line::new(origin.into(), direction.into());
        let (inside, crossings) = shape.cross(&line, None, None);
        assert_eq!((inside, crossings.len()), (before, expect.len()), "{shape:?} {line:?}");
        for ((t, place), expect) in crossings.iter().zip(expect) {
            assert!((t - expect).abs() <= 1e-15 * expect.abs(), "{t} is not {expect}");
            let there = line.origin + *t * line.direction;
            assert!((shape.point(*place) - there).length() <= 1e-15 * (1.0 + there.length()));
        }
    }

    #[test]
    fn lines_cross_where_geometry_says() {
        let ball = Shape::Ball(Transform::IDENTITY);
        check(ball, [0.0, 0.0, 5.0], [0.0, 0.0, -1.0], false, &[4.0, 6.0]);
        check(ball, [0.0, 0.0, 5.0], [0.0, 0.0, 2.0], false, &[-3.0, -2.0]);
        check(ball, [-2.0, 1.0, 0.0], [1.0, 0.0, 0.0], false, &[]);
        check(ball, [0.0, 0.0, 1e7], [0.0, 0.0, -1.0], false, &[1e7 - 1.0, 1e7 + 1.0]);
        let wide = Shape::Ball(Transform::IDENTITY.scaled(DVec3::new(3.0, -1e-9, 1.0)));
        check(wide, [5.0, 0.0, 0.0], [-1.0, 0.0, 0.0], false, &[2.0, 8.0]);
        check(GROUND, [0.0, 2.0, 0.0], [0.0, -1.0, 0.0], false, &[2.0]);
        check(GROUND, [0.0, 2.0, 0.0], [0.0, 1.0, 1.0], true, &[-2.0]);
        check(GROUND, [0.0, 2.0, 0.0], [1.0, 0.0, 0.0], false, &[]);
        check(GROUND, [0.0, 0.0, 0.0], [1.0, -0.0, 0.0], true, &[]);
    }

    #[test]
    fn from_its_own_surface_one_root_is_zero_and_the_other_is_kept() {
        let far = Shape::Ball(
            Transform::IDENTITY
                .scaled(DVec3::splat(1e-3))
                .translated(DVec3::splat(1e6)),
        );
        let place = DVec3::new(0.6, 0.8, 0.0);
        let across = Line::new(far.point(place), -DVec3::X);
        let (_, crossings) = far.cross(&across, Some(place), None);
        assert_eq!(crossings[0].0, 0.0);
        assert!((crossings[1].0 - 1.2e-3).abs() < 1e-18);
        assert!((crossings[1].1 - DVec3::new(-0.6, 0.8, 0.0)).length() < 1e-15);
        let (before, crossings) = GROUND.cross(&Line::new(DVec3::Y * 1e-9, DVec3::Y), Some(DVec3::ZERO), None);
        assert_eq!((before, crossings), (true, vec![(0.0, DVec3::ZERO)]));
    }
}
