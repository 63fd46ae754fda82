/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Sampling of one build of a light that is seen as an elliptic cone, one sample at a time or in
 * blocks that vectorise. Template: see precision.h.
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

static double FN(tabulated_point)(const psc_sampler *s, real u, real v, struct FN(psc_disk_point) *p)
{
    struct psc_disk_point_f64 wide;
    const double density = table_point(&s->disk, (double)u, (double)v, &wide);

    FN(round_point)(&wide, p);
    return density;
}

/* ---- One sample ---- */

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
    FN(disk_hit)(w.hit, &w, &p, out->direction, out->point, out->normal, &out->distance, out->surface);
    return out->weight > K(0.0) ? PSC_SUCCESS : PSC_CULLED;
}

static psc_result FN(disk_sample)(const psc_sampler *s, real u, real v, FN(psc_light_sample) *out)
{
    return s->sides == 0 ? PSC_EMPTY : FN(disk_sample_seen)(s, u, v, out);
}

/* ---- Blocks ---- */

struct FN(psc_disk_points) {
    real x[PSC_BLOCK], y[PSC_BLOCK], z[PSC_BLOCK], c[PSC_BLOCK], s[PSC_BLOCK], rest[PSC_BLOCK];
};

PSC_LANE void FN(store_point)(struct FN(psc_disk_points) *to, size_t i,
                              const struct FN(psc_disk_point) *p)
{
    to->x[i] = p->x;
    to->y[i] = p->y;
    to->z[i] = p->z;
    to->c[i] = p->c;
    to->s[i] = p->s;
    to->rest[i] = p->rest;
}

PSC_LANE struct FN(psc_disk_point) FN(load_point)(const struct FN(psc_disk_points) *from, size_t i)
{
    const struct FN(psc_disk_point) p = {from->x[i], from->y[i], from->z[i],
                                         from->c[i], from->s[i], from->rest[i]};

    return p;
}

#define FITTED_BLOCK(name, m, concentric)                                                          \
    static void FN(name)(const psc_sampler *s, size_t n, const real *restrict u,                   \
                         const real *restrict v, struct FN(psc_disk_points) *restrict to)          \
    {                                                                                              \
        const real a = (real)s->disk.seen.a, b = (real)s->disk.seen.b;                             \
        real fit[3 * (m)];                                                                         \
        size_t i;                                                                                  \
                                                                                                   \
        memcpy(fit, DISK_FIT(&s->disk), sizeof fit);                                               \
        for (i = 0; i < n; i++) {                                                                  \
            struct FN(psc_disk_point) p;                                                           \
                                                                                                   \
            FN(fitted_point)(m, 1, fit, concentric, a, b, u[i], v[i], &p);                         \
            FN(store_point)(to, i, &p);                                                            \
        }                                                                                          \
    }
#define FITTED_BLOCKS(i, m, steps, least)     \
    FITTED_BLOCK(radial_block_##m, m, 0)      \
    FITTED_BLOCK(concentric_block_##m, m, 1)
DISK_RULES(FITTED_BLOCKS)
#undef FITTED_BLOCKS
#undef FITTED_BLOCK

#define SPAN_BLOCK(i, m, steps, least)                                                             \
    static void FN(parallel_block_##m)(const psc_sampler *s, size_t n, const real *restrict u,     \
                                       const real *restrict v,                                     \
                                       struct FN(psc_disk_points) *restrict to)                    \
    {                                                                                              \
        const real a = (real)s->disk.seen.a, ca = (real)s->disk.seen.ca;                           \
        const real b = (real)s->disk.seen.b, cb = (real)s->disk.seen.cb;                           \
        real span[PSC_SPAN_ROWS(m)];                                                               \
        size_t e;                                                                                  \
                                                                                                   \
        memcpy(span, DISK_FIT(&s->disk), sizeof span);                                             \
        for (e = 0; e < n; e++) {                                                                  \
            struct FN(psc_disk_point) p;                                                           \
                                                                                                   \
            FN(span_point)(m, steps, 1, span, a, ca, b, cb, u[e], v[e], &p);                       \
            FN(store_point)(to, e, &p);                                                            \
        }                                                                                          \
    }
SPAN_RULES(SPAN_BLOCK)
#undef SPAN_BLOCK

#define AREA_BLOCK(name, map)                                                                      \
    static void FN(name)(const psc_sampler *s, size_t n, const real *restrict u,                   \
                         const real *restrict v, struct FN(psc_disk_points) *restrict to)          \
    {                                                                                              \
        struct FN(psc_disk_world) w;                                                               \
        size_t i;                                                                                  \
                                                                                                   \
        FN(disk_world)(s, &w);                                                                     \
        for (i = 0; i < n; i++) {                                                                  \
            struct FN(psc_disk_point) p;                                                           \
                                                                                                   \
            FN(area_lane)(map, &w, u[i], v[i], &p);                                                \
            FN(store_point)(to, i, &p);                                                            \
        }                                                                                          \
    }
AREA_BLOCK(area_radial_block, PSC_DISK_AREA_RADIAL)
AREA_BLOCK(area_concentric_block, PSC_DISK_AREA_CONCENTRIC)
AREA_BLOCK(area_parallel_block, PSC_DISK_AREA_PARALLEL)
#undef AREA_BLOCK

static void FN(quasi_block)(const psc_sampler *s, size_t n, const real *restrict u,
                            const real *restrict v, struct FN(psc_disk_points) *restrict to)
{
    struct FN(psc_disk_world) w;
    size_t i;

    FN(disk_world)(s, &w);
    for (i = 0; i < n; i++) {
        struct FN(psc_disk_point) p;

        FN(quasi_point)(w.a, w.b, w.ca2, w.cb2, w.mu1, u[i], v[i], &p);
        FN(store_point)(to, i, &p);
    }
}

static void FN(solved_block)(const psc_sampler *s, size_t n, const real *u, const real *v,
                             struct FN(psc_disk_points) *to)
{
    size_t i;

    for (i = 0; i < n; i++) {
        struct FN(psc_disk_point) p;

        FN(solved_point)(s, u[i], v[i], &p);
        FN(store_point)(to, i, &p);
    }
}

typedef void (*FN(disk_block))(const psc_sampler *, size_t, const real *, const real *,
                               struct FN(psc_disk_points) *);

static FN(disk_block) FN(block_of)(const struct psc_disk_light *d)
{
#define DISK_ROW(i, m, steps, least) {FN(radial_block_##m), FN(concentric_block_##m)},
    static const FN(disk_block) fitted[][2] = {DISK_RULES(DISK_ROW)};
#undef DISK_ROW
#define SPAN_ROW(i, m, steps, least) FN(parallel_block_##m),
    static const FN(disk_block) parallel[] = {SPAN_RULES(SPAN_ROW)};
#undef SPAN_ROW
    static const FN(disk_block) area[] = {FN(area_radial_block), FN(area_concentric_block),
                                          FN(area_parallel_block)};

    if (d->map >= PSC_DISK_AREA_RADIAL && d->map <= PSC_DISK_AREA_PARALLEL && AREA_FITS(d))
        return area[d->map - PSC_DISK_AREA_RADIAL];
    if (d->map == PSC_DISK_QUASI_UNIFORM)
        return FN(quasi_block);
    if (d->map > PSC_DISK_PARALLEL || DISK_RULE(d) < 0)
        return FN(solved_block);
    return d->map == PSC_DISK_PARALLEL ? parallel[DISK_RULE(d)] : fitted[DISK_RULE(d)][d->map];
}

/* Directions and densities of a block with the constants of one loop. */
PSC_LANE void FN(disk_densities)(enum psc_disk_density density, enum psc_facing facing,
                                 const struct FN(psc_disk_world) *w, size_t n,
                                 const struct FN(psc_disk_points) *restrict points,
                                 struct FN(psc_results) *restrict r)
{
    const struct FN(psc_disk_world) own = *w;
    real *pdf = r->value[PSC_PDF], *weight = r->value[PSC_WEIGHT];
    size_t i;

    for (i = 0; i < n; i++) {
        const struct FN(psc_disk_point) p = FN(load_point)(points, i);
        real direction[3];

        FN(disk_direction)(&own, &p, direction);
        r->value[0][i] = direction[0];
        r->value[1][i] = direction[1];
        r->value[2][i] = direction[2];
        FN(disk_density)(density, &own, &p, FN(disk_cosine)(facing, &own, direction), &pdf[i],
                         &weight[i]);
    }
    for (i = 0; i < n; i++)
        r->status[i] = weight[i] > K(0.0) ? PSC_SUCCESS : PSC_CULLED;
}

static void FN(disk_density_block)(const struct FN(psc_disk_world) *w, size_t n,
                                   const struct FN(psc_disk_points) *points,
                                   struct FN(psc_results) *r)
{
#define FACING_CASES(density)                                                                    \
    if (w->facing == PSC_FACING_NONE)                                                            \
        FN(disk_densities)(density, PSC_FACING_NONE, w, n, points, r);                           \
    else if (w->facing == PSC_FACING_ONE)                                                        \
        FN(disk_densities)(density, PSC_FACING_ONE, w, n, points, r);                            \
    else                                                                                         \
        FN(disk_densities)(density, PSC_FACING_BOTH, w, n, points, r)
    switch (disk_density_of(w->map)) {
    case PSC_DISK_BY_AREA: FACING_CASES(PSC_DISK_BY_AREA); break;
    case PSC_DISK_QUASI: FACING_CASES(PSC_DISK_QUASI); break;
    default: FACING_CASES(PSC_DISK_CONSTANT); break;
    }
#undef FACING_CASES
}

/* Hits of a block with the constants of one loop. */
PSC_LANE void FN(disk_hits)(enum psc_disk_hit hit, const struct FN(psc_disk_world) *w, size_t n,
                            const struct FN(psc_disk_points) *restrict points,
                            struct FN(psc_results) *restrict r)
{
    const struct FN(psc_disk_world) own = *w;
    size_t i;

    for (i = 0; i < n; i++) {
        const struct FN(psc_disk_point) p = FN(load_point)(points, i);
        const real direction[3] = {r->value[0][i], r->value[1][i], r->value[2][i]};
        real point[3], normal[3], distance, surface[2];

        FN(disk_hit)(hit, &own, &p, direction, point, normal, &distance, surface);
        FN(store_surface)(r, i, point, normal, distance, surface[0], surface[1]);
    }
}

static void FN(disk_hit_block)(const struct FN(psc_disk_world) *w, size_t n,
                               const struct FN(psc_disk_points) *points,
                               struct FN(psc_results) *r)
{
    switch (w->hit) {
#define HIT_CASE(hit) \
    case hit: FN(disk_hits)(hit, w, n, points, r); break
        HIT_CASE(PSC_DISK_HIT_FLAT);
        HIT_CASE(PSC_DISK_HIT_CHORD);
        HIT_CASE(PSC_DISK_HIT_SOLID);
        HIT_CASE(PSC_DISK_HIT_SOLID_CHORD);
        HIT_CASE(PSC_DISK_HIT_AREA);
        HIT_CASE(PSC_DISK_HIT_INSIDE);
#undef HIT_CASE
    }
}

static void FN(tabulated_block)(const psc_sampler *s, size_t n, const real *u, const real *v,
                                struct FN(psc_results) *r)
{
    size_t i;

    for (i = 0; i < n; i++) {
        real flat[PSC_COMPONENTS];
        FN(psc_light_sample) sample;
        int c;

        r->status[i] = FN(disk_sample_seen)(s, u[i], v[i], &sample);
        memcpy(flat, &sample, sizeof flat);
        for (c = 0; c < PSC_COMPONENTS; c++)
            r->value[c][i] = flat[c];
    }
}

static void FN(disk_side_block)(const psc_sampler *s, int k, size_t n, const real *u, const real *v,
                                int surface, struct FN(psc_results) *r)
{
    struct FN(psc_disk_points) points;
    struct FN(psc_disk_world) w;

    (void)k;
    if (s->disk.map == PSC_DISK_TABULATED) {
        FN(tabulated_block)(s, n, u, v, r);
        return;
    }
    FN(block_of)(&s->disk)(s, n, u, v, &points);
    FN(disk_world)(s, &w);
    FN(disk_density_block)(&w, n, &points, r);
    if (surface)
        FN(disk_hit_block)(&w, n, &points, r);
}

static void FN(disk_sample_n)(const psc_sampler *s, size_t count, const FN(psc_input) *uv,
                              const FN(psc_samples) *out)
{
    FN(sample_sides)(s, count, uv, out, FN(disk_side_block));
}
