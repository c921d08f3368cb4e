/* Where rays run inside a surface's solid: one interval each, since balls, ellipsoids and half-spaces are convex; and where
   they meet surfaces. */

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

/* Of a lane nothing if `enter` is not below `leave`. */
typedef struct {
    reals enter, leave;
} Intervals;

typedef struct {
    Vector direction, nearest;
    reals distance, half_chord;
} Approach;

Intervals intervals(reals enter, reals leave) {
    Intervals i;
    i.enter = enter;
    i.leave = leave;
    return i;
}

Intervals choose_intervals(uint set, Intervals in, Intervals out) {
    return intervals(choose(set, in.enter, out.enter), choose(set, in.leave, out.leave));
}

/* A row times a vector. */
reals row(__global const real *m, Vector v) { return inner(load(m), v); }

Vector to_local(__global const Shape *shape, Vector v) {
    if (IS_BALL(shape))
        return scale(v, spread(shape->inverse[0]));
    return vector(row(shape->inverse, v), row(shape->inverse + 3, v), row(shape->inverse + 6, v));
}

/* Closest approach of a line to the unit sphere's centre with one residual step: nothing large cancels in 1 - |nearest|^2, and
   the step takes away the rounding of the first projection. A miss gives a NaN, whose interval holds no number. */
Approach approach(Vector start, Vector direction) {
    Approach a;
    a.direction = direction;
    reals square = inner(direction, direction);
    reals first = -inner(start, direction) / square;
    Vector rough = scale_add(direction, first, start);
    reals rest = -inner(rough, direction) / square;
    a.nearest = scale_add(direction, rest, rough);
    reals discriminant = fma(-a.nearest.x, a.nearest.x, spread((real)1));
    discriminant = fma(-a.nearest.y, a.nearest.y, discriminant);
    discriminant = fma(-a.nearest.z, a.nearest.z, discriminant);
    a.distance = first + rest;
    a.half_chord = sqrt(discriminant / square);
    return a;
}

Intervals chord(const Approach *a) { return intervals(a->distance - a->half_chord, a->distance + a->half_chord); }

#if TOUCHES
/* Whether the rays' end lies on a surface, and where. */
__global const Touch *touch_of(__global const Shape *shape, const Rays *rays) {
    for (__global const Touch *touch = rays->touches; touch != rays->touches_end; ++touch)
        if (touch->class == shape->class)
            return touch;
    return 0;
}
#endif

/* From a point p of the unit sphere along d: the other root of |p + t d| = 1, given p.d. */
reals other_root(reals towards, Vector direction) { return -(towards + towards) / inner(direction, direction); }

#if HALF_SPACES
Intervals half_space_intervals(__global const Shape *shape, const Rays *rays, uint own) {
    Vector normal = load(shape->inverse), direction = get3(rays->direction);
    reals zero = spread((real)0), ever = spread((real)INFINITY);
    reals above = inner(normal, subtract(get3(rays->origin), load(shape->centre)));
    uint below = set_of(above <= zero), ahead, along = 0;
    reals crossed;
#if TOUCHES
    if (touch_of(shape, rays)) {
        ahead = below;
        crossed = get(rays->end);
    } else
#endif
    {
        reals towards = inner(normal, direction);
        /* Three products and two sums: below this size the sign of `towards` is rounding. */
        reals terms = fabs(normal.x * direction.x) + fabs(normal.y * direction.y) + fabs(normal.z * direction.z);
        along = set_of(fabs(towards) <= (real)3 * ROUNDOFF * terms);
        ahead = set_of(towards > zero);
        crossed = -above / towards;
    }
    Intervals result = intervals(choose(ahead, -ever, crossed), choose(ahead, crossed, ever));
    if (along != 0)
        result = choose_intervals(along, choose_intervals(below, intervals(-ever, ever), intervals(ever, -ever)), result);
    if (own != 0) {
        /* Of one class are this plane's half-spaces on either side, so the product is 1 or -1. */
        uint outside = set_of(inner(normal, get3(rays->place)) >= zero);
        result = choose_intervals(own, choose_intervals(outside, intervals(-ever, zero), intervals(zero, ever)), result);
    }
    return result;
}
#endif

/* Where rays run inside a shape. */
Intervals shape_intervals(__global const Shape *shape, const Rays *rays) {
    uint own = equal(rays->class, shape->class);
#if HALF_SPACES
    if (IS_HALF_SPACE(shape))
        return half_space_intervals(shape, rays, own);
#endif
    Vector direction = to_local(shape, get3(rays->direction));
    reals zero = spread((real)0);
    Intervals result = intervals(zero, zero);
#if TOUCHES
    __global const Touch *touch = touch_of(shape, rays);
    reals end = get(rays->end);
    if (touch) {
        /* Deflation, from the other end. */
        reals other = end + other_root(inner(load(touch->local_point), direction), direction);
        result = intervals(fmin(other, end), fmax(other, end));
    } else
#endif
    if (own != ALL_LANES) {
        Approach a = approach(to_local(shape, subtract(get3(rays->origin), load(shape->centre))), direction);
        result = chord(&a);
    }
    if (own != 0) {
        /* Deflation: the start lies on this sphere, so its roots are exactly 0 and -2 (p.d)/(d.d). */
        reals other = other_root(inner(get3(rays->place), direction), direction);
#if TOUCHES
        if (touch)
            other = end;
#endif
        Intervals known = intervals(zero, choose(rays->into, other, zero));
        result = own == ALL_LANES ? known : choose_intervals(own, known, result);
    }
    return result;
}

Intervals leaf_intervals(const Scene *scene, uint leaf, const Rays *rays) {
    return shape_intervals(scene->shapes + scene->leaves[leaf].shape, rays);
}
