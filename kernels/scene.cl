/* What every part of the tracer reads, and the ray. */

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

/* A half-line of unit direction, with what is known exactly about its start: the class of the surface that it starts on
   (NOTHING for the eye); its place there, on the unit sphere of a ball or ellipsoid, or the plane's normal on the ray's
   side; and whether it runs into the ball or ellipsoid, by the kind of crossing that sent it. */
typedef struct {
    Vector origin;
    Vector direction;
    Vector place;
    uint class;
    bool into;
    bool inside;
#if TOUCHES
    /* The light that it runs to, if that lies on surfaces. */
    real end;
    __global const Touch *touches, *touches_end;
#endif
} Ray;
