/* Where rays cross the surface of the whole solid, the union of all islands: from outside, a union is entered where the first
   of its parts is. */

void nearest_entries(const Scene *scene, const Rays *rays, uint lanes, Hits *hits) {
    Search search;
    start_search(&search, FIRST_ENTRY, lanes, spread((real)INFINITY));
    seek(scene, rays, &search);
    *hits = search.hits;
}

#if INSIDE
/* From inside: a union is left where a point is reached that no part holds. Each round goes to the farthest end among the
   parts that hold the point reached so far. */
void leave_solid(const Scene *scene, const Rays *rays, uint lanes, Hits *hits) {
    real at[LANES];
    put(spread((real)0), at);
    no_hits(hits);
    for (uint open = lanes; open != 0;) {
        Search search;
        start_search(&search, LAST_END, open, get(at));
        seek(scene, rays, &search);
        Hits reached = search.hits;
        /* No part holds the start, which lies within rounding of the surface: on to where the solid begins. */
        uint astray = open & ~met_by(&reached) & ~met_by(hits);
        if (astray != 0) {
            Hits entered;
            nearest_entries(scene, rays, astray, &entered);
            for (uint set = astray & met_by(&entered); set != 0; set = rest_of(set))
                put_hit(&reached, first_of(set), hit_of(&entered, first_of(set)));
        }
        /* Those are out that were in a part and are in none now. */
        open &= met_by(&reached);
        for (uint set = open; set != 0; set = rest_of(set)) {
            uint lane = first_of(set);
            bool endless = isinf(reached.distance[lane]);
            put_hit(hits, lane, endless ? no_hit() : hit_of(&reached, lane));
            at[lane] = reached.distance[lane];
            open = with(open, lane, !endless);
        }
    }
}
#endif

/* The first crossings of the solid's surface. */
void first_crossings(const Scene *scene, const Rays *rays, uint lanes, Hits *hits) {
#if INSIDE
    uint inside = lanes & rays->inside;
    if (lanes == inside) {
        leave_solid(scene, rays, lanes, hits);
        return;
    }
    nearest_entries(scene, rays, lanes & ~inside, hits);
    if (inside != 0) {
        Hits left;
        leave_solid(scene, rays, inside, &left);
        for (; inside != 0; inside = rest_of(inside))
            put_hit(hits, first_of(inside), hit_of(&left, first_of(inside)));
    }
#else
    nearest_entries(scene, rays, lanes, hits);
#endif
}

#if LIGHTS
/* Which rays cross the surface before their ends. */
uint blocked(const Scene *scene, const Rays *rays, uint lanes, reals ends) {
    uint found = 0;
#if INSIDE
    uint inside = lanes & rays->inside;
    if (inside != 0) {
        Hits left;
        leave_solid(scene, rays, inside, &left);
        found = inside & set_of(get(left.distance) < ends);
        lanes &= ~inside;
        if (lanes == 0)
            return found;
    }
#endif
    Search search;
    start_search(&search, ANY_ENTRY, lanes, ends);
    seek(scene, rays, &search);
    return found | (lanes & ~search.open);
}
#endif
