/* SPDX-License-Identifier: Apache-2.0 */
/* The body of test_wavefront.c for one precision: see there. */
#include "arrays.h"

/* What all elements share, and the inputs that they have of their own. */
struct FN(wave) {
    struct light shared;
    struct FN(array) position, normal, uv, parts[PARTS_MAX];
};

static void FN(set3)(const struct FN(array) *a, size_t i, const double v[3])
{
    int c;

    for (c = 0; c < 3; c++)
        *FN(array_at)(a, i, c) = (REAL)v[c];
}

/* A number that cannot be, in one of the parts; or a size that is none. */
static void FN(spoil_part)(const struct FN(wave) *w, size_t i, REAL number, uint64_t *seed)
{
    const int k = random_below(seed, part_count(w->shared.shape));
    const char part = w->shared.shape->parts[k];

    if (part_size(part) == 1 && random_below(seed, 2))
        number = (REAL)-random_below(seed, 2);
    *FN(array_at)(&w->parts[k], i, random_below(seed, part_size(part))) = number;
}

/* One element in eight has something wrong with it. */
static void FN(spoil)(const struct FN(wave) *w, size_t i, uint64_t *seed)
{
    static const REAL bad[3] = {(REAL)NAN, (REAL)INFINITY, (REAL)-INFINITY};
    REAL number = bad[random_below(seed, 3)];
    const double zero[3] = {0.0, 0.0, 0.0};

    switch (random_below(seed, 40)) {
    case 0: *FN(array_at)(&w->position, i, random_below(seed, 3)) = number; break;
    case 1: *FN(array_at)(&w->normal, i, random_below(seed, 3)) = number; break;
    case 2: FN(set3)(&w->normal, i, zero); break;
    case 3:
    case 4: FN(spoil_part)(w, i, number, seed); break;
    default: break;
    }
}

static void FN(set_element)(const struct FN(wave) *w, size_t i, const struct light *light)
{
    const double *g = light->geometry;
    int k, c;

    FN(set3)(&w->position, i, light->position);
    FN(set3)(&w->normal, i, light->normal);
    for (k = 0; k < part_count(light->shape); k++)
        for (c = 0; c < w->parts[k].components; c++)
            *FN(array_at)(&w->parts[k], i, c) = (REAL)*g++;
}

/* Turns the receiver so that its plane goes through a vertex or the centre, to rounding. */
static void FN(come_to_horizon)(struct light *light, uint64_t *seed)
{
    const int distant = is_distant(light->shape);
    double to[3], aside[3];
    int c;

    random_unit(seed, aside);
    for (c = 0; c < 3; c++)
        to[c] = light->geometry[c] - (distant ? 0.0 : light->position[c]);
    cross(to, aside, light->normal);
}

static void FN(wave_make)(struct FN(wave) *w, const struct shape *shape,
                          const struct test_technique *what, size_t count, uint64_t *seed)
{
    size_t i;
    int k;

    FN(array_make)(&w->position, 3, count, random_below(seed, FN(LAYOUTS)));
    FN(array_make)(&w->normal, 3, count, random_below(seed, FN(LAYOUTS)));
    FN(array_make)(&w->uv, 2, count, random_below(seed, FN(LAYOUTS)));
    for (k = 0; k < part_count(shape); k++)
        FN(array_make)(&w->parts[k], part_size(shape->parts[k]), count,
                       random_below(seed, FN(LAYOUTS)));
    random_light(seed, shape, what, &w->shared);
    if (random_below(seed, 4) == 0)
        w->shared.technique_flags = PSC_TECHNIQUE_ONE_SIDED;
    for (i = 0; i < count; i++) {
        struct light light;

        (random_below(seed, 4) ? random_light : random_hard_light)(seed, shape, what, &light);
        if (random_below(seed, 8) == 0)
            FN(come_to_horizon)(&light, seed);
        FN(set_element)(w, i, &light);
        *FN(array_at)(&w->uv, i, 0) = (REAL)random_coordinate(seed);
        *FN(array_at)(&w->uv, i, 1) = (REAL)random_coordinate(seed);
        FN(spoil)(w, i, seed);
    }
}

static void FN(wave_free)(struct FN(wave) *w)
{
    int k;

    free(w->position.memory);
    free(w->normal.memory);
    free(w->uv.memory);
    for (k = 0; k < part_count(w->shared.shape); k++)
        free(w->parts[k].memory);
}

/* What a sampler says for one element. */
static psc_result FN(one)(const struct FN(wave) *w, size_t i, FN(psc_light_sample) *sample)
{
    struct light light = w->shared;
    double *g = light.geometry;
    struct test_sampler s;
    psc_result result;
    int k, c;

    for (c = 0; c < 3; c++) {
        light.position[c] = *FN(array_at)(&w->position, i, c);
        light.normal[c] = *FN(array_at)(&w->normal, i, c);
    }
    for (k = 0; k < part_count(light.shape); k++)
        for (c = 0; c < w->parts[k].components; c++)
            *g++ = *FN(array_at)(&w->parts[k], i, c);
    result = build_light(make_sampler(&s), &light);
    return result != PSC_SUCCESS ? result
                                 : FN(psc_sample)(s.sampler, *FN(array_at)(&w->uv, i, 0),
                                                  *FN(array_at)(&w->uv, i, 1), sample);
}

static int FN(wave_same)(const struct shape *shape, const struct test_technique *what,
                         size_t count, unsigned wanted, int partial, uint64_t *seed, int *kinds)
{
    psc_technique technique;
    FN(psc_receivers) receivers;
    FN(psc_input) parts[PARTS_MAX], uv;
    const FN(psc_input) *in[PARTS_MAX];
    struct FN(outputs) out;
    struct FN(wave) w;
    size_t i;
    int same, k;

    FN(wave_make)(&w, shape, what, count, seed);
    FN(outputs_make)(&out, count, random_below(seed, FN(REPEATED)), wanted, partial);
    technique = light_technique(&w.shared);
    memset(&receivers, 0, sizeof receivers);
    receivers.struct_size = sizeof receivers;
    receivers.flags = w.shared.flags;
    receivers.position = FN(array_input)(&w.position);
    if (w.shared.has_normal)
        receivers.normal = FN(array_input)(&w.normal);
    for (k = 0; k < part_count(shape); k++) {
        parts[k] = FN(array_input)(&w.parts[k]);
        in[k] = parts + k;
    }
    uv = FN(array_input)(&w.uv);
    same = shape->FN(wave)(&technique, count, &receivers, in, &uv, &out.samples) ==
           PSC_SUCCESS;
    for (i = 0; i < count; i++) {
        FN(psc_light_sample) sample;
        psc_result result = FN(one)(&w, i, &sample);

        same &= FN(outputs_hold)(&out, i, wanted, &sample, result);
        *kinds |= 1 << (result < 0 ? 4 : (int)result);
    }
    FN(wave_free)(&w);
    FN(outputs_free)(&out);
    return same;
}

static void FN(wavefronts)(const struct shape *shape, const struct test_technique *what)
{
    static const size_t counts[] = {0, 1, 2, 3, 4, 5, 7, 8, 9, 15, 16, 17, 31, 33, 64, 257};
    uint64_t seed = 140;
    int i, differ = 0, kinds = 0;

    for (i = 0; i < 96; i++) {
        size_t count = counts[(size_t)i % (sizeof counts / sizeof counts[0])];
        unsigned wanted = i % 2 ? 0xffu : (unsigned)random_bits(&seed) & 0xffu;
        uint64_t same_seed = seed;

        if (!FN(wave_same)(shape, what, count, wanted, i % 5 == 0, &seed, &kinds)) {
            differ++;
            tap_note("seed %llx, %zu elements, wanted %x", (unsigned long long)same_seed, count,
                     wanted);
        }
    }
    tap_ok(differ == 0, "%s, %s, " SUFFIX ": wavefronts (%d of 96 differ)", shape->name,
           what->name, differ);
    tap_ok((kinds & 0x13) == 0x13, "%s, %s, " SUFFIX ": samples, nothing and errors were there",
           shape->name, what->name);
}

/* Errors of the call as a whole write nothing. */
static void FN(refusals)(const struct shape *shape)
{
    REAL numbers[3] = {(REAL)0.1, (REAL)0.2, (REAL)0.3};
    const FN(psc_input) good = {{numbers, numbers + 1, numbers + 2}, 3 * sizeof(REAL)};
    const FN(psc_input) hole = {{numbers, NULL, numbers + 2}, 3 * sizeof(REAL)};
    const FN(psc_input) *in[PARTS_MAX], *uv = &good;
    FN(psc_input) parts[PARTS_MAX];
    FN(psc_receivers) receivers = {sizeof receivers, 0, {{NULL, NULL, NULL}, 0},
                                   {{NULL, NULL, NULL}, 0}};
    psc_technique plain = make_technique(PSC_MEASURE_SOLID_ANGLE, PSC_MAP_RADIAL), technique;
    const struct test_technique *what;
    const psc_result null = PSC_ERROR_NULL_POINTER;
    struct FN(outputs) out;
    FN(psc_light_sample) unused;
    int k;

    for (k = 0; k < PARTS_MAX; k++) {
        parts[k] = good;
        in[k] = parts + k;
    }
    receivers.position = good;
    memset(&unused, 0, sizeof unused);
    FN(outputs_make)(&out, 1, FN(RECORDS), 0xff, 0);
#define REFUSED(expected, ...)                                               \
    out.status[0] = 77;                                                      \
    tap_ok(shape->FN(wave)(__VA_ARGS__) == (expected) &&                     \
               FN(outputs_hold)(&out, 0, 0, &unused, PSC_SUCCESS), "%s, %s: %s", \
           shape->name, SUFFIX, psc_result_string(expected))
    REFUSED(null, NULL, 1, &receivers, in, uv, &out.samples);
    REFUSED(null, &plain, 1, NULL, in, uv, &out.samples);
    REFUSED(null, &plain, 1, &receivers, in, NULL, &out.samples);
    REFUSED(null, &plain, 1, &receivers, in, uv, NULL);
    for (k = 0; k < part_count(shape); k++) {
        parts[k].component[part_size(shape->parts[k]) / 2] = NULL;
        REFUSED(null, &plain, 1, &receivers, in, uv, &out.samples);
        parts[k] = good;
        if (k > 0 && shape->joined)
            continue;
        in[k] = NULL;
        REFUSED(null, &plain, 1, &receivers, in, uv, &out.samples);
        in[k] = parts + k;
    }
    REFUSED(null, &plain, 1, &receivers, in, &hole, &out.samples);
    receivers.position = hole;
    REFUSED(null, &plain, 1, &receivers, in, uv, &out.samples);
    receivers.position = good;
    receivers.normal = hole;
    REFUSED(null, &plain, 1, &receivers, in, uv, &out.samples);
    memset(&receivers.normal, 0, sizeof receivers.normal);
    receivers.struct_size = 4;
    REFUSED(PSC_ERROR_STRUCT_SIZE, &plain, 1, &receivers, in, uv, &out.samples);
    receivers.struct_size = sizeof receivers;
    receivers.flags = 2;
    REFUSED(PSC_ERROR_UNKNOWN_FLAG, &plain, 1, &receivers, in, uv, &out.samples);
    receivers.flags = 0;
    technique = plain;
    technique.struct_size = 3;
    REFUSED(PSC_ERROR_STRUCT_SIZE, &technique, 1, &receivers, in, uv, &out.samples);
    technique = make_technique(9, PSC_MAP_RADIAL);
    REFUSED(PSC_ERROR_UNKNOWN_MEASURE, &technique, 1, &receivers, in, uv, &out.samples);
    technique = make_technique(PSC_MEASURE_SOLID_ANGLE, 9);
    REFUSED(PSC_ERROR_UNKNOWN_MAP, &technique, 1, &receivers, in, uv, &out.samples);
    technique = plain;
    technique.flags = 2;
    REFUSED(PSC_ERROR_UNKNOWN_FLAG, &technique, 1, &receivers, in, uv, &out.samples);
    technique = make_technique(PSC_MEASURE_VISIBLE_AREA, PSC_MAP_PARALLEL);
    REFUSED(PSC_ERROR_UNSUPPORTED_TECHNIQUE, &technique, 1, &receivers, in, uv,
            &out.samples);
    for (FOR_TECHNIQUES(shape, what))
        if (!is_offered(what, FACING_NONE)) {
            technique = make_technique(what->measure, what->map);
            REFUSED(PSC_ERROR_NEEDS_NORMAL, &technique, 1, &receivers, in, uv, &out.samples);
        }
    out.samples.struct_size = 8;
    REFUSED(PSC_ERROR_STRUCT_SIZE, &plain, 1, &receivers, in, uv, &out.samples);
    out.samples.struct_size = sizeof out.samples;
    out.samples.reserved = 1;
    REFUSED(PSC_ERROR_UNKNOWN_FIELD, &plain, 1, &receivers, in, uv, &out.samples);
#undef REFUSED
    FN(outputs_free)(&out);
}
