/* SPDX-License-Identifier: Apache-2.0 */
#include "arcs.h"

#include "cap_view.h"
#include "disk_build.h"

static void set_arcs(struct psc_ellipse *e, double alpha, double beta)
{
    double versine;

    sine_cosine(alpha, &e->a, &e->ca, &versine);
    sine_cosine(beta, &e->b, &e->cb, &versine);
    e->at = e->a / e->ca;
    e->bt = e->b / e->cb;
}

psc_result psc_build_ellipse_arcs(psc_sampler *sampler, const psc_technique *technique,
                                  double alpha, double beta)
{
    static const double origin[3] = {0.0, 0.0, 0.0}, center[3] = {0.0, 0.0, 1.0};
    static const double axis_u[3] = {1.0, 0.0, 0.0}, axis_v[3] = {0.0, 0.5, 0.0};
    const psc_receiver receiver = {sizeof receiver, 0, origin, NULL};
    psc_result result = psc_build_ellipse(sampler, technique, &receiver, center, axis_u, axis_v);
    struct psc_ellipse *e = &sampler->disk.seen;

    if (result != PSC_SUCCESS)
        return result;
    set_arcs(e, alpha, beta);
    sampler->disk.cdf.terms = 0;
    disk_head(sampler, technique->table);
    disk_fit(sampler);
    sampler->inverse_total = 1.0 / sampler->total;
    return result;
}

psc_result psc_build_ellipse_above(psc_sampler *sampler, double alpha, double beta,
                                   const double upwards[2], int lower, double gap)
{
    static const double origin[3] = {0.0, 0.0, 0.0}, center[3] = {0.0, 0.0, 1.0};
    static const double axis_u[3] = {1.0, 0.0, 0.0}, axis_v[3] = {0.0, 0.5, 0.0};
    const psc_technique technique = {sizeof technique, PSC_MEASURE_PROJECTED_SOLID_ANGLE,
                                     PSC_MAP_PARALLEL, 0, NULL};
    const psc_receiver receiver = {sizeof receiver, 0, origin, center};
    psc_result result = psc_build_ellipse(sampler, &technique, &receiver, center, axis_u, axis_v);
    struct psc_ellipse *e = &sampler->disk.seen;
    struct psc_horizon *h = &sampler->disk.horizon;
    const double length = SQRT(upwards[0] * upwards[0] + upwards[1] * upwards[1]);
    double versine, sine, cosine, tangent, m, sin_m, nf, other;

    if (result != PSC_SUCCESS)
        return result;
    set_arcs(e, alpha, beta);
    h->x = e->at * (upwards[0] / length);
    h->y = e->bt * (upwards[1] / length);
    tangent = SQRT(h->x * h->x + h->y * h->y);
    m = 1.0 / SQRT(1.0 + tangent * tangent); /* the cosine */
    sin_m = tangent * m;
    sine_cosine(ABS(gap), &sine, &cosine, &versine);
    sine = COPYSIGN(sine, gap);
    /* the elevation of the axis is gap - m or m + gap */
    h->z = lower ? sin_m * cosine + m * sine : m * sine - sin_m * cosine;
    nf = lower ? m * cosine - sin_m * sine : m * cosine + sin_m * sine;
    h->x *= nf;
    h->y *= nf;
    other = lower ? 2.0 * sin_m * m * cosine + (m - sin_m) * (m + sin_m) * sine
                  : 2.0 * sin_m * m * cosine - (m - sin_m) * (m + sin_m) * sine;
    h->margin = (lower ? -sine : sine) * other / (m * m);
    result = fibre_sides(sampler);
    sampler->inverse_total = result == PSC_SUCCESS ? 1.0 / sampler->total : 0.0;
    return result;
}

/* Without the axis, the direction is the offset. */
static psc_sampler without_axis(const psc_sampler *sampler)
{
    psc_sampler bare = *sampler;
    int i;

    for (i = 0; i < 3; i++)
        bare.disk.axis[i] = 0.0;
    return bare;
}

void psc_sample_cone_offset_f64(const psc_sampler *sampler, double u, double v, double offset[3])
{
    const psc_sampler bare = without_axis(sampler);
    psc_light_sample_f64 sample;

    bare.f64->sample(&bare, u, v, &sample);
    memcpy(offset, sample.direction, sizeof sample.direction);
}

void psc_sample_cone_offset_f32(const psc_sampler *sampler, float u, float v, float offset[3])
{
    const psc_sampler bare = without_axis(sampler);
    psc_light_sample_f32 sample;

    bare.f32->sample(&bare, u, v, &sample);
    memcpy(offset, sample.direction, sizeof sample.direction);
}
