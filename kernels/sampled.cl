/* What the samples of one pixel add up to, in blocks of samples that follow one another: the blocks are as many as the
   arrays have places, and two become one when all are full. */

#if SPREAD
#define BLOCKS 16

void begin(__global Sampled *sampled) {
    for (uint block = 0; block < BLOCKS; ++block)
        sampled->red[block] = sampled->green[block] = sampled->blue[block] = 0;
    for (uint i = 0; i < 3; ++i) {
        sampled->lost[i] = 0;
        sampled->low[i] = INFINITY;
        sampled->high[i] = -INFINITY;
    }
    sampled->dropped = 0;
    sampled->count = sampled->whole = sampled->filled = 0;
    sampled->size = 1;
}

/* Two blocks become one. */
void merge(__global real *blocks) {
    for (uint block = 0; block < BLOCKS / 2; ++block)
        blocks[block] = blocks[2 * block] + blocks[2 * block + 1];
    for (uint block = BLOCKS / 2; block < BLOCKS; ++block)
        blocks[block] = 0;
}

/* Adds to a block, which may hold thousands of samples, and keeps what the rounding takes (Kahan 1965). */
void add_to(__global Sampled *sampled, __global real *blocks, uint component, real value) {
    __global real *block = blocks + sampled->whole;
    real before = *block, more = value - sampled->lost[component];
    *block = before + more;
    sampled->lost[component] = (*block - before) - more;
}

void widen(__global Sampled *sampled, uint component, real value) {
    sampled->low[component] = fmin(sampled->low[component], value);
    sampled->high[component] = fmax(sampled->high[component], value);
}

/* Widens the range by a colour that is no sample. */
void see(__global Sampled *sampled, const real *colour) {
    for (uint component = 0; component < 3; ++component)
        widen(sampled, component, colour[component]);
}

/* Adds one sample, and the most that its dropped branches could have added to it. */
void take(__global Sampled *sampled, const real *colour, real dropped) {
    see(sampled, colour);
    add_to(sampled, sampled->red, 0, colour[0]);
    add_to(sampled, sampled->green, 1, colour[1]);
    add_to(sampled, sampled->blue, 2, colour[2]);
    sampled->dropped += dropped;
    sampled->count += 1;
    sampled->filled += 1;
    if (sampled->filled < sampled->size)
        return;
    sampled->filled = 0;
    sampled->whole += 1;
    sampled->lost[0] = sampled->lost[1] = sampled->lost[2] = 0;
    if (sampled->whole == BLOCKS) {
        merge(sampled->red);
        merge(sampled->green);
        merge(sampled->blue);
        sampled->whole = BLOCKS / 2;
        sampled->size *= 2;
    }
}
#endif
