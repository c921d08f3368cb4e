/* The entry points. */

/* The ray through a point of a pixel, measured from the pixel's centre. */
Ray camera_ray(__global const Frame *frame, uint column, uint row, real right, real down) {
    /* The whole part of the position is an integer that is exact in single precision. */
    real x = ((real)((int)(2 * column + 1) - (int)frame->width) + (real)2 * right) / (real)frame->width;
    real y = -(((real)((int)(2 * row + 1) - (int)frame->height) + (real)2 * down) / (real)frame->height);
    Ray ray;
    ray.origin = load(frame->eye);
    ray.direction = unit(scale_add(load(frame->up), y, scale_add(load(frame->right), x, load(frame->forward))));
    /* An eye that is on no surface has the normal 0, and all rays go to its side. */
    Vector normal = load(frame->eye_normal);
    bool behind = inner(normal, ray.direction) < 0;
    ray.place = load(frame->eye_local);
    if (frame->eye_flat)
        ray.place = behind ? negated(normal) : normal;
    ray.class = frame->eye_class;
    ray.into = behind;
    ray.inside = frame->eye_inside >> behind & 1;
#if TOUCHES
    ray.end = (real)INFINITY;
    ray.touches = ray.touches_end = 0;
#endif
    return ray;
}

/* What a ray finds islands by. */
#if EIGHTS
#define HIERARCHY_PARAMETERS                                                                                           \
    __global const WideNode *wide, __global const Block *blocks, __global const uint *runs,                            \
        __global const uint *starts, uint starts_count
#define HIERARCHY_ARGUMENTS wide, blocks, runs, starts, starts_count
#else
#define HIERARCHY_PARAMETERS __global const Node *nodes
#define HIERARCHY_ARGUMENTS nodes
#endif

/* What every entry point is given of the scene, in the order in which the host gives it. */
#define SCENE_PARAMETERS                                                                                               \
    __global const Frame *frame, __global const Shape *shapes, __global const Leaf *leaves,                            \
        __global const Island *islands, __global const Cell *cells, __global const uint *program,                      \
        __global const uint *members, HIERARCHY_PARAMETERS, __global const Material *materials,                        \
        __global const Light *lights, __global const Touch *touches, __global const real *samples,                     \
        __global const real *reach
#define SCENE_ARGUMENTS                                                                                                \
    frame, shapes, leaves, islands, cells, program, members, HIERARCHY_ARGUMENTS, materials, lights, touches, samples, reach

Scene scene_of(SCENE_PARAMETERS) {
    Scene scene;
    scene.frame = frame;
    scene.shapes = shapes;
    scene.leaves = leaves;
    scene.islands = islands;
    scene.cells = cells;
    scene.program = program;
    scene.members = members;
#if EIGHTS
    scene.wide = wide;
    scene.blocks = blocks;
    scene.runs = runs;
    scene.starts = starts;
    scene.starts_count = starts_count;
#else
    scene.nodes = nodes;
#endif
    scene.materials = materials;
    scene.lights = lights;
#if TOUCHES
    scene.touches = touches;
#endif
    scene.samples = samples;
    scene.reach = reach;
    return scene;
}

/* Nothing yet. */
Spent nothing_spent() {
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

/* What earlier samples took. */
Spent spent_by(__global const Outcome *outcome) {
    Spent spent = nothing_spent();
    spent.dropped = outcome->dropped;
    spent.shadow = outcome->shadow;
    spent.reflected = outcome->reflected;
    spent.refracted = outcome->refracted;
    spent.over = outcome->over;
    spent.rays = outcome->primary + spent.reflected + spent.refracted;
    return spent;
}

void keep(__global Outcome *outcome, const Spent *spent) {
    outcome->dropped = spent->dropped;
    outcome->primary = spent->rays - spent->reflected - spent->refracted;
    outcome->shadow = spent->shadow;
    outcome->reflected = spent->reflected;
    outcome->refracted = spent->refracted;
    outcome->over = spent->over;
}

/* Traces a tile of the window, row by row in `outcomes`: the samples from `first` up to, not including, `end` of its pixels.
   What the samples before them came to is in `outcomes`; after the last ones the means are. */
__kernel void trace(SCENE_PARAMETERS, __global Outcome *outcomes, __global Sampled *sums, uint tile_column,
                    uint tile_row, uint columns, uint rows, uint first, uint end) {
    if (get_global_id(0) >= columns || get_global_id(1) >= rows)
        return;
    uint place = get_global_id(1) * columns + get_global_id(0);
    __global Outcome *outcome = outcomes + place;
    uint column = frame->window_x + tile_column + get_global_id(0);
    uint row = frame->window_y + tile_row + get_global_id(1);
    Scene scene = scene_of(SCENE_ARGUMENTS);
    Spent spent = nothing_spent();
    Vector sum = vector(0, 0, 0);
    uint solid = NOTHING;
#if SUPERSAMPLING
    if (first > 0) {
        spent = spent_by(outcome);
        sum = load(outcome->colour);
        solid = outcome->solid;
    }
#endif
#if SPREAD
    if (first == 0)
        begin(sums + place);
#endif
    for (uint k = first; k < end; ++k) {
        if (spent.rays >= frame->ray_budget) {
            spent.dropped += reach[frame->raydepth];
            spent.over = true;
            continue;
        }
        spent.rays += 1;
        Hit hit;
        Ray ray = camera_ray(frame, column, row, samples[2 * k], samples[2 * k + 1]);
        Vector colour = walk(&scene, ray, &spent, &hit);
        sum = add(sum, colour);
#if SPREAD
        take(sums + place, colour, 0);
#endif
        if (k == 0) {
            solid = hit.leaf == NOTHING ? NOTHING : leaves[hit.leaf].solid;
#if DISTANCES
            outcome->distance = hit.leaf == NOTHING ? (real)INFINITY : hit.distance;
#endif
        }
    }
#if SUPERSAMPLING
    if (end == frame->samples && end > 1) {
        real share = (real)1 / (real)end;
        sum = scale(sum, share);
        spent.dropped *= share;
    }
#endif
    outcome->colour[0] = sum.x;
    outcome->colour[1] = sum.y;
    outcome->colour[2] = sum.z;
    outcome->solid = solid;
    keep(outcome, &spent);
}

#if SPREAD
/* The colour that a pixel's next ray brings back, through a point of it; what may be dropped of it is counted from nothing. */
Vector next_colour(const Scene *scene, uint column, uint row, real right, real down, Spent *spent) {
    spent->rays += 1;
    spent->dropped = 0;
    spent->spare = scene->frame->spare;
    Hit hit;
    return walk(scene, camera_ray(scene->frame, column, row, right, down), spent, &hit);
}

/* Looks at the points on a pixel's sides: its corners, and three on each side between them. */
void look_around(const Scene *scene, uint column, uint row, __global Sampled *sums, Spent *spent) {
    for (uint k = 0; k < 16; ++k) {
        real along = (real)(k % 4) / (real)4 - (real)0.5, end = k < 8 ? (real)0.5 : -(real)0.5;
        along = k < 8 ? along : -along;
        bool across = k / 4 % 2 == 0;
        see(sums, next_colour(scene, column, row, across ? along : end, across ? -end : along, spent));
    }
}

/* Goes on with some pixels, which are numbered row by row within the window: their samples from `first` up to, not including,
   `end`, until the rays of a pixel run out; before all of them its sides, if they are asked for. The items are laid out in rows of `width`, of which a tile is run. */
__kernel void refine(SCENE_PARAMETERS, __global Outcome *outcomes, __global Sampled *sums, __global const uint *pixels,
                     uint sides, uint count, uint width, uint tile_column, uint tile_row, uint columns, uint rows, uint first,
                     uint end) {
    uint item = (tile_row + get_global_id(1)) * width + tile_column + get_global_id(0);
    if (get_global_id(0) >= columns || get_global_id(1) >= rows || item >= count)
        return;
    uint column = frame->window_x + pixels[item] % frame->window_width;
    uint row = frame->window_y + pixels[item] / frame->window_width;
    Scene scene = scene_of(SCENE_ARGUMENTS);
    Spent spent = first == 0 ? nothing_spent() : spent_by(outcomes + item);
    if (first == 0) {
        begin(sums + item);
        if (sides)
            look_around(&scene, column, row, sums + item, &spent);
    }
    for (uint k = first; k < end && spent.rays < frame->ray_budget; ++k) {
        Vector colour = next_colour(&scene, column, row, samples[2 * k], samples[2 * k + 1], &spent);
        take(sums + item, colour, spent.dropped);
    }
    keep(outcomes + item, &spent);
}
#endif
