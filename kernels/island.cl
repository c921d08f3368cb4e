/* Where a ray enters or leaves one island. Most are one leaf, for which the way through `event.cl` is a short one. */

/* The leaf of an island that is nothing else, as most islands are; NOTHING for others. A complement stands under an operation
   of its own. */
uint lone(const Scene *scene, __global const Island *island) {
#if COMPOUND
    if (island->program_end - island->program != 1 || scene->program[island->program] != 0)
        return NOTHING;
#endif
    return scene->members[island->members];
}

Interval leaf_interval(const Scene *scene, uint leaf, const Ray *ray) {
    return shape_interval(scene->shapes + scene->leaves[leaf].shape, ray);
}

/* The first entry into a leaf after the start of a ray from outside, and not after `until`. */
Hit entered_leaf(const Scene *scene, uint leaf, const Ray *ray, real until) {
    Interval i = leaf_interval(scene, leaf, ray);
    if (i.enter <= 0) {
        /* The ray starts within, by rounding: see `crease`. */
        bool blocked =
            0 < i.leave && -i.enter < i.leave && ray->class != scene->shapes[scene->leaves[leaf].shape].class;
        return blocked ? new_hit(0, leaf, false) : no_hit();
    }
    return i.enter < i.leave && i.enter <= until ? new_hit(i.enter, leaf, false) : no_hit();
}

/* The same of an island. */
Hit entered(const Scene *scene, __global const Island *island, const Ray *ray, real until) {
    uint leaf = lone(scene, island);
#if COMPOUND
    bool held;
    if (leaf == NOTHING)
        return change(scene, island, ray, 0, until, false, &held);
#endif
    return entered_leaf(scene, leaf, ray, until);
}

#if INSIDE
/* Where a ray leaves a leaf that holds it at `from`, perhaps infinitely far; nothing if the leaf does not. */
Hit left_leaf(const Scene *scene, uint leaf, const Ray *ray, real from) {
    Interval i = leaf_interval(scene, leaf, ray);
    return i.enter <= from && from < i.leave ? new_hit(i.leave, leaf, true) : no_hit();
}

/* The same of an island. */
Hit left(const Scene *scene, __global const Island *island, const Ray *ray, real from) {
    uint leaf = lone(scene, island);
#if COMPOUND
    if (leaf == NOTHING) {
        bool held;
        Hit hit = change(scene, island, ray, from, (real)INFINITY, true, &held);
        return held && hit.leaf == NOTHING ? new_hit((real)INFINITY, scene->members[island->members], true) : hit;
    }
#endif
    return left_leaf(scene, leaf, ray, from);
}
#endif

/* The nearer of what was found first and what is found next; of two at the same distance the left one owns. */
Hit nearer(Hit best, Hit hit) {
    bool better = hit.distance < best.distance || (hit.distance == best.distance && hit.leaf < best.leaf);
    return hit.leaf != NOTHING && better ? hit : best;
}

#if INSIDE
/* The farther of two ends, of which the first may be none. */
Hit farther(Hit best, Hit hit) {
    bool better = best.leaf == NOTHING || hit.distance > best.distance ||
                  (hit.distance == best.distance && hit.leaf < best.leaf);
    return hit.leaf != NOTHING && better ? hit : best;
}

/* Whether a part that holds the ray has no end, so that no other matters. */
bool is_endless(Hit hit) { return hit.leaf != NOTHING && isinf(hit.distance); }
#endif
