/* Where a ray crosses the surface of the whole solid, the union of all islands: from outside, a union is entered where the first
   of its parts is. */

#if INSIDE
/* From inside: a union is left where a point is reached that no part holds. Each round goes to the farthest end among the
   parts that hold the point reached so far. */
Hit leave_solid(const Scene *scene, const Ray *ray) {
    Hit reached = no_hit();
    real at = 0;
    for (;;) {
        Hit farthest = farthest_end(scene, ray, at);
        if (is_endless(farthest))
            return no_hit();
        if (farthest.leaf != NOTHING) {
            reached = farthest;
        } else if (reached.leaf != NOTHING) {
            return reached;
        } else {
            /* No part holds the start, which lies within rounding of the surface: on to where the solid begins. */
            reached = nearest_entry(scene, ray);
            if (reached.leaf == NOTHING)
                return reached;
        }
        at = reached.distance;
    }
}
#endif

/* The first crossing of the solid's surface. */
Hit first_crossing(const Scene *scene, const Ray *ray) {
#if INSIDE
    if (ray->inside)
        return leave_solid(scene, ray);
#endif
    return nearest_entry(scene, ray);
}

#if LIGHTS
/* Whether the ray crosses the surface before `until`. */
bool blocked(const Scene *scene, const Ray *ray, real until) {
#if INSIDE
    if (ray->inside)
        return leave_solid(scene, ray).distance < until;
#endif
    return entered_before(scene, ray, until);
}
#endif
