/* Where a ray runs inside a surface's solid: one interval, since balls, ellipsoids and half-spaces are convex. */

#define KIND_BALL 0
#define KIND_HALF_SPACE 2

#if !HALF_SPACES
#define IS_HALF_SPACE(shape) false
#elif !BALLS && !ELLIPSOIDS
#define IS_HALF_SPACE(shape) true
#else
#define IS_HALF_SPACE(shape) ((shape)->kind == KIND_HALF_SPACE)
#endif

#if !BALLS
#define IS_BALL(shape) false
#elif !ELLIPSOIDS
#define IS_BALL(shape) true
#else
#define IS_BALL(shape) ((shape)->kind == KIND_BALL)
#endif

/* Nothing if `enter` is not below `leave`. */
typedef struct {
    real enter, leave;
} Interval;

typedef struct {
    Vector direction, nearest;
    real distance, half_chord;
} Approach;

typedef struct {
    Vector point, place, normal;
    uint class;
    /* Whether the ray comes from within the shape's solid, and whether that is a half-space. */
    bool leaving, flat;
} Contact;

Interval interval(real enter, real leave) {
    Interval i;
    i.enter = enter;
    i.leave = leave;
    return i;
}

Vector to_local(__global const Shape *shape, Vector v) {
    return IS_BALL(shape) ? scale(v, shape->inverse[0]) : rows(shape->inverse, v);
}

/* Closest approach with one residual step: nothing large cancels in 1 - |nearest|^2, and the step takes away the rounding
   of the first projection. A miss gives a NaN, whose interval holds no number. */
Approach approach(__global const Shape *shape, const Ray *ray) {
    Approach a;
    Vector start = to_local(shape, subtract(ray->origin, load(shape->centre)));
    a.direction = to_local(shape, ray->direction);
    real square = inner(a.direction, a.direction);
    real first = -inner(start, a.direction) / square;
    Vector rough = scale_add(a.direction, first, start);
    real rest = -inner(rough, a.direction) / square;
    a.nearest = scale_add(a.direction, rest, rough);
    real discriminant = fma(-a.nearest.x, a.nearest.x, (real)1);
    discriminant = fma(-a.nearest.y, a.nearest.y, discriminant);
    discriminant = fma(-a.nearest.z, a.nearest.z, discriminant);
    a.distance = first + rest;
    a.half_chord = sqrt(discriminant / square);
    return a;
}

#if TOUCHES
/* Whether the ray's end lies on the surface, and where. */
__global const Touch *touch_of(__global const Shape *shape, const Ray *ray) {
    for (__global const Touch *touch = ray->touches; touch != ray->touches_end; ++touch)
        if (touch->class == shape->class)
            return touch;
    return 0;
}
#endif

/* From a point p of the unit sphere along d: the other root of |p + t d| = 1, given p.d. */
real other_root(real towards, Vector direction) { return -(towards + towards) / inner(direction, direction); }

Interval half_space_interval(__global const Shape *shape, const Ray *ray) {
    Vector normal = load(shape->inverse);
    /* Of one class are this plane's half-spaces on either side, so the product is 1 or -1. */
    if (shape->class == ray->class)
        return inner(normal, ray->place) >= 0 ? interval(-(real)INFINITY, 0) : interval(0, (real)INFINITY);
    real towards = inner(normal, ray->direction);
    real above = inner(normal, subtract(ray->origin, load(shape->centre)));
#if TOUCHES
    if (touch_of(shape, ray))
        return above <= 0 ? interval(-(real)INFINITY, ray->end) : interval(ray->end, (real)INFINITY);
#endif
    /* Three products and two sums: below this size the sign of `towards` is rounding. */
    real terms =
        fabs(normal.x * ray->direction.x) + fabs(normal.y * ray->direction.y) + fabs(normal.z * ray->direction.z);
    if (fabs(towards) <= (real)3 * ROUNDOFF * terms)
        return above <= 0 ? interval(-(real)INFINITY, (real)INFINITY) : interval((real)INFINITY, -(real)INFINITY);
    real distance = -above / towards;
    return towards > 0 ? interval(-(real)INFINITY, distance) : interval(distance, (real)INFINITY);
}

Interval shape_interval(__global const Shape *shape, const Ray *ray) {
    if (IS_HALF_SPACE(shape))
        return half_space_interval(shape, ray);
    if (shape->class == ray->class) {
        /* Deflation: the start lies on this sphere, so its roots are exactly 0 and -2 (p.d)/(d.d). */
        if (!ray->into)
            return interval(0, 0);
#if TOUCHES
        if (touch_of(shape, ray))
            return interval(0, ray->end);
#endif
        Vector direction = to_local(shape, ray->direction);
        return interval(0, other_root(inner(ray->place, direction), direction));
    }
#if TOUCHES
    __global const Touch *touch = touch_of(shape, ray);
    if (touch) {
        /* The same from the other end. */
        Vector direction = to_local(shape, ray->direction);
        real other = ray->end + other_root(inner(load(touch->local_point), direction), direction);
        return interval(fmin(other, ray->end), fmax(other, ray->end));
    }
#endif
    Approach a = approach(shape, ray);
    return interval(a.distance - a.half_chord, a.distance + a.half_chord);
}

/* Where the ray meets the surface at `distance`, on its way in or out; the normal is turned to the ray's side by the kind
   of crossing, not by a product that rounding may turn over. */
Contact contact(__global const Shape *shape, const Ray *ray, real distance, bool leaving) {
    Contact c;
    c.class = shape->class;
    c.leaving = leaving;
    c.flat = IS_HALF_SPACE(shape);
    if (IS_HALF_SPACE(shape)) {
        Vector outward = load(shape->inverse);
        Vector point = scale_add(ray->direction, distance, ray->origin);
        /* One projection takes the rounding across the plane away. */
        real off = inner(outward, subtract(point, load(shape->centre)));
        c.point = scale_add(outward, -off, point);
        c.place = vector(0, 0, 0);
        c.normal = leaving ? negated(outward) : outward;
        return c;
    }
    if (shape->class == ray->class) {
        c.place = scale_add(to_local(shape, ray->direction), distance, ray->place);
    } else {
        Approach a = approach(shape, ray);
        c.place = scale_add(a.direction, leaving ? a.half_chord : -a.half_chord, a.nearest);
    }
    c.place = unit(c.place);
    Vector outward = c.place;
    Vector world;
    if (IS_BALL(shape)) {
        world = scale(c.place, shape->linear[0]);
    } else {
        world = rows(shape->linear, c.place);
        outward = unit(columns(shape->inverse, c.place));
    }
    c.point = add(load(shape->centre), world);
    c.normal = leaving ? negated(outward) : outward;
    return c;
}

/* The ray that leaves a contact in this direction, `behind` the surface or on the side of the one that came. */
Ray ray_from(const Contact *contact, Vector direction, bool behind, bool inside) {
    Ray ray;
    ray.origin = contact->point;
    ray.direction = direction;
    ray.place = contact->place;
    if (contact->flat)
        ray.place = behind ? negated(contact->normal) : contact->normal;
    ray.class = contact->class;
    ray.into = contact->leaving != behind;
    ray.inside = inside;
#if TOUCHES
    ray.end = (real)INFINITY;
    ray.touches = ray.touches_end = 0;
#endif
    return ray;
}
