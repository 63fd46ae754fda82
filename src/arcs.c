/* SPDX-License-Identifier: Apache-2.0 */
#include "arcs.h"

#include "cap_view.h"
#include "disk_build.h"

psc_result psc_build_ellipse_arcs(psc_sampler *sampler, const psc_technique *technique,
                                  double alpha, double beta)
{
    static const double origin[3] = {0.0, 0.0, 0.0}, center[3] = {0.0, 0.0, 1.0};
    static const double axis_u[3] = {1.0, 0.0, 0.0}, axis_v[3] = {0.0, 0.5, 0.0};
    const psc_receiver receiver = {sizeof receiver, 0, origin, NULL};
    psc_result result = psc_build_ellipse(sampler, technique, &receiver, center, axis_u, axis_v);
    struct psc_ellipse *e = &sampler->disk.seen;
    double versine;

    if (result != PSC_SUCCESS)
        return result;
    sine_cosine(alpha, &e->a, &e->ca, &versine);
    sine_cosine(beta, &e->b, &e->cb, &versine);
    e->at = e->a / e->ca;
    e->bt = e->b / e->cb;
    sampler->disk.cdf.terms = 0;
    disk_head(sampler, technique->table);
    disk_fit(sampler);
    sampler->inverse_total = 1.0 / sampler->total;
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
