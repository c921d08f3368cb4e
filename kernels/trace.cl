/* The entry points. */

/* Rays through points of pixels, measured from the pixels' centres. `across` and `down` count from the picture's centre in
   halves of pixels; these are integers that are exact in single precision. */
Rays camera_rays(__global const Frame *frame, reals across, reals down, reals right_of, reals below) {
    reals x = (across + (real)2 * right_of) / (real)frame->width;
    reals y = -((down + (real)2 * below) / (real)frame->height);
    Vector direction = unit(scale_add(load(frame->up), y, scale_add(load(frame->right), x, load(frame->forward))));
    /* An eye that is on no surface has the normal 0, and all rays go to its side. */
    Vector normal = load(frame->eye_normal);
    uint behind = set_of(inner(normal, direction) < spread((real)0));
    Rays rays;
    no_rays(&rays);
    put3(load(frame->eye), rays.origin);
    put3(direction, rays.direction);
    put3(frame->eye_flat ? choose3(behind, negated(normal), normal) : load(frame->eye_local), rays.place);
    for (uint lane = 0; lane < LANES; ++lane)
        rays.class[lane] = frame->eye_class;
    rays.into = behind;
    rays.inside = (frame->eye_inside & 1 ? ~behind : 0) | (frame->eye_inside & 2 ? behind : 0);
    return rays;
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

/* Gives lanes that have nothing to follow the next rays of their pixels, or of the next pixels; which have one then. `busy` are
   the lanes with a pixel. */
uint begin_rays(Work *work, uint lanes, Pixel *pixels, Paths *paths, Rays *rays, uint *busy) {
    __global const Frame *frame = work->scene->frame;
    real across[LANES], down[LANES], right_of[LANES], below[LANES];
    put(spread((real)0), across);
    put(spread((real)0), down);
    put(spread((real)0), right_of);
    put(spread((real)0), below);
    uint begun = 0;
    for (; lanes != 0; lanes = rest_of(lanes)) {
        uint lane = first_of(lanes);
        Pixel *pixel = pixels + lane;
        Spent *spent = paths->spent + lane;
        bool found = false;
        while (!found) {
            if (!has(*busy, lane)) {
                if (!next_pixel(work, pixel, spent))
                    break;
                *busy |= 1u << lane;
            }
            found = next_point(work, pixel, spent, right_of + lane, below + lane);
            if (!found) {
                end_pixel(work, pixel, spent);
                *busy &= ~(1u << lane);
            }
        }
        if (!found)
            continue;
        begun |= 1u << lane;
        across[lane] = (real)((int)(2 * pixel->column + 1) - (int)frame->width);
        down[lane] = (real)((int)(2 * pixel->row + 1) - (int)frame->height);
        spent->rays += 1;
#if SPREAD
        if (REFINES(work)) {
            spent->dropped = 0;
            spent->spare = frame->spare;
        }
#endif
        paths->weight[lane] = 1;
        paths->bounces[lane] = frame->raydepth;
        for (uint component = 0; component < 3; ++component)
            paths->colour[component][lane] = 0;
#if BRANCHING
        paths->count[lane] = 0;
#endif
    }
    if (begun != 0) {
        Rays eye = camera_rays(frame, get(across), get(down), get(right_of), get(below));
        take_over(rays, begun, &eye);
    }
    return begun;
}

/* Follows all rays of a work-item's pixels. */
void trace_pixels(Work *work) {
    const Scene *scene = work->scene;
    Pixel pixels[LANES];
    Paths paths;
    Rays rays;
    no_rays(&rays);
    for (uint lane = 0; lane < LANES; ++lane) {
        paths.weight[lane] = 0;
        for (uint component = 0; component < 3; ++component)
            paths.colour[component][lane] = 0;
    }
    uint busy = 0, open = 0;
    for (;;) {
        uint begun = begin_rays(work, ALL_LANES & ~open, pixels, &paths, &rays, &busy);
        open |= begun;
        if (open == 0)
            return;
        Hits hits;
        first_crossings(scene, &rays, open, &hits);
        for (uint set = begun; set != 0; set = rest_of(set)) {
            uint lane = first_of(set), leaf = hits.leaf[lane];
            if (pixels[lane].sample != 0 || REFINES(work))
                continue;
            pixels[lane].solid = leaf == NOTHING ? NOTHING : scene->leaves[leaf].solid;
#if DISTANCES
            work->outcomes[pixels[lane].place].distance = hits.distance[lane];
#endif
        }
        uint going = go_on(scene, &rays, open, &hits, &paths);
        for (uint set = open & ~going; set != 0; set = rest_of(set)) {
            uint lane = first_of(set);
            real colour[3] = {paths.colour[0][lane], paths.colour[1][lane], paths.colour[2][lane]};
            end_point(work, pixels + lane, paths.spent + lane, colour);
        }
        open = going;
    }
}

/* Traces a tile of the window, row by row in `outcomes`: the samples from `first` up to, not including, `end` of its pixels.
   What the samples before them came to is in `outcomes`; after the last ones the means are. */
__kernel void trace(SCENE_PARAMETERS, __global Outcome *outcomes, __global Sampled *sums, uint tile_column,
                    uint tile_row, uint columns, uint rows, uint first, uint end) {
    Scene scene = scene_of(SCENE_ARGUMENTS);
    Work work = new_work(&scene, outcomes, sums, tile_column, tile_row, columns, rows, first, end);
    trace_pixels(&work);
}

#if SPREAD
/* Goes on with some pixels, which are numbered row by row within the window: their samples from `first` up to, not including,
   `end`, until the rays of a pixel run out; before all of them its sides, if they are asked for. The pixels are laid out in rows
   of `width`, of which a tile is run. */
__kernel void refine(SCENE_PARAMETERS, __global Outcome *outcomes, __global Sampled *sums, __global const uint *pixels,
                     uint sides, uint count, uint width, uint tile_column, uint tile_row, uint columns, uint rows, uint first,
                     uint end) {
    Scene scene = scene_of(SCENE_ARGUMENTS);
    Work work = new_work(&scene, outcomes, sums, tile_column, tile_row, columns, rows, first, end);
    work.pixels = pixels;
    work.count = count;
    work.width = width;
    work.sides = sides;
    trace_pixels(&work);
}
#endif
