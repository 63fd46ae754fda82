/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Wavefronts by projected solid angle. Each element is seen on its own; those with a series of not
 * too many terms are sorted by its rule, by whether the horizon clips them and by how long the
 * fibres are, and go through the loops of fibre_lanes_tmpl.h. All else is left to the calls for
 * one: receivers lit on both sides, panels, errors. Template: see precision.h.
 */

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

/* Sees element i. */
static psc_result FN(see_element)(const struct psc_wave *wave, FN(disk_see) see, size_t i,
                                  psc_sampler *s)
{
    const double position[3] = {wave->position[0][i], wave->position[1][i],
                                wave->position[2][i]};
    const double normal[3] = {wave->normal[0][i], wave->normal[1][i], wave->normal[2][i]};
    double geometry[PSC_MAX_GEOMETRY];
    struct psc_request request;
    psc_result result;
    int k;

    if (!FN(wave_checks)(wave, i))
        return PSC_PENDING;
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
    result = see(s, &request, geometry);
    return result < 0 ? PSC_PENDING : result;
}

/* By rule up to FIBRE_TERMS, clipped, brief. */
enum { FN(FIBRE_LOOPS) = 3 * 4 };

/* What is kept of an element between the loops. */
struct FN(fibre_views) {
    struct FN(psc_disk_world) world[PSC_BLOCK];
    struct psc_sheaf_f64 sheaf[PSC_BLOCK];
    struct FN(fibre_frame) frame[PSC_BLOCK];
    double total[PSC_BLOCK];
    int steps[PSC_BLOCK], solid[PSC_BLOCK];
    uint32_t index[FN(FIBRE_LOOPS)][PSC_BLOCK];
    size_t count[FN(FIBRE_LOOPS)];
};

/* Sorts element i, which is seen; whether a loop takes it. */
static int FN(fibre_sort)(psc_sampler *s, size_t i, struct FN(fibre_views) *o)
{
    struct psc_disk_light *d = &s->disk;
    struct psc_sheaf_f64 *f = o->sheaf + i;
    int rule, loop;

    if (d->inside || !sheaf_build(f, &d->seen, &d->horizon))
        return 0;
    o->steps[i] = series_steps(f, d->seen.at);
    rule = fibre_rule(d->seen.at);
    if (o->steps[i] == 0 || rule < 0 || rule > 2 || !SERIES_FITS_SHEAF(f))
        return 0;
    o->total[i] = PSC_PI * (d->seen.a * d->seen.b) * d->horizon.z;
    if (!f->clipped && !(o->total[i] > 0.0))
        return 0;
    memcpy(d->axis, d->seen.z, sizeof d->axis);
    d->map = PSC_DISK_FIBRES;
    s->total = s->inverse_total = 1.0; /* not known yet */
    FN(disk_world)(s, o->world + i);
    o->frame[i] = FN(frame_of)(d);
    o->solid[i] = d->solid;
    loop = 4 * rule + 2 * f->clipped + SHEAF_BRIEF(f);
    o->index[loop][o->count[loop]++] = (uint32_t)i;
    return 1;
}

static void FN(fibre_gather)(const struct FN(fibre_views) *o, size_t i, size_t e, real u, real v,
                             struct FN(fibre_lanes) *k)
{
    const struct psc_sheaf_f64 *f = o->sheaf + i;
    int c;

    k->index[e] = (uint32_t)i;
    k->u[e] = u;
    k->v[e] = v;
    k->bt[e] = o->frame[i].bt;
    for (c = 0; c < 2; c++) {
        k->per[c][e] = o->frame[i].per[c];
        k->f[c][e] = f->f[c];
        k->turn[c][e] = f->turn[c];
    }
    k->total[e] = o->total[i];
    k->start_steps[e] = start_steps(FIBRE_TERMS, f);
    k->most_start_steps = MAX(k->most_start_steps, start_steps(FIBRE_TERMS, f));
    k->steps[e] = o->steps[i];
    k->most_steps = MAX(k->most_steps, o->steps[i]);
    k->sin_m[e] = f->sin_m;
    k->cos_m[e] = f->cos_m;
    k->shear[e] = f->shear;
    k->width[e] = f->width;
    k->nz[e] = f->nz;
    k->nf[e] = f->nf;
    k->end[e] = f->end;
    k->cos_end[e] = f->cos_end;
}

static void FN(fibre_finish)(const struct psc_wave *wave, struct FN(fibre_views) *o,
                             const struct FN(fibre_lanes) *k, size_t e, struct FN(psc_results) *r)
{
    const size_t i = k->index[e];
    struct FN(psc_disk_world) *const w = o->world + i;
    real direction[3], point[3], normal[3], distance, surface[2];
    int c;

    if (!(k->total[e] > 0.0)) {
        r->status[i] = PSC_PENDING;
        return;
    }
    w->total = (real)k->total[e];
    w->inverse_total = (real)(1.0 / k->total[e]);
    FN(fibre_world)(w, K(1.0), k->x[e], k->y[e], k->z[e], direction);
    for (c = 0; c < 3; c++)
        r->value[c][i] = direction[c];
    r->value[PSC_PDF][i] = k->height[e] * w->inverse_total;
    r->value[PSC_WEIGHT][i] = w->total;
    r->status[i] = w->total > K(0.0) ? PSC_SUCCESS : PSC_CULLED;
    if (wave->surface) {
        FN(gnomonic_hit)(o->solid[i], w, k->uz[e], k->vz[e], k->depth[e], k->margin[e], point,
                         normal, &distance, surface);
        FN(store_surface)(r, i, point, normal, distance, surface[0], surface[1]);
    }
}

static void FN(fibre_loop)(const struct psc_wave *wave, struct FN(fibre_views) *o, int loop,
                           const real *u, const real *v, struct FN(psc_results) *r)
{
    typedef void lanes(struct FN(fibre_lanes) *, size_t);
    static lanes *const find[] = {FN(fibre_wave_whole_0), FN(fibre_wave_clipped_0),
                                  FN(fibre_wave_whole_1), FN(fibre_wave_clipped_1),
                                  FN(fibre_wave_whole_2), FN(fibre_wave_clipped_2)};
    static lanes *const place[] = {
        FN(fibre_wave_place_whole), FN(fibre_wave_place_whole_brief),
        FN(fibre_wave_place_clipped), FN(fibre_wave_place_clipped_brief)};
    struct FN(fibre_lanes) k;
    size_t first, n, e;

    for (first = 0; first < o->count[loop]; first += n) {
        n = MIN(o->count[loop] - first, FIBRE_LANES);
        k.most_start_steps = k.most_steps = 0;
        for (e = 0; e < n; e++) {
            const uint32_t i = o->index[loop][first + e];

            FN(fibre_gather)(o, i, e, u[i], v[i], &k);
        }
        find[loop / 2](&k, n);
        place[loop % 4](&k, n);
        for (e = 0; e < n; e++)
            FN(fibre_finish)(wave, o, &k, e, r);
    }
}

static void FN(projected_waves)(const struct psc_wave *wave, FN(disk_see) see, const real *u,
                                const real *v, struct FN(psc_results) *r)
{
    struct FN(fibre_views) o;
    psc_sampler s;
    size_t i;
    int loop;

    memset(o.count, 0, sizeof o.count);
    s.measure = wave->measure;
    s.map = wave->map;
    s.facing = wave->facing;
    for (i = 0; i < wave->count; i++) {
        r->status[i] = PSC_PENDING;
        if (wave->facing != PSC_FACING_ONE)
            continue;
        r->status[i] = FN(see_element)(wave, see, i, &s);
        if (r->status[i] == PSC_SUCCESS && !FN(fibre_sort)(&s, i, &o))
            r->status[i] = PSC_PENDING;
    }
    for (loop = 0; loop < FN(FIBRE_LOOPS); loop++)
        FN(fibre_loop)(wave, &o, loop, u, v, r);
}
