/* What a surface sends towards the ray by itself: Phong's model with shadows, and the sky. */

Vector background(const Scene *scene, Vector direction) {
    real high = (direction.y + (real)1) / (real)2;
    Vector nadir = load(scene->frame->nadir), zenith = load(scene->frame->zenith);
    return vector(((real)1 - high) * nadir.x + high * zenith.x, ((real)1 - high) * nadir.y + high * zenith.y,
                  ((real)1 - high) * nadir.z + high * zenith.z);
}

#if LIGHTS && HIGHLIGHTS
/* max(0, R.V)^s as exp(s log1p(-|R - V|^2 / 2)): R.V itself has lost the digits that a large exponent asks for. */
real phong(real shiny, const Ray *ray, Vector normal, Vector towards, real cosine) {
    if (shiny == 0)
        return 1;
    Vector mirrored = scale_add(normal, cosine + cosine, negated(towards));
    Vector gap = add(ray->direction, mirrored);
    real apart = inner(gap, gap) / (real)2;
    return apart >= 1 ? (real)0 : exp(shiny * log1p(-apart));
}
#endif

/* Ambient, diffuse and highlights at a contact of `ray`; counts the rays towards lights. */
Vector local_colour(const Scene *scene, __global const Material *material, const Ray *ray, const Contact *contact,
                    uint *shadows) {
    Vector colour = load(material->colour), ambient = load(scene->frame->ambient);
    Vector sum = vector(material->ambient * colour.x * ambient.x, material->ambient * colour.y * ambient.y,
                        material->ambient * colour.z * ambient.z);
#if LIGHTS
    for (uint i = 0; i < scene->frame->lights; ++i) {
        __global const Light *light = scene->lights + i;
        Vector way = subtract(load(light->position), contact->point);
        /* Scaled before it is squared: a far light's square would overflow. */
        real largest = fmax(fmax(fabs(way.x), fabs(way.y)), fabs(way.z));
        if (largest == 0)
            continue;
        way = scale(way, (real)1 / largest);
        real length_scaled = sqrt(inner(way, way));
        Vector towards = scale(way, (real)1 / length_scaled);
        real cosine = inner(contact->normal, towards);
        if (cosine <= 0)
            continue;
        Ray shadow = ray_from(contact, towards, false, ray->inside);
#if TOUCHES
        shadow.end = length_scaled * largest;
        shadow.touches = scene->touches + light->touches;
        shadow.touches_end = scene->touches + light->touches_end;
#endif
        *shadows += 1;
        if (blocked(scene, &shadow, length_scaled * largest))
            continue;
        real diffuse = material->diffuse * cosine;
        real highlight = 0;
#if HIGHLIGHTS
        if (material->specular != 0)
            highlight = material->specular * phong(material->shiny, ray, contact->normal, towards, cosine);
#endif
        sum.x = sum.x + (diffuse * colour.x + highlight) * light->colour[0];
        sum.y = sum.y + (diffuse * colour.y + highlight) * light->colour[1];
        sum.z = sum.z + (diffuse * colour.z + highlight) * light->colour[2];
    }
#endif
    return sum;
}
