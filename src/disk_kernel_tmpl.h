/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Sampling of one build of a light that is seen as an elliptic cone, one sample at a time.
 * Template: see precision.h.
 */
#include "disk_world_tmpl.h"

#if PSC_REAL_BITS == 64
#define DISK_RULES PSC_RULES_F64
#define SPAN_RULES PSC_SPAN_RULES_F64
#define DISK_RULE(d) ((d)->rule_f64)
#define DISK_FIT(d) ((d)->fit_f64)
#define AREA_LEAST (-1.0)
#define DISK_TERMS PSC_MOST_TERMS_F64
#define DISK_RULE_TABLE(m) psc_rule_f64_##m
#else
#define DISK_RULES PSC_RULES_F32
#define SPAN_RULES PSC_SPAN_RULES_F32
#define DISK_RULE(d) ((d)->rule_f32)
#define DISK_FIT(d) ((d)->fit_f32)
#define DISK_TERMS PSC_MOST_TERMS_F32
#define DISK_RULE_TABLE(m) psc_rule_f32_##m
/* Cubes of distances must be numbers: the height of the receiver over the light, by the larger of
   its distance and its size. */
#define AREA_LEAST 1e-12
#endif
#define AREA_FITS(d) ((d)->laid.height > AREA_LEAST)

static void FN(round_point)(const struct psc_disk_point_f64 *wide, struct FN(psc_disk_point) *p)
{
    p->x = (real)wide->x;
    p->y = (real)wide->y;
    p->z = (real)wide->z;
    p->c = (real)wide->c;
    p->s = (real)wide->s;
    p->rest = (real)wide->rest;
}

static void FN(solved_point)(const psc_sampler *s, real u, real v, struct FN(psc_disk_point) *p)
{
    struct psc_disk_point_f64 wide;

    solve_point(s, (double)u, (double)v, &wide);
    FN(round_point)(&wide, p);
}

static double FN(tabulated_point)(const psc_sampler *s, real u, real v,
                                  struct FN(psc_disk_point) *p)
{
    struct psc_disk_point_f64 wide;
    const double density = table_point(&s->disk, (double)u, (double)v, &wide);

    FN(round_point)(&wide, p);
    return density;
}

static void FN(disk_point)(const psc_sampler *s, const struct FN(psc_disk_world) *w, real u, real v,
                           struct FN(psc_disk_point) *p)
{
    const struct psc_disk_light *d = &s->disk;

    switch (d->map) {
    case PSC_DISK_AREA_RADIAL:
    case PSC_DISK_AREA_CONCENTRIC:
    case PSC_DISK_AREA_PARALLEL:
        if (AREA_FITS(d)) {
            FN(area_lane)(d->map, w, u, v, p);
            return;
        }
        break;
    case PSC_DISK_RADIAL:
    case PSC_DISK_CONCENTRIC:
        switch (DISK_RULE(d)) {
#define DISK_CASE(i, m, steps, least)                                                             \
    case i:                                                                                       \
        FN(fitted_point)(m, 1, DISK_FIT(d), d->map == PSC_DISK_CONCENTRIC, w->a, w->b, u, v, p); \
        return;
            DISK_RULES(DISK_CASE)
#undef DISK_CASE
        default: break;
        }
        break;
    case PSC_DISK_PARALLEL:
        switch (DISK_RULE(d)) {
#define SPAN_CASE(i, m, steps, least)                                                              \
    case i: FN(span_point)(m, steps, 1, DISK_FIT(d), w->a, w->ca, w->b, w->cb, u, v, p); return;
            SPAN_RULES(SPAN_CASE)
#undef SPAN_CASE
        default: break;
        }
        break;
    case PSC_DISK_QUASI_UNIFORM:
        FN(quasi_point)(w->a, w->b, w->ca2, w->cb2, w->mu1, u, v, p);
        return;
    default: break;
    }
    FN(solved_point)(s, u, v, p);
}

/* Of a sampler that is not empty. */
static psc_result FN(disk_sample_seen)(const psc_sampler *s, real u, real v,
                                       FN(psc_light_sample) *out)
{
    struct FN(psc_disk_world) w;
    struct FN(psc_disk_point) p;
    double density = 0.0;
    real cosine;

    FN(disk_world)(s, &w);
    if (w.map == PSC_DISK_TABULATED)
        density = FN(tabulated_point)(s, u, v, &p);
    else
        FN(disk_point)(s, &w, u, v, &p);
    FN(disk_direction)(&w, &p, out->direction);
    cosine = FN(disk_cosine)(w.facing, &w, out->direction);
    if (w.map == PSC_DISK_TABULATED) {
        out->pdf = (real)density;
        out->weight = density > 0.0 ? (real)((double)cosine / density) : K(0.0);
    } else {
        FN(disk_density)(disk_density_of(w.map), &w, &p, cosine, &out->pdf, &out->weight);
    }
    FN(disk_hit)(w.hit, &w, &p, out->direction, out->point, out->normal, &out->distance,
                 out->surface);
    return out->weight > K(0.0) ? PSC_SUCCESS : PSC_CULLED;
}

static psc_result FN(disk_sample)(const psc_sampler *s, real u, real v, FN(psc_light_sample) *out)
{
    return s->sides == 0 ? PSC_EMPTY : FN(disk_sample_seen)(s, u, v, out);
}
