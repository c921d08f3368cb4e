/* Where rays cross the surface of one island: the next distance at which the island's truth changes. */

/* Whether some island is more than a leaf. */
#define COMPOUND (PRODUCTS || PROGRAMS)

#if COMPOUND

#if !PROGRAMS
#define IS_PRODUCT(part) true
#else
#define IS_PRODUCT(part) ((part)->product != 0)
#endif

/* What is inside of one surface's solid along one ray. */
typedef struct {
    real enter, leave;
} Interval;

/* The intervals of one part's members along the rays: kept where there is room, else computed anew each time. */
typedef struct {
    const Scene *scene;
    __global const Island *part;
    const Rays *rays;
    /* Which of the rays is looked at. */
    uint lane;
#if MEMBERS
    bool keeps;
    real enter[MEMBERS][LANES], leave[MEMBERS][LANES];
#endif
} Crossings;

/* What is known of a ray on its way through an island: how far it has been followed, whether it is inside to begin with and
   whether the island says so, whether it has been on the side where it is to be; the last crossing that is not ahead of a
   start on the other side, and the first one that the ray has not come to. */
typedef struct {
    real from, at, ahead;
    bool inside, held, settled;
    Hit behind;
} March;

uint member_leaf(const Crossings *crossings, uint member) {
    return crossings->scene->members[crossings->part->members + member];
}

uint member_count(const Crossings *crossings) { return crossings->part->members_end - crossings->part->members; }

Interval new_interval(real enter, real leave) {
    Interval interval;
    interval.enter = enter;
    interval.leave = leave;
    return interval;
}

Intervals computed(const Crossings *crossings, uint member) {
    return leaf_intervals(crossings->scene, member_leaf(crossings, member), crossings->rays);
}

Interval member_interval(const Crossings *crossings, uint member) {
#if MEMBERS
    if (crossings->keeps)
        return new_interval(crossings->enter[member][crossings->lane], crossings->leave[member][crossings->lane]);
#endif
    Intervals all = computed(crossings, member);
    real enter[LANES], leave[LANES];
    put(all.enter, enter);
    put(all.leave, leave);
    return new_interval(enter[crossings->lane], leave[crossings->lane]);
}

void cross(Crossings *crossings, const Scene *scene, __global const Island *part, const Rays *rays) {
    crossings->scene = scene;
    crossings->part = part;
    crossings->rays = rays;
#if MEMBERS
    uint count = member_count(crossings);
    crossings->keeps = count <= MEMBERS;
    if (crossings->keeps)
        for (uint member = 0; member < count; ++member) {
            Intervals all = computed(crossings, member);
            put(all.enter, crossings->enter[member]);
            put(all.leave, crossings->leave[member]);
        }
#endif
}

uint operand_of(uint instruction) { return instruction & ((1u << OPERATION_SHIFT) - 1); }

bool holds_member(const Crossings *crossings, uint member, real distance) {
    Interval i = member_interval(crossings, member);
    return i.enter <= distance && distance < i.leave;
}

#if PROGRAMS
/* A stack of truths after an operation on the two topmost. */
uint joined(uint operation, uint bits) {
    uint top = bits & 1, below = bits >> 1 & 1;
    return bits >> 2 << 1 | ((operation & 1) ? below | top : below & top);
}
#endif

/* Whether a product holds the ray at a distance. */
bool holds_product(const Crossings *crossings, real distance) {
    for (uint at = crossings->part->program; at < crossings->part->program_end; ++at) {
        uint literal = crossings->scene->program[at];
        bool positive = literal >> OPERATION_SHIFT == 0;
        if (holds_member(crossings, operand_of(literal), distance) != positive)
            return false;
    }
    return true;
}

/* Whether the part holds the ray at a distance. */
bool holds(const Crossings *crossings, real distance) {
#if PROGRAMS
    if (!IS_PRODUCT(crossings->part)) {
        uint bits = 0;
        for (uint at = crossings->part->program; at < crossings->part->program_end; ++at) {
            uint instruction = crossings->scene->program[at];
            uint operation = instruction >> OPERATION_SHIFT;
            if (operation == 0 || operation == COMPLEMENT)
                bits = bits << 1 | (holds_member(crossings, operand_of(instruction), distance) != (operation == COMPLEMENT));
            else
                bits = joined(operation, bits);
        }
        return bits & 1;
    }
#endif
    return holds_product(crossings, distance);
}

Hit member_hit(const Crossings *crossings, uint member, real distance) {
    return new_hit(distance, member_leaf(crossings, member), member_interval(crossings, member).leave == distance);
}

/* The crossing of a distance where a product changes: all members that change do so in the same direction. */
Hit product_owner(const Crossings *crossings, real distance) {
    for (uint at = crossings->part->program; at < crossings->part->program_end; ++at) {
        uint member = operand_of(crossings->scene->program[at]);
        Interval i = member_interval(crossings, member);
        bool before = i.enter < distance && distance <= i.leave, after = i.enter <= distance && distance < i.leave;
        if (before != after)
            return member_hit(crossings, member, distance);
    }
    return member_hit(crossings, 0, distance);
}

/* The crossing of a distance where the part changes: of operands that change together, the left one owns it. */
Hit owner(const Crossings *crossings, real distance) {
#if PROGRAMS
    if (!IS_PRODUCT(crossings->part)) {
        uint before = 0, after = 0, depth = 0;
        uint owners[PROGRAM_DEPTH];
        for (uint at = crossings->part->program; at < crossings->part->program_end; ++at) {
            uint instruction = crossings->scene->program[at];
            uint operation = instruction >> OPERATION_SHIFT;
            if (operation == 0 || operation == COMPLEMENT) {
                uint member = operand_of(instruction);
                bool negative = operation == COMPLEMENT;
                Interval i = member_interval(crossings, member);
                before = before << 1 | ((i.enter < distance && distance <= i.leave) != negative);
                after = after << 1 | ((i.enter <= distance && distance < i.leave) != negative);
                owners[depth++] = member;
            } else {
                uint changed = before ^ after;
                bool takes_top = operation > 4 ? changed & 1 : !(changed & 2);
                depth -= 1;
                if (takes_top)
                    owners[depth - 1] = owners[depth];
                before = joined(operation, before);
                after = joined(operation, after);
            }
        }
        return member_hit(crossings, owners[0], distance);
    }
#endif
    return product_owner(crossings, distance);
}

/* The last end that is not after a distance, of a member of another class than the ray's start; the leftmost of several. */
Hit behind(const Crossings *crossings, real from) {
    const Scene *scene = crossings->scene;
    Hit last = no_hit();
    last.distance = -(real)INFINITY;
    for (uint member = 0; member < member_count(crossings); ++member) {
        Interval i = member_interval(crossings, member);
        if (!(i.enter < i.leave) || scene->shapes[scene->leaves[member_leaf(crossings, member)].shape].class ==
                                        crossings->rays->class[crossings->lane])
            continue;
        if (i.enter <= from && i.enter > last.distance)
            last = member_hit(crossings, member, i.enter);
        if (i.leave <= from && i.leave > last.distance)
            last = member_hit(crossings, member, i.leave);
    }
    return last;
}

March new_march(real from, bool inside, bool held, Hit behind) {
    March march;
    march.from = march.at = from;
    march.ahead = (real)INFINITY;
    march.inside = inside;
    march.held = held;
    march.settled = held == inside;
    march.behind = behind;
    return march;
}

March start_march(const Crossings *crossings, real from, bool inside) {
    bool held = holds(crossings, from);
    return new_march(from, inside, held, held == inside ? no_hit() : behind(crossings, from));
}

/* A ray that is on the wrong side of the surface at its start, until `end`, starts within rounding of another surface than
   its own. It is stopped there if the crossing behind it is nearer than the one ahead: then it runs into a crease. */
Hit crease(const March *march, real end) {
    if (march->behind.leaf == NOTHING || !(march->from - march->behind.distance < end - march->from))
        return no_hit();
    Hit hit = march->behind;
    hit.distance = march->from;
    return hit;
}

/* What the ray meets if it comes to no change. */
Hit finish(const March *march) { return march->settled ? no_hit() : crease(march, march->ahead); }

/* The first end of a member after a distance. */
real next_end(const Crossings *crossings, real at) {
    real next = (real)INFINITY;
    for (uint member = 0; member < member_count(crossings); ++member) {
        Interval i = member_interval(crossings, member);
        if (i.enter < i.leave) {
            if (i.enter > at && i.enter < next)
                next = i.enter;
            if (i.leave > at && i.leave < next)
                next = i.leave;
        }
    }
    return next;
}

/* Where a product that holds `at` (or does not) stops to (or begins to) after that: all members reach from the last of their
   beginnings to the first of their ends, and the complements take away what they cover. */
real product_change(const Crossings *crossings, real at, bool inside) {
    __global const Island *part = crossings->part;
    real first = at, last = (real)INFINITY;
    for (uint word = part->program; word < part->program_end; ++word) {
        uint literal = crossings->scene->program[word];
        bool positive = literal >> OPERATION_SHIFT == 0;
        if (!positive && !inside)
            continue;
        Interval i = member_interval(crossings, operand_of(literal));
        if (!positive) {
            if (i.enter < i.leave && i.enter > at)
                last = fmin(last, i.enter);
        } else if (i.enter < i.leave) {
            first = fmax(first, i.enter);
            last = fmin(last, i.leave);
        } else {
            return (real)INFINITY;
        }
    }
    if (inside)
        return last;
    /* What is taken away only moves the beginning further: most rays that miss the rest are through here. */
    if (!(first < last))
        return (real)INFINITY;
    for (bool moved = true; moved;) {
        moved = false;
        for (uint word = part->program; word < part->program_end; ++word) {
            uint literal = crossings->scene->program[word];
            if (literal >> OPERATION_SHIFT == 0)
                continue;
            Interval i = member_interval(crossings, operand_of(literal));
            if (i.enter <= first && first < i.leave) {
                first = i.leave;
                moved = true;
            }
        }
    }
    return first < last ? first : (real)INFINITY;
}

/* The first change that is not after `until`. */
Hit follow(const Crossings *crossings, March *march, real until) {
    if (IS_PRODUCT(crossings->part) && march->settled) {
        real next = product_change(crossings, march->at, march->inside);
        return next <= until && !isinf(next) ? product_owner(crossings, next) : no_hit();
    }
    for (;;) {
        real next = next_end(crossings, march->at);
        if (next > until || isinf(next)) {
            march->ahead = next;
            return no_hit();
        }
        march->at = next;
        bool now = holds(crossings, next);
        if (march->settled && now != march->inside)
            return owner(crossings, next);
        if (!march->settled && now == march->inside) {
            Hit hit = crease(march, next);
            if (hit.leaf != NOTHING)
                return hit;
            march->settled = true;
        }
    }
}

/* Tells of what a ray has met of an island, if anything. What holds it without an end is left infinitely far away. */
void tell(const Scene *scene, __global const Island *island, Search *search, uint lane, Hit hit, bool held) {
    if (search->sought == LAST_END && held && hit.leaf == NOTHING)
        hit = new_hit((real)INFINITY, scene->members[island->members], true);
    if (hit.leaf != NOTHING)
        keep_hit(search, lane, hit);
}

real sought_until(const Search *search, uint lane) {
    return search->sought == LAST_END ? (real)INFINITY : search->until[lane];
}

/* Tells of the first changes of an island in the range that is searched, of rays that are inside (or not) to begin with. A ray that
   is to be inside and is not held by the island there meets nothing. */
void change(const Scene *scene, __global const Island *island, const Rays *rays, uint lanes, Search *search) {
    bool inside = search->sought == LAST_END;
    Crossings crossings;
    cross(&crossings, scene, island, rays);
    for (; lanes != 0; lanes = rest_of(lanes)) {
        uint lane = crossings.lane = first_of(lanes);
        March march = start_march(&crossings, search->from[lane], inside);
        Hit hit = no_hit();
        if (!inside || march.held) {
            hit = follow(&crossings, &march, sought_until(search, lane));
            if (hit.leaf == NOTHING)
                hit = finish(&march);
        }
        tell(scene, island, search, lane, hit, march.held);
    }
}
#endif
