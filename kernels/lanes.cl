/* How many rays a work-item follows side by side, each in its lane: eight on a processor, whose compilers make vectors of
   nothing else; one on a GPU, which makes its own of neighbouring work-items.

   What is written over `reals` serves both. A set of lanes has a bit for each. */

#if EIGHTS
#define LANES 8
#if DOUBLES
typedef double8 reals;
typedef long8 truths;
#define to_reals convert_double8
#define to_truths convert_long8
#define set_of set_of_longs
#else
typedef float8 reals;
typedef int8 truths;
#define to_reals convert_float8
#define to_truths(ints) (ints)
#define set_of set_of_ints
#endif
#define spread(number) ((reals)(number))
#define get(numbers) vload8(0, numbers)
#define put(values, numbers) vstore8(values, 0, numbers)

#if defined(__clang__) && defined(__AVX__)
/* The signs of singles and doubles are what these processors have an instruction for. */
uint set_of_ints(int8 holds) { return __builtin_ia32_movmskps256(as_float8(holds)); }

uint set_of_longs(long8 holds) {
    return __builtin_ia32_movmskpd256(as_double4(holds.lo)) | __builtin_ia32_movmskpd256(as_double4(holds.hi)) << 4;
}
#else
uint set_of_ints(int8 holds) {
    int8 bits = holds & (int8)(1, 2, 4, 8, 16, 32, 64, 128);
    int4 four = bits.lo | bits.hi;
    int2 two = four.lo | four.hi;
    return two.x | two.y;
}

uint set_of_longs(long8 holds) { return set_of_ints(convert_int8(holds)); }
#endif

truths truths_of(uint set) { return to_truths(((int8)((int)set) & (int8)(1, 2, 4, 8, 16, 32, 64, 128)) != 0); }

reals choose(uint set, reals in, reals out) { return select(out, in, truths_of(set)); }

/* The lanes with this number. */
uint equal(const uint *numbers, uint number) { return set_of_ints(vload8(0, numbers) == number); }

uint equal_lanes(const uint *numbers, const uint *others) { return set_of_ints(vload8(0, numbers) == vload8(0, others)); }

/* The first lane of a set that has one. */
uint first_of(uint set) { return popcount(~set & (set - 1)); }
#else
#define LANES 1
typedef real reals;
#define spread(number) (number)
#define get(numbers) (*(numbers))
#define put(values, numbers) (*(numbers) = (values))
#define set_of(holds) ((uint)(holds))
#define choose(set, in, out) ((set) != 0 ? (in) : (out))

uint equal(const uint *numbers, uint number) { return *numbers == number; }

uint equal_lanes(const uint *numbers, const uint *others) { return *numbers == *others; }

#define first_of(set) 0u
#endif

#define ALL_LANES ((1u << LANES) - 1)

/* Without its first lane. */
#define rest_of(set) ((set) & ((set) - 1))

bool has(uint set, uint lane) { return set >> lane & 1; }

uint with(uint set, uint lane, bool in) { return (set & ~(1u << lane)) | (uint)in << lane; }
