/* SPDX-License-Identifier: Apache-2.0 */
/* Blocks of samples of one build of a light that is seen as an elliptic cone, in loops that
   vectorise. Template: see precision.h. */

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
        FN(flat_world)(s, &w);                                                                     \
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
