/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Sampling by projected solid angle, one sample at a time or in blocks: in double behind both
 * precisions up to the direction, in that of the kernel from there to the hit. Template: see
 * precision.h.
 */

/* From inside the second side is the mirror image of the first. */
#define FIBRE_MIRROR(light, side) ((light)->inside && (side) == 1 ? -1.0 : 1.0)

PSC_LANE void FN(fibre_world)(const struct psc_disk_light *l, double mirror, double x, double y,
                              double z, real direction[3])
{
    int i;

    for (i = 0; i < 3; i++)
        direction[i] = (real)(mirror * (l->axis[i] + z * l->seen.z[i]) +
                              (x * l->seen.x[i] + y * l->seen.y[i]));
}

/* ---- One sample ---- */

static psc_result FN(fibre_sample)(const psc_sampler *s, real u, real v,
                                   FN(psc_light_sample) *out)
{
    const struct psc_disk_light *l = &s->disk;
    struct psc_fibre_direction d;
    struct FN(psc_disk_world) w;
    real within;
    int side;

    if (s->sides == 0)
        return PSC_EMPTY;
    side = FN(pick_side)(s, u, &within);
    fibre_point(l, side, (double)within, (double)v, &d);
    FN(fibre_world)(l, FIBRE_MIRROR(l, side), d.x, d.y, d.z, out->direction);
    out->pdf = (real)(d.height * s->inverse_total);
    FN(disk_world)(s, &w);
    out->weight = w.total;
    if (l->inside) {
        FN(inside_hit)(&w, out->direction, out->point, out->normal, &out->distance);
        out->surface[0] = out->surface[1] = K(0.0);
    } else {
        FN(gnomonic_hit)(l->solid, &w, (real)d.uz, (real)d.vz, (real)d.depth, (real)d.margin, out->point,
                         out->normal, &out->distance, out->surface);
    }
    return out->weight > K(0.0) ? PSC_SUCCESS : PSC_CULLED;
}

/* ---- Blocks ---- */

/* Where the fibres are: from the top, or from the end. */
struct FN(fibre_places) {
    double x[PSC_BLOCK], target[PSC_BLOCK], sign[PSC_BLOCK], v[PSC_BLOCK];
};

struct FN(fibre_directions) {
    double x[PSC_BLOCK], y[PSC_BLOCK], z[PSC_BLOCK], height[PSC_BLOCK];
    real depth[PSC_BLOCK], uz[PSC_BLOCK], vz[PSC_BLOCK], margin[PSC_BLOCK];
};

#define FIND_BLOCK(i, m, most)                                                                     \
    static void FN(find_fibres_##m)(const struct psc_fibres *f, size_t n, const real *restrict u,  \
                                    struct FN(fibre_places) *restrict to)                          \
    {                                                                                              \
        const struct psc_fibre_series q = f->series;                                               \
        const struct psc_sheaf sheaf = f->sheaf;                                                   \
        size_t e;                                                                                  \
        int step;                                                                                  \
                                                                                                   \
        for (e = 0; e < n; e++)                                                                    \
            to->x[e] = series_start(&sheaf, &q, (double)u[e], 1.0 - (double)u[e], &to->sign[e],    \
                                    &to->target[e]);                                               \
        for (step = 0; step < q.steps; step++)                                                     \
            for (e = 0; e < n; e++)                                                                \
                to->x[e] =                                                                         \
                    series_step(m, &q, to->sign[e], sheaf.end, to->target[e], to->x[e]);           \
    }
PSC_FIBRE_RULES(FIND_BLOCK)
#undef FIND_BLOCK

static void FN(find_fibres)(const struct psc_fibres *f, size_t n, const real *u,
                            struct FN(fibre_places) *to)
{
    size_t e;
    int lower;

    switch (f->series.rule) {
#define FIND_CASE(i, m, most) \
    case i: FN(find_fibres_##m)(f, n, u, to); break;
        PSC_FIBRE_RULES(FIND_CASE)
#undef FIND_CASE
    default:
        for (e = 0; e < n; e++) {
            to->x[e] = panel_find(f, (double)u[e], 1.0 - (double)u[e], &lower);
            to->sign[e] = lower ? -1.0 : 1.0;
        }
        break;
    }
}

#define PLACE_BLOCK(name, clipped, brief)                                                          \
    static void FN(name)(const struct psc_disk_light *l, const struct psc_sheaf *from, size_t n,   \
                         const struct FN(fibre_places) *restrict at,                               \
                         struct FN(fibre_directions) *restrict to)                                 \
    {                                                                                              \
        const double per[2] = {l->seen.ca / l->seen.a, l->seen.cb / l->seen.b}, bt = l->seen.bt;   \
        const struct psc_sheaf f = *from;                                                          \
        size_t e;                                                                                  \
                                                                                                   \
        for (e = 0; e < n; e++) {                                                                  \
            struct psc_fibre_direction d;                                                          \
                                                                                                   \
            place_on_fibre(&f, clipped, brief, per, bt, at->sign[e] < 0.0, at->x[e], at->v[e],     \
                           &d);                                                                    \
            to->x[e] = d.x;                                                                        \
            to->y[e] = d.y;                                                                        \
            to->z[e] = d.z;                                                                        \
            to->height[e] = d.height;                                                              \
            to->depth[e] = (real)d.depth;                                                          \
            to->uz[e] = (real)d.uz;                                                                \
            to->vz[e] = (real)d.vz;                                                                \
            to->margin[e] = (real)d.margin;                                                        \
        }                                                                                          \
    }
PLACE_BLOCK(place_whole, 0, 0)
PLACE_BLOCK(place_whole_brief, 0, 1)
PLACE_BLOCK(place_clipped, 1, 0)
PLACE_BLOCK(place_clipped_brief, 1, 1)
#undef PLACE_BLOCK

PSC_LANE void FN(fibre_hits)(int inside, int solid, const struct FN(psc_disk_world) *w, size_t n,
                             const struct FN(fibre_directions) *restrict d,
                             struct FN(psc_results) *restrict r)
{
    const struct FN(psc_disk_world) own = *w;
    size_t i;

    for (i = 0; i < n; i++) {
        const real direction[3] = {r->value[0][i], r->value[1][i], r->value[2][i]};
        real point[3], normal[3], distance, surface[2] = {K(0.0), K(0.0)};

        if (inside)
            FN(inside_hit)(&own, direction, point, normal, &distance);
        else
            FN(gnomonic_hit)(solid, &own, d->uz[i], d->vz[i], d->depth[i], d->margin[i], point, normal,
                             &distance, surface);
        FN(store_surface)(r, i, point, normal, distance, surface[0], surface[1]);
    }
}

static void FN(fibre_surfaces)(const struct psc_disk_light *l, const struct FN(psc_disk_world) *w,
                               size_t n, const struct FN(fibre_directions) *d,
                               struct FN(psc_results) *r)
{
    if (l->inside)
        FN(fibre_hits)(1, 1, w, n, d, r);
    else if (l->solid)
        FN(fibre_hits)(0, 1, w, n, d, r);
    else
        FN(fibre_hits)(0, 0, w, n, d, r);
}

static void FN(fibre_side_block)(const psc_sampler *s, int side, size_t n, const real *u,
                                 const real *v, int surface, struct FN(psc_results) *r)
{
    const struct psc_disk_light *l = &s->disk;
    const struct psc_fibres *f = l->fibres + side;
    const double mirror = FIBRE_MIRROR(l, side), inverse = s->inverse_total;
    struct FN(fibre_places) places;
    struct FN(fibre_directions) d;
    struct FN(psc_disk_world) w;
    size_t i;

    FN(find_fibres)(f, n, u, &places);
    for (i = 0; i < n; i++)
        places.v[i] = (double)v[i];
    if (f->sheaf.clipped)
        (f->sheaf.brief ? FN(place_clipped_brief) : FN(place_clipped))(l, &f->sheaf, n, &places, &d);
    else
        (f->sheaf.brief ? FN(place_whole_brief) : FN(place_whole))(l, &f->sheaf, n, &places, &d);
    FN(disk_world)(s, &w);
    for (i = 0; i < n; i++) {
        real direction[3];

        FN(fibre_world)(l, mirror, d.x[i], d.y[i], d.z[i], direction);
        r->value[0][i] = direction[0];
        r->value[1][i] = direction[1];
        r->value[2][i] = direction[2];
        r->value[PSC_PDF][i] = (real)(d.height[i] * inverse);
    }
    for (i = 0; i < n; i++) {
        r->value[PSC_WEIGHT][i] = w.total;
        r->status[i] = w.total > K(0.0) ? PSC_SUCCESS : PSC_CULLED;
    }
    if (surface)
        FN(fibre_surfaces)(l, &w, n, &d, r);
}
#undef FIBRE_MIRROR

/* ---- The calls for cones by any measure ---- */

static psc_result FN(cone_sample)(const psc_sampler *s, real u, real v, FN(psc_light_sample) *out)
{
    return s->projected ? FN(fibre_sample)(s, u, v, out) : FN(disk_sample)(s, u, v, out);
}

static void FN(cone_sample_n)(const psc_sampler *s, size_t count, const FN(psc_input) *uv,
                              const FN(psc_samples) *out)
{
    if (s->projected)
        FN(sample_sides)(s, count, uv, out, FN(fibre_side_block));
    else
        FN(disk_sample_n)(s, count, uv, out);
}
