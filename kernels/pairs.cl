/* What a ray meets of all islands, one at a time.

   A cursor hands out the islands whose box the ray meets between `from` and `until`, near ones first; its user may lower
   `until` on the way. */

#if !EIGHTS

typedef struct {
    real from, until;
    uint index, end;
#if HIERARCHY
    Vector inverse;
    uint count;
    uint node;
    real entry;
    uint waiting[HIERARCHY_DEPTH];
    real entries[HIERARCHY_DEPTH];
#endif
} Cursor;

#if HIERARCHY
/* Where the ray enters the node's box, or NaN. fmin and fmax pass over the NaN of a zero component on the box's face. */
real meets(__global const Node *node, const Ray *ray, const Cursor *cursor) {
    real low = ((real)node->low[0] - ray->origin.x) * cursor->inverse.x;
    real high = ((real)node->high[0] - ray->origin.x) * cursor->inverse.x;
    real near = fmin(low, high), far = fmax(low, high);
    low = ((real)node->low[1] - ray->origin.y) * cursor->inverse.y;
    high = ((real)node->high[1] - ray->origin.y) * cursor->inverse.y;
    near = fmax(near, fmin(low, high));
    far = fmin(far, fmax(low, high));
    low = ((real)node->low[2] - ray->origin.z) * cursor->inverse.z;
    high = ((real)node->high[2] - ray->origin.z) * cursor->inverse.z;
    near = fmax(near, fmin(low, high));
    far = fmin(far, fmax(low, high)) * SLACK;
    return near <= far && near <= cursor->until * SLACK && far >= cursor->from ? near : (real)NAN;
}
#endif

Cursor start_cursor(const Scene *scene, const Ray *ray, real from, real until) {
    Cursor cursor;
    cursor.from = from;
    cursor.until = until;
    cursor.index = 0;
    cursor.end = scene->frame->linear;
#if HIERARCHY
    cursor.inverse = vector((real)1 / ray->direction.x, (real)1 / ray->direction.y, (real)1 / ray->direction.z);
    cursor.count = 0;
    if (scene->frame->nodes > 0) {
        real entry = meets(scene->nodes, ray, &cursor);
        if (!isnan(entry)) {
            cursor.waiting[0] = 0;
            cursor.entries[0] = entry;
            cursor.count = 1;
        }
    }
#endif
    return cursor;
}

/* The next island, or 0. */
__global const Island *next_island(const Scene *scene, const Ray *ray, Cursor *cursor) {
#if HIERARCHY
    while (cursor->index == cursor->end) {
        if (cursor->count == 0)
            return 0;
        cursor->count -= 1;
        /* `until` may have come nearer since the node was put aside. */
        if (!(cursor->entries[cursor->count] <= cursor->until * SLACK))
            continue;
        __global const Node *node = scene->nodes + cursor->waiting[cursor->count];
        while (node->count == 0) {
            uint a = node->first, b = a + 1;
            real entry_a = meets(scene->nodes + a, ray, cursor), entry_b = meets(scene->nodes + b, ray, cursor);
            bool meets_a = !isnan(entry_a), meets_b = !isnan(entry_b);
            if (!meets_a && !meets_b)
                break;
            bool b_first = meets_b && (!meets_a || entry_b < entry_a);
            if (meets_a && meets_b) {
                cursor->waiting[cursor->count] = b_first ? a : b;
                cursor->entries[cursor->count] = b_first ? entry_a : entry_b;
                cursor->count += 1;
            }
            node = scene->nodes + (b_first ? b : a);
        }
        if (node->count > 0) {
            cursor->index = node->first;
            cursor->end = node->first + node->count;
        }
    }
#else
    if (cursor->index == cursor->end)
        return 0;
#endif
    return scene->islands + cursor->index++;
}

Hit nearest_entry(const Scene *scene, const Ray *ray) {
    Hit nearest = no_hit();
    Cursor cursor = start_cursor(scene, ray, 0, (real)INFINITY);
    for (__global const Island *island = next_island(scene, ray, &cursor); island;
         island = next_island(scene, ray, &cursor)) {
        nearest = nearer(nearest, entered(scene, island, ray, cursor.until));
        cursor.until = nearest.distance;
    }
    return nearest;
}

#if INSIDE
Hit farthest_end(const Scene *scene, const Ray *ray, real at) {
    Hit farthest = no_hit();
    Cursor cursor = start_cursor(scene, ray, at, at);
    for (__global const Island *island = next_island(scene, ray, &cursor); island && !is_endless(farthest);
         island = next_island(scene, ray, &cursor))
        farthest = farther(farthest, left(scene, island, ray, at));
    return farthest;
}
#endif

#if LIGHTS
bool entered_before(const Scene *scene, const Ray *ray, real until) {
    Cursor cursor = start_cursor(scene, ray, 0, until);
    for (__global const Island *island = next_island(scene, ray, &cursor); island;
         island = next_island(scene, ray, &cursor))
        if (entered(scene, island, ray, until).distance < until)
            return true;
    return false;
}
#endif

#endif
