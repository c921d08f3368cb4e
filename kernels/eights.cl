/* The way of eight rays to the islands that they may meet, through a hierarchy of eight boxes to a node and eight balls to a
   block. A node or block is read once for all rays that reach it. */

#if EIGHTS

/* On each level of the hierarchy all children of a node but one wait, and for a moment that one too. */
#define EIGHTS_DEPTH (7 * HIERARCHY_DEPTH + 1)
#define CHILD_INDEX(child) ((child) & ((1u << CHILD_SHIFT) - 1))

/* A child and the rays that are to go there; none of them enters it before `entry`. */
typedef struct {
    uint child, lanes;
    real entry;
} Step;

/* A ball and a ray in every lane: one ray and the balls of a block, or one of these and all rays. */
typedef struct {
    /* From the centres to where the rays start. */
    Vector start;
    Vector direction;
    /* The square of the radius and a thousandth more, and 1 / radius. */
    reals reach, inverse;
    uint lanes;
} Couples;

Couples of_block(__global const Block *block, const Rays *rays, uint lane) {
    Couples couples;
    couples.start.x = rays->origin[0][lane] - vload8(0, block->centre);
    couples.start.y = rays->origin[1][lane] - vload8(1, block->centre);
    couples.start.z = rays->origin[2][lane] - vload8(2, block->centre);
    couples.direction = vector(spread(rays->direction[0][lane]), spread(rays->direction[1][lane]),
                               spread(rays->direction[2][lane]));
    couples.reach = vload8(0, block->reach);
    couples.inverse = vload8(0, block->inverse);
    couples.lanes = block->there;
    return couples;
}

Couples of_ball(__global const Block *block, uint place, const Rays *rays, uint lanes) {
    Couples couples;
    couples.start.x = get(rays->origin[0]) - block->centre[place];
    couples.start.y = get(rays->origin[1]) - block->centre[8 + place];
    couples.start.z = get(rays->origin[2]) - block->centre[16 + place];
    couples.direction = get3(rays->direction);
    couples.reach = spread(block->reach[place]);
    couples.inverse = spread(block->inverse[place]);
    couples.lanes = lanes;
    return couples;
}

/* The balls that the rays' lines may meet; none that a line does meet is left out. The computed distance to a centre is off
   across the line by a few roundings of itself, and along it by a few of the way to the nearest point: the thousandth in `reach`
   is worth far more than the first, and the square of that way times 2^-34 far more than the second. A NaN is let in. */
uint near_balls(const Couples *couples) {
    reals along = inner(couples->start, couples->direction);
    Vector across = scale_add(couples->direction, -along, couples->start);
    reals bound = fma(along * along, spread((real)0x1p-34f), couples->reach);
    return ~set_of(inner(across, across) > bound) & couples->lanes;
}

/* Which rays enter balls at a distance of at most `until`, and where. The balls that they start on are for others to leave out. */
uint entries(const Couples *couples, reals until, real *distance) {
    uint near = near_balls(couples);
    if (near == 0)
        return 0;
    Approach a = approach(scale(couples->start, couples->inverse), scale(couples->direction, couples->inverse));
    Intervals i = chord(&a);
    put(fmax(i.enter, spread((real)0)), distance);
    return near & entering(i, until);
}

/* Shows a block of balls to some rays, ball by ball or ray by ray, whichever there are fewer of. */
void show_block(const Scene *scene, const Rays *rays, uint lanes, uint number, Search *search) {
    __global const Block *block = scene->blocks + number;
    real distance[LANES];
    uint there = block->there;
#if TOUCHES
    /* What is known of the light decides there, whatever the numbers say. */
    bool one_by_one = search->sought == LAST_END || rays->touches != rays->touches_end;
#else
    bool one_by_one = search->sought == LAST_END;
#endif
    if (one_by_one) {
        for (; there != 0; there = rest_of(there))
            show_leaf(scene, rays, lanes, block->leaf[first_of(there)], search);
    } else if (popcount(lanes) > popcount(there)) {
        for (; there != 0; there = rest_of(there)) {
            uint place = first_of(there);
            Couples couples = of_ball(block, place, rays, lanes & search->open & ~equal(rays->class, block->class[place]));
            for (uint set = entries(&couples, get(search->until), distance); set != 0; set = rest_of(set)) {
                uint lane = first_of(set);
                keep_hit(search, lane, new_hit(distance[lane], block->leaf[place], false));
            }
        }
    } else {
        for (; lanes != 0; lanes = rest_of(lanes)) {
            uint lane = first_of(lanes);
            Couples couples = of_block(block, rays, lane);
            uint set = entries(&couples, spread(search->until[lane]), distance);
            if (set != 0)
                set &= ~set_of_ints(vload8(0, block->class) == rays->class[lane]);
            for (; set != 0; set = rest_of(set)) {
                uint place = first_of(set);
                keep_hit(search, lane, new_hit(distance[place], block->leaf[place], false));
            }
        }
    }
}

/* Shows what is in a block or run. */
void show(const Scene *scene, const Rays *rays, uint lanes, uint child, Search *search) {
    uint number = CHILD_INDEX(child);
    if (child >> CHILD_SHIFT == CHILD_BLOCK) {
        show_block(scene, rays, lanes, number, search);
        return;
    }
    uint end = scene->runs[2 * number + 1];
    for (uint i = scene->runs[2 * number]; i < end && search->open != 0; ++i)
        show_island(scene, rays, lanes & search->open, scene->islands + i, search);
}

#if HIERARCHY
/* What rays need for boxes. */
typedef struct {
    real inverse[3][LANES];
    /* Where in a node those corners stand that a ray comes to first, by axis. */
    uint near[3][LANES];
} Slabs;

/* No component counts as larger than the largest single, so that no product is 0 times infinity. Boxes are wider than what
   is in them, so that a ray along a face meets nothing there. */
Slabs slabs_of(const Rays *rays) {
    Slabs slabs;
    reals largest = spread((real)FLT_MAX);
    for (uint axis = 0; axis < 3; ++axis) {
        reals inverse = fmin(fmax(spread((real)1) / get(rays->direction[axis]), -largest), largest);
        put(inverse, slabs.inverse[axis]);
        uint downwards = set_of(inverse < spread((real)0));
        for (uint lane = 0; lane < LANES; ++lane)
            slabs.near[axis][lane] = 8 * axis + (has(downwards, lane) ? 24 : 0);
    }
    return slabs;
}

reals slab(__global const float *bounds, uint place, real origin, real inverse) {
    return (to_reals(vload8(0, bounds + place)) - origin) * inverse;
}

/* Which boxes of a node a ray is in between `from` and `until`; lowers `entry` to where it enters them. */
uint meets(__global const float *bounds, const Rays *rays, uint lane, const Slabs *slabs, const Search *search, reals *entry) {
    uint x = slabs->near[0][lane], y = slabs->near[1][lane], z = slabs->near[2][lane];
    real from_x = rays->origin[0][lane], from_y = rays->origin[1][lane], from_z = rays->origin[2][lane];
    real by_x = slabs->inverse[0][lane], by_y = slabs->inverse[1][lane], by_z = slabs->inverse[2][lane];
    reals near = max(max(slab(bounds, x, from_x, by_x), slab(bounds, y, from_y, by_y)),
                     max(slab(bounds, z, from_z, by_z), spread(search->from[lane])));
    reals far = min(min(slab(bounds, 24 - x, from_x, by_x), slab(bounds, 40 - y, from_y, by_y)),
                    min(slab(bounds, 56 - z, from_z, by_z), spread(search->until[lane])));
    truths met = near <= far * SLACK;
    *entry = select(*entry, min(*entry, near), met);
    return set_of(met);
}

/* Rows for columns of eight by eight bits. */
ulong turned(ulong sets) {
    ulong change = (sets ^ sets >> 7) & 0x00aa00aa00aa00aaul;
    sets ^= change ^ change << 7;
    change = (sets ^ sets >> 14) & 0x0000cccc0000ccccul;
    sets ^= change ^ change << 14;
    change = (sets ^ sets >> 28) & 0x00000000f0f0f0f0ul;
    return sets ^ change ^ change << 28;
}

/* Goes through the hierarchy from its root. */
void descend(const Scene *scene, const Rays *rays, uint root, Search *search) {
    Slabs slabs = slabs_of(rays);
    Step waiting[EIGHTS_DEPTH];
    uint count = 0;
    Step step;
    step.child = root;
    step.lanes = search->open;
    for (;;) {
        uint any = 0;
        if (step.child >> CHILD_SHIFT != CHILD_NODE) {
            show(scene, rays, step.lanes, step.child, search);
            if (search->open == 0)
                return;
        } else {
            __global const WideNode *node = scene->wide + step.child;
            reals entry = spread((real)INFINITY);
            /* Which boxes a ray meets, a byte to each; and then which rays meet a box. */
            ulong sets = 0;
            for (uint left = step.lanes; left != 0; left = rest_of(left)) {
                uint lane = first_of(left), met = meets(node->bounds, rays, lane, &slabs, search, &entry);
                any |= met;
                sets |= (ulong)met << 8 * lane;
            }
            sets = turned(sets);
            real entered[LANES];
            put(entry, entered);
            for (uint base = count; any != 0; any = rest_of(any)) {
                uint child = first_of(any);
                step.child = node->children[child];
                step.lanes = sets >> 8 * child & 0xff;
                step.entry = entered[child];
                uint at = count++;
                if (search->sought == FIRST_ENTRY)
                    for (; at > base && waiting[at - 1].entry < step.entry; --at)
                        waiting[at] = waiting[at - 1];
                waiting[at] = step;
            }
        }
        do {
            if (count == 0)
                return;
            step = waiting[--count];
            step.lanes &= search->open;
            /* `until` may have come nearer since this was put aside. */
            if (search->sought == FIRST_ENTRY)
                step.lanes &= set_of(spread(step.entry) <= get(search->until) * SLACK);
        } while (step.lanes == 0);
    }
}
#endif

/* Looks through all that the rays may meet: the root of the hierarchy comes last. */
void seek(const Scene *scene, const Rays *rays, Search *search) {
    for (uint i = 0; i < scene->starts_count && search->open != 0; ++i) {
        uint child = scene->starts[i];
#if HIERARCHY
        if (child >> CHILD_SHIFT == CHILD_NODE) {
            descend(scene, rays, child, search);
            continue;
        }
#endif
        show(scene, rays, search->open, child, search);
    }
}

#endif
