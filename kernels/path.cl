/* The tree of rays behind one sample: Whitted's recursion as a loop over a bounded stack. */

/* A ray with what its colour is multiplied by on the way to the sample, and how often it may still bounce. */
typedef struct {
    Ray ray;
    real weight;
    uint bounces;
} Branch;

typedef struct {
    uint rays;
    real dropped;
#if SPREAD
    /* What may still be dropped for being faint. */
    real spare;
#endif
    bool over;
    uint shadow, reflected, refracted;
} Spent;

/* The branch to follow after a hit, if any, and one that waits, if any. */
typedef struct {
    Branch next, other;
    bool has_next, has_other;
} Bounce;

#if REFLECTIONS
Vector reflected(Vector direction, Vector normal) {
    real towards = inner(direction, normal);
    return unit(scale_add(normal, -(towards + towards), direction));
}

/* Whether the branch is worth following and the pixel has rays left; fills it in if so. */
bool spawn(const Scene *scene, const Branch *parent, Ray ray, real share, Spent *spent, Branch *branch) {
    branch->weight = parent->weight * share;
    branch->bounces = parent->bounces - 1;
    real most = fabs(branch->weight) * scene->reach[branch->bounces];
#if SPREAD
    bool faint = most < scene->frame->cutoff && most <= spent->spare;
    if (faint)
        spent->spare -= most;
#else
    bool faint = most < scene->frame->cutoff;
#endif
    if (faint) {
        spent->dropped += most;
        return false;
    }
    if (spent->rays >= scene->frame->ray_budget) {
        spent->dropped += most;
        spent->over = true;
        return false;
    }
    spent->rays += 1;
    branch->ray = ray;
    return true;
}
#endif

#if REFRACTIONS
/* Snell's law in tangential and normal parts; false at total reflection. The tangential part is a difference that is small
   near the perpendicular, where 1 - cos^2 would have no digits left. */
bool refracted(real index, const Ray *ray, Vector normal, Vector *direction) {
    real cosine = -inner(normal, ray->direction);
    Vector tangent = scale_add(normal, cosine, ray->direction);
    if (index == 0) {
        *direction = negated(normal);
        return ray->inside || inner(tangent, tangent) == 0;
    }
    real ratio = ray->inside ? index : (real)1 / index;
    Vector bent = scale(tangent, ratio);
    real rest = (real)1 - inner(bent, bent);
    if (!(rest >= 0))
        return false;
    *direction = unit(scale_add(normal, -sqrt(rest), bent));
    return true;
}
#endif

/* Adds what the surface itself sends, and finds the rays to follow. */
Bounce bounce(const Scene *scene, const Branch *branch, Hit hit, Vector *colour, Spent *spent) {
    Bounce result;
    result.has_next = false;
    result.has_other = false;
    const Ray *ray = &branch->ray;
    Leaf leaf = scene->leaves[hit.leaf];
    __global const Material *material = scene->materials + leaf.material;
    Contact at = contact(scene->shapes + leaf.shape, ray, hit.distance, hit.leaving);
    Vector own = local_colour(scene, material, ray, &at, &spent->shadow);
    *colour = scale_add(own, branch->weight, *colour);
#if REFLECTIONS
    if (branch->bounces == 0)
        return result;
    real mirrored = material->reflect;
#if REFRACTIONS
    Vector direction;
    bool through = false;
    if (material->refract != 0) {
        through = refracted(material->index, ray, at.normal, &direction);
        if (!through)
            mirrored += material->refract;
    }
#endif
    bool mirror = false;
    if (mirrored != 0)
        mirror = spawn(scene, branch, ray_from(&at, reflected(ray->direction, at.normal), false, ray->inside), mirrored,
                       spent, &result.other);
    spent->reflected += mirror;
#if REFRACTIONS
    if (through)
        through = spawn(scene, branch, ray_from(&at, direction, true, !ray->inside), material->refract, spent,
                        &result.next);
    spent->refracted += through;
    result.has_next = through;
#endif
    if (mirror && !result.has_next) {
        result.next = result.other;
        result.has_next = true;
    } else {
        result.has_other = mirror;
    }
#endif
    return result;
}

/* The colour that a ray from the eye brings back, and what it hits first. */
Vector walk(const Scene *scene, Ray ray, Spent *spent, Hit *first) {
    Vector colour = vector(0, 0, 0);
    Branch branch;
    branch.ray = ray;
    branch.weight = 1;
    branch.bounces = scene->frame->raydepth;
    bool primary = true;
#if BRANCHING
    Branch waiting[WAITING];
    uint count = 0;
#endif
    for (;;) {
        Hit hit = first_crossing(scene, &branch.ray);
        if (primary)
            *first = hit;
        primary = false;
        if (hit.leaf != NOTHING) {
            Bounce after = bounce(scene, &branch, hit, &colour, spent);
#if BRANCHING
            if (after.has_other)
                waiting[count++] = after.other;
#endif
            if (after.has_next) {
                branch = after.next;
                continue;
            }
        } else {
            colour = scale_add(background(scene, branch.ray.direction), branch.weight, colour);
        }
#if BRANCHING
        if (count > 0) {
            branch = waiting[--count];
            continue;
        }
#endif
        return colour;
    }
}
