//! Where a ray runs inside a surface's solid: always one interval, since balls, ellipsoids and half-spaces are convex.

use scenec_plan::packed_structs::{Shape, Touch};
use scenec_plan::{Real, ShapeKind};

use crate::lanes::Lanes;
use crate::ray::Ray;
use crate::vector::{Arithmetic, Vector, add, columns, dot, fma, normalize, rows, scale, sub};

pub(crate) const BALL: u32 = ShapeKind::Ball.number();
pub(crate) const HALF_SPACE: u32 = ShapeKind::HalfSpace.number();

/// Distances at which the ray enters and leaves; nothing if the first is not below the second.
pub(crate) type Interval<R> = (R, R);

/// A ray in a shape's own coordinates, at its point nearest to the centre.
pub(crate) struct Approach<A> {
    direction: Vector<A>,
    nearest: Vector<A>,
    /// Distance along the ray to `nearest`.
    distance: A,
    /// From `nearest` to either root.
    half: A,
}

impl<A: Arithmetic> Approach<A> {
    /// Where the ray enters and leaves.
    #[inline(always)]
    pub(crate) fn ends(&self) -> (A, A) {
        (self.distance - self.half, self.distance + self.half)
    }

    /// The point that is so far from the nearest one: where it enters or leaves, in the shape's own coordinates.
    #[inline(always)]
    pub(crate) fn point(&self, half: A) -> Vector<A> {
        fma(self.direction, half, self.nearest)
    }

    /// From the nearest point to either end.
    #[inline(always)]
    pub(crate) const fn half(&self) -> A {
        self.half
    }
}

/// The interval of a ray inside a shape; `touches` are the surfaces that its end lies on.
#[inline(always)]
pub(crate) fn interval<R: Lanes>(shape: &Shape<R>, ray: &Ray<R>, touches: &[Touch<R>]) -> Interval<R> {
    let end = touches.iter().find(|touch| touch.class == shape.class);
    if shape.kind == HALF_SPACE {
        return half_space(shape, ray, end.is_some());
    }
    if shape.class == ray.class {
        // Deflation: the start lies on this sphere, so the equation loses its constant term and has exactly the roots 0
        // and -2 (p.d)/(d.d). A ray that leaves has no second one ahead.
        if !ray.into {
            return (R::ZERO, R::ZERO);
        }
        if end.is_some() {
            return (R::ZERO, ray.end);
        }
        let direction = to_local(shape.kind, &shape.inverse, ray.direction);
        return (R::ZERO, other_root(dot(ray.local, direction), direction));
    }
    if let Some(touch) = end {
        // The same from the other end.
        let direction = to_local(shape.kind, &shape.inverse, ray.direction);
        let other = ray.end + other_root(dot(touch.local_point, direction), direction);
        return (other.min(ray.end), other.max(ray.end));
    }
    approach_of(shape, ray).ends()
}

/// From a point p of the unit sphere along d: the other root of |p + t d| = 1, given p.d.
#[inline(always)]
pub(crate) fn other_root<A: Arithmetic>(towards: A, direction: Vector<A>) -> A {
    -(towards + towards) / dot(direction, direction)
}

/// Closest approach with one residual step: the discriminant is 1 minus the square of the distance between ray and centre,
/// so no large numbers cancel, and the correction removes the rounding of the first projection. A miss gives half = NaN,
/// whose interval holds no number.
#[inline(always)]
pub(crate) fn approach<A: Arithmetic>(start: Vector<A>, direction: Vector<A>) -> Approach<A> {
    let square = dot(direction, direction);
    let first = -dot(start, direction) / square;
    let rough = fma(direction, first, start);
    let rest = -dot(rough, direction) / square;
    let nearest = fma(direction, rest, rough);
    let discriminant = (-nearest[0]).fused(nearest[0], square.one());
    let discriminant = (-nearest[1]).fused(nearest[1], discriminant);
    let discriminant = (-nearest[2]).fused(nearest[2], discriminant);
    Approach {
        direction,
        nearest,
        distance: first + rest,
        half: (discriminant / square).root(),
    }
}

/// The same of a ball or ellipsoid and a ray.
#[inline(always)]
fn approach_of<R: Lanes>(shape: &Shape<R>, ray: &Ray<R>) -> Approach<R> {
    let start = to_local(shape.kind, &shape.inverse, sub(ray.origin, shape.centre));
    approach(start, to_local(shape.kind, &shape.inverse, ray.direction))
}

/// A ray's way to a plane.
pub(crate) struct Slope<A> {
    /// How fast it rises from it.
    pub(crate) towards: A,
    /// How high it begins.
    pub(crate) above: A,
    /// The sizes of what `towards` is the sum of. Three products and two sums: below 3 u times this the sign of `towards` is
    /// rounding, and the ray counts as parallel.
    pub(crate) terms: A,
}

#[inline(always)]
pub(crate) fn slope<A: Arithmetic>(
    normal: Vector<A>,
    foot: Vector<A>,
    origin: Vector<A>,
    direction: Vector<A>,
) -> Slope<A> {
    Slope {
        towards: dot(normal, direction),
        above: dot(normal, sub(origin, foot)),
        terms: (normal[0] * direction[0]).size()
            + (normal[1] * direction[1]).size()
            + (normal[2] * direction[2]).size(),
    }
}

/// What the sizes are multiplied by.
#[inline(always)]
pub(crate) fn parallel<R: Real>() -> R {
    (R::ONE + R::TWO) * R::ROUNDOFF
}

#[inline(always)]
fn half_space<R: Lanes>(shape: &Shape<R>, ray: &Ray<R>, ends_here: bool) -> Interval<R> {
    let normal = plane_normal(shape);
    if shape.class == ray.class {
        // Of one class are this plane's half-spaces on either side, so this product is 1 or -1.
        let towards = dot(normal, ray.local);
        return if towards >= R::ZERO {
            (-R::INFINITY, R::ZERO)
        } else {
            (R::ZERO, R::INFINITY)
        };
    }
    let Slope { towards, above, terms } = slope(normal, shape.centre, ray.origin, ray.direction);
    if ends_here {
        let distance = ray.end;
        return if above <= R::ZERO {
            (-R::INFINITY, distance)
        } else {
            (distance, R::INFINITY)
        };
    }
    if towards.abs() <= parallel::<R>() * terms {
        return if above <= R::ZERO {
            (-R::INFINITY, R::INFINITY)
        } else {
            (R::INFINITY, -R::INFINITY)
        };
    }
    let distance = -above / towards;
    if towards > R::ZERO {
        (-R::INFINITY, distance)
    } else {
        (distance, R::INFINITY)
    }
}

/// Where the ray meets the surface of an ellipsoid at `distance`, on its way in or (`leaving`) out: the point, the same on the
/// unit sphere, and the unit normal that points outwards.
#[inline(always)]
pub(crate) fn on_ellipsoid<R: Lanes>(
    shape: &Shape<R>,
    ray: &Ray<R>,
    distance: R,
    leaving: bool,
) -> (Vector<R>, Vector<R>, Vector<R>) {
    let local = if shape.class == ray.class {
        fma(to_local(shape.kind, &shape.inverse, ray.direction), distance, ray.local)
    } else {
        let approach = approach_of(shape, ray);
        approach.point(if leaving { approach.half } else { -approach.half })
    };
    let local = normalize(local);
    let point = add(shape.centre, rows(&shape.linear, local));
    (point, local, normalize(columns(&shape.inverse, local)))
}

/// Into a shape's own coordinates, by its kind and its matrix.
#[inline(always)]
pub(crate) fn to_local<A: Arithmetic>(kind: u32, inverse: &[A; 9], v: Vector<A>) -> Vector<A> {
    if kind == BALL {
        scale(v, inverse[0])
    } else {
        rows(inverse, v)
    }
}

#[inline(always)]
pub(crate) const fn plane_normal<R: Real>(shape: &Shape<R>) -> Vector<R> {
    [shape.inverse[0], shape.inverse[1], shape.inverse[2]]
}
