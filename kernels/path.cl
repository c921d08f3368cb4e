/* The trees of rays behind samples: Whitted's recursion as a loop over a bounded stack, one for each lane. */

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

/* A ray that waits until its lane has followed another, with what its colour is multiplied by on the way to the sample, and how
   often it may still bounce. */
typedef struct {
    real origin[3], direction[3], place[3];
    real weight;
    uint class, bounces;
    bool into, inside;
} Branch;

/* What lanes know of the samples that their rays belong to. */
typedef struct {
    /* Of the rays that are followed now. */
    real weight[LANES];
    uint bounces[LANES];
    /* What the samples come to so far, and what their pixels took. */
    real colour[3][LANES];
    Spent spent[LANES];
#if BRANCHING
    uint count[LANES];
    Branch waiting[LANES][WAITING];
#endif
} Paths;

#if REFLECTIONS
Vector reflected(Vector direction, Vector normal) {
    reals towards = inner(direction, normal);
    return unit(scale_add(normal, -(towards + towards), direction));
}

/* Whether a branch of a lane's ray is worth following and the pixel has rays left; tells its weight if so. */
bool spawn(const Scene *scene, Paths *paths, uint lane, real share, real *weight) {
    Spent *spent = paths->spent + lane;
    *weight = paths->weight[lane] * share;
    real most = fabs(*weight) * scene->reach[paths->bounces[lane] - 1];
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
    return true;
}
#endif

#if REFRACTIONS
/* Snell's law in tangential and normal parts; which rays are not totally reflected. The tangential part is a difference that is
   small near the perpendicular, where 1 - cos^2 would have no digits left. */
uint refracted(reals index, const Rays *rays, Vector normal, Vector *direction) {
    reals zero = spread((real)0), one = spread((real)1);
    Vector before = get3(rays->direction);
    Vector tangent = scale_add(normal, -inner(normal, before), before);
    Vector bent = scale(tangent, choose(rays->inside, index, one / index));
    reals rest = one - inner(bent, bent);
    uint straight = set_of(index == zero);
    *direction = choose3(straight, negated(normal), unit(scale_add(normal, -sqrt(rest), bent)));
    return (straight & (rays->inside | set_of(inner(tangent, tangent) == zero))) | (~straight & set_of(rest >= zero));
}
#endif

#if BRANCHING
void wait(Paths *paths, uint lane, const Rays *rays, real weight) {
    Branch *branch = paths->waiting[lane] + paths->count[lane]++;
    for (uint i = 0; i < 3; ++i) {
        branch->origin[i] = rays->origin[i][lane];
        branch->direction[i] = rays->direction[i][lane];
        branch->place[i] = rays->place[i][lane];
    }
    branch->weight = weight;
    branch->class = rays->class[lane];
    branch->bounces = paths->bounces[lane] - 1;
    branch->into = has(rays->into, lane);
    branch->inside = has(rays->inside, lane);
}

void resume(Paths *paths, uint lane, Rays *rays) {
    const Branch *branch = paths->waiting[lane] + --paths->count[lane];
    for (uint i = 0; i < 3; ++i) {
        rays->origin[i][lane] = branch->origin[i];
        rays->direction[i][lane] = branch->direction[i];
        rays->place[i][lane] = branch->place[i];
    }
    paths->weight[lane] = branch->weight;
    rays->class[lane] = branch->class;
    paths->bounces[lane] = branch->bounces;
    rays->into = with(rays->into, lane, branch->into);
    rays->inside = with(rays->inside, lane, branch->inside);
}
#endif

#if REFLECTIONS
/* Goes on from contacts to the rays that they send out; which lanes have one to follow. */
uint bounce(const Scene *scene, Rays *rays, uint lanes, const Contacts *contacts, const Materials *materials, Paths *paths) {
    uint mirror = 0, through = 0;
    real mirrored[LANES], weight[LANES];
#if REFRACTIONS
    Vector bent;
    uint passing = refracted(get(materials->index), rays, contacts->normal, &bent);
#endif
    for (uint set = lanes; set != 0; set = rest_of(set)) {
        uint lane = first_of(set);
        if (paths->bounces[lane] == 0)
            continue;
        real share = materials->reflect[lane];
#if REFRACTIONS
        real refract = materials->refract[lane];
        if (refract != 0 && !has(passing, lane))
            share += refract;
#endif
        if (share != 0)
            mirror |= (uint)spawn(scene, paths, lane, share, mirrored + lane) << lane;
#if REFRACTIONS
        if (refract != 0 && has(passing, lane))
            through |= (uint)spawn(scene, paths, lane, refract, weight + lane) << lane;
#endif
        paths->spent[lane].reflected += has(mirror, lane);
        paths->spent[lane].refracted += has(through, lane);
    }
    if (mirror != 0) {
        Rays next = rays_from(contacts, reflected(get3(rays->direction), contacts->normal), false, rays->inside);
#if BRANCHING
        for (uint set = mirror & through; set != 0; set = rest_of(set))
            wait(paths, first_of(set), &next, mirrored[first_of(set)]);
#endif
        take_over(rays, mirror & ~through, &next);
    }
#if REFRACTIONS
    if (through != 0) {
        Rays next = rays_from(contacts, bent, true, ~rays->inside);
        take_over(rays, through, &next);
    }
#endif
    for (uint set = mirror | through; set != 0; set = rest_of(set)) {
        uint lane = first_of(set);
        paths->weight[lane] = has(through, lane) ? weight[lane] : mirrored[lane];
        paths->bounces[lane] -= 1;
    }
    return mirror | through;
}
#endif

/* Adds what rays bring to their samples, and goes on to the next ray of each; which lanes have one. */
uint go_on(const Scene *scene, Rays *rays, uint lanes, const Hits *hits, Paths *paths) {
    uint met = lanes & met_by(hits), going = 0;
    Contacts contacts;
    Materials materials;
    Vector brought = background(scene, get3(rays->direction)), colour = get3(paths->colour);
    if (met != 0) {
        contacts = contacts_of(scene, rays, hits, met);
        materials = materials_at(scene, hits, met);
        uint asked[LANES];
        brought = choose3(met, local_colours(scene, &materials, rays, &contacts, met, asked), brought);
        for (uint set = met; set != 0; set = rest_of(set))
            paths->spent[first_of(set)].shadow += asked[first_of(set)];
    }
    put3(choose3(lanes, scale_add(brought, get(paths->weight), colour), colour), paths->colour);
#if REFLECTIONS
    if (met != 0)
        going = bounce(scene, rays, met, &contacts, &materials, paths);
#endif
#if BRANCHING
    for (uint set = lanes & ~going; set != 0; set = rest_of(set)) {
        uint lane = first_of(set);
        if (paths->count[lane] > 0) {
            resume(paths, lane, rays);
            going |= 1u << lane;
        }
    }
#endif
    return going;
}
