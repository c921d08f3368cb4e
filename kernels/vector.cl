/* Three numbers, as scalars: a vector type's unused lane can hold denormals, and compilers vectorise across work-items only
   without it. */

typedef struct {
    real x, y, z;
} Vector;

Vector vector(real x, real y, real z) {
    Vector v;
    v.x = x;
    v.y = y;
    v.z = z;
    return v;
}

Vector load(__global const real *v) { return vector(v[0], v[1], v[2]); }

Vector add(Vector a, Vector b) { return vector(a.x + b.x, a.y + b.y, a.z + b.z); }

Vector subtract(Vector a, Vector b) { return vector(a.x - b.x, a.y - b.y, a.z - b.z); }

Vector scale(Vector a, real by) { return vector(a.x * by, a.y * by, a.z * by); }

Vector negated(Vector a) { return vector(-a.x, -a.y, -a.z); }

/* a * by + b, each component rounded once. */
Vector scale_add(Vector a, real by, Vector b) {
    return vector(fma(a.x, by, b.x), fma(a.y, by, b.y), fma(a.z, by, b.z));
}

real inner(Vector a, Vector b) { return fma(a.x, b.x, fma(a.y, b.y, a.z * b.z)); }

Vector unit(Vector a) { return scale(a, (real)1 / sqrt(inner(a, a))); }

/* Rows times vector. */
Vector rows(__global const real *m, Vector v) {
    return vector(inner(load(m), v), inner(load(m + 3), v), inner(load(m + 6), v));
}

/* Columns times vector: the transpose of the rows. */
Vector columns(__global const real *m, Vector v) {
    return vector(inner(vector(m[0], m[3], m[6]), v), inner(vector(m[1], m[4], m[7]), v),
                  inner(vector(m[2], m[5], m[8]), v));
}
