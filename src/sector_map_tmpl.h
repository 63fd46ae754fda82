/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Sampling of polygons by projected solid angle, one sample at a time or in blocks that vectorise.
 * In double behind both precisions: shares of thin sectors are beyond float. Template: see
 * precision.h.
 */

/* Steps of sector_solve(): the worst error of the cumulative distribution is then 5e-16 and, for
   float, 9e-10, over 2.5 million samples of lights of all kinds. */
#undef SECTOR_STEPS
#if PSC_REAL_BITS == 64
#define SECTOR_STEPS 3
#else
#define SECTOR_STEPS 2
#endif

/* The number of the sector that u falls to. */
PSC_LANE int FN(pick_sector)(const struct psc_sector_light *l, const struct psc_sector_side *side,
                             double u)
{
    int i, k = side->sector;

    for (i = 1; i < side->sectors; i++)
        k += u >= l->sector[side->sector + i].start;
    return k;
}

PSC_LANE void FN(sector_direction)(const struct psc_sector_side *side, double x, double y,
                                   double z, real direction[3])
{
    int i;

    for (i = 0; i < 3; i++)
        direction[i] = (real)((x * side->x[i] + y * side->y[i]) + z * side->z[i]);
}

/* Where the direction meets the light, and how far away in units of the view. */
PSC_LANE void FN(sector_surface)(const struct psc_sector_light *l, int k,
                                 const struct psc_sector_point *p, real point[3],
                                 real surface[2], double *distance)
{
    const struct psc_sector_hit *const hit = l->hit + k;
    double share[4], sum[5] = {0.0, 0.0, 0.0, 0.0, 0.0};
    int i, c;

    *distance = 1.0 / sector_shares(hit, p, share);
    for (i = 0; i < 4; i++) {
        const int at = hit->corner[i];
        const double part = share[i] * *distance;

        for (c = 0; c < 3; c++)
            sum[c] += part * l->corner[at].offset[c];
        for (c = 0; c < 2; c++)
            sum[3 + c] += part * l->corner[at].place[c];
    }
    for (c = 0; c < 3; c++)
        point[c] = (real)(l->pivot[c] + sum[c]);
    surface[0] = (real)sum[3];
    surface[1] = (real)sum[4];
}

static psc_result FN(sector_sample)(const psc_sampler *s, real u, real v,
                                    FN(psc_light_sample) *out)
{
    const struct psc_polygon_light *const l = &s->polygon;
    const struct psc_sector_side *const side = l->projected.side + FN(pick_side)(s, u, &u);
    const int k = FN(pick_sector)(&l->projected, side, (double)u);
    const struct psc_sector *const sector = l->projected.sector + k;
    struct psc_sector_point p;
    double distance;
    int i;

    sector_point(sector, sector_solve(sector, SECTOR_STEPS, (double)u), (double)v, &p);
    FN(sector_direction)(side, p.x, p.y, p.z, out->direction);
    FN(sector_surface)(&l->projected, k, &p, out->point, out->surface, &distance);
    out->distance = (real)(distance * unit_inverse(l->view.scale));
    out->pdf = (real)(p.z * s->inverse_total);
    out->weight = (real)s->total;
    for (i = 0; i < 3; i++)
        out->normal[i] = (real)l->normal[i];
    return PSC_SUCCESS;
}

/* ---- Blocks ---- */

#define SECTOR_ARRAY(name) double name[PSC_BLOCK];
struct FN(psc_sector_block) {
    PSC_SECTOR_FIELDS(SECTOR_ARRAY)
    double l[PSC_BLOCK], x[PSC_BLOCK], y[PSC_BLOCK], z[PSC_BLOCK], u[PSC_BLOCK], w[PSC_BLOCK];
    int number[PSC_BLOCK];
};
#undef SECTOR_ARRAY

PSC_LANE void FN(load_sector)(const struct FN(psc_sector_block) *b, size_t i, struct psc_sector *to)
{
#define SECTOR_LOAD(name) to->name = b->name[i];
    PSC_SECTOR_FIELDS(SECTOR_LOAD)
#undef SECTOR_LOAD
}

/* The sector of each sample, then its fields: what varies from sample to sample are numbers alone,
   for the loops that follow. */
static void FN(gather_sectors)(const struct psc_sector_light *l,
                               const struct psc_sector_side *side, size_t n,
                               const real *restrict u, struct FN(psc_sector_block) *restrict b)
{
    size_t i;
    int k;

    for (i = 0; i < n; i++)
        b->number[i] = side->sector;
    for (k = 1; k < side->sectors; k++) {
        const double start = l->sector[side->sector + k].start;

        for (i = 0; i < n; i++)
            b->number[i] += (double)u[i] >= start;
    }
    for (i = 0; i < n; i++) {
        const struct psc_sector *const from = l->sector + b->number[i];

#define SECTOR_STORE(name) b->name[i] = from->name;
        PSC_SECTOR_FIELDS(SECTOR_STORE)
#undef SECTOR_STORE
    }
}

static void FN(solve_sectors)(size_t n, const real *restrict u, const real *restrict v,
                              struct FN(psc_sector_block) *restrict b)
{
    size_t i;

    for (i = 0; i < n; i++) {
        struct psc_sector s;

        FN(load_sector)(b, i, &s);
        b->l[i] = sector_solve(&s, SECTOR_STEPS, (double)u[i]);
    }
    for (i = 0; i < n; i++) {
        struct psc_sector s;
        struct psc_sector_point p;

        FN(load_sector)(b, i, &s);
        sector_point(&s, b->l[i], (double)v[i], &p);
        b->x[i] = p.x;
        b->y[i] = p.y;
        b->z[i] = p.z;
        b->u[i] = p.u;
        b->w[i] = p.w;
    }
}

static void FN(sector_block)(const psc_sampler *s, int number, size_t n, const real *restrict u,
                             const real *restrict v, int surface,
                             struct FN(psc_results) *restrict r)
{
    const struct psc_polygon_light *const l = &s->polygon;
    const struct psc_sector_side side = l->projected.side[number];
    const real normal[3] = {(real)l->normal[0], (real)l->normal[1], (real)l->normal[2]};
    const double inverse_total = s->inverse_total, unit = unit_inverse(l->view.scale);
    const real total = (real)s->total;
    struct FN(psc_sector_block) b;
    size_t i;

    FN(gather_sectors)(&l->projected, &side, n, u, &b);
    FN(solve_sectors)(n, u, v, &b);
    for (i = 0; i < n; i++) {
        real direction[3];

        FN(sector_direction)(&side, b.x[i], b.y[i], b.z[i], direction);
        r->value[0][i] = direction[0];
        r->value[1][i] = direction[1];
        r->value[2][i] = direction[2];
        r->value[PSC_PDF][i] = (real)(b.z[i] * inverse_total);
        r->value[PSC_WEIGHT][i] = total;
    }
    for (i = 0; surface && i < n; i++) {
        const struct psc_sector_point p = {b.l[i], b.x[i], b.y[i], b.z[i], b.u[i], b.w[i]};
        real point[3], place[2];
        double distance;

        FN(sector_surface)(&l->projected, b.number[i], &p, point, place, &distance);
        FN(store_surface)(r, i, point, normal, (real)(distance * unit), place[0], place[1]);
    }
    for (i = 0; i < n; i++)
        r->status[i] = PSC_SUCCESS;
}
