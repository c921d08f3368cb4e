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

/* Traces a tile of the window, row by row in `outcomes`: the samples from `first` up to, not including, `end` of its pixels.
   What the samples before them came to is in `outcomes`; after the last ones the means are. */
__kernel void trace(__global const Frame *frame, __global const Shape *shapes, __global const Leaf *leaves,
                    __global const Island *islands, __global const Cell *cells, __global const uint *program,
                    __global const uint *members, __global const Node *nodes, __global const Material *materials, __global const Light *lights,
                    __global const Touch *touches, __global const real *samples, __global const real *reach, __global Outcome *outcomes,
                    uint tile_column, uint tile_row, uint columns, uint rows, uint first, uint end) {
    if (get_global_id(0) >= columns || get_global_id(1) >= rows)
        return;
    __global Outcome *outcome = outcomes + get_global_id(1) * columns + get_global_id(0);
    uint column = frame->window_x + tile_column + get_global_id(0);
    uint row = frame->window_y + tile_row + get_global_id(1);
    Scene scene;
    scene.frame = frame;
    scene.shapes = shapes;
    scene.leaves = leaves;
    scene.islands = islands;
    scene.cells = cells;
    scene.program = program;
    scene.members = members;
    scene.nodes = nodes;
    scene.materials = materials;
    scene.lights = lights;
#if TOUCHES
    scene.touches = touches;
#endif
    scene.samples = samples;
    scene.reach = reach;

    Spent spent;
    spent.rays = 0;
    spent.dropped = 0;
    spent.over = false;
    spent.shadow = spent.reflected = spent.refracted = 0;
    Vector sum = vector(0, 0, 0);
    uint solid = NOTHING, primary = 0;
#if SUPERSAMPLING
    if (first > 0) {
        sum = load(outcome->colour);
        spent.dropped = outcome->dropped;
        solid = outcome->solid;
        primary = outcome->primary;
        spent.shadow = outcome->shadow;
        spent.reflected = outcome->reflected;
        spent.refracted = outcome->refracted;
        spent.over = outcome->over;
        spent.rays = primary + spent.reflected + spent.refracted;
    }
#endif
    for (uint k = first; k < end; ++k) {
        if (spent.rays >= frame->ray_budget) {
            spent.dropped += reach[frame->raydepth];
            spent.over = true;
            continue;
        }
        spent.rays += 1;
        primary += 1;
        Hit hit;
        Ray ray = camera_ray(frame, column, row, samples[2 * k], samples[2 * k + 1]);
        sum = add(sum, walk(&scene, ray, &spent, &hit));
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
    outcome->dropped = spent.dropped;
    outcome->solid = solid;
    outcome->primary = primary;
    outcome->shadow = spent.shadow;
    outcome->reflected = spent.reflected;
    outcome->refracted = spent.refracted;
    outcome->over = spent.over;
}
