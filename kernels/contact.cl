/* Where rays meet surfaces, and the rays that leave from there. */

/* What rays have met, each in its lane. Lanes that stand idle have what another has, so that nothing is read that was never
   written. */
typedef struct {
    real centre[3][LANES];
#if ELLIPSOIDS
    real inverse[9][LANES], linear[9][LANES];
#else
    real inverse[3][LANES], linear[1][LANES];
#endif
    uint class[LANES];
    /* Sets of lanes. */
    uint balls, flat;
} Shapes;

typedef struct {
    Vector point;
    /* On the unit sphere of a ball or ellipsoid. */
    Vector place;
    /* On the side of the ray. */
    Vector normal;
    uint class[LANES];
    /* Which rays come from within, and which meet a half-space. */
    uint leaving, flat;
} Contacts;

Shapes shapes_at(const Scene *scene, const Hits *hits, uint lanes) {
    Shapes shapes;
    shapes.balls = shapes.flat = 0;
    for (uint lane = 0; lane < LANES; ++lane) {
        uint leaf = hits->leaf[has(lanes, lane) ? lane : first_of(lanes)];
        __global const Shape *shape = scene->shapes + scene->leaves[leaf].shape;
        for (uint i = 0; i < 3; ++i)
            shapes.centre[i][lane] = shape->centre[i];
        for (uint i = 0; i < sizeof(shapes.inverse) / sizeof(shapes.inverse[0]); ++i)
            shapes.inverse[i][lane] = shape->inverse[i];
        for (uint i = 0; i < sizeof(shapes.linear) / sizeof(shapes.linear[0]); ++i)
            shapes.linear[i][lane] = shape->linear[i];
        shapes.class[lane] = shape->class;
        shapes.balls = with(shapes.balls, lane, IS_BALL(shape));
        shapes.flat = with(shapes.flat, lane, IS_HALF_SPACE(shape));
    }
    return shapes;
}

#if ELLIPSOIDS
Vector rows(const real (*m)[LANES], Vector v) {
    return vector(inner(get3(m), v), inner(get3(m + 3), v), inner(get3(m + 6), v));
}

/* Columns times vector: the transpose of the rows. */
Vector columns(const real (*m)[LANES], Vector v) {
    return vector(inner(vector(get(m[0]), get(m[3]), get(m[6])), v), inner(vector(get(m[1]), get(m[4]), get(m[7])), v),
                  inner(vector(get(m[2]), get(m[5]), get(m[8])), v));
}
#endif

/* To the unit spheres of what each ray has met. */
Vector to_each(const Shapes *shapes, Vector v) {
    Vector scaled = scale(v, get(shapes->inverse[0]));
#if ELLIPSOIDS
    if ((shapes->balls | shapes->flat) != ALL_LANES)
        return choose3(shapes->balls, scaled, rows(shapes->inverse, v));
#endif
    return scaled;
}

#if BALLS || ELLIPSOIDS
/* Where rays meet balls and ellipsoids, and which way is out there. */
Vector meet_balls(const Rays *rays, const Shapes *shapes, uint lanes, const real *distance, Contacts *c) {
    uint own = lanes & equal_lanes(rays->class, shapes->class);
    Vector direction = to_each(shapes, get3(rays->direction)), centre = get3(shapes->centre);
    Vector place = get3(rays->place);
    if (own != lanes) {
        Approach a = approach(to_each(shapes, subtract(get3(rays->origin), centre)), direction);
        place = choose3(own, place, scale_add(direction, choose(c->leaving, a.half_chord, -a.half_chord), a.nearest));
    }
    if (own != 0)
        place = choose3(own, scale_add(direction, get(distance), place), place);
    place = unit(place);
    Vector outward = place, world = scale(place, get(shapes->linear[0]));
#if ELLIPSOIDS
    if (lanes & ~shapes->balls) {
        world = choose3(shapes->balls, world, rows(shapes->linear, place));
        outward = choose3(shapes->balls, place, unit(columns(shapes->inverse, place)));
    }
#endif
    c->place = place;
    c->point = add(centre, world);
    return outward;
}
#endif

#if HALF_SPACES
Vector meet_half_spaces(const Rays *rays, const Shapes *shapes, const real *distance, Contacts *c) {
    Vector outward = get3(shapes->inverse);
    Vector point = scale_add(get3(rays->direction), get(distance), get3(rays->origin));
    /* One projection takes the rounding across the plane away. */
    reals off = inner(outward, subtract(point, get3(shapes->centre)));
    c->point = choose3(shapes->flat, scale_add(outward, -off, point), c->point);
    return outward;
}
#endif

/* Where rays meet surfaces, on their ways in or out; the normal is turned to the ray's side by the kind of crossing, not by a
   product that rounding may turn over. */
Contacts contacts_of(const Scene *scene, const Rays *rays, const Hits *hits, uint lanes) {
    Shapes shapes = shapes_at(scene, hits, lanes);
    Contacts c;
    for (uint lane = 0; lane < LANES; ++lane)
        c.class[lane] = shapes.class[lane];
    c.leaving = hits->leaving;
    c.flat = shapes.flat;
    Vector outward = vector(spread((real)0), spread((real)0), spread((real)0));
    c.point = c.place = outward;
#if BALLS || ELLIPSOIDS
    if (lanes & ~shapes.flat)
        outward = meet_balls(rays, &shapes, lanes & ~shapes.flat, hits->distance, &c);
#endif
#if HALF_SPACES
    if (lanes & shapes.flat)
        outward = choose3(shapes.flat, meet_half_spaces(rays, &shapes, hits->distance, &c), outward);
#endif
    c.normal = choose3(c.leaving, negated(outward), outward);
    return c;
}

/* The rays that leave contacts in these directions, `behind` the surfaces or on the side of the rays that came. */
Rays rays_from(const Contacts *contacts, Vector direction, bool behind, uint inside) {
    Rays rays;
    put3(contacts->point, rays.origin);
    put3(direction, rays.direction);
    Vector side = behind ? negated(contacts->normal) : contacts->normal;
    put3(choose3(contacts->flat, side, contacts->place), rays.place);
    for (uint lane = 0; lane < LANES; ++lane)
        rays.class[lane] = contacts->class[lane];
    rays.into = behind ? ~contacts->leaving : contacts->leaving;
    rays.inside = inside;
    without_end(&rays);
    return rays;
}
