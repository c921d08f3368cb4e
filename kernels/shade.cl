/* What surfaces send towards rays by themselves: Phong's model with shadows, and the sky. */

/* What rays have met is made of, each in its lane; idle lanes have what another has. */
typedef struct {
    real ambient[LANES], diffuse[LANES], specular[LANES], reflect[LANES], refract[LANES], index[LANES], shiny[LANES];
    real colour[3][LANES];
} Materials;

Materials materials_at(const Scene *scene, const Hits *hits, uint lanes) {
    Materials all;
    for (uint lane = 0; lane < LANES; ++lane) {
        uint leaf = hits->leaf[has(lanes, lane) ? lane : first_of(lanes)];
        __global const Material *material = scene->materials + scene->leaves[leaf].material;
        all.ambient[lane] = material->ambient;
        all.diffuse[lane] = material->diffuse;
        all.specular[lane] = material->specular;
        all.reflect[lane] = material->reflect;
        all.refract[lane] = material->refract;
        all.index[lane] = material->index;
        all.shiny[lane] = material->shiny;
        for (uint i = 0; i < 3; ++i)
            all.colour[i][lane] = material->colour[i];
    }
    return all;
}

Vector background(const Scene *scene, Vector direction) {
    reals high = (direction.y + (real)1) / (real)2, low = (real)1 - high;
    Vector nadir = load(scene->frame->nadir), zenith = load(scene->frame->zenith);
    return vector(low * nadir.x + high * zenith.x, low * nadir.y + high * zenith.y, low * nadir.z + high * zenith.z);
}

#if LIGHTS
/* A light as seen from contacts: which way it is and how far, and the cosine between that and the normal. */
typedef struct {
    Vector towards;
    reals far, cosine;
    /* The contacts that it may shine on. */
    uint lanes;
} Sight;

Sight sight_of(__global const Light *light, const Contacts *contacts, uint lanes) {
    Sight sight;
    Vector way = subtract(load(light->position), contacts->point);
    /* Scaled before it is squared: a far light's square would overflow. */
    reals largest = fmax(fmax(fabs(way.x), fabs(way.y)), fabs(way.z));
    way = scale(way, spread((real)1) / largest);
    reals length_scaled = sqrt(inner(way, way));
    sight.towards = scale(way, spread((real)1) / length_scaled);
    sight.far = length_scaled * largest;
    sight.cosine = inner(contacts->normal, sight.towards);
    reals zero = spread((real)0);
    /* A light at the contact itself has no direction. */
    sight.lanes = lanes & set_of(largest != zero) & ~set_of(sight.cosine <= zero);
    return sight;
}
#endif

#if LIGHTS && HIGHLIGHTS
/* max(0, R.V)^s as exp(s log1p(-|R - V|^2 / 2)): R.V itself has lost the digits that a large exponent asks for. Powers are taken
   one by one, since a library may round its vectors otherwise. */
reals phong(const Materials *materials, const Rays *rays, const Contacts *contacts, const Sight *sight, uint lanes) {
    reals cosine = sight->cosine;
    Vector mirrored = scale_add(contacts->normal, cosine + cosine, negated(sight->towards));
    Vector gap = add(get3(rays->direction), mirrored);
    real apart[LANES], power[LANES];
    put(inner(gap, gap) / (real)2, apart);
    put(spread((real)0), power);
    for (; lanes != 0; lanes = rest_of(lanes)) {
        uint lane = first_of(lanes);
        real shiny = materials->shiny[lane];
        if (shiny == 0)
            power[lane] = 1;
        else if (!(apart[lane] >= 1))
            power[lane] = exp(shiny * log1p(-apart[lane]));
    }
    return get(power);
}
#endif

/* Ambient, diffuse and highlights at contacts of rays; tells `asked` how many rays went towards lights, lane by lane. */
Vector local_colours(const Scene *scene, const Materials *materials, const Rays *rays, const Contacts *contacts, uint lanes,
                     uint *asked) {
    Vector colour = get3(materials->colour), ambient = load(scene->frame->ambient);
    reals share = get(materials->ambient);
    Vector sum = vector(share * colour.x * ambient.x, share * colour.y * ambient.y, share * colour.z * ambient.z);
    for (uint lane = 0; lane < LANES; ++lane)
        asked[lane] = 0;
#if LIGHTS
    for (uint i = 0; i < scene->frame->lights; ++i) {
        __global const Light *light = scene->lights + i;
        Sight sight = sight_of(light, contacts, lanes);
        if (sight.lanes == 0)
            continue;
        Rays shadows = rays_from(contacts, sight.towards, false, rays->inside);
#if TOUCHES
        put(sight.far, shadows.end);
        shadows.touches = scene->touches + light->touches;
        shadows.touches_end = scene->touches + light->touches_end;
#endif
        for (uint lane = 0; lane < LANES; ++lane)
            asked[lane] += has(sight.lanes, lane);
        uint lit = sight.lanes & ~blocked(scene, &shadows, sight.lanes, sight.far);
        if (lit == 0)
            continue;
        reals diffuse = get(materials->diffuse) * sight.cosine, highlight = spread((real)0);
#if HIGHLIGHTS
        reals specular = get(materials->specular);
        uint shining = lit & set_of(specular != spread((real)0));
        if (shining != 0)
            highlight = choose(shining, specular * phong(materials, rays, contacts, &sight, shining), highlight);
#endif
        sum.x = choose(lit, sum.x + (diffuse * colour.x + highlight) * light->colour[0], sum.x);
        sum.y = choose(lit, sum.y + (diffuse * colour.y + highlight) * light->colour[1], sum.y);
        sum.z = choose(lit, sum.z + (diffuse * colour.z + highlight) * light->colour[2], sum.z);
    }
#endif
    return sum;
}
