/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Fibres of many lights at once, with a series each: built, found and placed in loops. Statement by
 * statement the loops do what series_build(), fit_starts() and find_fibre() do for one light, so
 * the bits are the same. Template: see precision.h.
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

/* What the loops read of a sheaf. */
PSC_LANE struct psc_sheaf_f64 FN(lane_sheaf)(const struct FN(fibre_lanes) *k, size_t e, int clipped)
{
    struct psc_sheaf_f64 f;

    f.sin_m = k->sin_m[e];
    f.cos_m = k->cos_m[e];
    f.shear = k->shear[e];
    f.width = k->width[e];
    f.nz = k->nz[e];
    f.nf = k->nf[e];
    f.end = k->end[e];
    f.cos_end = k->cos_end[e];
    f.clipped = clipped;
    return f;
}

PSC_LANE struct series_view_f64 FN(lane_view)(const struct FN(fibre_lanes) *k, size_t e)
{
    const struct series_view_f64 view = {
        FIBRE_LANES,         k->mean + e,       k->start + e,
        k->even + e,         k->odd + e,        k->even_integral + e,
        k->odd_integral + e, k->even_slope + e, k->odd_slope + e};

    return view;
}

/* even_fit() of both functions. */
PSC_LANE void FN(lane_fits)(int n, const double *column, const double *power, size_t count,
                            struct FN(fibre_lanes) *restrict k)
{
    double *const to[2] = {k->even, k->odd};
    size_t e;
    int side, i, j;

    for (side = 0; side < 2; side++) {
        for (i = 0; i < n; i++)
            for (e = 0; e < count; e++) {
                double sum = 0.0;

                PSC_UNROLL
                for (j = 0; j < n; j++)
                    sum += k->values[side][(size_t)j * FIBRE_LANES + e] * column[j * n + i];
                k->waves[side][(size_t)i * FIBRE_LANES + e] = sum * (i > 0 ? 1.0 : 0.5) * (2.0 / n);
            }
        for (i = 0; i < n; i++)
            for (e = 0; e < count; e++) {
                double sum = 0.0;

                PSC_UNROLL
                for (j = 0; j < n; j++)
                    sum += k->waves[side][(size_t)j * FIBRE_LANES + e] * power[j * n + i];
                to[side][(size_t)i * FIBRE_LANES + e] = sum;
            }
    }
}

/* series_build() without the starts */
PSC_LANE void FN(lane_series)(int n, int clipped, const double *c, const double *s,
                              const double *per_s, const double *column, const double *power,
                              size_t count, struct FN(fibre_lanes) *restrict k)
{
    size_t e;
    int j;

    for (j = 0; j < n; j++)
        for (e = 0; e < count; e++) {
            const struct psc_sheaf_f64 f = FN(lane_sheaf)(k, e, clipped);
            struct psc_fibre_f64 o;
            double even;

            fibre_shape_f64(&f, s[j], c[j], &o);
            even = 0.5 * f.sin_m * o.weight * per_s[j];
            k->values[0][(size_t)j * FIBRE_LANES + e] = even;
            k->values[1][(size_t)j * FIBRE_LANES + e] = even / o.k;
        }
    FN(lane_fits)(n, column, power, count, k);
    for (j = 0; j < n; j++)
        for (e = 0; e < count; e++) {
            k->even[(size_t)j * FIBRE_LANES + e] *= k->nz[e];
            k->odd[(size_t)j * FIBRE_LANES + e] *= k->nf[e] * k->sin_m[e];
        }
    for (e = 0; e < count; e++)
        integrate_series(n, FIBRE_LANES, k->even + e, k->odd + e, k->even_integral + e,
                         k->odd_integral + e, k->mean + e);
    for (e = 0; e < count; e++) {
        const struct series_view_f64 q = FN(lane_view)(k, e);
        struct fibre_arc_f64 end;
        double whole;

        arc_of_f64(k->end[e], &end);
        whole = clipped ? series_integral_f64(n, &q, 1.0, &end) : PSC_PI * k->mean[e];
        if (clipped)
            k->total[e] = whole;
        k->number[e] = 1.0 / whole;
    }
    for (j = 0; j < n; j++)
        for (e = 0; e < count; e++) {
            const size_t at = (size_t)j * FIBRE_LANES + e;

            k->even[at] *= k->number[e];
            k->odd[at] *= k->number[e];
            k->even_integral[at] *= k->number[e];
            k->odd_integral[at] *= k->number[e];
        }
    for (e = 0; e < count; e++)
        k->mean[e] *= k->number[e];
    for (j = 0; j < n; j++)
        for (e = 0; e < count; e++) {
            const size_t at = (size_t)j * FIBRE_LANES + e, next = at + FIBRE_LANES;

            k->even_slope[at] = j < n - 1 ? (j + 1) * k->even[next] : 0.0;
            k->odd_slope[at] = j < n - 1 ? (j + 1) * k->odd[next] : 0.0;
        }
}

/* fit_starts() */
PSC_LANE void FN(lane_starts)(int n, int clipped, size_t count,
                              struct FN(fibre_lanes) *restrict k)
{
    enum { HALF = PSC_START_TERMS, BOTH = 2 * HALF };
    const double *const model = psc_start_model + clipped * PSC_MODEL_TERMS * BOTH;
    const double *const powers[2] = {psc_start_powers, psc_start_powers + clipped * HALF * HALF};
    size_t e;
    int i, j, half;

    for (i = 0; i < BOTH; i++) {
        const int lower = i >= HALF, cut = lower && clipped;
        const int from = lower && !clipped ? i - HALF : i;
        const double root = psc_start_root[from], given = psc_start_share[from];
        const double sign = lower && !clipped ? -1.0 : 1.0;

        for (e = 0; e < count; e++) {
            const struct psc_sheaf_f64 f = FN(lane_sheaf)(k, e, clipped);
            const double t = model_variable(&f, clipped), unit = clipped ? f.end : 1.0;
            double x = 0.0;

            PSC_UNROLL
            for (j = PSC_MODEL_TERMS - 1; j >= 0; j--)
                x = x * t + model[j * BOTH + i];
            x *= root * unit;
            k->number[e] = cut ? f.end - x : x;
        }
        for (j = 0; j < k->most_start_steps; j++)
            for (e = 0; e < count; e++) {
                const struct series_view_f64 q = FN(lane_view)(k, e);
                const double share = cut ? 1.0 - given : given;
                struct fibre_arc_f64 at;
                double next;

                arc_of_f64(k->number[e], &at);
                next = k->number[e] + series_step_f64(n, &q, sign, k->end[e], share, &at);
                k->number[e] = k->start_steps[e] > j + 0.5 ? next : k->number[e];
            }
        for (e = 0; e < count; e++) {
            const double x = cut ? k->end[e] - k->number[e] : k->number[e];

            k->place[(size_t)i * FIBRE_LANES + e] = x / root;
        }
    }
    for (half = 0; half < 2; half++)
        for (i = 0; i < HALF; i++)
            for (e = 0; e < count; e++) {
                const double *const x = k->place + (size_t)(half * HALF) * FIBRE_LANES + e;
                double sum = 0.0;

                PSC_UNROLL
                for (j = 0; j < HALF; j++)
                    sum += x[(size_t)j * FIBRE_LANES] * powers[half][j * HALF + i];
                k->start[(size_t)(half * HALF + i) * FIBRE_LANES + e] = sum;
            }
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
        FN(lane_series)(m, 0, psc_rule_f64_##m.c, psc_rule_f64_##m.s, psc_rule_f64_##m.per_s,      \
                        psc_rule_f64_##m.column, psc_rule_f64_##m.power, count, k);                \
        FN(lane_starts)(m, 0, count, k);                                                           \
        LANE_FIND_WHOLE(m, count, k);                                                              \
    }                                                                                              \
    static void FN(fibre_wave_clipped_##i)(struct FN(fibre_lanes) *k, size_t count)                \
    {                                                                                              \
        FN(lane_series)(m, 1, psc_rule_f64_##m.c, psc_rule_f64_##m.s, psc_rule_f64_##m.per_s,      \
                        psc_rule_f64_##m.column, psc_rule_f64_##m.power, count, k);                \
        FN(lane_starts)(m, 1, count, k);                                                           \
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
