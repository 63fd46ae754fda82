/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Arrays in the layouts that callers have, and what they hold afterwards: shared by the tests of
 * the array calls and of the wavefront calls. Included once for each precision, with REAL, and
 * FN(name) that adds the suffix.
 */

/* Numbers in memory of exactly the size that is needed, so that a sanitizer sees every step
   beyond it: separate arrays, records, records backwards, or one value for all. */
struct FN(array) {
    REAL *memory, *first;
    int components, layout;
    size_t count;
    ptrdiff_t stride, apart; /* bytes from element to element, numbers between components */
};

enum { FN(SEPARATE), FN(RECORDS), FN(BACKWARDS), FN(REPEATED), FN(LAYOUTS) };

static void FN(array_make)(struct FN(array) *a, int components, size_t count, int layout)
{
    size_t stored = layout == FN(REPEATED) ? 1 : count;
    size_t n = stored * (size_t)components, i;

    a->components = components;
    a->layout = layout;
    a->count = count;
    a->memory = malloc(n > 0 ? n * sizeof(REAL) : 1);
    for (i = 0; i < n; i++)
        a->memory[i] = (REAL)-77.0; /* what is left as it was */
    a->first = a->memory;
    a->apart = layout == FN(SEPARATE) ? (ptrdiff_t)count : 1;
    a->stride = layout == FN(REPEATED)   ? 0
                : layout == FN(SEPARATE) ? (ptrdiff_t)sizeof(REAL)
                                         : (ptrdiff_t)sizeof(REAL) * components;
    if (layout == FN(BACKWARDS) && count > 0) {
        a->first += (count - 1) * (size_t)components;
        a->stride = -a->stride;
    }
}

static REAL *FN(array_at)(const struct FN(array) *a, size_t i, int component)
{
    char *element = (char *)(a->first + component * a->apart);
    return (REAL *)(void *)(element + (ptrdiff_t)i * a->stride);
}

static FN(psc_input) FN(array_input)(const struct FN(array) *a)
{
    FN(psc_input) in = {{NULL, NULL, NULL}, 0};
    int c;

    for (c = 0; c < a->components; c++)
        in.component[c] = a->first + c * a->apart;
    in.stride = a->stride;
    return in;
}

/* The components in the mask; the others are not wanted. */
static FN(psc_output) FN(array_output)(const struct FN(array) *a, unsigned mask)
{
    FN(psc_output) out = {{NULL, NULL, NULL}, 0};
    int c;

    for (c = 0; c < a->components; c++)
        if (mask >> c & 1)
            out.component[c] = a->first + c * a->apart;
    out.stride = a->stride;
    return out;
}

/* Whether the components in the mask hold these numbers, to the bit, and the others nothing. */
static int FN(array_holds)(const struct FN(array) *a, size_t i, unsigned mask,
                           const REAL *expected)
{
    const REAL nothing = (REAL)-77.0;
    int c, same = 1;

    for (c = 0; c < a->components; c++)
        same &= memcmp(FN(array_at)(a, i, c), mask >> c & 1 ? &expected[c] : &nothing,
                       sizeof(REAL)) == 0;
    return same;
}

/* All that a sampling call can write. */
struct FN(outputs) {
    struct FN(array) direction, pdf, point, distance, normal, weight, surface;
    psc_result *status;
    unsigned mask;
    FN(psc_samples) samples;
};

#define PSC_TEST_OUTPUTS(X)                                                             \
    X(direction, 3, 0) X(pdf, 1, 1) X(point, 3, 2) X(distance, 1, 3) X(normal, 3, 4) \
    X(weight, 1, 5) X(surface, 2, 6)

/* Bit k of wanted asks for field k, bit 7 for the statuses. Of vectors in an odd field of
   partial only the second component is wanted. */
static void FN(outputs_make)(struct FN(outputs) *o, size_t count, int layout, unsigned wanted,
                             int partial)
{
    size_t i;

    memset(&o->samples, 0, sizeof o->samples);
    o->samples.struct_size = sizeof o->samples;
    o->mask = partial ? 2u : 7u;
#define MAKE(field, components, k)                                                       \
    FN(array_make)(&o->field, components, count, layout);                                \
    if (wanted >> k & 1)                                                                 \
        o->samples.field = FN(array_output)(&o->field, components > 1 ? o->mask : 1u);
    PSC_TEST_OUTPUTS(MAKE)
#undef MAKE
    o->status = malloc(count > 0 ? count * sizeof *o->status : 1);
    for (i = 0; i < count; i++)
        o->status[i] = 77;
    if (wanted >> 7 & 1) {
        o->samples.status.data = o->status;
        o->samples.status.stride = sizeof *o->status;
    }
}

/* Element i holds the sample, and its status the result; without a sample, nothing. */
static int FN(outputs_hold)(const struct FN(outputs) *o, size_t i, unsigned wanted,
                            const FN(psc_light_sample) *sample, psc_result result)
{
    int same = o->status[i] == (wanted >> 7 & 1 ? result : 77);
    int written = result == PSC_SUCCESS || result == PSC_CULLED;

#define HOLDS(field, components, k)                                                           \
    same &= FN(array_holds)(&o->field, i,                                                     \
                            !written || !(wanted >> k & 1) ? 0u                               \
                            : components > 1               ? o->mask                          \
                                                           : 1u,                              \
                            (const REAL *)(const void *)&sample->field);
    PSC_TEST_OUTPUTS(HOLDS)
#undef HOLDS
    return same;
}

static void FN(outputs_free)(struct FN(outputs) *o)
{
#define FREE(field, components, k) free(o->field.memory);
    PSC_TEST_OUTPUTS(FREE)
#undef FREE
    free(o->status);
}

#undef PSC_TEST_OUTPUTS
