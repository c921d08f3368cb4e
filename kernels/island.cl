/* What islands have of what is looked for. Most are one leaf, for which the way through `event.cl` is a short one. */

/* Which rays from outside enter at a distance of at most `until`; one that starts within by rounding does at 0, if the
   crossing behind is the nearer one. */
uint entering(Intervals i, reals until) {
    reals zero = spread((real)0);
    uint within = set_of(i.enter <= zero) & set_of(i.leave > zero) & set_of(-i.enter < i.leave);
    uint ahead = set_of(i.enter > zero) & set_of(i.enter < i.leave) & set_of(i.enter <= until);
    return within | ahead;
}

/* Shows a leaf to some rays: they don't enter what they start on. */
void show_leaf(const Scene *scene, const Rays *rays, uint lanes, uint leaf, Search *search) {
    Intervals i = leaf_intervals(scene, leaf, rays);
    bool leaving = search->sought == LAST_END;
    real distance[LANES];
    if (leaving) {
        reals at = get(search->from);
        lanes &= set_of(i.enter <= at) & set_of(at < i.leave);
        put(i.leave, distance);
    } else {
        lanes &= entering(i, get(search->until)) & ~equal(rays->class, scene->shapes[scene->leaves[leaf].shape].class);
        put(fmax(i.enter, spread((real)0)), distance);
    }
    for (; lanes != 0; lanes = rest_of(lanes)) {
        uint lane = first_of(lanes);
        keep_hit(search, lane, new_hit(distance[lane], leaf, leaving));
    }
}

/* The leaf of an island that is nothing else, as most islands are; NOTHING for others. A complement stands under an operation
   of its own. */
uint lone(const Scene *scene, __global const Island *island) {
#if COMPOUND
    if (island->program_end - island->program != 1 || scene->program[island->program] != 0)
        return NOTHING;
#endif
    return scene->members[island->members];
}

/* Shows an island to some rays. */
void show_island(const Scene *scene, const Rays *rays, uint lanes, __global const Island *island, Search *search) {
    uint leaf = lone(scene, island);
#if COMPOUND
    if (leaf == NOTHING) {
#if CELLS
        uint divided = island->cells == NOTHING ? 0 : lanes & ~far_away(rays);
        if (divided != 0)
            change_in_cells(scene, island, rays, divided, search);
        lanes &= ~divided;
#endif
        if (lanes != 0)
            change(scene, island, rays, lanes, search);
        return;
    }
#endif
    show_leaf(scene, rays, lanes, leaf, search);
}
