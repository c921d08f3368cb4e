/* What every part of the tracer reads, and rays. */

#define NOTHING UINT_MAX
#define ROUNDOFF (REAL_EPSILON / (real)2)
/* 1 + 2 gamma(3), rounded up: what the three roundings of a box distance can be worth. */
#define SLACK ((real)1 + (real)8 * ROUNDOFF)

typedef struct {
    __global const Frame *frame;
    __global const Shape *shapes;
    __global const Leaf *leaves;
    __global const Island *islands;
    __global const Cell *cells;
    __global const uint *program;
    __global const uint *members;
#if EIGHTS
    __global const WideNode *wide;
    __global const Block *blocks;
    __global const uint *runs;
    __global const uint *starts;
    uint starts_count;
#else
    __global const Node *nodes;
#endif
    __global const Material *materials;
    __global const Light *lights;
#if TOUCHES
    __global const Touch *touches;
#endif
    __global const real *samples;
    __global const real *reach;
} Scene;

/* Half-lines of unit direction, with what is known exactly about their starts: the class of the surface that one starts on
   (NOTHING for the eye); its place there, on the unit sphere of a ball or ellipsoid, or the plane's normal on the ray's
   side; and whether it runs into the ball or ellipsoid, by the kind of crossing that sent it. Three numbers of all lanes
   stand axis by axis. */
typedef struct {
    real origin[3][LANES];
    real direction[3][LANES];
    real place[3][LANES];
    uint class[LANES];
    /* Sets of lanes. */
    uint into, inside;
#if TOUCHES
    /* The light that all run to, if that lies on surfaces. */
    real end[LANES];
    __global const Touch *touches, *touches_end;
#endif
} Rays;

void without_end(Rays *rays) {
#if TOUCHES
    put(spread((real)INFINITY), rays->end);
    rays->touches = rays->touches_end = 0;
#endif
}

/* Rays of which there are none yet. */
void no_rays(Rays *rays) {
    Vector zero = vector(spread((real)0), spread((real)0), spread((real)0));
    put3(zero, rays->origin);
    put3(zero, rays->direction);
    put3(zero, rays->place);
    for (uint lane = 0; lane < LANES; ++lane)
        rays->class[lane] = NOTHING;
    rays->into = rays->inside = 0;
    without_end(rays);
}

/* Puts some other rays in the place of those in their lanes. */
void take_over(Rays *rays, uint lanes, const Rays *others) {
    put3(choose3(lanes, get3(others->origin), get3(rays->origin)), rays->origin);
    put3(choose3(lanes, get3(others->direction), get3(rays->direction)), rays->direction);
    put3(choose3(lanes, get3(others->place), get3(rays->place)), rays->place);
    for (uint lane = 0; lane < LANES; ++lane)
        rays->class[lane] = has(lanes, lane) ? others->class[lane] : rays->class[lane];
    rays->into = (rays->into & ~lanes) | (others->into & lanes);
    rays->inside = (rays->inside & ~lanes) | (others->inside & lanes);
}
