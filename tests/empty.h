/* SPDX-License-Identifier: Apache-2.0 */
/* Whether a sampler is empty and safe: what each call does with it. */
#ifndef PSC_TESTS_EMPTY_H
#define PSC_TESTS_EMPTY_H

#include <psc/psc.h>

#include <string.h>

static inline int untouched(const void *memory, size_t size)
{
    const unsigned char *byte = memory;
    size_t i;

    for (i = 0; i < size; i++)
        if (byte[i] != 0xa5)
            return 0;
    return 1;
}

static inline int empty_f64(const psc_sampler *s)
{
    static const double upwards[3] = {0.0, 0.0, 1.0};
    psc_light_sample_f64 sample;
    double uv[2], pdf = 1.0;
    int ok;

    memset(&sample, 0xa5, sizeof sample);
    memset(uv, 0xa5, sizeof uv);
    ok = psc_sample_f64(s, 0.3, 0.7, &sample) == PSC_EMPTY && untouched(&sample, sizeof sample);
    ok &= psc_invert_f64(s, upwards, uv) == PSC_EMPTY && untouched(uv, sizeof uv);
    ok &= psc_pdf_f64(s, upwards, &pdf) == PSC_EMPTY && pdf == 0.0;
    return ok;
}

static inline int empty_f32(const psc_sampler *s)
{
    static const float upwards[3] = {0.0f, 0.0f, 1.0f};
    psc_light_sample_f32 sample;
    float uv[2], pdf = 1.0f;
    int ok;

    memset(&sample, 0xa5, sizeof sample);
    memset(uv, 0xa5, sizeof uv);
    ok = psc_sample_f32(s, 0.3f, 0.7f, &sample) == PSC_EMPTY && untouched(&sample, sizeof sample);
    ok &= psc_invert_f32(s, upwards, uv) == PSC_EMPTY && untouched(uv, sizeof uv);
    ok &= psc_pdf_f32(s, upwards, &pdf) == PSC_EMPTY && pdf == 0.0f;
    return ok;
}

/* Three elements of every array call. */
static inline int empty_arrays(const psc_sampler *s)
{
    double uv[6] = {0.1, 0.2, 0.3, 0.4, 0.5, 0.6}, places[6], pdf[3] = {1.0, 1.0, 1.0};
    double direction[9] = {0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0}, points[9];
    psc_result status[3] = {7, 7, 7};
    psc_input_f64 in_uv = {{uv, uv + 1, NULL}, 2 * sizeof(double)};
    psc_input_f64 in_direction = {{direction, direction + 1, direction + 2}, 3 * sizeof(double)};
    psc_output_f64 out_pdf = {{pdf, NULL, NULL}, sizeof(double)};
    psc_output_f64 out_uv = {{places, places + 1, NULL}, 2 * sizeof(double)};
    psc_output_result out_status = {status, sizeof(psc_result)};
    psc_samples_f64 samples;
    int ok, i;

    memset(&samples, 0, sizeof samples);
    samples.struct_size = sizeof samples;
    for (i = 0; i < 3; i++)
        samples.point.component[i] = points + i;
    samples.point.stride = 3 * sizeof(double);
    samples.status = out_status;
    memset(points, 0xa5, sizeof points);
    memset(places, 0xa5, sizeof places);
    ok = psc_sample_n_f64(s, 3, &in_uv, &samples) == PSC_EMPTY && untouched(points, sizeof points);
    for (i = 0; i < 3; i++)
        ok &= status[i] == PSC_EMPTY;
    memset(status, 0, sizeof status);
    ok &= psc_invert_n_f64(s, 3, &in_direction, &out_uv, &out_status) == PSC_EMPTY &&
          untouched(places, sizeof places);
    ok &= psc_pdf_n_f64(s, 3, &in_direction, &out_pdf) == PSC_EMPTY;
    for (i = 0; i < 3; i++)
        ok &= status[i] == PSC_EMPTY && pdf[i] == 0.0;
    return ok;
}

static inline int empty_questions(const psc_sampler *s, int built)
{
    psc_description d;
    double total = 1.0, value;
    int ok;

    memset(&d, 0xa5, sizeof d);
    d.struct_size = sizeof d;
    ok = psc_sampler_describe(s, &d) == PSC_EMPTY && d.visibility == PSC_CASE_EMPTY &&
         d.reserved == 0 && (d.shape == PSC_SHAPE_NONE) == !built;
    ok &= psc_sampler_total(s, &total) == PSC_EMPTY && total == 0.0;
    if (!built) {
        value = 1.0;
        ok &= psc_sampler_solid_angle(s, &value) == PSC_EMPTY && value == 0.0;
        value = 1.0;
        ok &= psc_sampler_projected_solid_angle(s, &value) == PSC_EMPTY && value == 0.0;
        value = 1.0;
        ok &= psc_sampler_form_factor(s, &value) == PSC_EMPTY && value == 0.0;
        value = 1.0;
        ok &= psc_sampler_area(s, &value) == PSC_EMPTY && value == 0.0;
    }
    return ok;
}

/* Every call leaves its outputs alone; `built` if the last build gave PSC_EMPTY, not an error. */
static inline int is_empty(const psc_sampler *s, int built)
{
    return empty_f64(s) && empty_f32(s) && empty_arrays(s) && empty_questions(s, built);
}

#endif
