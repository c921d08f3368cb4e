/* What a ray meets of all islands, eight boxes or eight balls at a time: for processors, whose compilers make vectors of
   nothing else.

   A cursor hands out what the ray may meet between `from` and `until`: blocks of balls and runs of islands; its user may
   lower `until` on the way. What is computed of a ball is computed by the very operations that serve for one. */

#if EIGHTS

/* All children of a node but one wait. */
#define EIGHTS_DEPTH (7 * HIERARCHY_DEPTH)
#define CHILD_SHIFT 30
#define CHILD_NODE 0
#define CHILD_BLOCK 1
#define CHILD_INDEX(child) ((child) & ((1u << CHILD_SHIFT) - 1))

/* Three numbers, eight times. */
typedef struct {
    real8 x, y, z;
} Vectors;

typedef struct {
    real from, until;
    Vector inverse;
    /* Where in a node those corners stand that the ray comes to first, by axis. */
    uint near[3];
    bool near_first;
    /* How many of the things that every ray has to try are left, and those of them that wait. */
    uint start, count;
    uint waiting[EIGHTS_DEPTH];
    real entries[EIGHTS_DEPTH];
} Cursor;

/* Entries into the balls of a block: which lanes have one, and how far along the ray. */
typedef struct {
    uint lanes;
    real distance[8];
} Entries;

real8 inner8(Vectors a, Vectors b) { return fma(a.x, b.x, fma(a.y, b.y, a.z * b.z)); }

Vectors scale_add8(Vectors a, real8 by, Vectors b) {
    Vectors v;
    v.x = fma(a.x, by, b.x);
    v.y = fma(a.y, by, b.y);
    v.z = fma(a.z, by, b.z);
    return v;
}

Vectors scale8(Vectors a, real8 by) {
    Vectors v;
    v.x = a.x * by;
    v.y = a.y * by;
    v.z = a.z * by;
    return v;
}

Vectors spread(Vector a) {
    Vectors v;
    v.x = (real8)(a.x);
    v.y = (real8)(a.y);
    v.z = (real8)(a.z);
    return v;
}

/* The lanes in which something holds, one bit each. */
uint lanes_of(int8 holds) {
    int8 bits = holds & (int8)(1, 2, 4, 8, 16, 32, 64, 128);
    int4 four = bits.lo | bits.hi;
    int2 two = four.lo | four.hi;
    return two.x | two.y;
}

/* The lowest of some lanes, of which there is one. */
uint lowest(uint lanes) { return 31 - clz(lanes & -lanes); }

/* No component counts as larger than the largest single, so that no product is 0 times infinity. Boxes are wider than what
   is in them, so that a ray along a face meets nothing there. */
real inverse_of(real component) { return fmin(fmax((real)1 / component, -(real)FLT_MAX), (real)FLT_MAX); }

Cursor start_cursor(const Scene *scene, const Ray *ray, real from, real until, bool near_first) {
    Cursor cursor;
    cursor.from = from;
    cursor.until = until;
    cursor.inverse =
        vector(inverse_of(ray->direction.x), inverse_of(ray->direction.y), inverse_of(ray->direction.z));
    cursor.near[0] = cursor.inverse.x < 0 ? 24 : 0;
    cursor.near[1] = cursor.inverse.y < 0 ? 32 : 8;
    cursor.near[2] = cursor.inverse.z < 0 ? 40 : 16;
    cursor.near_first = near_first;
    cursor.start = 0;
    cursor.count = 0;
    return cursor;
}

real8 slab(__global const float *bounds, uint place, real origin, real inverse) {
    return (to_real8(vload8(0, bounds + place)) - origin) * inverse;
}

/* The child of a node to go on with, if the ray meets any; others wait. */
uint descend(__global const WideNode *node, const Ray *ray, Cursor *cursor) {
    uint x = cursor->near[0], y = cursor->near[1], z = cursor->near[2];
    Vector from = ray->origin, by = cursor->inverse;
    real8 near = max(max(slab(node->bounds, x, from.x, by.x), slab(node->bounds, y, from.y, by.y)),
                     max(slab(node->bounds, z, from.z, by.z), (real8)(cursor->from)));
    real8 far = min(min(slab(node->bounds, 24 - x, from.x, by.x), slab(node->bounds, 40 - y, from.y, by.y)),
                    min(slab(node->bounds, 56 - z, from.z, by.z), (real8)(cursor->until)));
    uint met = lanes_of(convert_int8(near <= far * SLACK));
    if (met == 0)
        return NOTHING;
    uint lane = lowest(met);
    met &= met - 1;
    if (met == 0)
        return node->children[lane];
    real entry[8];
    vstore8(near, 0, entry);
    uint base = cursor->count, child = node->children[lane];
    real first = entry[lane];
    for (; met != 0; met &= met - 1) {
        lane = lowest(met);
        uint other = node->children[lane];
        real distance = entry[lane];
        if (distance < first) {
            /* The nearest so far waits as the last. */
            uint swap = child;
            child = other;
            other = swap;
            real swapped = first;
            first = distance;
            distance = swapped;
        }
        uint at = cursor->count++;
        if (cursor->near_first)
            for (; at > base && cursor->entries[at - 1] < distance; --at) {
                cursor->waiting[at] = cursor->waiting[at - 1];
                cursor->entries[at] = cursor->entries[at - 1];
            }
        cursor->waiting[at] = other;
        cursor->entries[at] = distance;
    }
    return child;
}

/* The next block or run, or NOTHING. */
uint next_child(const Scene *scene, const Ray *ray, Cursor *cursor) {
    for (;;) {
        uint child;
        if (cursor->count > 0) {
            cursor->count -= 1;
            /* `until` may have come nearer since this was put aside. */
            if (cursor->near_first && cursor->entries[cursor->count] > cursor->until * SLACK)
                continue;
            child = cursor->waiting[cursor->count];
        } else {
            if (cursor->start == scene->starts_count)
                return NOTHING;
            child = scene->starts[cursor->start++];
        }
        while (child >> CHILD_SHIFT == CHILD_NODE)
            child = descend(scene->wide + child, ray, cursor);
        if (child != NOTHING)
            return child;
    }
}

uint run_first(const Scene *scene, uint child) { return scene->runs[2 * CHILD_INDEX(child)]; }

uint run_end(const Scene *scene, uint child) { return scene->runs[2 * CHILD_INDEX(child) + 1]; }

Vectors from_centres(__global const Block *block, const Ray *ray) {
    Vectors v;
    v.x = ray->origin.x - vload8(0, block->centre);
    v.y = ray->origin.y - vload8(1, block->centre);
    v.z = ray->origin.z - vload8(2, block->centre);
    return v;
}

/* The balls that the ray's line may meet; none that it does meet is left out. The computed distance to a centre is off across
   the line by a few roundings of itself, and along it by a few of the way to the nearest point: the thousandth in `reach` is
   worth far more than the first, and the square of that way times 2^-34 far more than the second. A NaN is let in. */
uint near_balls(__global const Block *block, const Ray *ray) {
    Vectors start = from_centres(block, ray), direction = spread(ray->direction);
    real8 along = inner8(start, direction);
    Vectors across = scale_add8(direction, -along, start);
    real8 bound = fma(along * along, (real8)(0x1p-34f), vload8(0, block->reach));
    return ~lanes_of(convert_int8(inner8(across, across) > bound)) & block->there;
}

/* The lanes of one class. */
uint of_class(__global const Block *block, uint class) {
    return lanes_of(vload8(0, block->class) == class);
}

/* Where a ray from outside enters balls at a distance of at most `until`: the ball that it starts on is not entered, and one
   that it starts within by rounding is, at 0, if the crossing behind is the nearer one. */
Entries entries_of(__global const Block *block, const Ray *ray, real until) {
    Entries entries;
    entries.lanes = near_balls(block, ray);
    if (entries.lanes == 0)
        return entries;
    /* As the closest approach to one, operation by operation. */
    real8 inverse = vload8(0, block->inverse);
    Vectors start = scale8(from_centres(block, ray), inverse);
    Vectors direction = scale8(spread(ray->direction), inverse);
    real8 square = inner8(direction, direction);
    real8 first = -inner8(start, direction) / square;
    Vectors rough = scale_add8(direction, first, start);
    real8 rest = -inner8(rough, direction) / square;
    Vectors nearest = scale_add8(direction, rest, rough);
    real8 discriminant = fma(-nearest.x, nearest.x, (real8)(1));
    discriminant = fma(-nearest.y, nearest.y, discriminant);
    discriminant = fma(-nearest.z, nearest.z, discriminant);
    real8 distance = first + rest, half_chord = sqrt(discriminant / square);
    real8 enter = distance - half_chord, leave = distance + half_chord;
    truth8 within = enter <= 0 && leave > 0 && -enter < leave;
    truth8 ahead = enter > 0 && enter < leave && enter <= until;
    entries.lanes &= lanes_of(convert_int8(within || ahead));
    if (entries.lanes != 0) {
        entries.lanes &= ~of_class(block, ray->class);
        vstore8(max(enter, (real8)(0)), 0, entries.distance);
    }
    return entries;
}

Hit nearest_entry(const Scene *scene, const Ray *ray) {
    Hit nearest = no_hit();
    Cursor cursor = start_cursor(scene, ray, 0, (real)INFINITY, true);
    for (uint child = next_child(scene, ray, &cursor); child != NOTHING; child = next_child(scene, ray, &cursor)) {
        if (child >> CHILD_SHIFT == CHILD_BLOCK) {
            __global const Block *block = scene->blocks + CHILD_INDEX(child);
            Entries entries = entries_of(block, ray, cursor.until);
            for (; entries.lanes != 0; entries.lanes &= entries.lanes - 1) {
                uint lane = lowest(entries.lanes);
                nearest = nearer(nearest, new_hit(entries.distance[lane], block->leaf[lane], false));
            }
        } else {
            for (uint i = run_first(scene, child); i < run_end(scene, child); ++i)
                nearest = nearer(nearest, entered(scene, scene->islands + i, ray, nearest.distance));
        }
        cursor.until = nearest.distance;
    }
    return nearest;
}

#if INSIDE
Hit farthest_end(const Scene *scene, const Ray *ray, real at) {
    Hit farthest = no_hit();
    Cursor cursor = start_cursor(scene, ray, at, at, false);
    for (uint child = next_child(scene, ray, &cursor); child != NOTHING && !is_endless(farthest);
         child = next_child(scene, ray, &cursor)) {
        if (child >> CHILD_SHIFT == CHILD_BLOCK) {
            __global const Block *block = scene->blocks + CHILD_INDEX(child);
            uint lanes = near_balls(block, ray) | (of_class(block, ray->class) & block->there);
#if TOUCHES
            /* What is known of the light decides there, whatever the numbers say. */
            if (ray->touches != ray->touches_end)
                lanes = block->there;
#endif
            for (; lanes != 0; lanes &= lanes - 1)
                farthest = farther(farthest, left_leaf(scene, block->leaf[lowest(lanes)], ray, at));
        } else {
            for (uint i = run_first(scene, child); i < run_end(scene, child); ++i)
                farthest = farther(farthest, left(scene, scene->islands + i, ray, at));
        }
    }
    return farthest;
}
#endif

#if LIGHTS
/* Whether a ray from outside enters some ball of a block before `until`. */
bool blocks(const Scene *scene, __global const Block *block, const Ray *ray, real until) {
#if TOUCHES
    if (ray->touches != ray->touches_end) {
        for (uint lanes = block->there; lanes != 0; lanes &= lanes - 1)
            if (entered_leaf(scene, block->leaf[lowest(lanes)], ray, until).distance < until)
                return true;
        return false;
    }
#endif
    Entries entries = entries_of(block, ray, until);
    for (; entries.lanes != 0; entries.lanes &= entries.lanes - 1)
        if (entries.distance[lowest(entries.lanes)] < until)
            return true;
    return false;
}

bool entered_before(const Scene *scene, const Ray *ray, real until) {
    Cursor cursor = start_cursor(scene, ray, 0, until, false);
    for (uint child = next_child(scene, ray, &cursor); child != NOTHING; child = next_child(scene, ray, &cursor)) {
        if (child >> CHILD_SHIFT == CHILD_BLOCK) {
            if (blocks(scene, scene->blocks + CHILD_INDEX(child), ray, until))
                return true;
        } else {
            for (uint i = run_first(scene, child); i < run_end(scene, child); ++i)
                if (entered(scene, scene->islands + i, ray, until).distance < until)
                    return true;
        }
    }
    return false;
}
#endif

#endif
