/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Wavefronts of lights that are seen as an elliptic cone. Each element is seen on its own; those
 * with a rule of interpolation are sorted by it, and fitted and sampled in loops over many. The
 * lane functions are those of the calls for one, so the bits are too. Errors, and the tabulated map,
 * are left to the calls for one. Template: see precision.h.
 */

/* The elements of one rule, packed. */
struct FN(psc_fits) {
    real ca2[PSC_BLOCK], cb2[PSC_BLOCK], bend[PSC_BLOCK], mu1[PSC_BLOCK];
    real a[PSC_BLOCK], b[PSC_BLOCK], u[PSC_BLOCK], v[PSC_BLOCK];
    real work[4 * DISK_TERMS * PSC_BLOCK], series[DISK_TERMS * PSC_BLOCK];
    real fit[3 * DISK_TERMS * PSC_BLOCK];
    struct FN(psc_disk_points) points;
};

#define RULE_LOOP(i, m, steps, least)                                                              \
    static void FN(fit_and_sample_##m)(struct FN(psc_fits) *restrict k, size_t n, int concentric)  \
    {                                                                                              \
        const struct FN(fit_input) in = {k->ca2, k->cb2, k->bend, k->mu1};                         \
        size_t e;                                                                                  \
                                                                                                   \
        FN(fit)(m, steps, n, PSC_BLOCK, DISK_RULE_TABLE(m).c, DISK_RULE_TABLE(m).s,                \
                DISK_RULE_TABLE(m).per_c, DISK_RULE_TABLE(m).per_s, DISK_RULE_TABLE(m).wave,       \
                DISK_RULE_TABLE(m).power, &in, k->work, k->series, k->fit);                        \
        if (concentric)                                                                            \
            for (e = 0; e < n; e++) {                                                              \
                struct FN(psc_disk_point) p;                                                       \
                                                                                                   \
                FN(fitted_point)(m, PSC_BLOCK, k->fit + e, 1, k->a[e], k->b[e], k->u[e], k->v[e],  \
                                 &p);                                                              \
                FN(store_point)(&k->points, e, &p);                                                \
            }                                                                                      \
        else                                                                                       \
            for (e = 0; e < n; e++) {                                                              \
                struct FN(psc_disk_point) p;                                                       \
                                                                                                   \
                FN(fitted_point)(m, PSC_BLOCK, k->fit + e, 0, k->a[e], k->b[e], k->u[e], k->v[e],  \
                                 &p);                                                              \
                FN(store_point)(&k->points, e, &p);                                                \
            }                                                                                      \
    }
DISK_RULES(RULE_LOOP)
#undef RULE_LOOP

static void FN(sample_quasi)(struct FN(psc_fits) *restrict k, size_t n, int concentric)
{
    size_t e;

    (void)concentric;
    for (e = 0; e < n; e++) {
        struct FN(psc_disk_point) p;

        FN(quasi_point)(k->a[e], k->b[e], k->ca2[e], k->cb2[e], k->mu1[e], k->u[e], k->v[e], &p);
        FN(store_point)(&k->points, e, &p);
    }
}

#define DISK_COUNT_RULE(i, m, steps, least) +1
/* The rules of interpolation, and the map that needs none. */
enum { FN(QUASI_LOOP) = 0 DISK_RULES(DISK_COUNT_RULE), FN(LOOPS) };
#undef DISK_COUNT_RULE

/* What is seen of a block. */
struct FN(psc_disk_views) {
    struct FN(psc_disk_world) world[PSC_BLOCK];
    struct FN(psc_disk_point) point[PSC_BLOCK];
    struct psc_ellipse seen[PSC_BLOCK];
    uint32_t index[FN(LOOPS)][PSC_BLOCK]; /* by loop */
    size_t count[FN(LOOPS)];
};

static void FN(wave_loop)(struct FN(psc_disk_views) *o, int loop, int concentric, const real *u,
                          const real *v)
{
#define DISK_ROW(i, m, steps, least) FN(fit_and_sample_##m),
    static void (*const loops[])(struct FN(psc_fits) *, size_t, int) = {DISK_RULES(DISK_ROW) FN(sample_quasi)};
#undef DISK_ROW
    const size_t n = o->count[loop];
    struct FN(psc_fits) k;
    size_t e;

    for (e = 0; e < n; e++) {
        const uint32_t i = o->index[loop][e];
        const struct psc_ellipse *seen = o->seen + i;

        k.ca2[e] = (real)(seen->ca * seen->ca);
        k.cb2[e] = (real)(seen->cb * seen->cb);
        k.bend[e] = (real)((seen->cb - seen->ca) * (seen->cb + seen->ca));
        k.mu1[e] = (real)ellipse_mu1(seen->ca, seen->cb);
        k.a[e] = (real)seen->a;
        k.b[e] = (real)seen->b;
        k.u[e] = u[i];
        k.v[e] = v[i];
    }
    loops[loop](&k, n, concentric);
    for (e = 0; e < n; e++)
        o->point[o->index[loop][e]] = FN(load_point)(&k.points, e);
}

typedef psc_result (*FN(disk_see))(psc_sampler *, const struct psc_request *, const double *);

/* Whether the numbers of an element are ones that a build takes. */
static int FN(wave_checks)(const struct psc_wave *wave, size_t i)
{
    double sum = 0.0;
    int k;

    for (k = 0; k < 3; k++)
        sum += wave->position[k][i] * 0.0 + wave->normal[k][i] * 0.0;
    for (k = 0; k < wave->parts; k++)
        sum += wave->geometry[k][i] * 0.0;
    return sum == 0.0 && (wave->facing == PSC_FACING_NONE || wave->normal[0][i] != 0.0 ||
                          wave->normal[1][i] != 0.0 || wave->normal[2][i] != 0.0);
}

/* Sees element i; its sample is taken at once where no loop serves it. */
static void FN(wave_see)(const struct psc_wave *wave, FN(disk_see) see, size_t i, real u, real v,
                         psc_sampler *s, struct FN(psc_disk_views) *o, psc_result *status)
{
    const double position[3] = {wave->position[0][i], wave->position[1][i],
                                wave->position[2][i]};
    const double normal[3] = {wave->normal[0][i], wave->normal[1][i], wave->normal[2][i]};
    double geometry[PSC_MAX_GEOMETRY];
    struct psc_request request;
    int k, loop = -1;

    *status = PSC_PENDING;
    if (wave->map == PSC_MAP_TABULATED || !FN(wave_checks)(wave, i))
        return;
    request.measure = wave->measure;
    request.map = wave->map;
    request.facing = wave->facing;
    request.position = position;
    request.normal = wave->facing == PSC_FACING_NONE ? NULL : normal;
    request.one_sided = wave->one_sided;
    request.table = wave->table;
    request.numbers = wave->parts;
    for (k = 0; k < wave->parts; k++)
        geometry[k] = wave->geometry[k][i];
    *status = see(s, &request, geometry);
    if (*status < 0)
        *status = PSC_PENDING;
    if (*status != PSC_SUCCESS)
        return;
    disk_head(s, request.table);
    if (!(s->total > 0.0)) {
        *status = PSC_EMPTY;
        return;
    }
    s->inverse_total = 1.0 / s->total;
    FN(disk_world)(s, o->world + i);
    if (s->disk.map == PSC_DISK_QUASI_UNIFORM)
        loop = FN(QUASI_LOOP);
    else if (s->disk.map <= PSC_DISK_CONCENTRIC && s->disk.seen.ca > 0.0)
        loop = DISK_RULE(&s->disk);
    if (loop >= 0) {
        o->seen[i] = s->disk.seen;
        o->index[loop][o->count[loop]++] = (uint32_t)i;
    } else {
        disk_fit(s);
        FN(disk_point)(s, o->world + i, u, v, o->point + i);
    }
}

static void FN(wave_finish)(const struct psc_wave *wave, const struct FN(psc_disk_views) *o,
                            struct FN(psc_results) *r)
{
    real direction[3], point[3], normal[3], distance, surface[2], cosine;
    size_t i;
    int c;

    for (i = 0; i < wave->count; i++) {
        const struct FN(psc_disk_world) *w = o->world + i;
        const struct FN(psc_disk_point) *p = o->point + i;

        if (r->status[i] != PSC_SUCCESS)
            continue;
        FN(disk_direction)(w, p, direction);
        cosine = FN(disk_cosine)(wave->facing, w, direction);
        FN(disk_density)(disk_density_of(w->map), w, p, cosine, &r->value[PSC_PDF][i],
                         &r->value[PSC_WEIGHT][i]);
        for (c = 0; c < 3; c++)
            r->value[c][i] = direction[c];
        if (wave->surface) {
            FN(disk_hit)(w->hit, w, p, direction, point, normal, &distance, surface);
            FN(store_surface)(r, i, point, normal, distance, surface[0], surface[1]);
        }
        r->status[i] = r->value[PSC_WEIGHT][i] > K(0.0) ? PSC_SUCCESS : PSC_CULLED;
    }
}

static void FN(disk_waves)(const struct psc_wave *wave, FN(disk_see) see, const real *u,
                           const real *v, struct FN(psc_results) *r)
{
    struct FN(psc_disk_views) o;
    psc_sampler s;
    size_t i;
    int loop;

    if (wave->measure == PSC_MEASURE_PROJECTED_SOLID_ANGLE) {
        for (i = 0; i < wave->count; i++)
            r->status[i] = PSC_PENDING;
        return;
    }
    memset(o.count, 0, sizeof o.count);
    s.measure = wave->measure;
    s.map = wave->map;
    s.facing = wave->facing;
    for (i = 0; i < wave->count; i++)
        FN(wave_see)(wave, see, i, u[i], v[i], &s, &o, r->status + i);
    for (loop = 0; loop < FN(LOOPS); loop++)
        if (o.count[loop] > 0)
            FN(wave_loop)(&o, loop, wave->map == PSC_MAP_CONCENTRIC, u, v);
    FN(wave_finish)(wave, &o, r);
}

#define DISK_WAVE(name)                                                                            \
    static void FN(name##_wave)(const struct psc_wave *wave, const real *u, const real *v,         \
                                struct FN(psc_results) *r)                                         \
    {                                                                                              \
        FN(disk_waves)(wave, name##_see, u, v, r);                                                 \
    }
DISK_WAVE(disk)
DISK_WAVE(elliptical)
DISK_WAVE(ellipsoid)
#undef DISK_WAVE
