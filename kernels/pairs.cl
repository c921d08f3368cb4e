/* The way of one ray to the islands that it may meet, through a hierarchy of pairs of boxes. */

#if !EIGHTS

#if HIERARCHY
/* Where the ray enters the node's box, or NaN. fmin and fmax pass over the NaN of a zero component on the box's face. */
real meets(__global const Node *node, const Rays *rays, const real *inverse, const Search *search) {
    real near = -(real)INFINITY, far = (real)INFINITY;
    for (uint axis = 0; axis < 3; ++axis) {
        real low = ((real)node->low[axis] - rays->origin[axis][0]) * inverse[axis];
        real high = ((real)node->high[axis] - rays->origin[axis][0]) * inverse[axis];
        near = fmax(near, fmin(low, high));
        far = fmin(far, fmax(low, high));
    }
    far *= SLACK;
    return near <= far && near <= search->until[0] * SLACK && far >= search->from[0] ? near : (real)NAN;
}

/* Goes through the hierarchy, near things first. */
void descend(const Scene *scene, const Rays *rays, Search *search) {
    if (scene->frame->nodes == 0)
        return;
    real inverse[3];
    for (uint axis = 0; axis < 3; ++axis)
        inverse[axis] = (real)1 / rays->direction[axis][0];
    uint waiting[HIERARCHY_DEPTH];
    real entries[HIERARCHY_DEPTH];
    waiting[0] = 0;
    entries[0] = meets(scene->nodes, rays, inverse, search);
    for (uint count = 1; count > 0 && search->open != 0;) {
        count -= 1;
        /* `until` may have come nearer since the node was put aside. */
        if (!(entries[count] <= search->until[0] * SLACK))
            continue;
        __global const Node *node = scene->nodes + waiting[count];
        while (node->count == 0) {
            uint a = node->first, b = a + 1;
            real entry_a = meets(scene->nodes + a, rays, inverse, search);
            real entry_b = meets(scene->nodes + b, rays, inverse, search);
            bool meets_a = !isnan(entry_a), meets_b = !isnan(entry_b);
            if (!meets_a && !meets_b)
                break;
            bool b_first = meets_b && (!meets_a || entry_b < entry_a);
            if (meets_a && meets_b) {
                waiting[count] = b_first ? a : b;
                entries[count] = b_first ? entry_a : entry_b;
                count += 1;
            }
            node = scene->nodes + (b_first ? b : a);
        }
        for (uint i = 0; i < node->count && search->open != 0; ++i)
            show_island(scene, rays, 1, scene->islands + node->first + i, search);
    }
}
#endif

/* Looks through all that the ray may meet. */
void seek(const Scene *scene, const Rays *rays, Search *search) {
    for (uint i = 0; i < scene->frame->linear && search->open != 0; ++i)
        show_island(scene, rays, 1, scene->islands + i, search);
#if HIERARCHY
    if (search->open != 0)
        descend(scene, rays, search);
#endif
}

#endif
