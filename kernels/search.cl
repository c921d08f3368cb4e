/* Crossings, and what is looked for along rays. */

/* A crossing, or nothing if `leaf` is NOTHING. `leaving` tells of the leaf, not of the solid. */
typedef struct {
    real distance;
    uint leaf;
    bool leaving;
} Hit;

Hit new_hit(real distance, uint leaf, bool leaving) {
    Hit hit;
    hit.distance = distance;
    hit.leaf = leaf;
    hit.leaving = leaving;
    return hit;
}

Hit no_hit(void) { return new_hit((real)INFINITY, NOTHING, false); }

/* Where rays from outside first enter something; whether they enter anything before a distance; where that which holds them at
   a distance ends last. */
#define FIRST_ENTRY 0
#define ANY_ENTRY 1
#define LAST_END 2

/* A crossing of every lane, or nothing where `leaf` is NOTHING. */
typedef struct {
    real distance[LANES];
    uint leaf[LANES];
    uint leaving;
} Hits;

typedef struct {
    uint sought;
    /* The rays that still ask. */
    uint open;
    /* Between these distances things matter. */
    real from[LANES], until[LANES];
    Hits hits;
} Search;

void no_hits(Hits *hits) {
    for (uint lane = 0; lane < LANES; ++lane) {
        hits->distance[lane] = (real)INFINITY;
        hits->leaf[lane] = NOTHING;
    }
    hits->leaving = 0;
}

Hit hit_of(const Hits *hits, uint lane) {
    return new_hit(hits->distance[lane], hits->leaf[lane], has(hits->leaving, lane));
}

void put_hit(Hits *hits, uint lane, Hit hit) {
    hits->distance[lane] = hit.distance;
    hits->leaf[lane] = hit.leaf;
    hits->leaving = with(hits->leaving, lane, hit.leaving);
}

/* The lanes that have one. */
uint met_by(const Hits *hits) { return ALL_LANES & ~equal(hits->leaf, NOTHING); }

void start_search(Search *search, uint sought, uint lanes, reals at) {
    search->sought = sought;
    search->open = lanes;
    put(sought == LAST_END ? at : spread((real)0), search->from);
    put(at, search->until);
    no_hits(&search->hits);
}

/* The nearer of what was found first and what is found next; of two at the same distance the left one owns. */
Hit nearer(Hit best, Hit hit) {
    bool better = hit.distance < best.distance || (hit.distance == best.distance && hit.leaf < best.leaf);
    return better ? hit : best;
}

/* The farther of two ends, of which the first may be none. */
Hit farther(Hit best, Hit hit) {
    bool better = best.leaf == NOTHING || hit.distance > best.distance ||
                  (hit.distance == best.distance && hit.leaf < best.leaf);
    return better ? hit : best;
}

/* Tells of a crossing of one ray. */
void keep_hit(Search *search, uint lane, Hit hit) {
    if (search->sought == ANY_ENTRY) {
        if (hit.distance < search->until[lane])
            search->open = with(search->open, lane, false);
        return;
    }
    Hit best = hit_of(&search->hits, lane);
    if (search->sought == FIRST_ENTRY) {
        best = nearer(best, hit);
        search->until[lane] = best.distance;
    } else {
        best = farther(best, hit);
        /* What has no end ends last. */
        if (isinf(best.distance))
            search->open = with(search->open, lane, false);
    }
    put_hit(&search->hits, lane, best);
}
