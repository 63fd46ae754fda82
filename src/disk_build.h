/* SPDX-License-Identifier: Apache-2.0 */
/* From a disk, an elliptical disk or an ellipsoid to a sampler that is ready. */
#ifndef PSC_SRC_DISK_BUILD_H
#define PSC_SRC_DISK_BUILD_H

#include "disk_table.h"
#include "disk_view.h"
#include "ellipsoid_see.h"

#include "ellipse_fit_tmpl.h"
#include "span_fit_tmpl.h"
#undef PSC_BITS
#define PSC_BITS 32
#include "precision.h"
#include "ellipse_fit_tmpl.h"
#include "span_fit_tmpl.h"
#undef PSC_BITS
#define PSC_BITS 64
#include "precision.h"

#include "fibre_build.h"

/* What rules of interpolation are chosen by. */
PSC_LANE double rule_quotient(enum psc_disk_map map, double ca, double cb)
{
    return map == PSC_DISK_PARALLEL || !(cb > 0.0) ? ca : ca / cb;
}

/* The rules of interpolation of a cone by its map. */
#define RULE_AT_LEAST(i, m, steps, least) quotient >= (least) ? (i) :
static inline void choose_rules(struct psc_disk_light *d)
{
    const double quotient = rule_quotient(d->map, d->seen.ca, d->seen.cb);

    if (d->map == PSC_DISK_PARALLEL) {
        d->rule_f64 = PSC_SPAN_RULES_F64(RULE_AT_LEAST) -1;
        d->rule_f32 = PSC_SPAN_RULES_F32(RULE_AT_LEAST) -1;
    } else {
        d->rule_f64 = PSC_RULES_F64(RULE_AT_LEAST) -1;
        d->rule_f32 = PSC_RULES_F32(RULE_AT_LEAST) -1;
    }
}
#undef RULE_AT_LEAST

/* What the radial maps need, in both precisions. */
static inline void radial_fit(struct psc_disk_light *d)
{
    const struct psc_ellipse *e = &d->seen;
    const double ca2 = e->ca * e->ca, cb2 = e->cb * e->cb;
    const double bend = (e->cb - e->ca) * (e->cb + e->ca), mu1 = ellipse_mu1(e->ca, e->cb);
    const float ca2_f = (float)ca2, cb2_f = (float)cb2, bend_f = (float)bend, mu1_f = (float)mu1;
    const struct fit_input_f64 wide = {&ca2, &cb2, &bend, &mu1};
    const struct fit_input_f32 narrow = {&ca2_f, &cb2_f, &bend_f, &mu1_f};
    double work[4 * PSC_MOST_TERMS_F64];
    float work_f[4 * PSC_MOST_TERMS_F32], series_f[PSC_MOST_TERMS_F32];

#define FIT_CASE_F64(i, m, steps, least)                                                           \
    case i:                                                                                        \
        fit_f64(m, steps, 1, 1, psc_rule_f64_##m.c, psc_rule_f64_##m.s, psc_rule_f64_##m.per_c,    \
                psc_rule_f64_##m.per_s, psc_rule_f64_##m.wave, psc_rule_f64_##m.power, &wide,      \
                work, d->cdf.series, d->fit_f64);                                                  \
        d->cdf.terms = m;                                                                          \
        break;
#define FIT_CASE_F32(i, m, steps, least)                                                           \
    case i:                                                                                        \
        fit_f32(m, steps, 1, 1, psc_rule_f32_##m.c, psc_rule_f32_##m.s, psc_rule_f32_##m.per_c,    \
                psc_rule_f32_##m.per_s, psc_rule_f32_##m.wave, psc_rule_f32_##m.power, &narrow,    \
                work_f, series_f, d->fit_f32);                                                     \
        break;
    switch (d->rule_f64) {
        PSC_RULES_F64(FIT_CASE_F64)
    default: return;
    }
    switch (d->rule_f32) {
        PSC_RULES_F32(FIT_CASE_F32)
    default: break;
    }
#undef FIT_CASE_F64
#undef FIT_CASE_F32
    d->cdf.mean = d->cdf.series[0];
}

/* What the parallel map needs, in both precisions. */
static inline void parallel_fit(struct psc_disk_light *d)
{
    const double ca = d->seen.ca, cb = d->seen.cb;
    const float ca_f = (float)ca, cb_f = (float)cb;
    const struct span_input_f64 wide = {&ca, &cb};
    const struct span_input_f32 narrow = {&ca_f, &cb_f};
    double work[PSC_MOST_TERMS_F64 + 1];
    float work_f[PSC_MOST_TERMS_F32 + 1];

#define SPAN_CASE_F64(i, m, steps, least)                                                          \
    case i:                                                                                        \
        span_fit_f64(m, 1, 1, psc_rule_f64_##m.c, psc_rule_f64_##m.s, psc_rule_f64_##m.wave,       \
                     &wide, work, d->fit_f64);                                                     \
        break;
#define SPAN_CASE_F32(i, m, steps, least)                                                          \
    case i:                                                                                        \
        span_fit_f32(m, 1, 1, psc_rule_f32_##m.c, psc_rule_f32_##m.s, psc_rule_f32_##m.wave,       \
                     &narrow, work_f, d->fit_f32);                                                 \
        break;
    switch (d->rule_f64) {
        PSC_SPAN_RULES_F64(SPAN_CASE_F64)
    default: break;
    }
    switch (d->rule_f32) {
        PSC_SPAN_RULES_F32(SPAN_CASE_F32)
    default: break;
    }
#undef SPAN_CASE_F64
#undef SPAN_CASE_F32
}

/* A half space: the cone of a receiver on a surface. */
static inline void half_space_fit(struct psc_disk_light *d)
{
    int i;

    memset(d->fit_f64, 0, sizeof d->fit_f64);
    memset(d->fit_f32, 0, sizeof d->fit_f32);
    memset(d->cdf.series, 0, sizeof d->cdf.series);
    for (i = 0; i < 3; i++) {
        d->fit_f64[4 * i] = 1.0;
        d->fit_f32[3 * i] = 1.0f;
    }
    d->cdf.mean = 1.0;
    d->cdf.terms = 1;
}

/* By psc_map; inside an ellipsoid there is one for all measures. */
static inline enum psc_disk_map disk_map_of(psc_measure measure, psc_map map, int inside)
{
    static const enum psc_disk_map
        solid_angle[] = {PSC_DISK_RADIAL, PSC_DISK_PARALLEL, PSC_DISK_CONCENTRIC,
                         PSC_DISK_QUASI_UNIFORM, PSC_DISK_TABULATED},
        area[] = {PSC_DISK_AREA_RADIAL, PSC_DISK_AREA_PARALLEL, PSC_DISK_AREA_CONCENTRIC},
        around[] = {PSC_DISK_AROUND_RADIAL, PSC_DISK_AROUND_PARALLEL, PSC_DISK_AROUND_CONCENTRIC,
                    PSC_DISK_AROUND_RADIAL, PSC_DISK_AROUND_RADIAL};

    return (inside                        ? around
            : measure == PSC_MEASURE_AREA ? area
                                          : solid_angle)[map];
}

/* The map of a cone that is seen, or of a flat light by area, and its total. */
static inline void disk_head(psc_sampler *s, const psc_table *table)
{
    struct psc_disk_light *d = &s->disk;

    s->sides = 1;
    d->map = disk_map_of(s->measure, s->map, d->inside);
    if (s->measure == PSC_MEASURE_AREA) {
        d->axis[0] = d->axis[1] = d->axis[2] = 0.0;
        s->total = d->area;
        return;
    }
    memcpy(d->axis, d->seen.z, sizeof d->axis);
    if (d->map == PSC_DISK_TABULATED)
        table_choose(d, table);
    s->total = d->inside ? 4.0 * PSC_PI : ellipse_total(&d->seen);
    choose_rules(d);
}

/* The fibres above the horizon, and below it where the receiver is lit on both sides. From inside
   the cone is the hemisphere above, and below its mirror image. */
static inline psc_result fibre_sides(psc_sampler *s)
{
    struct psc_disk_light *d = &s->disk;
    const struct psc_horizon *h = &d->horizon;
    const struct psc_horizon below = {-h->x, -h->y, -h->z, h->margin};

    memcpy(d->axis, d->seen.z, sizeof d->axis);
    d->map = PSC_DISK_FIBRES;
    s->sides = fibres_build(d->fibres, &d->seen, h);
    s->total = s->sides ? d->fibres[0].total : 0.0;
    s->split = 1.0;
    if (s->facing == PSC_FACING_BOTH) {
        const double above = s->total;
        struct psc_fibres *second = d->fibres + s->sides;

        if (fibres_build(second, &d->seen, d->inside ? h : &below)) {
            s->sides++;
            s->total += second->total;
            s->split = above / s->total;
        }
    }
    return s->sides > 0 ? PSC_SUCCESS : PSC_EMPTY;
}

/* What samples by solid angle need beyond that. */
static inline void disk_fit(psc_sampler *s)
{
    struct psc_disk_light *d = &s->disk;

    if (d->map > PSC_DISK_PARALLEL)
        return;
    if (!(d->seen.ca > 0.0))
        half_space_fit(d);
    else if (d->map == PSC_DISK_PARALLEL)
        parallel_fit(d);
    else
        radial_fit(d);
    cdf_build(&d->cdf, &d->seen);
}

/* What questions about other measures are answered from, whatever is sampled. */
static inline void keep_given(struct psc_disk_light *d, const struct psc_request *request,
                              const double *geometry, int numbers)
{
    copy3(request->position, d->given_position);
    if (request->normal)
        copy3(request->normal, d->given_normal);
    d->numbers = numbers;
    memcpy(d->given, geometry, (size_t)numbers * sizeof *geometry);
}

/* The public builds: all of the above. */
#define DISK_BUILD(name, numbers)                                                               \
    static inline psc_result name##_build(psc_sampler *s, const struct psc_request *request,    \
                                          const double *geometry)                               \
    {                                                                                           \
        const psc_result result = name##_see(s, request, geometry);                             \
                                                                                                \
        if (request->normal || request->measure == PSC_MEASURE_AREA)                            \
            keep_given(&s->disk, request, geometry, numbers);                                   \
        if (result == PSC_SUCCESS && s->projected)                                              \
            return fibre_sides(s);                                                              \
        if (result == PSC_SUCCESS) {                                                            \
            disk_head(s, request->table);                                                       \
            disk_fit(s);                                                                        \
        }                                                                                       \
        return result;                                                                          \
    }
DISK_BUILD(disk, 7)
DISK_BUILD(elliptical, 9)
DISK_BUILD(ellipsoid, PSC_DISK_NUMBERS)
#undef DISK_BUILD

#endif
