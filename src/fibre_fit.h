/* SPDX-License-Identifier: Apache-2.0 */
/* The series of fibre_series_tmpl.h, from the density at the nodes of a rule. */
#ifndef PSC_SRC_FIBRE_FIT_H
#define PSC_SRC_FIBRE_FIT_H

#include "ellipse_rules.h"
#include "fibre_lot.h"

/* The number of steps where the series serves, else 0: not for slivers, where its sum would lose
   digits, nor where the horizon nearly touches the cone from below or above and the starts are
   poor, the more so in wide cones. */
static inline int series_steps(const struct psc_sheaf_f64 *f, double at)
{
    const double low = f->nz * f->cos_m, high = f->nf * f->sin_m;
    const int wide = at > 0.55;

    if (at > PSC_SERIES_TANGENT || (f->clipped && f->rest > 2.2))
        return 0;
    if (f->clipped ? f->rest > 1.0 : high < 0.55 * low)
        return wide ? 2 : 1;
    if (f->clipped ? f->rest > 0.6 : high < 0.8 * low)
        return 2;
    return !wide && (f->clipped ? f->rest > 0.4 : high < 0.9 * low) ? 3 : 0;
}

PSC_LANE int fibre_rule(double at)
{
#define FIBRE_RULE(i, m, most) at <= (most) ? (i) :
    return PSC_FIBRE_RULES(FIBRE_RULE) -1;
#undef FIBRE_RULE
}

/* The polynomial in cos 2s through the values at the nodes: Chebyshev's first. */
PSC_LANE void even_fit(int n, const double *column, const double *power, int side,
                       const struct psc_series_lot *k)
{
    row_sums(n, column, 1.0 / n, 2.0 / n, k->count, k->stride, k->values[side], k->waves[side]);
    row_sums(n, power, 1.0, 1.0, k->count, k->stride, k->waves[side],
             side == 0 ? k->even : k->odd);
}

/* 1 / (j + 1), 1 / (2 j + 3) */
static const double psc_inverse[PSC_SERIES_TERMS] = {
    1.0,      1.0 / 2,  1.0 / 3,  1.0 / 4,  1.0 / 5,  1.0 / 6,  1.0 / 7,  1.0 / 8,
    1.0 / 9,  1.0 / 10, 1.0 / 11, 1.0 / 12, 1.0 / 13, 1.0 / 14, 1.0 / 15, 1.0 / 16,
    1.0 / 17, 1.0 / 18, 1.0 / 19, 1.0 / 20, 1.0 / 21, 1.0 / 22, 1.0 / 23, 1.0 / 24};
static const double psc_odd_inverse[PSC_SERIES_TERMS] = {
    1.0 / 3,  1.0 / 5,  1.0 / 7,  1.0 / 9,  1.0 / 11, 1.0 / 13, 1.0 / 15, 1.0 / 17,
    1.0 / 19, 1.0 / 21, 1.0 / 23, 1.0 / 25, 1.0 / 27, 1.0 / 29, 1.0 / 31, 1.0 / 33,
    1.0 / 35, 1.0 / 37, 1.0 / 39, 1.0 / 41, 1.0 / 43, 1.0 / 45, 1.0 / 47, 1.0 / 49};

/* The coefficients of the integral: A_j = P_j + (j + 1) (P_(j - 1) - P_(j + 1)),
   B_j = (2 j + 3) R_j - 2 (j + 1) R_(j + 1). */
PSC_LANE void integrate_series(int n, size_t stride, const double *even, const double *odd,
                               double *even_integral, double *odd_integral, double *mean)
{
    double p = 0.0, above = 0.0, r = 0.0;
    int j;

    PSC_UNROLL
    for (j = n - 1; j >= 0; j--) {
        const size_t at = (size_t)j * stride;

        r = (odd[at] + 2.0 * (j + 1) * r) * psc_odd_inverse[j];
        odd_integral[at] = r;
        even_integral[at] = p;
        if (j > 0) {
            const double next = (even[at] - p) * psc_inverse[j] + above;

            above = p;
            p = next;
        }
    }
    *mean = 0.5 * (even[0] - p + above);
}

/* What the places of fixed shares are modelled in powers of. */
PSC_LANE double model_variable(const struct psc_sheaf_f64 *f, int clipped)
{
    return clipped ? f->end * f->end : f->nf * f->sin_m / (f->nz * f->cos_m);
}

/* From that to the place: needles are far from it too. */
PSC_LANE int start_steps(int n, const struct psc_sheaf_f64 *f)
{
    return n > 12 || ABS(f->shear) > 0.25 ? 2 : 1;
}

/* Those places as they are in a small cone; `number` of the lot is model_variable(). What rows are
   written is restricted, for no loop is to ask whether they are those that it reads. */
PSC_LANE void model_rows(int clipped, const double *root, const struct psc_series_lot *k,
                         double *restrict x)
{
    enum { BOTH = 2 * PSC_START_TERMS };
    const double *const model = psc_start_model + clipped * PSC_MODEL_TERMS * BOTH;
    size_t e;
    int i, j;

    PSC_KEEP_LOOP
    for (i = 0; i < BOTH; i++)
        for (e = 0; e < k->count; e++) {
            double sum = 0.0;

            PSC_UNROLL
            for (j = PSC_MODEL_TERMS - 1; j >= 0; j--)
                sum = sum * k->number[e] + model[j * BOTH + i];
            x[(size_t)i * k->stride + e] = sum * (root[i] * (clipped ? k->end[e] : 1.0));
        }
}

/* A step of all that have so many. */
PSC_LANE void step_rows(int n, int step, const double *sign, const double *share,
                        const struct psc_series_lot *k, double *restrict x)
{
    size_t e;
    int i;

    PSC_KEEP_LOOP
    for (i = 0; i < 2 * PSC_START_TERMS; i++)
        for (e = 0; e < k->count; e++) {
            const size_t at = (size_t)i * k->stride + e;
            const struct series_view_f64 q = lot_view(k, e);
            struct fibre_arc_f64 arc;
            double next;

            arc_of_f64(x[at], &arc);
            next = x[at] + series_step_f64(n, &q, sign[i], k->end[e], share[i], &arc);
            x[at] = k->start_steps[e] > step + 0.5 ? next : x[at];
        }
}

/* The starts through places of fixed shares: those of a small cone, and a step, or two where the
   cone is wide. */
PSC_LANE void fit_starts(int n, int clipped, const struct psc_series_lot *k)
{
    enum { HALF = PSC_START_TERMS, BOTH = 2 * HALF };
    const double *const powers[2] = {psc_start_powers, psc_start_powers + clipped * HALF * HALF};
    const size_t count = k->count, stride = k->stride;
    double share[BOTH], root[BOTH], sign[BOTH];
    double *const x = k->place;
    size_t e;
    int i, step;

    for (i = 0; i < BOTH; i++) {
        share[i] = psc_start_share[i < HALF || clipped ? i : i - HALF];
        share[i] = i >= HALF && clipped ? 1.0 - share[i] : share[i];
        root[i] = psc_start_root[i < HALF || clipped ? i : i - HALF];
        sign[i] = i < HALF || clipped ? 1.0 : -1.0;
    }
    for (e = 0; e < count; e++) {
        const struct psc_sheaf_f64 f = lot_sheaf(k, e, clipped);

        k->number[e] = model_variable(&f, clipped);
    }
    model_rows(clipped, root, k, x);
    for (i = HALF; clipped && i < BOTH; i++)
        for (e = 0; e < count; e++)
            x[(size_t)i * stride + e] = k->end[e] - x[(size_t)i * stride + e];
    for (step = 0; step < k->most_start_steps; step++)
        step_rows(n, step, sign, share, k, x);
    for (i = HALF; clipped && i < BOTH; i++)
        for (e = 0; e < count; e++)
            x[(size_t)i * stride + e] = k->end[e] - x[(size_t)i * stride + e];
    PSC_KEEP_LOOP
    for (i = 0; i < BOTH; i++)
        for (e = 0; e < count; e++)
            x[(size_t)i * stride + e] /= root[i];
    for (i = 0; i < 2; i++)
        row_sums(HALF, powers[i], 1.0, 1.0, count, stride, x + (size_t)(i * HALF) * stride,
                 k->start + (size_t)(i * HALF) * stride);
}

/* The density at the nodes of a rule, of a cone that is level and over the tilt. */
PSC_LANE void density_rows(int n, int clipped, const double *c, const double *s,
                           const double *per_s, const struct psc_series_lot *k,
                           double *restrict even, double *restrict odd)
{
    size_t e;
    int j;

    for (j = 0; j < n; j++)
        for (e = 0; e < k->count; e++) {
            const struct psc_sheaf_f64 f = lot_sheaf(k, e, clipped);
            const size_t at = (size_t)j * k->stride + e;
            struct psc_fibre_f64 o;

            fibre_shape_f64(&f, s[j], c[j], &o);
            even[at] = 0.5 * f.sin_m * o.weight * per_s[j];
            odd[at] = even[at] / o.k;
        }
}

/* From the nodes of a rule. */
PSC_LANE void series_build(int n, int clipped, const double *c, const double *s,
                           const double *per_s, const double *column, const double *power,
                           const struct psc_series_lot *k)
{
    const size_t count = k->count, stride = k->stride;
    size_t e;
    int j;

    density_rows(n, clipped, c, s, per_s, k, k->values[0], k->values[1]);
    even_fit(n, column, power, 0, k);
    even_fit(n, column, power, 1, k);
    for (e = 0; e < count; e++)
        k->number[e] = k->nf[e] * k->sin_m[e];
    scale_rows(n, count, stride, k->nz, k->even);
    scale_rows(n, count, stride, k->number, k->odd);
    for (e = 0; e < count; e++)
        integrate_series(n, stride, k->even + e, k->odd + e, k->even_integral + e,
                         k->odd_integral + e, k->mean + e);
    for (e = 0; e < count; e++) {
        const struct series_view_f64 q = lot_view(k, e);
        struct fibre_arc_f64 end;
        double whole;

        arc_of_f64(k->end[e], &end);
        whole = clipped ? series_integral_f64(n, &q, 1.0, &end) : PSC_PI * k->mean[e];
        if (clipped)
            k->total[e] = whole;
        k->number[e] = 1.0 / whole;
    }
    scale_rows(n, count, stride, k->number, k->even);
    scale_rows(n, count, stride, k->number, k->odd);
    scale_rows(n, count, stride, k->number, k->even_integral);
    scale_rows(n, count, stride, k->number, k->odd_integral);
    for (e = 0; e < count; e++)
        k->mean[e] *= k->number[e];
    for (j = 0; j < n; j++)
        for (e = 0; e < count; e++) {
            const size_t at = (size_t)j * stride + e, next = at + stride;

            k->even_slope[at] = j < n - 1 ? (j + 1) * k->even[next] : 0.0;
            k->odd_slope[at] = j < n - 1 ? (j + 1) * k->odd[next] : 0.0;
        }
    fit_starts(n, clipped, k);
}

/* The same of one sheaf. */
PSC_LANE void series_of_one(int n, const double *c, const double *s, const double *per_s,
                            const double *column, const double *power, struct psc_fibres *f)
{
    struct psc_fibre_series_f64 *const q = &f->series;
    const struct psc_sheaf_f64 sheaf = f->sheaf;
    const int steps = start_steps(n, &sheaf);
    const double enough = steps;
    double values[2][PSC_SERIES_TERMS], waves[2][PSC_SERIES_TERMS];
    double place[2 * PSC_START_TERMS], number, total = f->total;
    const struct psc_series_lot lot = {
        1, 1, &sheaf.sin_m, &sheaf.cos_m, &sheaf.shear, &sheaf.width, &sheaf.nz, &sheaf.nf,
        &sheaf.end, &total, &enough, steps, &q->mean, q->start[0], q->even, q->odd,
        q->even_integral, q->odd_integral, q->even_slope, q->odd_slope, {values[0], values[1]},
        {waves[0], waves[1]}, place, &number};

    series_build(n, sheaf.clipped, c, s, per_s, column, power, &lot);
    f->total = total;
}

#endif
