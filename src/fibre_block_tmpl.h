/* SPDX-License-Identifier: Apache-2.0 */
/* Blocks of samples by projected solid angle, and the calls for cones by any measure. Template: see
   precision.h. */

/* Where the fibres are. */
struct FN(fibre_sites) {
    real sine[PSC_BLOCK], cosine[PSC_BLOCK], rise[PSC_BLOCK];
};

struct FN(fibre_directions) {
    real x[PSC_BLOCK], y[PSC_BLOCK], z[PSC_BLOCK], height[PSC_BLOCK];
    real depth[PSC_BLOCK], uz[PSC_BLOCK], vz[PSC_BLOCK], margin[PSC_BLOCK];
};

PSC_LANE void FN(store_direction)(struct FN(fibre_directions) *to, size_t e,
                                  const struct FN(psc_fibre_direction) *d)
{
    to->x[e] = d->x;
    to->y[e] = d->y;
    to->z[e] = d->z;
    to->height[e] = d->height;
    to->depth[e] = d->depth;
    to->uz[e] = d->uz;
    to->vz[e] = d->vz;
    to->margin[e] = d->margin;
}

/* In the precision `number`, of which P adds the suffix. */
#define FIND_BLOCK(name, m, number, P, series_of)                                                  \
    static void FN(name)(const struct psc_fibres *f, const struct P(psc_sheaf) *from, size_t n,    \
                         const real *restrict u, struct FN(fibre_sites) *restrict to)              \
    {                                                                                              \
        const struct P(psc_sheaf) sheaf = *from;                                                   \
        const int steps = f->steps;                                                                \
        struct P(psc_fibre_series) series;                                                         \
        const struct P(series_view) q = P(view_of)(series_of(m, f, &series));                      \
        number x[PSC_BLOCK], target[PSC_BLOCK], sign[PSC_BLOCK];                                   \
        size_t e;                                                                                  \
        int step;                                                                                  \
                                                                                                   \
        (void)series;                                                                              \
        for (e = 0; e < n; e++)                                                                    \
            x[e] = P(series_start)(&q, sheaf.clipped, sheaf.end, (number)u[e],                     \
                                   (number)1.0 - (number)u[e], &sign[e], &target[e]);              \
        for (step = 1; step < steps; step++)                                                       \
            for (e = 0; e < n; e++)                                                                \
                x[e] = P(series_nearer)(m, &q, sign[e], sheaf.end, target[e], x[e]);               \
        for (e = 0; e < n; e++) {                                                                  \
            struct P(psc_fibre_site) site;                                                         \
                                                                                                   \
            P(series_place)(m, &q, &sheaf, sign[e], target[e], x[e], &site);                       \
            to->sine[e] = (real)site.sine;                                                         \
            to->cosine[e] = (real)site.cosine;                                                     \
            to->rise[e] = (real)site.rise;                                                         \
        }                                                                                          \
    }
#define FIND_WHOLE(i, m, most) FIND_BLOCK(find_whole_##m, m, real, FN, SERIES_OF)
#define WIDE(name) name##_f64
#define WIDE_SERIES_OF(m, f, to) (&(f)->series)
#define FIND_CLIPPED(i, m, most) FIND_BLOCK(find_clipped_##m, m, double, WIDE, WIDE_SERIES_OF)
PSC_FIBRE_RULES(FIND_WHOLE)
#if PSC_REAL_BITS == 32
PSC_FIBRE_RULES(FIND_CLIPPED)
#define FIND_CLIPPED_BLOCK(m) FN(find_clipped_##m)
#else
#define FIND_CLIPPED_BLOCK(m) FN(find_whole_##m)
#endif
#undef FIND_WHOLE
#undef FIND_CLIPPED
#undef FIND_BLOCK

#define PLACE_BLOCK(name, clipped, brief)                                                          \
    static void FN(name)(const struct psc_disk_light *l, const struct FN(psc_sheaf) *from,         \
                         size_t n, const struct FN(fibre_sites) *restrict at,                      \
                         const real *restrict v, struct FN(fibre_directions) *restrict to)         \
    {                                                                                              \
        const struct FN(fibre_frame) frame = FN(frame_of)(l);                                      \
        const struct FN(psc_sheaf) f = *from;                                                      \
        size_t e;                                                                                  \
                                                                                                   \
        for (e = 0; e < n; e++) {                                                                  \
            const struct FN(psc_fibre_site) site = {at->sine[e], at->cosine[e], at->rise[e]};      \
            struct FN(psc_fibre_direction) d;                                                      \
                                                                                                   \
            FN(place_on_fibre)(&f, clipped, brief, frame.per, frame.bt, &site, v[e], &d);          \
            FN(store_direction)(to, e, &d);                                                        \
        }                                                                                          \
    }
PLACE_BLOCK(place_whole, 0, 0)
PLACE_BLOCK(place_whole_brief, 0, 1)
PLACE_BLOCK(place_clipped, 1, 0)
PLACE_BLOCK(place_clipped_brief, 1, 1)
#undef PLACE_BLOCK

static void FN(series_block)(const struct psc_disk_light *l, const struct psc_fibres *f, size_t n,
                             const real *u, const real *v, struct FN(fibre_directions) *d)
{
    struct FN(fibre_sites) sites;
    struct FN(psc_sheaf) rounded;
    const struct FN(psc_sheaf) *const sheaf = SHEAF_OF(f, &rounded);

    (void)rounded;
    switch (f->rule) {
#define FIND_CASE(i, m, most)                                   \
    case i:                                                     \
        if (sheaf->clipped)                                     \
            FIND_CLIPPED_BLOCK(m)(f, &f->sheaf, n, u, &sites);  \
        else                                                    \
            FN(find_whole_##m)(f, sheaf, n, u, &sites);         \
        break;
        PSC_FIBRE_RULES(FIND_CASE)
#undef FIND_CASE
    default: return;
    }
    if (sheaf->clipped)
        (sheaf->brief ? FN(place_clipped_brief) : FN(place_clipped))(l, sheaf, n, &sites, v, d);
    else
        (sheaf->brief ? FN(place_whole_brief) : FN(place_whole))(l, sheaf, n, &sites, v, d);
}

static void FN(panel_block)(const struct psc_disk_light *l, int side, size_t n, const real *u,
                            const real *v, struct FN(fibre_directions) *d)
{
    size_t e;

    for (e = 0; e < n; e++) {
        struct psc_fibre_direction_f64 wide;
        struct FN(psc_fibre_direction) narrow;

        fibre_point(l, side, (double)u[e], (double)v[e], &wide);
        FN(round_direction)(&wide, &narrow);
        FN(store_direction)(d, e, &narrow);
    }
}

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
            FN(gnomonic_hit)(solid, &own, d->uz[i], d->vz[i], d->depth[i], d->margin[i], point,
                             normal, &distance, surface);
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
    const real mirror = FIBRE_MIRROR(l, side);
    struct FN(fibre_directions) d;
    struct FN(psc_disk_world) w;
    size_t i;

    if (SERIES_FITS(l->fibres + side))
        FN(series_block)(l, l->fibres + side, n, u, v, &d);
    else
        FN(panel_block)(l, side, n, u, v, &d);
    FN(disk_world)(s, &w);
    for (i = 0; i < n; i++) {
        real direction[3];

        FN(fibre_world)(&w, mirror, d.x[i], d.y[i], d.z[i], direction);
        r->value[0][i] = direction[0];
        r->value[1][i] = direction[1];
        r->value[2][i] = direction[2];
        r->value[PSC_PDF][i] = d.height[i] * w.inverse_total;
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
