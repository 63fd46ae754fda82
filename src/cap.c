/* SPDX-License-Identifier: Apache-2.0 */
/* Distant lights: a cap of directions, the same from everywhere. */
#include <math.h>

#include "angles.h"
#include "cap_light.h"
#include "vector.h"

#define PSC_PI_LOW 1.2246467991473532e-16 /* pi - PSC_PI */

/* Sine, cosine and 1 - cosine of an angle in [0, pi], each accurate relative to itself. */
static void sine_cosine(double a, double *sine, double *cosine, double *versine)
{
    const double right = 0.5 * PSC_PI;
    double defect, v, x;

    if (a < 1.0) {
        sine_cosine_defects_f64(a, &defect, versine);
        *sine = a - defect;
        *cosine = 1.0 - *versine;
    } else if (a < PSC_PI - 1.0) {
        x = (right - a) + 0.5 * PSC_PI_LOW;
        sine_cosine_defects_f64(x, &defect, &v);
        *sine = 1.0 - v;
        *cosine = x - defect;
        *versine = 1.0 - *cosine;
    } else {
        x = (PSC_PI - a) + PSC_PI_LOW;
        sine_cosine_defects_f64(x, &defect, &v);
        *sine = x - defect;
        *cosine = v - 1.0;
        *versine = 2.0 - v;
    }
}

static psc_result check_half_angle(double half_angle)
{
    return half_angle < 0.0      ? PSC_ERROR_NEGATIVE_SIZE
           : half_angle > PSC_PI ? PSC_ERROR_HALF_ANGLE
                                 : PSC_SUCCESS;
}

static psc_result see_cap(const struct psc_view *view, const double axis[3], double half_angle,
                          struct psc_cap *cap, struct psc_cap_frame *frame, double *h0)
{
    const psc_result result = check_half_angle(half_angle);
    double a[3], length;
    int i;

    if (result != PSC_SUCCESS)
        return result;
    if (!scale_to_one(axis, a))
        return PSC_ERROR_ZERO_VECTOR;
    length = SQRT(dot(a, a));
    for (i = 0; i < 3; i++)
        frame->axis[i] = a[i] / length;
    sine_cosine(half_angle, &cap->sin_a, &cap->cos_a, h0);
    if (view->facing == PSC_FACING_NONE) {
        psc_cap_frame_around(frame->axis, frame);
        cap->sin_b = 1.0;
        cap->cos_b = 0.0;
        cap->q2 = 0.0;
    } else {
        const double normal_length = SQRT(dot(view->normal, view->normal));
        const double both = 1.0 / (length * normal_length);
        double across[3], reach, up = 0.0, up_low = 0.0;

        for (i = 0; i < 3; i++) {
            frame->normal[i] = view->normal[i] / normal_length;
            add_product(view->normal[i], a[i], &up, &up_low);
        }
        cross(view->normal, a, across);
        reach = SQRT(dot(across, across));
        if (reach > 0.0)
            for (i = 0; i < 3; i++)
                frame->sideways[i] = across[i] / reach;
        else
            perpendicular(frame->normal, frame->sideways);
        cap->sin_b = (up + up_low) * both;
        cap->cos_b = reach * both;
        /* sin^2 alpha - sin^2 beta, from whichever pair is smaller. */
        cap->q2 = ABS(cap->sin_b) <= cap->cos_b
                      ? (cap->sin_a - ABS(cap->sin_b)) * (cap->sin_a + ABS(cap->sin_b))
                      : (cap->cos_b - ABS(cap->cos_a)) * (cap->cos_b + ABS(cap->cos_a));
    }
    return half_angle > 0.0 ? PSC_SUCCESS : PSC_EMPTY;
}

static psc_result build(psc_sampler *s, const struct psc_view *view, const double *g)
{
    struct psc_cap_frame frame;
    double h0;
    psc_result result;

    s->distance = (double)INFINITY;
    if (s->measure == PSC_MEASURE_AREA || s->measure == PSC_MEASURE_VISIBLE_AREA ||
        (s->map == PSC_MAP_PARALLEL && !s->projected))
        return PSC_ERROR_UNSUPPORTED_TECHNIQUE;
    result = see_cap(view, g, g[3], &s->cap, &frame, &h0);
    if (result != PSC_SUCCESS) {
        memset(&s->cap, 0, sizeof s->cap);
        return result;
    }
    if (s->projected && s->cap.cos_a < 0.0)
        return PSC_ERROR_HALF_ANGLE;
    return psc_cap_sides(s, &frame, h0);
}

static psc_result no_area(const psc_sampler *s, double *value)
{
    (void)s, (void)value;
    return PSC_ERROR_UNSUPPORTED_TECHNIQUE;
}

const struct psc_shape_row psc_shape_cap = {
    PSC_SHAPE_CAP, "vs", build, psc_cap_whole_solid_angle, psc_cap_projected_solid_angle, no_area,
    psc_cap_pdf, psc_cap_invert};

psc_result psc_build_cap(psc_sampler *sampler, const psc_technique *technique,
                         const psc_receiver *receiver, const double axis[3], double half_angle)
{
    const double *const parts[] = {axis, &half_angle};

    return psc_build(sampler, &psc_shape_cap, technique, receiver, parts);
}

psc_result psc_cap_sample_n_f64(const psc_technique *technique, size_t count,
                                const psc_receivers_f64 *receivers, const psc_input_f64 *axis,
                                const psc_input_f64 *half_angle, const psc_input_f64 *uv,
                                const psc_samples_f64 *out)
{
    const psc_input_f64 *const parts[] = {axis, half_angle};

    return psc_wavefront_f64(&psc_shape_cap, technique, count, receivers, parts, uv, out);
}

psc_result psc_cap_sample_n_f32(const psc_technique *technique, size_t count,
                                const psc_receivers_f32 *receivers, const psc_input_f32 *axis,
                                const psc_input_f32 *half_angle, const psc_input_f32 *uv,
                                const psc_samples_f32 *out)
{
    const psc_input_f32 *const parts[] = {axis, half_angle};

    return psc_wavefront_f32(&psc_shape_cap, technique, count, receivers, parts, uv, out);
}

psc_result psc_cap_solid_angle(double half_angle, double *solid_angle)
{
    double sine, cosine, versine;
    psc_result result;

    if (!solid_angle)
        return PSC_ERROR_NULL_POINTER;
    if (!is_finite(half_angle))
        return PSC_ERROR_NOT_FINITE;
    result = check_half_angle(half_angle);
    if (result != PSC_SUCCESS)
        return result;
    sine_cosine(half_angle, &sine, &cosine, &versine);
    *solid_angle = 2.0 * PSC_PI * versine;
    return *solid_angle > 0.0 ? PSC_SUCCESS : PSC_EMPTY;
}

psc_result psc_cap_form_factor(const psc_receiver *receiver, const double axis[3],
                               double half_angle, double *form_factor)
{
    struct psc_cap_frame frame;
    struct psc_view view;
    struct psc_cap cap;
    psc_result result;
    double h0;

    if (!form_factor || !axis)
        return PSC_ERROR_NULL_POINTER;
    result = psc_read_receiver(receiver, &view);
    if (result != PSC_SUCCESS)
        return result;
    if (view.facing == PSC_FACING_NONE)
        return PSC_ERROR_NEEDS_NORMAL;
    if (!is_finite3(axis) || !is_finite(half_angle))
        return PSC_ERROR_NOT_FINITE;
    result = see_cap(&view, axis, half_angle, &cap, &frame, &h0);
    if (result < 0)
        return result;
    if (cap.cos_a < 0.0)
        return PSC_ERROR_HALF_ANGLE;
    *form_factor = result == PSC_EMPTY
                       ? 0.0
                       : psc_cap_projected(&cap, view.facing == PSC_FACING_BOTH) * (1.0 / PSC_PI);
    return *form_factor > 0.0 ? PSC_SUCCESS : PSC_EMPTY;
}

/* ---- By angles, for tests ---- */

psc_result psc_build_cap_angles(psc_sampler *sampler, const psc_technique *technique,
                                double half_angle, double elevation)
{
    static const double origin[3] = {0.0, 0.0, 0.0}, up[3] = {0.0, 0.0, 1.0};
    const psc_receiver receiver = {sizeof receiver, 0, origin, up};
    const double below = ABS(elevation);
    struct psc_cap_frame frame = {{0.0, 0.0, 1.0}, {0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}};
    double axis[3] = {1.0, 0.0, 0.0}, h0, versine, sine_d, cosine_d, sine_b;
    psc_result result = psc_build_cap(sampler, technique, &receiver, axis, half_angle);
    struct psc_cap *cap = &sampler->cap;

    if (result != PSC_SUCCESS)
        return result;
    sine_cosine(half_angle, &cap->sin_a, &cap->cos_a, &h0);
    sine_cosine(below, &sine_b, &cap->cos_b, &versine);
    cap->sin_b = COPYSIGN(sine_b, elevation);
    sine_cosine(ABS(half_angle - below), &sine_d, &cosine_d, &versine);
    cap->q2 = COPYSIGN(sine_d, half_angle - below) *
              (cap->sin_a * cap->cos_b + cap->cos_a * sine_b);
    frame.axis[0] = cap->cos_b;
    frame.axis[2] = cap->sin_b;
    result = psc_cap_sides(sampler, &frame, h0);
    if (result != PSC_SUCCESS)
        psc_clear(sampler);
    else
        sampler->inverse_total = 1.0 / sampler->total;
    return result;
}

void psc_sample_offset_f64(const psc_sampler *sampler, double u, double v, double offset[3])
{
    psc_sampler bare = *sampler;
    psc_light_sample_f64 sample;
    struct psc_side *side = bare.side;
    int i;

    /* Without the axis, the direction is the offset. */
    for (i = 0; i < 3; i++)
        side->axis[i] = 0.0;
    bare.f64->sample(&bare, u, v, &sample);
    memcpy(offset, sample.direction, sizeof sample.direction);
}

void psc_sample_offset_f32(const psc_sampler *sampler, float u, float v, float offset[3])
{
    psc_sampler bare = *sampler;
    psc_light_sample_f32 sample;
    struct psc_side *side = bare.side;
    int i;

    for (i = 0; i < 3; i++)
        side->axis[i] = 0.0;
    bare.f32->sample(&bare, u, v, &sample);
    memcpy(offset, sample.direction, sizeof sample.direction);
}
