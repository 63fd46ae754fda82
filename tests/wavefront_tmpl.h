/* SPDX-License-Identifier: Apache-2.0 */
/* The body of test_wavefront.c for one precision: see there. */
#include "arrays.h"

struct FN(wave) {
    struct FN(array) position, normal, where, size, uv;
    int has_normal;
    uint32_t flags;
};

static void FN(set3)(const struct FN(array) *a, size_t i, const double v[3])
{
    int c;

    for (c = 0; c < 3; c++)
        *FN(array_at)(a, i, c) = (REAL)v[c];
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
    case 2: *FN(array_at)(&w->where, i, random_below(seed, 3)) = number; break;
    case 3: *FN(array_at)(&w->size, i, 0) = number; break;
    case 4: FN(set3)(&w->normal, i, zero); break;
    case 5: *FN(array_at)(&w->size, i, 0) = (REAL)-1.0; break;
    case 6: *FN(array_at)(&w->size, i, 0) = (REAL)0.0; break;
    default: break;
    }
}

static void FN(wave_make)(struct FN(wave) *w, const struct test_technique *what, int distant,
                          size_t count, uint64_t *seed)
{
    struct test_technique kind = *what;
    struct FN(array) *all[5];
    static const int components[5] = {3, 3, 3, 1, 2};
    size_t i;
    int k;

    all[0] = &w->position;
    all[1] = &w->normal;
    all[2] = &w->where;
    all[3] = &w->size;
    all[4] = &w->uv;
    for (k = 0; k < 5; k++)
        FN(array_make)(all[k], components[k], count, random_below(seed, FN(LAYOUTS)));
    w->flags = random_below(seed, 3) == 0 ? PSC_RECEIVER_TWO_SIDED : 0;
    w->has_normal = what->measure == PSC_MEASURE_PROJECTED_SOLID_ANGLE || random_below(seed, 4);
    kind.distant = distant;
    for (i = 0; i < count; i++) {
        struct light light;

        do
            random_light(seed, &kind, &light);
        while (light.distant != distant);
        FN(set3)(&w->position, i, light.scene.position);
        FN(set3)(&w->normal, i, light.scene.normal);
        FN(set3)(&w->where, i, light.scene.center);
        *FN(array_at)(&w->size, i, 0) = (REAL)light.scene.radius;
        *FN(array_at)(&w->uv, i, 0) = (REAL)random_coordinate(seed);
        *FN(array_at)(&w->uv, i, 1) = (REAL)random_coordinate(seed);
        FN(spoil)(w, i, seed);
    }
}

static void FN(wave_free)(struct FN(wave) *w)
{
    free(w->position.memory);
    free(w->normal.memory);
    free(w->where.memory);
    free(w->size.memory);
    free(w->uv.memory);
}

/* What a sampler says for one element. */
static psc_result FN(one)(const struct FN(wave) *w, const struct test_technique *what,
                          int distant, size_t i, FN(psc_light_sample) *sample)
{
    double position[3], normal[3], where[3], size = *FN(array_at)(&w->size, i, 0);
    psc_technique technique = make_technique(what->measure, what->map);
    psc_receiver receiver = make_receiver(position, w->has_normal ? normal : NULL, w->flags);
    struct test_sampler s;
    psc_result result;
    int c;

    for (c = 0; c < 3; c++) {
        position[c] = *FN(array_at)(&w->position, i, c);
        normal[c] = *FN(array_at)(&w->normal, i, c);
        where[c] = *FN(array_at)(&w->where, i, c);
    }
    make_sampler(&s);
    result = distant ? psc_build_cap(s.sampler, &technique, &receiver, where, size)
                     : psc_build_sphere(s.sampler, &technique, &receiver, where, size);
    return result != PSC_SUCCESS ? result
                                 : FN(psc_sample)(s.sampler, *FN(array_at)(&w->uv, i, 0),
                                                  *FN(array_at)(&w->uv, i, 1), sample);
}

static int FN(wave_same)(const struct test_technique *what, int distant, size_t count,
                         unsigned wanted, int partial, uint64_t *seed, int *kinds)
{
    psc_technique technique = make_technique(what->measure, what->map);
    FN(psc_receivers) receivers;
    FN(psc_input) where, size, uv;
    struct FN(outputs) out;
    struct FN(wave) w;
    psc_result whole;
    size_t i;
    int same;

    FN(wave_make)(&w, what, distant, count, seed);
    FN(outputs_make)(&out, count, random_below(seed, FN(REPEATED)), wanted, partial);
    memset(&receivers, 0, sizeof receivers);
    receivers.struct_size = sizeof receivers;
    receivers.flags = w.flags;
    receivers.position = FN(array_input)(&w.position);
    if (w.has_normal)
        receivers.normal = FN(array_input)(&w.normal);
    where = FN(array_input)(&w.where);
    size = FN(array_input)(&w.size);
    uv = FN(array_input)(&w.uv);
    whole = distant ? FN(psc_cap_sample_n)(&technique, count, &receivers, &where, &size, &uv,
                                           &out.samples)
                    : FN(psc_sphere_sample_n)(&technique, count, &receivers, &where, &size, &uv,
                                              &out.samples);
    same = whole == PSC_SUCCESS;
    for (i = 0; i < count; i++) {
        FN(psc_light_sample) sample;
        psc_result result = FN(one)(&w, what, distant, i, &sample);

        same &= FN(outputs_hold)(&out, i, wanted, &sample, result);
        *kinds |= 1 << (result < 0 ? 4 : (int)result);
    }
    FN(wave_free)(&w);
    FN(outputs_free)(&out);
    return same;
}

static void FN(wavefronts)(const struct test_technique *what, int distant)
{
    static const size_t counts[] = {0, 1, 2, 3, 4, 5, 7, 8, 9, 15, 16, 17, 31, 33, 64, 257};
    uint64_t seed = 140;
    int i, differ = 0, kinds = 0;

    for (i = 0; i < 96; i++) {
        size_t count = counts[(size_t)i % (sizeof counts / sizeof counts[0])];
        unsigned wanted = i % 2 ? 0xffu : (unsigned)random_bits(&seed) & 0xffu;
        uint64_t same_seed = seed;

        if (!FN(wave_same)(what, distant, count, wanted, i % 5 == 0, &seed, &kinds)) {
            differ++;
            tap_note("seed %llx, %zu elements, wanted %x", (unsigned long long)same_seed, count,
                     wanted);
        }
    }
    tap_ok(differ == 0, "%s %s, " SUFFIX ": wavefronts (%d of 96 differ)",
           distant ? "cap" : "sphere", what->name, differ);
    tap_ok((kinds & 0x13) == 0x13, "%s %s, " SUFFIX ": samples, nothing and errors were there",
           distant ? "cap" : "sphere", what->name);
}

/* Errors of the call as a whole write nothing. */
static void FN(refusals)(int distant)
{
    REAL numbers[3] = {(REAL)0.1, (REAL)0.2, (REAL)0.3};
    FN(psc_input) in = {{numbers, numbers + 1, numbers + 2}, 3 * sizeof(REAL)};
    FN(psc_input) hole = {{numbers, NULL, numbers + 2}, 3 * sizeof(REAL)};
    FN(psc_receivers) receivers = {sizeof receivers, 0, {{NULL, NULL, NULL}, 0},
                                   {{NULL, NULL, NULL}, 0}};
    psc_result (*call)(const psc_technique *, size_t, const FN(psc_receivers) *,
                       const FN(psc_input) *, const FN(psc_input) *, const FN(psc_input) *,
                       const FN(psc_samples) *) =
        distant ? FN(psc_cap_sample_n) : FN(psc_sphere_sample_n);
    const char *name = distant ? "cap, " SUFFIX : "sphere, " SUFFIX;
    psc_technique good = make_technique(PSC_MEASURE_SOLID_ANGLE, PSC_MAP_RADIAL), technique;
    const psc_result null = PSC_ERROR_NULL_POINTER;
    struct FN(outputs) out;
    FN(psc_light_sample) unused;

    receivers.position = in;
    memset(&unused, 0, sizeof unused);
    FN(outputs_make)(&out, 1, FN(RECORDS), 0xff, 0);
#define REFUSED(expected, ...)                                               \
    out.status[0] = 77;                                                      \
    tap_ok(call(__VA_ARGS__) == (expected) &&                                \
               FN(outputs_hold)(&out, 0, 0, &unused, PSC_SUCCESS), "%s: %s", \
           name, psc_result_string(expected))
    REFUSED(null, NULL, 1, &receivers, &in, &in, &in, &out.samples);
    REFUSED(null, &good, 1, NULL, &in, &in, &in, &out.samples);
    REFUSED(null, &good, 1, &receivers, NULL, &in, &in, &out.samples);
    REFUSED(null, &good, 1, &receivers, &in, NULL, &in, &out.samples);
    REFUSED(null, &good, 1, &receivers, &in, &in, NULL, &out.samples);
    REFUSED(null, &good, 1, &receivers, &in, &in, &in, NULL);
    REFUSED(null, &good, 1, &receivers, &hole, &in, &in, &out.samples);
    REFUSED(null, &good, 1, &receivers, &in, &in, &hole, &out.samples);
    receivers.position = hole;
    REFUSED(null, &good, 1, &receivers, &in, &in, &in, &out.samples);
    receivers.position = in;
    receivers.normal = hole;
    REFUSED(null, &good, 1, &receivers, &in, &in, &in, &out.samples);
    memset(&receivers.normal, 0, sizeof receivers.normal);
    receivers.struct_size = 4;
    REFUSED(PSC_ERROR_STRUCT_SIZE, &good, 1, &receivers, &in, &in, &in, &out.samples);
    receivers.struct_size = sizeof receivers;
    receivers.flags = 2;
    REFUSED(PSC_ERROR_UNKNOWN_FLAG, &good, 1, &receivers, &in, &in, &in, &out.samples);
    receivers.flags = 0;
    technique = good;
    technique.struct_size = 3;
    REFUSED(PSC_ERROR_STRUCT_SIZE, &technique, 1, &receivers, &in, &in, &in, &out.samples);
    technique = make_technique(9, PSC_MAP_RADIAL);
    REFUSED(PSC_ERROR_UNKNOWN_MEASURE, &technique, 1, &receivers, &in, &in, &in, &out.samples);
    technique = make_technique(PSC_MEASURE_SOLID_ANGLE, 9);
    REFUSED(PSC_ERROR_UNKNOWN_MAP, &technique, 1, &receivers, &in, &in, &in, &out.samples);
    technique = good;
    technique.flags = 2;
    REFUSED(PSC_ERROR_UNKNOWN_FLAG, &technique, 1, &receivers, &in, &in, &in, &out.samples);
    technique = make_technique(PSC_MEASURE_SOLID_ANGLE, PSC_MAP_PARALLEL);
    REFUSED(PSC_ERROR_UNSUPPORTED_TECHNIQUE, &technique, 1, &receivers, &in, &in, &in,
            &out.samples);
    technique = make_technique(PSC_MEASURE_PROJECTED_SOLID_ANGLE, PSC_MAP_RADIAL);
    REFUSED(PSC_ERROR_NEEDS_NORMAL, &technique, 1, &receivers, &in, &in, &in, &out.samples);
    out.samples.struct_size = 8;
    REFUSED(PSC_ERROR_STRUCT_SIZE, &good, 1, &receivers, &in, &in, &in, &out.samples);
    out.samples.struct_size = sizeof out.samples;
    out.samples.reserved = 1;
    REFUSED(PSC_ERROR_UNKNOWN_FIELD, &good, 1, &receivers, &in, &in, &in, &out.samples);
#undef REFUSED
    FN(outputs_free)(&out);
}
