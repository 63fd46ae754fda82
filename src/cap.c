/* SPDX-License-Identifier: Apache-2.0 */
/* Distant lights: a cap of directions, the same from everywhere. */
#include "angles.h"
#include "build.h"
#include "cap_build.h"
#include "cap_light.h"

/* PSC_SUCCESS for a half-angle in [0, limit]. */
static psc_result check_half_angle(double half_angle, double limit)
{
    return !is_finite(half_angle) ? PSC_ERROR_NOT_FINITE
           : half_angle < 0.0     ? PSC_ERROR_NEGATIVE_SIZE
           : half_angle > limit   ? PSC_ERROR_HALF_ANGLE
                                  : PSC_SUCCESS;
}

static psc_result no_area(const psc_sampler *s, double *value)
{
    (void)s, (void)value;
    return PSC_ERROR_UNSUPPORTED_TECHNIQUE;
}

static const char geometry[] = "vs"; /* axis, half-angle */

const struct psc_shape_row psc_shape_cap = {
    PSC_SHAPE_CAP, PSC_KERNEL_CAP, {5, 7, 0, 0}, psc_cap_whole_solid_angle,
    psc_cap_projected_solid_angle, no_area, psc_cap_pdf, psc_cap_invert};

psc_result psc_build_cap(psc_sampler *sampler, const psc_technique *technique,
                         const psc_receiver *receiver, const double axis[3], double half_angle)
{
    return psc_build_vector_scalar(sampler, &psc_shape_cap, technique, receiver, axis, half_angle);
}

psc_result psc_cap_sample_n_f64(const psc_technique *technique, size_t count,
                                const psc_receivers_f64 *receivers, const psc_input_f64 *axis,
                                const psc_input_f64 *half_angle, const psc_input_f64 *uv,
                                const psc_samples_f64 *out)
{
    const psc_input_f64 *const parts[] = {axis, half_angle};

    return psc_wavefront_f64(&psc_shape_cap, geometry, technique, count, receivers, parts, uv, out);
}

psc_result psc_cap_sample_n_f32(const psc_technique *technique, size_t count,
                                const psc_receivers_f32 *receivers, const psc_input_f32 *axis,
                                const psc_input_f32 *half_angle, const psc_input_f32 *uv,
                                const psc_samples_f32 *out)
{
    const psc_input_f32 *const parts[] = {axis, half_angle};

    return psc_wavefront_f32(&psc_shape_cap, geometry, technique, count, receivers, parts, uv, out);
}

psc_result psc_cap_solid_angle(double half_angle, double *solid_angle)
{
    double sine, cosine, versine;
    psc_result result;

    if (!solid_angle)
        return PSC_ERROR_NULL_POINTER;
    result = check_half_angle(half_angle, PSC_PI);
    if (result != PSC_SUCCESS)
        return result;
    sine_cosine(half_angle, &sine, &cosine, &versine);
    *solid_angle = 2.0 * PSC_PI * versine;
    return *solid_angle > 0.0 ? PSC_SUCCESS : PSC_EMPTY;
}

psc_result psc_cap_form_factor(const psc_receiver *receiver, const double axis[3],
                               double half_angle, double *form_factor)
{
    struct psc_request request;
    struct psc_cap_view o;
    psc_result result;

    if (!form_factor || !axis)
        return PSC_ERROR_NULL_POINTER;
    result = psc_check_receiver(receiver, &request);
    if (result != PSC_SUCCESS)
        return result;
    if (!request.normal)
        return PSC_ERROR_NEEDS_NORMAL;
    if (!is_finite3(axis))
        return PSC_ERROR_NOT_FINITE;
    result = check_half_angle(half_angle, 0.5 * PSC_PI);
    if (result != PSC_SUCCESS)
        return result;
    if (largest(axis) == 0.0)
        return PSC_ERROR_ZERO_VECTOR;
    *form_factor = 0.0;
    if (half_angle == 0.0)
        return PSC_EMPTY;
    see_cap(request.normal, axis, half_angle, &o);
    *form_factor = psc_cap_projected(&o.cap, request.facing == PSC_FACING_BOTH) * (1.0 / PSC_PI);
    return *form_factor > 0.0 ? PSC_SUCCESS : PSC_EMPTY;
}

/* ---- By angles, for tests ---- */

psc_result psc_build_cap_angles(psc_sampler *sampler, const psc_technique *technique,
                                double half_angle, double elevation)
{
    static const double origin[3] = {0.0, 0.0, 0.0}, up[3] = {0.0, 0.0, 1.0};
    const psc_receiver receiver = {sizeof receiver, 0, origin, up};
    const double axis[3] = {1.0, 0.0, 0.0}, below = ABS(elevation);
    double versine, sine_d, cosine_d, sine_b;
    psc_result result = psc_build_cap(sampler, technique, &receiver, axis, half_angle);
    struct psc_cap *cap = &sampler->cap.seen;
    struct psc_cap_view o;

    if (result != PSC_SUCCESS)
        return result;
    see_cap(up, axis, half_angle, &o);
    sine_cosine(below, &sine_b, &cap->cos_b, &versine);
    cap->sin_b = COPYSIGN(sine_b, elevation);
    sine_cosine(ABS(half_angle - below), &sine_d, &cosine_d, &versine);
    cap->q2 = COPYSIGN(sine_d, half_angle - below) *
              (cap->sin_a * cap->cos_b + cap->cos_a * sine_b);
    copy_cap(cap, &o.cap);
    o.axis[0] = cap->cos_b;
    o.axis[2] = cap->sin_b;
    result = cap_sides(sampler, &o);
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
    struct psc_side *side = bare.cap.side;
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
    struct psc_side *side = bare.cap.side;
    int i;

    for (i = 0; i < 3; i++)
        side->axis[i] = 0.0;
    bare.f32->sample(&bare, u, v, &sample);
    memcpy(offset, sample.direction, sizeof sample.direction);
}
