/* SPDX-License-Identifier: Apache-2.0 */
/*
 * The same bits from every variant of the kernels and from every kind of call: each is compared
 * with single samples of the first variant, which is the kernel template compiled without
 * vector instructions wherever the compiler can be kept from them.
 */
#include <math.h>
#include <stdlib.h>

#include "shapes.h"
#include "tap.h"
#include "variants.h"

enum layout { LAYOUT_SEPARATE, LAYOUT_RECORDS, LAYOUT_REVERSED, LAYOUTS };

/* Elements: more than two blocks of the library's loops. */
enum { COUNT_MAX = 300, COMPONENTS = 14, REPEATED = 21 };

#define ALL_COMPONENTS ((1u << COMPONENTS) - 1)

static const char *const component_names[COMPONENTS] = {
    "direction x", "direction y", "direction z", "pdf",      "point x",   "point y", "point z",
    "distance",    "normal x",    "normal y",    "normal z", "weight",    "surface u", "surface v"};

/* What was compared, and the first differences. */
struct tally {
    char what[160];
    size_t compared, differences;
    size_t statuses[5]; /* of single samples: by number, errors last */
};

static int tally_add(struct tally *tally, size_t i, const char *name, double got, double expected)
{
    if (tally->differences++ < 3)
        tap_note("    %s: element %zu, %s: %a, not %a", tally->what, i, name, got, expected);
    return 0;
}

static void fill(void *memory, size_t size)
{
    memset(memory, 0xa5, size);
}

/* Exactly this size; never NULL, which has a meaning of its own. */
static void *allocate(size_t size)
{
    void *memory = malloc(size > 0 ? size : 1);

    if (!memory)
        abort();
    fill(memory, size);
    return memory;
}

/* Every count up to two of the widest vectors, then around the sizes of blocks. */
static size_t next_count(size_t count)
{
    static const size_t later[] = {47, 48, 63, 64, 65, 97, 127, 128, 129, 200, 255, 256, 257,
                                   COUNT_MAX, COUNT_MAX + 1};
    size_t i = 0;

    if (count < 34)
        return count + 1;
    while (later[i] <= count)
        i++;
    return later[i];
}

/* All outputs, or one kind of them, or some. */
static unsigned some_components(size_t turn)
{
    static const unsigned sets[] = {ALL_COMPONENTS, 0xf, ALL_COMPONENTS, 0x70, 0x80, ALL_COMPONENTS,
                                    0x700, 0x800, 0x2492, 0x3000};

    return sets[turn % (sizeof sets / sizeof *sets)];
}

/* Coordinates of the unit square: every third is one of those that are at the edge of something,
   the smallest of which is 0 in single precision. */
static double coordinate(size_t i)
{
    static const double edges[] = {0.0,      1.0,      0.5,      0x1p-1074, 0x1p-149,
                                   0x1p-126, 0x1p-60,  1 - 0x1p-24, 1 - 0x1p-53, 0.5 + 0x1p-24,
                                   0.5 - 0x1p-25, 0.5 - 0x1p-54, 0.25, 0x1p-1022};
    uint64_t state = i * 0x2545f4914f6cdd1du;

    if (random_bits(&state) % 3 == 0)
        return edges[random_bits(&state) % (sizeof edges / sizeof *edges)];
    return random_uniform(&state);
}

/* ---- Lights ---- */

/* One or more for each case of each shape. */
static const struct situation {
    const char *name;
    int place, horizon;
} situations[] = {
    {"above", PLACE_ORDINARY, HORIZON_ABOVE}, {"touching the horizon", PLACE_ORDINARY, HORIZON_TOUCH},
    {"cut", PLACE_ORDINARY, HORIZON_CUT},     {"cut elsewhere", PLACE_ORDINARY, HORIZON_CUT},
    {"low", PLACE_ORDINARY, HORIZON_LOW},     {"far", PLACE_FAR, HORIZON_CUT},
    {"tiny", PLACE_TINY, HORIZON_ANY},        {"close", PLACE_CLOSE, HORIZON_ANY},
    {"grazing", PLACE_GRAZING, HORIZON_ANY},  {"inside or in its plane", PLACE_INSIDE, HORIZON_ANY},
    {"below", PLACE_ORDINARY, HORIZON_BELOW}, {"anywhere", PLACE_ORDINARY, HORIZON_ANY},
};

enum { SITUATIONS = sizeof situations / sizeof *situations };

/* Where each input is among the values of an element. */
enum { POSITION = 0, NORMAL = 3, UV = 6, GEOMETRY = 8, MAX_INPUTS = GEOMETRY + GEOMETRY_MAX };

static void to_values(const struct light *light, double values[MAX_INPUTS])
{
    memcpy(values + POSITION, light->position, sizeof light->position);
    memcpy(values + NORMAL, light->normal, sizeof light->normal);
    memcpy(values + GEOMETRY, light->geometry, sizeof light->geometry);
}

static void from_values(const double values[MAX_INPUTS], struct light *light)
{
    memcpy(light->position, values + POSITION, sizeof light->position);
    memcpy(light->normal, values + NORMAL, sizeof light->normal);
    memcpy(light->geometry, values + GEOMETRY, sizeof light->geometry);
}

/* A part of the light that cannot be, or has no size. */
static void spoil(size_t turn, struct light *light)
{
    const int n = geometry_size(light->shape);

    switch (turn % 5) {
    case 0: light->position[1] = NAN; break;
    case 1: memset(light->normal, 0, sizeof light->normal); break;
    case 2: light->geometry[turn / 5 % (size_t)n] = INFINITY; break;
    case 3: light->geometry[n - 1] = NAN; break;
    default: shrink_to_nothing(light); break;
    }
}

/* Element i. Every eighth is one that cannot be built. */
static void make_element(const struct light *shared, size_t i, double element[MAX_INPUTS])
{
    uint64_t state = i * 0x9e6c63d0876a9a47u + 1;
    const struct situation *s = &situations[random_below(&state, SITUATIONS)];
    struct light light;

    place_light(&state, shared->shape, shared->what, s->place, s->horizon, FACING_ONE, &light);
    if (i % 8 == 3)
        spoil(i / 8, &light);
    to_values(&light, element);
    element[UV] = coordinate(2 * i);
    element[UV + 1] = coordinate(2 * i + 1);
}

#define BITS 64
#include "real.h"
#include "kernels_tmpl.h"

#undef BITS
#define BITS 32
#include "real.h"
#include "kernels_tmpl.h"

/* ---- The checks ---- */

static const char *const facing_names[FACINGS] = {"no normal", "one-sided", "two-sided"};

static void check_builds(const struct psc_variant *variant, const struct shape *shape,
                         const struct test_technique *what, int bits)
{
    struct tally tally = {{0}, 0, 0, {0}};
    int i, facing;

    for (i = 0; i < SITUATIONS; i++)
        for (facing = 0; facing < FACINGS; facing++) {
            uint64_t state = (uint64_t)i + 1;
            struct light light;

            if (!is_offered(what, facing))
                continue;
            place_light(&state, shape, what, situations[i].place, situations[i].horizon, facing,
                        &light);
            snprintf(tally.what, sizeof tally.what, "%s, %s", situations[i].name,
                     facing_names[facing]);
            (bits == 64 ? check_light_f64 : check_light_f32)(&tally, &light, variant);
        }
    tap_ok(tally.differences == 0 && tally.compared > 0,
           "%s f%d, %s of %ss: %zu differences in %zu samples, densities and inverses "
           "of batches",
           variant_name(variant), bits, what->name, shape->name, tally.differences,
           tally.compared);
}

static void check_wavefronts(const struct psc_variant *variant, const struct shape *shape,
                             const struct test_technique *what, int bits)
{
    struct tally tally = {{0}, 0, 0, {0}};
    int facing;

    for (facing = 0; facing < FACINGS; facing++) {
        uint64_t state = 1;
        struct light shared;

        if (!is_offered(what, facing))
            continue;
        place_light(&state, shape, what, PLACE_ORDINARY, HORIZON_ANY, facing, &shared);
        snprintf(tally.what, sizeof tally.what, "wavefront, %s", facing_names[facing]);
        (bits == 64 ? check_wavefront_f64 : check_wavefront_f32)(&tally, &shared, variant);
    }
    tap_ok(tally.differences == 0 && tally.statuses[PSC_SUCCESS] > 100 &&
               tally.statuses[PSC_EMPTY] > 10 && tally.statuses[4] > 10,
           "%s f%d, %s of %ss: %zu differences in %zu samples of wavefronts",
           variant_name(variant), bits, what->name, shape->name, tally.differences,
           tally.compared);
}

static void check_variant(const struct psc_variant *variant)
{
    const struct test_technique *what;
    int i, bits;

    for (bits = 64; bits >= 32; bits -= 32)
        for (i = 0; shapes[i]; i++)
            for (FOR_TECHNIQUES(shapes[i], what)) {
                check_builds(variant, shapes[i], what, bits);
                check_wavefronts(variant, shapes[i], what, bits);
            }
}

int main(void)
{
    unsigned v;

    for (v = 0; v < variant_count(); v++)
        if (variant_runs(v))
            check_variant(variant_at(v));
        else
            tap_skip("%s: not on this CPU", variant_name(variant_at(v)));
    return tap_done();
}
