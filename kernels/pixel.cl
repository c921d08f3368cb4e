/* The pixels of a work-item: which they are, where their rays go, and what is told of them. */

/* Points on the sides of a pixel. */
#define SIDE_POINTS 16

/* What a work-item has to do. */
typedef struct {
    const Scene *scene;
    __global Outcome *outcomes;
    __global Sampled *sums;
    /* The tile; and which of its pixels' samples: from `first` up to, not including, `end`. */
    uint tile_column, tile_row, columns, rows, first, end;
    /* How many of its pixels were taken up. */
    uint taken;
#if SPREAD
    /* Where some pixels go on: which, how many, in rows of how many they are laid out, and whether their sides are looked at
       before their samples. */
    __global const uint *pixels;
    uint count, width;
    bool sides;
#endif
} Work;

/* To trace a tile. */
Work new_work(const Scene *scene, __global Outcome *outcomes, __global Sampled *sums, uint tile_column, uint tile_row,
              uint columns, uint rows, uint first, uint end) {
    Work work;
    work.scene = scene;
    work.outcomes = outcomes;
    work.sums = sums;
    work.tile_column = tile_column;
    work.tile_row = tile_row;
    work.columns = columns;
    work.rows = rows;
    work.first = first;
    work.end = end;
    work.taken = 0;
#if SPREAD
    work.pixels = 0;
#endif
    return work;
}

/* A pixel that a lane has taken up. */
typedef struct {
    /* Where what is told of it stands. */
    uint place;
    /* Where it is in the picture. */
    uint column, row;
    /* Its next sample. */
    uint sample;
#if SPREAD
    /* The next of the points on its sides. */
    uint side;
#endif
    /* What its first sample hits. */
    uint solid;
    real sum[3];
} Pixel;

#if SPREAD
#define REFINES(work) ((work)->pixels != 0)
/* Whether samples are summed up in blocks: one alone tells nothing that its colour does not. */
#define SUMS_UP(work) (REFINES(work) || (work)->scene->frame->samples > 1)
#else
#define REFINES(work) false
#endif

/* What earlier samples took. */
Spent spent_by(__global const Outcome *outcome) {
    Spent spent;
    spent.dropped = outcome->dropped;
#if SPREAD
    spent.spare = (real)INFINITY;
#endif
    spent.shadow = outcome->shadow;
    spent.reflected = outcome->reflected;
    spent.refracted = outcome->refracted;
    spent.over = outcome->over;
    spent.rays = outcome->primary + spent.reflected + spent.refracted;
    return spent;
}

/* Nothing yet. */
Spent nothing_spent(void) {
    Spent spent;
    spent.rays = 0;
    spent.dropped = 0;
#if SPREAD
    spent.spare = (real)INFINITY;
#endif
    spent.over = false;
    spent.shadow = spent.reflected = spent.refracted = 0;
    return spent;
}

/* Finds a pixel by its place in the tile; false if there is none. */
bool locate(const Work *work, uint x, uint y, Pixel *pixel) {
    __global const Frame *frame = work->scene->frame;
    if (x >= work->columns || y >= work->rows)
        return false;
#if SPREAD
    if (REFINES(work)) {
        pixel->place = (work->tile_row + y) * work->width + work->tile_column + x;
        if (pixel->place >= work->count)
            return false;
        pixel->column = frame->window_x + work->pixels[pixel->place] % frame->window_width;
        pixel->row = frame->window_y + work->pixels[pixel->place] / frame->window_width;
        return true;
    }
#endif
    pixel->place = y * work->columns + x;
    pixel->column = frame->window_x + work->tile_column + x;
    pixel->row = frame->window_y + work->tile_row + y;
    return true;
}

/* Takes up the next of the work-item's pixels, if there is one. */
bool next_pixel(Work *work, Pixel *pixel, Spent *spent) {
    bool found = false;
    while (!found && work->taken < ITEM_SIDE * ITEM_SIDE) {
        uint number = work->taken++;
        found = locate(work, get_global_id(0) * ITEM_SIDE + number % ITEM_SIDE,
                       get_global_id(1) * ITEM_SIDE + number / ITEM_SIDE, pixel);
    }
    if (!found)
        return false;
    bool begins = work->first == 0;
    __global const Outcome *outcome = work->outcomes + pixel->place;
    *spent = begins ? nothing_spent() : spent_by(outcome);
    pixel->sample = work->first;
    pixel->solid = begins ? NOTHING : outcome->solid;
    for (uint component = 0; component < 3; ++component)
        pixel->sum[component] = begins ? (real)0 : outcome->colour[component];
#if SPREAD
    if (begins && SUMS_UP(work))
        begin(work->sums + pixel->place);
    pixel->side = REFINES(work) && work->sides && begins ? 0 : SIDE_POINTS;
#endif
    return true;
}

/* The next point of a pixel that a ray goes through, from its centre; false if there is none. */
bool next_point(const Work *work, Pixel *pixel, Spent *spent, real *right_of, real *below) {
    const Scene *scene = work->scene;
#if SPREAD
    if (pixel->side < SIDE_POINTS) {
        /* The corners, and three on each side between them. */
        uint k = pixel->side;
        real along = (real)(k % 4) / (real)4 - (real)0.5, end = k < 8 ? (real)0.5 : -(real)0.5;
        along = k < 8 ? along : -along;
        bool across = k / 4 % 2 == 0;
        *right_of = across ? along : end;
        *below = across ? -end : along;
        return true;
    }
#endif
    for (; pixel->sample < work->end; ++pixel->sample) {
        if (spent->rays < scene->frame->ray_budget) {
            *right_of = scene->samples[2 * pixel->sample];
            *below = scene->samples[2 * pixel->sample + 1];
            return true;
        }
        if (!REFINES(work)) {
            spent->dropped += scene->reach[scene->frame->raydepth];
            spent->over = true;
        }
    }
    return false;
}

/* Adds what a ray through a point came to. */
void end_point(const Work *work, Pixel *pixel, const Spent *spent, const real *colour) {
#if SPREAD
    __global Sampled *sums = work->sums + pixel->place;
    if (pixel->side < SIDE_POINTS) {
        see(sums, colour);
        pixel->side += 1;
        return;
    }
    if (SUMS_UP(work))
        take(sums, colour, REFINES(work) ? spent->dropped : (real)0);
#endif
    for (uint component = 0; component < 3; ++component)
        pixel->sum[component] = pixel->sum[component] + colour[component];
    pixel->sample += 1;
}

/* Tells what a pixel came to. */
void end_pixel(const Work *work, const Pixel *pixel, const Spent *spent) {
    __global Outcome *outcome = work->outcomes + pixel->place;
    real share = 1;
#if SUPERSAMPLING
    if (!REFINES(work) && work->end == work->scene->frame->samples)
        share = (real)1 / (real)work->end;
#endif
    for (uint component = 0; component < 3; ++component)
        outcome->colour[component] = pixel->sum[component] * share;
    outcome->dropped = spent->dropped * share;
    outcome->solid = pixel->solid;
    outcome->primary = spent->rays - spent->reflected - spent->refracted;
    outcome->shadow = spent->shadow;
    outcome->reflected = spent->reflected;
    outcome->refracted = spent->refracted;
    outcome->over = spent->over;
}
