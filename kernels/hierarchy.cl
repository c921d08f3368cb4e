/* Where a ray crosses the surface of the whole solid, the union of all islands.

   A cursor hands out the islands whose box the ray meets between `from` and `until`, near ones first; its user may lower
   `until` on the way. */

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
/* 1 + 2 gamma(3), rounded up: what the three roundings of a box distance can be worth. */
#define SLACK ((real)1 + (real)8 * ROUNDOFF)

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

/* From outside: a union is entered where the first of its parts is; of two at the same distance the left one owns. */
Hit enter_solid(const Scene *scene, const Ray *ray) {
    Hit nearest = no_hit();
    Cursor cursor = start_cursor(scene, ray, 0, (real)INFINITY);
    for (__global const Island *island = next_island(scene, ray, &cursor); island;
         island = next_island(scene, ray, &cursor)) {
        bool held;
        Hit hit = change(scene, island, ray, 0, cursor.until, false, &held);
        if (hit.leaf != NOTHING &&
            (hit.distance < nearest.distance || (hit.distance == nearest.distance && hit.leaf < nearest.leaf))) {
            cursor.until = hit.distance;
            nearest = hit;
        }
    }
    return nearest;
}

#if INSIDE
/* From inside: a union is left where a point is reached that no part holds. Each round goes to the farthest end among the
   parts that hold the point reached so far. */
Hit leave_solid(const Scene *scene, const Ray *ray) {
    Hit reached = no_hit();
    real at = 0;
    for (;;) {
        Hit farthest = no_hit();
        Cursor cursor = start_cursor(scene, ray, at, at);
        for (__global const Island *island = next_island(scene, ray, &cursor); island;
             island = next_island(scene, ray, &cursor)) {
            bool held;
            Hit hit = change(scene, island, ray, at, (real)INFINITY, true, &held);
            if (!held)
                continue;
            if (hit.leaf == NOTHING)
                return hit;
            if (farthest.leaf == NOTHING || hit.distance > farthest.distance ||
                (hit.distance == farthest.distance && hit.leaf < farthest.leaf))
                farthest = hit;
        }
        if (farthest.leaf != NOTHING) {
            reached = farthest;
        } else if (reached.leaf != NOTHING) {
            return reached;
        } else {
            /* No part holds the start, which lies within rounding of the surface: on to where the solid begins. */
            reached = enter_solid(scene, ray);
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
    return enter_solid(scene, ray);
}

#if LIGHTS
/* Whether the ray crosses the surface before `until`. */
bool blocked(const Scene *scene, const Ray *ray, real until) {
#if INSIDE
    if (ray->inside)
        return leave_solid(scene, ray).distance < until;
#endif
    Cursor cursor = start_cursor(scene, ray, 0, until);
    for (__global const Island *island = next_island(scene, ray, &cursor); island;
         island = next_island(scene, ray, &cursor)) {
        bool held;
        if (change(scene, island, ray, 0, until, false, &held).distance < until)
            return true;
    }
    return false;
}
#endif
