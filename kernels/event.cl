/* Where a ray crosses the surface of one island: the next distance at which the island's truth changes. */

#define OPERATION_SHIFT 29
#define PROGRAM_DEPTH 26

/* A crossing, or nothing if `leaf` is NOTHING. `leaving` tells of the leaf, not of the solid. */
typedef struct {
    real distance;
    uint leaf;
    bool leaving;
} Hit;

/* The members' intervals along one ray: kept where there is room, else computed anew each time. */
typedef struct {
    const Scene *scene;
    __global const Island *island;
    const Ray *ray;
#if MEMBERS
    Interval kept[MEMBERS];
#endif
} Crossings;

Hit no_hit(void) {
    Hit hit;
    hit.distance = (real)INFINITY;
    hit.leaf = NOTHING;
    hit.leaving = false;
    return hit;
}

uint member_leaf(const Crossings *crossings, uint member) {
    return crossings->scene->members[crossings->island->members + member];
}

uint member_count(const Crossings *crossings) {
    return crossings->island->members_end - crossings->island->members;
}

Interval computed(const Crossings *crossings, uint member) {
    const Scene *scene = crossings->scene;
    return shape_interval(scene->shapes + scene->leaves[member_leaf(crossings, member)].shape, crossings->ray);
}

#if MEMBERS
#define MEMBER(crossings, member) ((crossings)->kept[member])
#else
#define MEMBER(crossings, member) computed(crossings, member)
#endif

void cross(Crossings *crossings, const Scene *scene, __global const Island *island, const Ray *ray) {
    crossings->scene = scene;
    crossings->island = island;
    crossings->ray = ray;
#if MEMBERS
    for (uint member = 0; member < member_count(crossings); ++member)
        crossings->kept[member] = computed(crossings, member);
#endif
}

bool holds_member(const Crossings *crossings, uint member, real distance) {
    Interval i = MEMBER(crossings, member);
    return i.enter <= distance && distance < i.leave;
}

#if PROGRAMS
/* A stack of truths after an operation on the two topmost. */
uint joined(uint operation, uint bits) {
    uint top = bits & 1, below = bits >> 1 & 1;
    uint both = (operation & 3) == 1   ? below | top
                : (operation & 3) == 2 ? below & top
                : operation == 3       ? below & ~top
                                       : top & ~below;
    return bits >> 2 << 1 | (both & 1);
}
#endif

/* Whether the island holds the ray at a distance. */
bool holds(const Crossings *crossings, real distance) {
#if PROGRAMS
    uint bits = 0;
    for (uint at = crossings->island->program; at < crossings->island->program_end; ++at) {
        uint instruction = crossings->scene->program[at];
        uint operation = instruction >> OPERATION_SHIFT;
        bits = operation == 0 ? bits << 1 | holds_member(crossings, instruction, distance) : joined(operation, bits);
    }
    return bits & 1;
#else
    return holds_member(crossings, 0, distance);
#endif
}

Hit member_hit(const Crossings *crossings, uint member, real distance) {
    Hit hit;
    hit.distance = distance;
    hit.leaf = member_leaf(crossings, member);
    hit.leaving = MEMBER(crossings, member).leave == distance;
    return hit;
}

/* The crossing of a distance where the island changes: of operands that change together, the left one owns it. */
Hit owner(const Crossings *crossings, real distance) {
#if PROGRAMS
    uint before = 0, after = 0, depth = 0;
    uint owners[PROGRAM_DEPTH];
    for (uint at = crossings->island->program; at < crossings->island->program_end; ++at) {
        uint instruction = crossings->scene->program[at];
        uint operation = instruction >> OPERATION_SHIFT;
        if (operation == 0) {
            Interval i = MEMBER(crossings, instruction);
            before = before << 1 | (i.enter < distance && distance <= i.leave);
            after = after << 1 | (i.enter <= distance && distance < i.leave);
            owners[depth++] = instruction;
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
#else
    return member_hit(crossings, 0, distance);
#endif
}

/* Whether a member has ends at all and another class than the ray's start. */
bool counts(const Crossings *crossings, uint member) {
    const Scene *scene = crossings->scene;
    Interval i = MEMBER(crossings, member);
    return i.enter < i.leave &&
           scene->shapes[scene->leaves[member_leaf(crossings, member)].shape].class != crossings->ray->class;
}

/* A ray that is on the wrong side of the surface at its start, until `end`, starts within rounding of another surface than
   its own. It is stopped there if the crossing behind it is nearer than the one ahead: then it runs into a crease. */
Hit crease(const Crossings *crossings, real from, real end) {
    real before = -(real)INFINITY;
    for (uint member = 0; member < member_count(crossings); ++member) {
        Interval i = MEMBER(crossings, member);
        if (!counts(crossings, member))
            continue;
        if (i.enter <= from && i.enter > before)
            before = i.enter;
        if (i.leave <= from && i.leave > before)
            before = i.leave;
    }
    if (!(from - before < end - from))
        return no_hit();
    /* Of several that end there, the leftmost. */
    for (uint member = 0; member < member_count(crossings); ++member) {
        Interval i = MEMBER(crossings, member);
        if (counts(crossings, member) && (i.enter == before || i.leave == before)) {
            Hit hit = member_hit(crossings, member, before);
            hit.distance = from;
            return hit;
        }
    }
    return no_hit();
}

/* The first change after `from` and not after `until`, of a ray that is inside (or not) to begin with. */
Hit change(const Crossings *crossings, real from, real until, bool inside) {
    real at = from;
    bool settled = holds(crossings, at) == inside;
    for (;;) {
        real next = (real)INFINITY;
        for (uint member = 0; member < member_count(crossings); ++member) {
            Interval i = MEMBER(crossings, member);
            if (i.enter < i.leave) {
                if (i.enter > at && i.enter < next)
                    next = i.enter;
                if (i.leave > at && i.leave < next)
                    next = i.leave;
            }
        }
        if (next > until || isinf(next))
            return settled ? no_hit() : crease(crossings, from, next);
        at = next;
        bool now = holds(crossings, at);
        if (settled && now != inside)
            return owner(crossings, at);
        if (!settled && now == inside) {
            Hit hit = crease(crossings, from, at);
            if (hit.leaf != NOTHING)
                return hit;
            settled = true;
        }
    }
}
