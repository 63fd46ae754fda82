/* SPDX-License-Identifier: Apache-2.0 */
/* Short ways to call the library from tests: descriptions in one line, and one signature for
   both precisions, so that a test loops over them. */
#ifndef PSC_TESTS_CALLS_H
#define PSC_TESTS_CALLS_H

#include <psc/psc.h>

#include <string.h>

/* What samples are uniform in, and how. */
struct test_technique {
    const char *name;
    psc_measure measure;
    psc_map map;
};

/* Only nearly uniform: the density is what the pdf says. */
static inline int is_uneven(const struct test_technique *what)
{
    return what->map >= PSC_MAP_QUASI_UNIFORM;
}

/* Whether points of the square are rejected, and the map jumps: see psc_table_init(). */
static inline int is_tabulated(const struct test_technique *what)
{
    return what->map == PSC_MAP_TABULATED;
}

static inline int is_rejected(const struct test_technique *what, double pdf)
{
    return is_tabulated(what) && pdf == 0.0;
}

/* A small table for all tests. */
static inline const psc_table *test_table(void)
{
    static union {
        double align;
        unsigned char bytes[20000];
    } memory;
    static const psc_table *table;

    if (!table)
        psc_table_init(&memory, sizeof memory, 64, &table);
    return table;
}

static inline psc_technique make_technique(psc_measure measure, psc_map map)
{
    psc_technique technique = {.struct_size = sizeof technique};

    technique.measure = measure;
    technique.map = map;
    technique.table = map == PSC_MAP_TABULATED ? test_table() : NULL;
    return technique;
}

static inline psc_receiver make_receiver(const double *position, const double *normal,
                                         uint32_t flags)
{
    psc_receiver receiver = {sizeof receiver, 0, NULL, NULL};

    receiver.flags = flags;
    receiver.position = position;
    receiver.normal = normal;
    return receiver;
}

/* One sampler in memory of its own. */
struct test_sampler {
    psc_sampler_storage storage;
    psc_sampler *sampler;
};

static inline psc_sampler *make_sampler(struct test_sampler *s)
{
    psc_sampler_init(&s->storage, sizeof s->storage, &s->sampler);
    return s->sampler;
}

static inline psc_result build_sphere(psc_sampler *sampler, const struct test_technique *what,
                                      uint32_t flags, const double position[3],
                                      const double *normal, const double center[3],
                                      double radius)
{
    psc_technique technique = make_technique(what->measure, what->map);
    psc_receiver receiver = make_receiver(position, normal, flags);

    return psc_build_sphere(sampler, &technique, &receiver, center, radius);
}

static inline psc_result build_cap(psc_sampler *sampler, const struct test_technique *what,
                                   uint32_t flags, const double *normal, const double axis[3],
                                   double half_angle)
{
    static const double origin[3] = {0.0, 0.0, 0.0};
    psc_technique technique = make_technique(what->measure, what->map);
    psc_receiver receiver = make_receiver(origin, normal, flags);

    return psc_build_cap(sampler, &technique, &receiver, axis, half_angle);
}

static inline psc_result sample_any(int bits, const psc_sampler *sampler, double u, double v,
                                    psc_light_sample_f64 *out)
{
    psc_light_sample_f32 f;
    psc_result result;
    int i;

    if (bits == 64)
        return psc_sample_f64(sampler, u, v, out);
    result = psc_sample_f32(sampler, (float)u, (float)v, &f);
    if (result < 0 || result == PSC_EMPTY)
        return result;
    for (i = 0; i < 3; i++) {
        out->direction[i] = f.direction[i];
        out->point[i] = f.point[i];
        out->normal[i] = f.normal[i];
    }
    out->surface[0] = f.surface[0];
    out->surface[1] = f.surface[1];
    out->pdf = f.pdf;
    out->distance = f.distance;
    out->weight = f.weight;
    return result;
}

static inline psc_result pdf_any(int bits, const psc_sampler *sampler, const double direction[3],
                                 double *pdf)
{
    float f[3], value;
    psc_result result;
    int i;

    if (bits == 64)
        return psc_pdf_f64(sampler, direction, pdf);
    for (i = 0; i < 3; i++)
        f[i] = (float)direction[i];
    result = psc_pdf_f32(sampler, f, &value);
    *pdf = value;
    return result;
}

static inline psc_result invert_any(int bits, const psc_sampler *sampler,
                                    const double direction[3], double uv[2])
{
    float f[3], out[2];
    psc_result result;
    int i;

    if (bits == 64)
        return psc_invert_f64(sampler, direction, uv);
    for (i = 0; i < 3; i++)
        f[i] = (float)direction[i];
    result = psc_invert_f32(sampler, f, out);
    if (result == PSC_SUCCESS) {
        uv[0] = out[0];
        uv[1] = out[1];
    }
    return result;
}

#endif
