/* An island that is divided into cells is followed from cell to cell. What is left of it in a cell has the very truths of the whole
   there, so both ways find the very same crossings. */

#if COMPOUND && CELLS

/* A ray that starts farther out is not followed through cells, whose walls leave no room for its rounding. */
#define CELLS_REACH ((real)8)

/* Cells that a ray comes to later, each with the distance at which it leaves them. */
typedef struct {
    uint count;
    uint cells[CELLS_DEPTH + 1];
    real ends[CELLS_DEPTH + 1];
} Walk;

real component(const real (*v)[LANES], uint axis, uint lane) {
    return axis == 0 ? v[0][lane] : axis == 1 ? v[1][lane] : v[2][lane];
}

/* The cell that comes next, of which the ray is in until `end`; it was followed until `at`. */
__global const Cell *next_cell(const Scene *scene, const Rays *rays, uint lane, Walk *walk, real at, real *end) {
    walk->count -= 1;
    *end = walk->ends[walk->count];
    __global const Cell *cell = scene->cells + walk->cells[walk->count];
    while (cell->kind < CELL_PART) {
        real origin = component(rays->origin, cell->kind, lane), direction = component(rays->direction, cell->kind, lane);
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

/* The rays that start so far out that they are not followed through cells. */
uint far_away(const Rays *rays) {
    Vector origin = get3(rays->origin);
    reals reach = spread(CELLS_REACH);
    return set_of(fabs(origin.x) > reach) | set_of(fabs(origin.y) > reach) | set_of(fabs(origin.z) > reach);
}

/* The way of one ray through an island's cells. */
typedef struct {
    Walk walk;
    March march;
    /* The cell that it is in, and until where. */
    __global const Cell *cell;
    real end;
    bool started;
} Way;

/* Follows a ray through its cell; true if its way ends there. `crossings` are those of the part in the cell. */
bool pass(const Crossings *crossings, Way *way, real from, bool inside, Hit *hit) {
    March *march = &way->march;
    if (way->cell->kind == CELL_PART) {
        if (!way->started)
            *march = start_march(crossings, from, inside);
        if (inside && !march->held)
            return true;
        *hit = follow(crossings, march, way->end);
        if (hit->leaf != NOTHING)
            return true;
    } else if (!way->started) {
        *march = new_march(from, inside, way->cell->kind == CELL_FULL, no_hit());
        if (inside && !march->held)
            return true;
    }
    way->started = true;
    march->at = way->end;
    if (way->walk.count > 0)
        return false;
    *hit = finish(march);
    return true;
}

/* The same as `change`, from cell to cell: rays that are in one cell go through it together. */
void change_in_cells(const Scene *scene, __global const Island *island, const Rays *rays, uint lanes, Search *search) {
    bool inside = search->sought == LAST_END;
    Way ways[LANES];
    for (uint set = lanes; set != 0; set = rest_of(set)) {
        uint lane = first_of(set);
        Way *way = ways + lane;
        way->walk.count = 1;
        way->walk.cells[0] = island->cells;
        way->walk.ends[0] = sought_until(search, lane);
        way->march = new_march(search->from[lane], inside, inside, no_hit());
        way->started = false;
        way->cell = next_cell(scene, rays, lane, &way->walk, way->march.at, &way->end);
    }
    while (lanes != 0) {
        __global const Cell *cell = ways[first_of(lanes)].cell;
        Crossings crossings;
        if (cell->kind == CELL_PART)
            cross(&crossings, scene, scene->islands + cell->first, rays);
        for (uint set = lanes; set != 0; set = rest_of(set)) {
            uint lane = crossings.lane = first_of(set);
            Way *way = ways + lane;
            if (way->cell != cell)
                continue;
            Hit hit = no_hit();
            if (pass(&crossings, way, search->from[lane], inside, &hit)) {
                tell(scene, island, search, lane, hit, way->march.held);
                lanes = with(lanes, lane, false);
            } else {
                way->cell = next_cell(scene, rays, lane, &way->walk, way->march.at, &way->end);
            }
        }
    }
}

#endif
