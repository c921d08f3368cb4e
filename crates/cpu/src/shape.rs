//! Where a ray runs inside a surface's solid: always one interval, since balls, ellipsoids and half-spaces are convex.

use scenec_plan::Real;
use scenec_plan::packed_structs::{Shape, Touch};

use crate::ray::{End, Ray};
use crate::vector::{Vector, add, columns, dot, fma, neg, normalize, rows, scale, sub};

const BALL: u32 = 0;
const HALF_SPACE: u32 = 2;

/// Distances at which the ray enters and leaves; nothing if the first is not below the second.
pub(crate) type Interval<R> = (R, R);

/// The ray in a shape's own coordinates, at its point nearest to the centre.
struct Approach<R> {
    direction: Vector<R>,
    nearest: Vector<R>,
    /// Distance along the ray to `nearest`.
    distance: R,
    /// From `nearest` to either root.
    half: R,
}

/// The interval of a ray inside a shape; `touches` are the surfaces that its end lies on.
#[inline(always)]
pub(crate) fn interval<R: Real>(shape: &Shape<R>, ray: &Ray<R>, touches: &[Touch<R>]) -> Interval<R> {
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
            return (R::ZERO, ray.end.distance);
        }
        let direction = to_local(shape, ray.direction);
        return (R::ZERO, other_root(dot(ray.local, direction), direction));
    }
    if let Some(touch) = end {
        // The same from the other end.
        let direction = to_local(shape, ray.direction);
        let other = ray.end.distance + other_root(dot(touch.local_point, direction), direction);
        return (other.min(ray.end.distance), other.max(ray.end.distance));
    }
    let approach = approach(shape, ray);
    (approach.distance - approach.half, approach.distance + approach.half)
}

/// From a point p of the unit sphere along d: the other root of |p + t d| = 1, given p.d.
#[inline(always)]
fn other_root<R: Real>(towards: R, direction: Vector<R>) -> R {
    -(towards + towards) / dot(direction, direction)
}

/// Closest approach with one residual step: the discriminant is 1 minus the square of the distance between ray and centre,
/// so no large numbers cancel, and the correction removes the rounding of the first projection. A miss gives half = NaN,
/// whose interval holds no number.
#[inline(always)]
fn approach<R: Real>(shape: &Shape<R>, ray: &Ray<R>) -> Approach<R> {
    let start = to_local(shape, sub(ray.origin, shape.centre));
    let direction = to_local(shape, ray.direction);
    let square = dot(direction, direction);
    let first = -dot(start, direction) / square;
    let rough = fma(direction, first, start);
    let rest = -dot(rough, direction) / square;
    let nearest = fma(direction, rest, rough);
    let discriminant = (-nearest[0]).fma(nearest[0], R::ONE);
    let discriminant = (-nearest[1]).fma(nearest[1], discriminant);
    let discriminant = (-nearest[2]).fma(nearest[2], discriminant);
    Approach {
        direction,
        nearest,
        distance: first + rest,
        half: (discriminant / square).sqrt(),
    }
}

#[inline(always)]
fn half_space<R: Real>(shape: &Shape<R>, ray: &Ray<R>, ends_here: bool) -> Interval<R> {
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
    let towards = dot(normal, ray.direction);
    let above = dot(normal, sub(ray.origin, shape.centre));
    if ends_here {
        let distance = ray.end.distance;
        return if above <= R::ZERO {
            (-R::INFINITY, distance)
        } else {
            (distance, R::INFINITY)
        };
    }
    // Three products and two sums: below this size the sign of `towards` is rounding, and the ray counts as parallel.
    let terms = (normal[0] * ray.direction[0]).abs()
        + (normal[1] * ray.direction[1]).abs()
        + (normal[2] * ray.direction[2]).abs();
    if towards.abs() <= (R::ONE + R::TWO) * R::ROUNDOFF * terms {
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

/// A point on a surface.
pub(crate) struct Contact<R> {
    /// In plan coordinates.
    pub(crate) point: Vector<R>,
    /// On the shape's own unit sphere; of a half-space, nothing.
    local: Option<Vector<R>>,
    /// Of length 1, turned to the side that the ray comes from.
    pub(crate) normal: Vector<R>,
    /// The class of the surface.
    class: u32,
    /// Whether the ray comes from within the shape's solid.
    leaving: bool,
}

impl<R: Real> Contact<R> {
    /// The ray that leaves the contact in this direction, `behind` the surface or on the side of the one that came.
    #[inline(always)]
    pub(crate) fn ray(&self, direction: Vector<R>, behind: bool, inside: bool) -> Ray<R> {
        let side = if behind { neg(self.normal) } else { self.normal };
        Ray {
            origin: self.point,
            direction,
            local: self.local.unwrap_or(side),
            class: self.class,
            into: self.leaving != behind,
            inside,
            end: End::NONE,
        }
    }
}

/// Where the ray meets the surface at `distance`, on its way in or (`leaving`) out.
#[inline(always)]
pub(crate) fn contact<R: Real>(shape: &Shape<R>, ray: &Ray<R>, distance: R, leaving: bool) -> Contact<R> {
    if shape.kind == HALF_SPACE {
        let outward = plane_normal(shape);
        let point = fma(ray.direction, distance, ray.origin);
        // One projection takes the rounding across the plane away.
        let off = dot(outward, sub(point, shape.centre));
        let point = fma(outward, -off, point);
        let normal = facing(outward, leaving);
        return Contact {
            point,
            local: None,
            normal,
            class: shape.class,
            leaving,
        };
    }
    let local = if shape.class == ray.class {
        fma(to_local(shape, ray.direction), distance, ray.local)
    } else {
        let approach = approach(shape, ray);
        let half = if leaving { approach.half } else { -approach.half };
        fma(approach.direction, half, approach.nearest)
    };
    let local = normalize(local);
    let (world, outward) = if shape.kind == BALL {
        (scale(local, shape.linear[0]), local)
    } else {
        (rows(&shape.linear, local), normalize(columns(&shape.inverse, local)))
    };
    let (point, normal) = (add(shape.centre, world), facing(outward, leaving));
    Contact {
        point,
        local: Some(local),
        normal,
        class: shape.class,
        leaving,
    }
}

#[inline(always)]
fn to_local<R: Real>(shape: &Shape<R>, v: Vector<R>) -> Vector<R> {
    if shape.kind == BALL {
        scale(v, shape.inverse[0])
    } else {
        rows(&shape.inverse, v)
    }
}

#[inline(always)]
fn plane_normal<R: Real>(shape: &Shape<R>) -> Vector<R> {
    [shape.inverse[0], shape.inverse[1], shape.inverse[2]]
}

/// The outward normal turned to the side that a ray comes from. The kind of crossing decides, not a product that rounding
/// may turn over at grazing incidence.
#[inline(always)]
fn facing<R: Real>(outward: Vector<R>, leaving: bool) -> Vector<R> {
    if leaving { neg(outward) } else { outward }
}
