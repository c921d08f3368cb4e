/* Where a ray crosses the surface of one island: the next distance at which the island's truth changes.

   An island that is divided into cells is followed from cell to cell. What is left of it in a cell has the very truths of the
   whole there, so both ways find the very same crossings. */

/* Whether some island is more than a leaf. */
#define COMPOUND (PRODUCTS || PROGRAMS)

/* A crossing, or nothing if `leaf` is NOTHING. `leaving` tells of the leaf, not of the solid. */
typedef struct {
    real distance;
    uint leaf;
    bool leaving;
} Hit;

Hit new_hit(real distance, uint leaf, bool leaving) {
    Hit hit;
    hit.distance = distance;
    hit.leaf = leaf;
    hit.leaving = leaving;
    return hit;
}

Hit no_hit(void) { return new_hit((real)INFINITY, NOTHING, false); }

#if COMPOUND

#define OPERATION_SHIFT 29
#define COMPLEMENT 3
#define PROGRAM_DEPTH 26
#define CELL_PART 3
#define CELL_FULL 5
/* A ray that starts farther out is not followed through cells, whose walls leave no room for its rounding. */
#define CELLS_REACH ((real)8)

#if !PROGRAMS
#define IS_PRODUCT(part) true
#else
#define IS_PRODUCT(part) ((part)->product != 0)
#endif

/* The intervals of one part's members along one ray: kept where there is room, else computed anew each time. */
typedef struct {
    const Scene *scene;
    __global const Island *part;
    const Ray *ray;
#if MEMBERS
    bool keeps;
    Interval kept[MEMBERS];
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

Interval computed(const Crossings *crossings, uint member) {
    const Scene *scene = crossings->scene;
    return shape_interval(scene->shapes + scene->leaves[member_leaf(crossings, member)].shape, crossings->ray);
}

Interval member_interval(const Crossings *crossings, uint member) {
#if MEMBERS
    if (crossings->keeps)
        return crossings->kept[member];
#endif
    return computed(crossings, member);
}

void cross(Crossings *crossings, const Scene *scene, __global const Island *part, const Ray *ray) {
    crossings->scene = scene;
    crossings->part = part;
    crossings->ray = ray;
#if MEMBERS
    uint count = member_count(crossings);
    crossings->keeps = count <= MEMBERS;
    if (crossings->keeps)
        for (uint member = 0; member < count; ++member)
            crossings->kept[member] = computed(crossings, member);
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
        if (!(i.enter < i.leave) ||
            scene->shapes[scene->leaves[member_leaf(crossings, member)].shape].class == crossings->ray->class)
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
        Interval i = member_interval(crossings, operand_of(literal));
        if (literal >> OPERATION_SHIFT != 0) {
            if (inside && i.enter < i.leave && i.enter > at)
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

#if CELLS
/* Cells that a ray comes to later, each with the distance at which it leaves them. */
typedef struct {
    uint count;
    uint cells[CELLS_DEPTH + 1];
    real ends[CELLS_DEPTH + 1];
} Walk;

real component(Vector v, uint axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

/* The cell that comes next, of which the ray is in until `end`; it was followed until `at`. */
__global const Cell *next_cell(const Scene *scene, const Ray *ray, Walk *walk, real at, real *end) {
    walk->count -= 1;
    *end = walk->ends[walk->count];
    __global const Cell *cell = scene->cells + walk->cells[walk->count];
    while (cell->kind < CELL_PART) {
        real origin = component(ray->origin, cell->kind), direction = component(ray->direction, cell->kind);
        real wall = cell->wall;
        /* A ray along the wall gives an infinity or no number, and stays on its side. */
        real crossed = (wall - origin) / direction;
        uint below = origin < wall || (origin == wall && direction <= 0);
        uint near = cell->first + !below, far = cell->first + below;
        if (crossed > 0 && crossed <= at) {
            cell = scene->cells + far;
            continue;
        }
        if (crossed > 0 && crossed < *end) {
            walk->cells[walk->count] = far;
            walk->ends[walk->count] = *end;
            walk->count += 1;
            *end = crossed;
        }
        cell = scene->cells + near;
    }
    return cell;
}

/* The same as `change`, from cell to cell. */
Hit change_in_cells(const Scene *scene, __global const Island *island, const Ray *ray, real from, real until, bool inside,
                    bool *held) {
    Walk walk;
    walk.count = 1;
    walk.cells[0] = island->cells;
    walk.ends[0] = until;
    March march = new_march(from, inside, inside, no_hit());
    bool started = false;
    while (walk.count > 0) {
        real end;
        __global const Cell *cell = next_cell(scene, ray, &walk, march.at, &end);
        if (cell->kind == CELL_PART) {
            Crossings crossings;
            cross(&crossings, scene, scene->islands + cell->first, ray);
            if (!started)
                march = start_march(&crossings, from, inside);
            if (inside && !march.held)
                break;
            Hit hit = follow(&crossings, &march, end);
            if (hit.leaf != NOTHING) {
                *held = march.held;
                return hit;
            }
        } else if (!started) {
            march = new_march(from, inside, cell->kind == CELL_FULL, no_hit());
            if (inside && !march.held)
                break;
        }
        started = true;
        march.at = end;
    }
    *held = march.held;
    return inside && !march.held ? no_hit() : finish(&march);
}
#endif

/* The first change of an island after `from` and not after `until`, of a ray that is inside (or not) to begin with. A ray
   that is to be inside and is not held by the island there meets nothing. */
Hit change(const Scene *scene, __global const Island *island, const Ray *ray, real from, real until, bool inside, bool *held) {
#if CELLS
    bool far = fabs(ray->origin.x) > CELLS_REACH || fabs(ray->origin.y) > CELLS_REACH || fabs(ray->origin.z) > CELLS_REACH;
    if (island->cells != NOTHING && !far)
        return change_in_cells(scene, island, ray, from, until, inside, held);
#endif
    Crossings crossings;
    cross(&crossings, scene, island, ray);
    March march = start_march(&crossings, from, inside);
    *held = march.held;
    if (inside && !march.held)
        return no_hit();
    Hit hit = follow(&crossings, &march, until);
    return hit.leaf != NOTHING ? hit : finish(&march);
}
#endif
