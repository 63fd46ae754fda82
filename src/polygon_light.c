/* SPDX-License-Identifier: Apache-2.0 */
#include "polygon_light.h"

#include "fan_inverse.h"

#undef PSC_BITS
#define PSC_BITS 64
#include "precision.h"
#include "fan_map_tmpl.h"

/* ---- Totals ---- */

psc_result psc_polygon_solid_angle_of(const psc_sampler *s, double *value)
{
    *value = s->sides == 0 ? 0.0 : s->polygon.solid_angle;
    return *value > 0.0 ? PSC_SUCCESS : PSC_EMPTY;
}

psc_result psc_polygon_projected_solid_angle(const psc_sampler *s, double *value)
{
    (void)value;
    return s->facing == PSC_FACING_NONE ? PSC_ERROR_NEEDS_NORMAL : PSC_ERROR_UNSUPPORTED_TECHNIQUE;
}

psc_result psc_polygon_area(const psc_sampler *s, double *value)
{
    *value = s->sides == 0 ? 0.0 : s->polygon.area;
    return *value > 0.0 ? PSC_SUCCESS : PSC_EMPTY;
}

/* ---- Directions ---- */

/* The triangle of the fan that holds the direction, and the direction in its frame; -1 outside. */
static int find_triangle(const struct psc_polygon_light *l, const double direction[3],
                         double epsilon, struct psc_spot_f64 *p)
{
    const double slack = 32.0 * epsilon;
    int i, found = -1;
    double best = 0.0;

    for (i = 0; i < l->triangles; i++) {
        struct psc_fan_edges e;
        struct psc_spot_f64 q;
        double inside;

        fan_look(l->fan + i, direction, &q);
        if (!fan_holds(l->fan + i, &q, slack))
            continue;
        /* Between two triangles both may claim it. */
        fan_edges(l->fan + i, &e);
        inside = MIN(q.c, spot_dot(&q, &e.bc));
        if (found < 0 || inside > best) {
            found = i;
            best = inside;
            *p = q;
        }
    }
    return found;
}

double psc_polygon_pdf(const psc_sampler *s, const double direction[3], double epsilon)
{
    const struct psc_polygon_light *l = &s->polygon;
    struct psc_spot_f64 p;
    const int k = find_triangle(l, direction, epsilon, &p);
    double a, b, c, t;

    if (k < 0)
        return 0.0;
    if (s->measure != PSC_MEASURE_AREA)
        return s->inverse_total;
    fan_hit_f64(l->fan + k, &p, &a, &b, &c, &t);
    return 2.0 * (t * t * t) / l->volume;
}

psc_result psc_polygon_invert(const psc_sampler *s, const double direction[3], double epsilon,
                              double uv[2])
{
    const struct psc_polygon_light *l = &s->polygon;
    struct psc_spot_f64 p;
    const int k = find_triangle(l, direction, epsilon, &p);
    int i;

    if (k < 0)
        return PSC_OUTSIDE;
    if (s->measure == PSC_MEASURE_AREA) {
        double a, b, c, t, rest;

        fan_hit_f64(l->fan + k, &p, &a, &b, &c, &t);
        rest = a + c;
        uv[0] = rest > 0.0 ? c / rest : 0.0;
        uv[1] = rest * rest;
    } else {
        fan_invert(l->fan + k, &p, uv);
    }
    for (i = 0; i < 2; i++)
        uv[i] = MIN(MAX(uv[i], 0.0), 1.0);
    if (l->triangles > 1)
        uv[0] = MIN(l->below[k] + uv[0] / l->per_share[k], 1.0);
    return PSC_SUCCESS;
}
