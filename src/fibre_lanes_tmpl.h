/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Fibres of many lights at once, with a series each: built, found and placed in loops, by the lane
 * functions that do it for one light. Template: see precision.h.
 */

#define FIBRE_LANES 32
#define FIBRE_TERMS 12

/* Elements of one loop. Coefficients and places have a row for each term. */
struct FN(fibre_lanes) {
    uint32_t index[FIBRE_LANES]; /* in the block */
    real u[FIBRE_LANES], v[FIBRE_LANES], per[2][FIBRE_LANES], bt[FIBRE_LANES];
    double total[FIBRE_LANES]; /* given for whole cones */
    /* Numbers of steps, as vector code compares them: at starts, and from them. */
    double start_steps[FIBRE_LANES], steps[FIBRE_LANES];
    int most_start_steps, most_steps;

    double sin_m[FIBRE_LANES], cos_m[FIBRE_LANES], shear[FIBRE_LANES], width[FIBRE_LANES];
    double nz[FIBRE_LANES], nf[FIBRE_LANES], end[FIBRE_LANES], cos_end[FIBRE_LANES];
    double f[2][FIBRE_LANES], turn[2][FIBRE_LANES];

    double values[2][FIBRE_TERMS * FIBRE_LANES], waves[2][FIBRE_TERMS * FIBRE_LANES];
    double place[2 * PSC_START_TERMS * FIBRE_LANES], number[FIBRE_LANES];
    double mean[FIBRE_LANES], start[2 * PSC_START_TERMS * FIBRE_LANES];
    double even[FIBRE_TERMS * FIBRE_LANES], odd[FIBRE_TERMS * FIBRE_LANES];
    double even_integral[FIBRE_TERMS * FIBRE_LANES], odd_integral[FIBRE_TERMS * FIBRE_LANES];
    double even_slope[FIBRE_TERMS * FIBRE_LANES], odd_slope[FIBRE_TERMS * FIBRE_LANES];
#if PSC_REAL_BITS == 32
    float mean_f32[FIBRE_LANES], start_f32[2 * PSC_START_TERMS * FIBRE_LANES];
    float even_f32[FIBRE_TERMS * FIBRE_LANES], odd_f32[FIBRE_TERMS * FIBRE_LANES];
    float even_integral_f32[FIBRE_TERMS * FIBRE_LANES];
    float odd_integral_f32[FIBRE_TERMS * FIBRE_LANES];
    float even_slope_f32[FIBRE_TERMS * FIBRE_LANES], odd_slope_f32[FIBRE_TERMS * FIBRE_LANES];
#endif

    real sine[FIBRE_LANES], cosine[FIBRE_LANES], rise[FIBRE_LANES];
    real x[FIBRE_LANES], y[FIBRE_LANES], z[FIBRE_LANES], height[FIBRE_LANES];
    real depth[FIBRE_LANES], uz[FIBRE_LANES], vz[FIBRE_LANES], margin[FIBRE_LANES];
};

PSC_LANE struct psc_series_lot FN(lot_of)(struct FN(fibre_lanes) *k, size_t count)
{
    const struct psc_series_lot lot = {
        count, FIBRE_LANES, k->sin_m, k->cos_m, k->shear, k->width, k->nz, k->nf, k->end, k->total,
        k->start_steps, k->most_start_steps, k->mean, k->start, k->even, k->odd, k->even_integral,
        k->odd_integral, k->even_slope, k->odd_slope, {k->values[0], k->values[1]},
        {k->waves[0], k->waves[1]}, k->place, k->number};

    return lot;
}

PSC_LANE struct series_view_f64 FN(lane_view)(struct FN(fibre_lanes) *k, size_t e)
{
    const struct psc_series_lot lot = FN(lot_of)(k, 0);

    return lot_view(&lot, e);
}

#if PSC_REAL_BITS == 32
PSC_LANE void FN(round_lanes)(int n, size_t count, struct FN(fibre_lanes) *restrict k)
{
    size_t e;
    int j;

    for (e = 0; e < count; e++)
        k->mean_f32[e] = (float)k->mean[e];
    for (j = 0; j < 2 * PSC_START_TERMS; j++)
        for (e = 0; e < count; e++)
            k->start_f32[(size_t)j * FIBRE_LANES + e] =
                (float)k->start[(size_t)j * FIBRE_LANES + e];
    for (j = 0; j < n; j++)
        for (e = 0; e < count; e++) {
            const size_t at = (size_t)j * FIBRE_LANES + e;

            k->even_f32[at] = (float)k->even[at];
            k->odd_f32[at] = (float)k->odd[at];
            k->even_integral_f32[at] = (float)k->even_integral[at];
            k->odd_integral_f32[at] = (float)k->odd_integral[at];
            k->even_slope_f32[at] = (float)k->even_slope[at];
            k->odd_slope_f32[at] = (float)k->odd_slope[at];
        }
}

PSC_LANE struct series_view_f32 FN(narrow_view)(const struct FN(fibre_lanes) *k, size_t e)
{
    const struct series_view_f32 view = {
        FIBRE_LANES,             k->mean_f32 + e,       k->start_f32 + e,
        k->even_f32 + e,         k->odd_f32 + e,        k->even_integral_f32 + e,
        k->odd_integral_f32 + e, k->even_slope_f32 + e, k->odd_slope_f32 + e};

    return view;
}
#endif

/* find_fibre(), or find_whole(), in the precision `number`, of which P adds the suffix. */
#define LANE_FIND(name, number, P, view)                                                           \
    PSC_LANE void FN(name)(int n, int clipped, size_t count, struct FN(fibre_lanes) *restrict k)   \
    {                                                                                              \
        number x[FIBRE_LANES], target[FIBRE_LANES], sign[FIBRE_LANES];                             \
        size_t e;                                                                                  \
        int step;                                                                                  \
                                                                                                   \
        for (e = 0; e < count; e++) {                                                              \
            const struct P(series_view) q = FN(view)(k, e);                                        \
                                                                                                   \
            x[e] = P(series_start)(&q, clipped, (number)k->end[e], (number)k->u[e],                \
                                   (number)1.0 - (number)k->u[e], &sign[e], &target[e]);           \
        }                                                                                          \
        for (step = 1; step < k->most_steps; step++)                                               \
            for (e = 0; e < count; e++) {                                                          \
                const struct P(series_view) q = FN(view)(k, e);                                    \
                const number next = P(series_nearer)(n, &q, sign[e], (number)k->end[e], target[e], \
                                                     x[e]);                                        \
                                                                                                   \
                x[e] = k->steps[e] > step + 0.5 ? next : x[e];                                     \
            }                                                                                      \
        for (e = 0; e < count; e++) {                                                              \
            const struct P(series_view) q = FN(view)(k, e);                                        \
            struct P(psc_fibre_site) site;                                                         \
            struct P(psc_sheaf) f;                                                                 \
                                                                                                   \
            f.end = (number)k->end[e];                                                             \
            f.sin_m = (number)k->sin_m[e];                                                         \
            f.cos_end = (number)k->cos_end[e];                                                     \
            P(series_place)(n, &q, &f, sign[e], target[e], x[e], &site);                           \
            k->sine[e] = (real)site.sine;                                                          \
            k->cosine[e] = (real)site.cosine;                                                      \
            k->rise[e] = (real)site.rise;                                                          \
        }                                                                                          \
    }
LANE_FIND(lane_find, double, WIDE, lane_view)
#if PSC_REAL_BITS == 32
LANE_FIND(lane_find_whole, float, FN, narrow_view)
#endif
#undef LANE_FIND

PSC_LANE void FN(lane_place)(int clipped, int brief, size_t count,
                             struct FN(fibre_lanes) *restrict k)
{
    size_t e;

    for (e = 0; e < count; e++) {
        const struct FN(psc_fibre_site) site = {k->sine[e], k->cosine[e], k->rise[e]};
        const real per[2] = {k->per[0][e], k->per[1][e]};
        struct FN(psc_fibre_direction) d;
        struct FN(psc_sheaf) f;

        f.f[0] = (real)k->f[0][e];
        f.f[1] = (real)k->f[1][e];
        f.turn[0] = (real)k->turn[0][e];
        f.turn[1] = (real)k->turn[1][e];
        f.sin_m = (real)k->sin_m[e];
        f.cos_m = (real)k->cos_m[e];
        f.shear = (real)k->shear[e];
        f.width = (real)k->width[e];
        f.nz = (real)k->nz[e];
        f.nf = (real)k->nf[e];
        FN(place_on_fibre)(&f, clipped, brief, per, k->bt[e], &site, k->v[e], &d);
        k->x[e] = d.x;
        k->y[e] = d.y;
        k->z[e] = d.z;
        k->height[e] = d.height;
        k->depth[e] = d.depth;
        k->uz[e] = d.uz;
        k->vz[e] = d.vz;
        k->margin[e] = d.margin;
    }
}

#if PSC_REAL_BITS == 32
#define LANE_FIND_WHOLE(m, count, k) \
    FN(round_lanes)(m, count, k);    \
    FN(lane_find_whole)(m, 0, count, k)
#else
#define LANE_FIND_WHOLE(m, count, k) FN(lane_find)(m, 0, count, k)
#endif
#define LANE_LOOPS(i, m)                                                                           \
    static void FN(fibre_wave_whole_##i)(struct FN(fibre_lanes) *k, size_t count)                  \
    {                                                                                              \
        const struct psc_series_lot lot = FN(lot_of)(k, count);                                    \
                                                                                                   \
        series_build(m, 0, psc_rule_f64_##m.c, psc_rule_f64_##m.s, psc_rule_f64_##m.per_s,         \
                     psc_rule_f64_##m.column, psc_rule_f64_##m.power, &lot);                       \
        LANE_FIND_WHOLE(m, count, k);                                                              \
    }                                                                                              \
    static void FN(fibre_wave_clipped_##i)(struct FN(fibre_lanes) *k, size_t count)                \
    {                                                                                              \
        const struct psc_series_lot lot = FN(lot_of)(k, count);                                    \
                                                                                                   \
        series_build(m, 1, psc_rule_f64_##m.c, psc_rule_f64_##m.s, psc_rule_f64_##m.per_s,         \
                     psc_rule_f64_##m.column, psc_rule_f64_##m.power, &lot);                       \
        FN(lane_find)(m, 1, count, k);                                                             \
    }
LANE_LOOPS(0, 4)
LANE_LOOPS(1, 8)
LANE_LOOPS(2, 12)
#undef LANE_LOOPS

#define LANE_PLACE(name, clipped, brief)                                  \
    static void FN(name)(struct FN(fibre_lanes) *k, size_t count)         \
    {                                                                     \
        FN(lane_place)(clipped, brief, count, k);                         \
    }
LANE_PLACE(fibre_wave_place_whole, 0, 0)
LANE_PLACE(fibre_wave_place_whole_brief, 0, 1)
LANE_PLACE(fibre_wave_place_clipped, 1, 0)
LANE_PLACE(fibre_wave_place_clipped_brief, 1, 1)
#undef LANE_PLACE
