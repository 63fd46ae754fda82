/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Wavefronts of lights that are seen as an elliptic cone: all elements of a block are seen, then
 * those with the same rule of interpolation are packed, fitted and sampled together, then all are
 * finished. The lane functions are those of the calls for one, so the bits are too. Errors, and
 * what has no rule, are left to the calls for one. Template: see precision.h.
 */
/* The elements of one rule, packed: few at a time, so that all of it is near. */
#define FIT_BLOCK 32

struct FN(psc_fits) {
    real ca[FIT_BLOCK], cb[FIT_BLOCK], ca2[FIT_BLOCK], cb2[FIT_BLOCK];
    real bend[FIT_BLOCK], mu1[FIT_BLOCK], a[FIT_BLOCK], b[FIT_BLOCK], u[FIT_BLOCK], v[FIT_BLOCK];
    real work[4 * DISK_TERMS * FIT_BLOCK], series[DISK_TERMS * FIT_BLOCK];
    real fit[3 * DISK_TERMS * FIT_BLOCK];
    struct FN(psc_disk_points) points;
};

#define RULE_LOOP(name, m, concentric)                                                             \
    static void FN(name)(struct FN(psc_fits) *restrict k, size_t n)                                \
    {                                                                                              \
        size_t e;                                                                                  \
                                                                                                   \
        for (e = 0; e < n; e++) {                                                                  \
            struct FN(psc_disk_point) p;                                                           \
                                                                                                   \
            FN(fitted_point)(m, FIT_BLOCK, k->fit + e, concentric, k->a[e], k->b[e], k->u[e],      \
                             k->v[e], &p);                                                         \
            FN(store_point)(&k->points, e, &p);                                                    \
        }                                                                                          \
    }
#define RULE_LOOPS(i, m, steps, least)                                                             \
    RULE_LOOP(wave_radial_##m, m, 0)                                                               \
    RULE_LOOP(wave_concentric_##m, m, 1)                                                           \
    static void FN(wave_fit_##m)(struct FN(psc_fits) *restrict k, size_t n)                        \
    {                                                                                              \
        const struct FN(fit_input) in = {k->ca2, k->cb2, k->bend, k->mu1};                         \
                                                                                                   \
        FN(fit)(m, steps, n, FIT_BLOCK, DISK_RULE_TABLE(m).c, DISK_RULE_TABLE(m).s,                \
                DISK_RULE_TABLE(m).per_c, DISK_RULE_TABLE(m).per_s, DISK_RULE_TABLE(m).wave,       \
                DISK_RULE_TABLE(m).power, &in, k->work, k->series, k->fit);                        \
    }
DISK_RULES(RULE_LOOPS)
#undef RULE_LOOPS
#undef RULE_LOOP

#define SPAN_LOOPS(i, m, steps, least)                                                             \
    static void FN(wave_span_fit_##m)(struct FN(psc_fits) *restrict k, size_t n)                   \
    {                                                                                              \
        const struct FN(span_input) in = {k->ca, k->cb};                                           \
                                                                                                   \
        FN(span_fit)(m, n, FIT_BLOCK, DISK_RULE_TABLE(m).c, DISK_RULE_TABLE(m).s,                  \
                     DISK_RULE_TABLE(m).wave, &in, k->work, k->fit);                               \
    }                                                                                              \
    static void FN(wave_parallel_##m)(struct FN(psc_fits) *restrict k, size_t n)                   \
    {                                                                                              \
        size_t e;                                                                                  \
                                                                                                   \
        for (e = 0; e < n; e++) {                                                                  \
            struct FN(psc_disk_point) p;                                                           \
                                                                                                   \
            FN(span_point)(m, steps, FIT_BLOCK, k->fit + e, k->a[e], k->ca[e], k->b[e], k->cb[e],  \
                           k->u[e], k->v[e], &p);                                                  \
            FN(store_point)(&k->points, e, &p);                                                    \
        }                                                                                          \
    }
SPAN_RULES(SPAN_LOOPS)
#undef SPAN_LOOPS

#define COUNT_RULE(i, m, steps, least) +1
enum { FN(MOST_RULES) = 0 DISK_RULES(COUNT_RULE) };
#undef COUNT_RULE

typedef void (*FN(rule_loop))(struct FN(psc_fits) *, size_t);

/* Fits and samples the elements of an index that have one rule. */
static void FN(wave_rule)(enum psc_disk_map map, int rule, const uint32_t *index, size_t count,
                          const real *u, const real *v, struct FN(psc_disk_views) *o)
{
#define FIT_ROW(i, m, steps, least) \
    {FN(wave_fit_##m), FN(wave_radial_##m), FN(wave_concentric_##m)},
    static const FN(rule_loop) fitted[][3] = {DISK_RULES(FIT_ROW)};
#undef FIT_ROW
#define SPAN_ROW(i, m, steps, least) {FN(wave_span_fit_##m), FN(wave_parallel_##m)},
    static const FN(rule_loop) spans[][2] = {SPAN_RULES(SPAN_ROW)};
#undef SPAN_ROW
    struct FN(psc_fits) k;
    size_t first, n, e;

    for (first = 0; first < count; first += n) {
        n = MIN(count - first, FIT_BLOCK);
        for (e = 0; e < n; e++) {
            const uint32_t i = index[first + e];

            k.ca[e] = o->ca[i];
            k.cb[e] = o->cb[i];
            k.ca2[e] = o->ca2[i];
            k.cb2[e] = o->cb2[i];
            k.bend[e] = o->bend[i];
            k.mu1[e] = o->mu1[i];
            k.a[e] = o->a[i];
            k.b[e] = o->b[i];
            k.u[e] = u[i];
            k.v[e] = v[i];
        }
        if (map == PSC_DISK_PARALLEL) {
            spans[rule][0](&k, n);
            spans[rule][1](&k, n);
        } else {
            fitted[rule][0](&k, n);
            fitted[rule][map == PSC_DISK_CONCENTRIC ? 2 : 1](&k, n);
        }
        for (e = 0; e < n; e++) {
            const struct FN(psc_disk_point) p = FN(load_point)(&k.points, e);

            FN(store_point)(&o->points, index[first + e], &p);
        }
    }
}

static void FN(wave_rules)(enum psc_disk_map map, size_t count, const real *u, const real *v,
                           struct FN(psc_disk_views) *o, psc_result *status)
{
    uint32_t index[FN(MOST_RULES)][PSC_BLOCK];
    size_t size[FN(MOST_RULES)] = {0}, i;
    int rule;

    memset(&o->points, 0, sizeof o->points); /* of what is not sampled here */
    for (i = 0; i < count; i++) {
        if (status[i] != PSC_SUCCESS)
            continue;
        rule = FN(rule_of)(map, o->quotient[i]);
        if (rule < 0)
            status[i] = PSC_PENDING;
        else
            index[rule][size[rule]++] = (uint32_t)i;
    }
    for (rule = 0; rule < FN(MOST_RULES); rule++)
        if (size[rule] > 0)
            FN(wave_rule)(map, rule, index[rule], size[rule], u, v, o);
}

static void FN(wave_quasi)(struct FN(psc_disk_views) *restrict o, size_t n, const real *restrict u,
                           const real *restrict v)
{
    size_t e;

    for (e = 0; e < n; e++) {
        struct FN(psc_disk_point) p;

        FN(quasi_point)(o->a[e], o->b[e], o->ca2[e], o->cb2[e], o->mu1[e], u[e], v[e], &p);
        FN(store_point)(&o->points, e, &p);
    }
}

#define WAVE_AREA(name, map)                                                                       \
    static void FN(name)(struct FN(psc_disk_views) *restrict o, size_t n, const real *restrict u,  \
                         const real *restrict v)                                                   \
    {                                                                                              \
        size_t e;                                                                                  \
                                                                                                   \
        for (e = 0; e < n; e++) {                                                                  \
            struct FN(psc_disk_world) w;                                                           \
            struct FN(psc_disk_point) p;                                                           \
                                                                                                   \
            FN(load_world)(o, e, &w);                                                              \
            FN(area_lane)(map, &w, u[e], v[e], &p);                                                \
            FN(store_point)(&o->points, e, &p);                                                    \
        }                                                                                          \
    }
WAVE_AREA(wave_area_radial, PSC_DISK_AREA_RADIAL)
WAVE_AREA(wave_area_concentric, PSC_DISK_AREA_CONCENTRIC)
WAVE_AREA(wave_area_parallel, PSC_DISK_AREA_PARALLEL)
#undef WAVE_AREA

static void FN(wave_points)(enum psc_disk_map map, size_t n, const real *u, const real *v,
                            struct FN(psc_disk_views) *o, psc_result *status)
{
    switch (map) {
    case PSC_DISK_AREA_RADIAL: FN(wave_area_radial)(o, n, u, v); break;
    case PSC_DISK_AREA_CONCENTRIC: FN(wave_area_concentric)(o, n, u, v); break;
    case PSC_DISK_AREA_PARALLEL: FN(wave_area_parallel)(o, n, u, v); break;
    case PSC_DISK_QUASI_UNIFORM: FN(wave_quasi)(o, n, u, v); break;
    default: FN(wave_rules)(map, n, u, v, o, status); break;
    }
}

/* ---- The kernels ---- */

static void FN(disk_waves)(const struct psc_wave *wave, FN(view_loop) view, FN(disk_see) see,
                           int solid, const real *u, const real *v, struct FN(psc_results) *r)
{
    const enum psc_disk_map map = disk_map_of(wave->measure, wave->map, 0);
    struct FN(psc_disk_views) o;
    size_t i;

    if (wave->measure == PSC_MEASURE_PROJECTED_SOLID_ANGLE) {
        FN(projected_waves)(wave, see, u, v, r);
        return;
    }
    if (map == PSC_DISK_TABULATED) {
        for (i = 0; i < wave->count; i++)
            r->status[i] = PSC_PENDING;
        return;
    }
    FN(view_all)(wave, view, map, &o, r->status);
    FN(wave_points)(map, wave->count, u, v, &o, r->status);
    FN(wave_results)(wave, map, solid, &o, r);
}

#define BY_MEASURE(cones, areas) (wave->measure == PSC_MEASURE_AREA ? FN(areas) : FN(cones))
#define DISK_WAVE(name, view, solid)                                                               \
    static void FN(name##_wave)(const struct psc_wave *wave, const real *u, const real *v,         \
                                struct FN(psc_results) *r)                                         \
    {                                                                                              \
        FN(disk_waves)(wave, view, name##_see, solid, u, v, r);                                    \
    }
DISK_WAVE(disk, BY_MEASURE(view_disk_cones, view_disk_areas), 0)
DISK_WAVE(elliptical, BY_MEASURE(view_elliptical_cones, view_elliptical_areas), 0)
DISK_WAVE(ellipsoid, FN(view_ellipsoid_cones), 1)
#undef DISK_WAVE
#undef BY_MEASURE
