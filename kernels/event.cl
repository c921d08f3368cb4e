/* Where a ray crosses the surface of one island: the next distance at which the island's truth changes. */

#define OPERATION_SHIFT 29

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

/* The island's truth at a distance with one member's truth turned over; no member has the number NOTHING. */
bool truth(const Crossings *crossings, real distance, uint turned) {
#if PROGRAMS
    uint bits = 0;
    for (uint at = crossings->island->program; at < crossings->island->program_end; ++at) {
        uint instruction = crossings->scene->program[at];
        uint operation = instruction >> OPERATION_SHIFT;
        if (operation == 0) {
            bits = bits << 1 | (holds_member(crossings, instruction, distance) != (instruction == turned));
        } else {
            uint top = bits & 1, below = bits >> 1 & 1;
            uint joined = operation == 1   ? below | top
                          : operation == 2 ? below & top
                          : operation == 3 ? below & ~top
                                           : top & ~below;
            bits = bits >> 2 << 1 | (joined & 1);
        }
    }
    return bits & 1;
#else
    return holds_member(crossings, 0, distance) != (turned == 0);
#endif
}

bool holds(const Crossings *crossings, real distance) { return truth(crossings, distance, NOTHING); }

/* Of the members that end where the island changes, the leftmost whose change matters by itself; where none does, the
   leftmost. */
Hit owner(const Crossings *crossings, real distance, bool now) {
    Hit found = no_hit();
    for (uint member = 0; member < member_count(crossings); ++member) {
        Interval i = MEMBER(crossings, member);
        if (i.enter < i.leave && (i.enter == distance || i.leave == distance)) {
            bool matters = truth(crossings, distance, member) != now;
            if (matters || found.leaf == NOTHING) {
                found.distance = distance;
                found.leaf = member_leaf(crossings, member);
                found.leaving = i.leave == distance;
            }
            if (matters)
                break;
        }
    }
    return found;
}

/* A ray that is on the wrong side of the surface at its start, until `end`, starts within rounding of another surface than
   its own. It is stopped there if the crossing behind it is nearer than the one ahead: then it runs into a crease. */
Hit crease(const Crossings *crossings, real from, real end) {
    real before = -(real)INFINITY;
    for (uint member = 0; member < member_count(crossings); ++member) {
        const Scene *scene = crossings->scene;
        Interval i = MEMBER(crossings, member);
        if (i.enter < i.leave &&
            scene->shapes[scene->leaves[member_leaf(crossings, member)].shape].class != crossings->ray->class) {
            if (i.enter <= from && i.enter > before)
                before = i.enter;
            if (i.leave <= from && i.leave > before)
                before = i.leave;
        }
    }
    if (!(from - before < end - from))
        return no_hit();
    Hit hit = owner(crossings, before, holds(crossings, before));
    hit.distance = from;
    return hit;
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
            return owner(crossings, at, now);
        if (!settled && now == inside) {
            Hit hit = crease(crossings, from, at);
            if (hit.leaf != NOTHING)
                return hit;
            settled = true;
        }
    }
}
