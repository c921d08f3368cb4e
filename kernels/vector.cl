/* Three numbers, lane by lane. */

typedef struct {
    reals x, y, z;
} Vector;

Vector vector(reals x, reals y, reals z) {
    Vector v;
    v.x = x;
    v.y = y;
    v.z = z;
    return v;
}

/* The same in every lane. */
Vector load(__global const real *v) { return vector(spread(v[0]), spread(v[1]), spread(v[2])); }

/* Of every lane its own. */
Vector get3(const real (*v)[LANES]) { return vector(get(v[0]), get(v[1]), get(v[2])); }

void put3(Vector v, real (*to)[LANES]) {
    put(v.x, to[0]);
    put(v.y, to[1]);
    put(v.z, to[2]);
}

Vector choose3(uint set, Vector in, Vector out) {
    return vector(choose(set, in.x, out.x), choose(set, in.y, out.y), choose(set, in.z, out.z));
}

Vector add(Vector a, Vector b) { return vector(a.x + b.x, a.y + b.y, a.z + b.z); }

Vector subtract(Vector a, Vector b) { return vector(a.x - b.x, a.y - b.y, a.z - b.z); }

Vector scale(Vector a, reals by) { return vector(a.x * by, a.y * by, a.z * by); }

Vector negated(Vector a) { return vector(-a.x, -a.y, -a.z); }

/* a * by + b, each component rounded once. */
Vector scale_add(Vector a, reals by, Vector b) {
    return vector(fma(a.x, by, b.x), fma(a.y, by, b.y), fma(a.z, by, b.z));
}

reals inner(Vector a, Vector b) { return fma(a.x, b.x, fma(a.y, b.y, a.z * b.z)); }

Vector unit(Vector a) { return scale(a, spread((real)1) / sqrt(inner(a, a))); }
