/* SPDX-License-Identifier: Apache-2.0 */
#include "cap_light.h"

#include "cap_build.h"
#include "cap_inverse.h"

/* ---- Totals ---- */

double psc_cap_projected(const struct psc_cap *cap, int both)
{
    const struct psc_cap below = mirrored(cap);
    struct psc_lobe_f64 l;
    double q, total;

    lobe_total(&l, psc_cap_region(cap), cap, psc_cap_versine(cap), &q);
    total = l.total;
    if (both) {
        lobe_total(&l, psc_cap_region(&below), &below, psc_cap_versine(&below), &q);
        total += l.total;
    }
    return total;
}

psc_result psc_cap_projected_solid_angle(const psc_sampler *s, double *value)
{
    if (s->facing == PSC_FACING_NONE)
        return PSC_ERROR_NEEDS_NORMAL;
    if (s->cap.seen.cos_a < 0.0)
        return PSC_ERROR_HALF_ANGLE;
    *value = s->cap.inside            ? PSC_PI * (s->facing == PSC_FACING_BOTH ? 2.0 : 1.0)
             : s->cap.seen.sin_a > 0.0 ? psc_cap_projected(&s->cap.seen, s->facing == PSC_FACING_BOTH)
                                  : 0.0;
    return *value > 0.0 ? PSC_SUCCESS : PSC_EMPTY;
}

psc_result psc_cap_whole_solid_angle(const psc_sampler *s, double *value)
{
    const int no_size = s->cap.seen.sin_a == 0.0 && s->cap.seen.cos_a == 0.0;

    *value = s->cap.inside ? 4.0 * PSC_PI
             : no_size ? 0.0
                       : 2.0 * PSC_PI * psc_cap_versine(&s->cap.seen);
    return *value > 0.0 ? PSC_SUCCESS : PSC_EMPTY;
}

/* ---- Directions ---- */

double psc_cap_pdf(const psc_sampler *s, const double direction[3], double epsilon)
{
    const struct psc_cap_light *light = &s->cap;
    const int area = is_area_map(light->side[0].map);
    double pdf = 0.0;
    int i;

    for (i = 0; i < s->sides && !(pdf > 0.0); i++)
        pdf = seen_pdf(light, light->side + i, seen_reach(light, i), area, light->inside,
                       s->projected, s->inverse_total, direction, epsilon);
    return pdf;
}

psc_result psc_cap_invert(const psc_sampler *s, const double direction[3], double epsilon,
                          double uv[2])
{
    const struct psc_cap_light *light = &s->cap;
    const double stretch = seen_stretch(direction);
    struct seen d;
    int i;

    for (i = 0; i < s->sides; i++)
        if (look(light->side + i, direction, stretch, epsilon, seen_reach(light, i),
                 s->projected, &d)) {
            seen_invert(light, i, light->side[i].map, s->map == PSC_MAP_CONCENTRIC,
                        light->inside, direction, &d, uv);
            share_sides(s->sides, i, s->split, uv);
            return PSC_SUCCESS;
        }
    return PSC_OUTSIDE;
}
