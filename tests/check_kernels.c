/* SPDX-License-Identifier: Apache-2.0 */
/*
 * The same bits from every variant of the kernels and from every kind of call: each is compared
 * with single samples of the first variant, which is the kernel template compiled without
 * vector instructions wherever the compiler can be kept from them.
 */
#include <math.h>
#include <stdlib.h>

#include "lights.h"
#include "tap.h"
#include "variants.h"

enum layout { LAYOUT_SEPARATE, LAYOUT_RECORDS, LAYOUT_REVERSED, LAYOUTS };

/* Elements: more than two blocks of the library's loops. */
enum { COUNT_MAX = 300, COMPONENTS = 14, MAX_INPUTS = 12, REPEATED = 21 };

#define ALL_COMPONENTS ((1u << COMPONENTS) - 1)

static const char *const component_names[COMPONENTS] = {
    "direction x", "direction y", "direction z", "pdf",      "point x",   "point y", "point z",
    "distance",    "normal x",    "normal y",    "normal z", "weight",    "surface u", "surface v"};

/* What was compared, and the first differences. */
struct tally {
    char what[320];
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

/* Gaps and sines of place_sphere(), one or more for each case. */
static const struct situation {
    const char *name;
    double gap, sine;
} situations[] = {
    {"ellipse", 1.5, 0.9},        {"overhead", 1.0, 1.0},        {"touching the horizon", 1.0, 0.5},
    {"ellipse and lune", 0.4, 0.4}, {"half", 0.4, 0.0},          {"lune", 0.4, -0.3},
    {"thin lune", 0.4, -0.69},    {"sun", 200.0, 0.002},         {"low sun", 200.0, -0.0048},
    {"close", 1e-9, 0.3},         {"inside", -0.5, 0.4},         {"below", 0.4, -0.9},
    {"on the surface", 0.0, 0.5},
};

enum { SITUATIONS = sizeof situations / sizeof *situations };

/* The facing of receivers: without a normal, one-sided, two-sided. */
enum { FACINGS = 3 };

static int offered(const struct test_technique *what, int distant, int facing)
{
    return (!distant || what->distant) &&
           (facing > 0 || what->measure != PSC_MEASURE_PROJECTED_SOLID_ANGLE);
}

static void make_scene(uint64_t *state, const struct situation *s, int distant,
                       struct scene *scene)
{
    static const struct scene on_surface = {{0, 0, 0}, {0, 0, 2}, {3, 0, 4}, 5};
    int i;

    if (s->gap == 0.0)
        *scene = on_surface;
    else
        place_sphere(state, s->gap, s->sine, 1.0, scene);
    if (distant) {
        for (i = 0; i < 3; i++)
            scene->center[i] -= scene->position[i];
        scene->radius = s->gap > 0.0 ? asin(1.0 / (1.0 + s->gap)) : RIGHT_ANGLE * (1.0 - s->gap);
    }
}

/* One call's arrays: what all elements share. */
struct wavefront {
    const struct test_technique *what;
    int distant, has_normal;
    uint32_t flags;
};

static psc_result build_parts(psc_sampler *sampler, const struct wavefront *w,
                              const double position[3], const double normal[3],
                              const double center[3], double radius)
{
    const psc_technique technique = make_technique(w->what->measure, w->what->map);
    const psc_receiver receiver = make_receiver(position, w->has_normal ? normal : NULL, w->flags);

    return w->distant ? psc_build_cap(sampler, &technique, &receiver, center, radius)
                      : psc_build_sphere(sampler, &technique, &receiver, center, radius);
}

/* Where each input is among the values of an element. */
enum { POSITION = 0, NORMAL = 3, CENTER = 6, RADIUS = 9, UV = 10 };

/* Element i. Every eighth is one that cannot be built. */
static void make_element(const struct wavefront *w, size_t i, double element[MAX_INPUTS])
{
    uint64_t state = i * 0x9e6c63d0876a9a47u + 1;
    struct scene s;

    make_scene(&state, &situations[random_below(&state, SITUATIONS)], w->distant, &s);
    if (i % 8 == 3)
        switch (i / 8 % 5) {
        case 0: s.position[1] = NAN; break;
        case 1: s.normal[0] = s.normal[1] = s.normal[2] = 0.0; break;
        case 2: s.center[2] = INFINITY; break;
        case 3: s.radius = -1.0; break;
        default: s.radius = 0.0; break;
        }
    memcpy(element + POSITION, s.position, sizeof s.position);
    memcpy(element + NORMAL, s.normal, sizeof s.normal);
    memcpy(element + CENTER, s.center, sizeof s.center);
    element[RADIUS] = s.radius;
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

static void check_builds(const struct psc_variant *variant, const struct test_technique *what,
                         int distant, int bits)
{
    struct tally tally = {{0}, 0, 0, {0}};
    struct light light = {what, distant, 0, 0, {{0}, {0}, {0}, 0}};
    int i, facing;

    for (i = 0; i < SITUATIONS; i++)
        for (facing = 0; facing < FACINGS; facing++) {
            uint64_t state = (uint64_t)i + 1;

            if (!offered(what, distant, facing))
                continue;
            make_scene(&state, &situations[i], distant, &light.scene);
            light.has_normal = facing > 0;
            light.flags = facing == 2 ? PSC_RECEIVER_TWO_SIDED : 0;
            snprintf(tally.what, sizeof tally.what, "%s, %s", situations[i].name,
                     facing_names[facing]);
            if (bits == 64)
                check_light_f64(&tally, &light, variant);
            else
                check_light_f32(&tally, &light, variant);
        }
    tap_ok(tally.differences == 0 && tally.compared > 0,
           "%s f%d, %s of %s: %zu differences in %zu samples of batches", variant_name(variant), bits,
           what->name, distant ? "caps" : "spheres", tally.differences, tally.compared);
}

static void check_wavefronts(const struct psc_variant *variant, const struct test_technique *what,
                             int distant, int bits)
{
    struct tally tally = {{0}, 0, 0, {0}};
    int facing;

    for (facing = 0; facing < FACINGS; facing++) {
        const struct wavefront w = {what, distant, facing > 0,
                                    facing == 2 ? PSC_RECEIVER_TWO_SIDED : 0};

        if (!offered(what, distant, facing))
            continue;
        snprintf(tally.what, sizeof tally.what, "wavefront, %s", facing_names[facing]);
        if (bits == 64)
            check_wavefront_f64(&tally, &w, variant);
        else
            check_wavefront_f32(&tally, &w, variant);
    }
    tap_ok(tally.differences == 0 && tally.statuses[PSC_SUCCESS] > 100 &&
               tally.statuses[PSC_EMPTY] > 10 && tally.statuses[4] > 10,
           "%s f%d, %s of %s: %zu differences in %zu samples of wavefronts", variant_name(variant), bits,
           what->name, distant ? "caps" : "spheres", tally.differences, tally.compared);
}

int main(void)
{
    unsigned v;
    int t, distant, bits;

    for (v = 0; v < variant_count(); v++) {
        if (!variant_runs(v)) {
            tap_skip("%s: not on this CPU", variant_name(variant_at(v)));
            continue;
        }
        for (bits = 64; bits >= 32; bits -= 32)
            for (t = 0; t < TEST_TECHNIQUES; t++)
                for (distant = 0; distant <= test_techniques[t].distant; distant++) {
                    check_builds(variant_at(v), &test_techniques[t], distant, bits);
                    check_wavefronts(variant_at(v), &test_techniques[t], distant, bits);
                }
    }
    return tap_done();
}
