/* SPDX-License-Identifier: Apache-2.0 */
/* The series of fibre_series_tmpl.h, from the density at the nodes of a rule. */
#ifndef PSC_SRC_FIBRE_FIT_H
#define PSC_SRC_FIBRE_FIT_H

#include "ellipse_rules.h"
#include "fibre_series.h"

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

/* The sums of values[j] rows[j n + k] over j: a loop over k that becomes vector code. */
PSC_LANE void row_sums(int n, const double *restrict rows, const double *restrict values,
                       double *restrict to)
{
    int j, k;

    PSC_KEEP_LOOP
    for (k = 0; k < n; k++) {
        double sum = 0.0;

        PSC_UNROLL
        for (j = 0; j < n; j++)
            sum += values[j] * rows[j * n + k];
        to[k] = sum;
    }
}

/* The polynomial in cos 2s through the values at the nodes: Chebyshev's first. */
PSC_LANE void even_fit(int n, const double *column, const double *power, const double *values,
                       double *to)
{
    double waves[PSC_SERIES_TERMS];
    int k;

    row_sums(n, column, values, waves);
    waves[0] *= 0.5;
    PSC_KEEP_LOOP
    for (k = 0; k < n; k++)
        waves[k] *= 2.0 / n;
    row_sums(n, power, waves, to);
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

/* The starts through places of fixed shares: those of a small cone, and a step, or two where the
   cone is wide. */
PSC_LANE void fit_starts(int n, int steps, const struct psc_sheaf_f64 *f,
                         struct psc_fibre_series_f64 *q)
{
    enum { HALF = PSC_START_TERMS, BOTH = 2 * HALF };
    const double *const model = psc_start_model + f->clipped * PSC_MODEL_TERMS * BOTH;
    const double *const powers = psc_start_powers + f->clipped * HALF * HALF;
    const double t = model_variable(f, f->clipped), unit = f->clipped ? f->end : 1.0;
    const struct series_view_f64 view = view_of_f64(q);
    double x[BOTH], share[BOTH], root[BOTH], sign[BOTH];
    int i, k, step;

    for (i = 0; i < BOTH; i++) {
        share[i] = psc_start_share[i < HALF || f->clipped ? i : i - HALF];
        root[i] = psc_start_root[i < HALF || f->clipped ? i : i - HALF];
        sign[i] = i < HALF || f->clipped ? 1.0 : -1.0;
        x[i] = 0.0;
    }
    for (k = PSC_MODEL_TERMS - 1; k >= 0; k--) {
        PSC_KEEP_LOOP
        for (i = 0; i < BOTH; i++)
            x[i] = x[i] * t + model[k * BOTH + i];
    }
    for (i = 0; i < BOTH; i++)
        x[i] *= root[i] * unit;
    for (i = HALF; i < BOTH; i++) {
        x[i] = f->clipped ? f->end - x[i] : x[i];
        share[i] = f->clipped ? 1.0 - share[i] : share[i];
    }
    for (step = 0; step < steps; step++) {
        PSC_KEEP_LOOP
        for (i = 0; i < BOTH; i++) {
            struct fibre_arc_f64 at;

            arc_of_f64(x[i], &at);
            x[i] += series_step_f64(n, &view, sign[i], f->end, share[i], &at);
        }
    }
    for (i = HALF; i < BOTH; i++)
        x[i] = f->clipped ? f->end - x[i] : x[i];
    for (i = 0; i < BOTH; i++)
        x[i] /= root[i];
    row_sums(HALF, psc_start_powers, x, q->start[0]);
    row_sums(HALF, powers, x + HALF, q->start[1]);
}

/* From the nodes of a rule. */
PSC_LANE void series_build(int n, const double *c, const double *s, const double *per_s,
                           const double *column, const double *power, struct psc_fibres *f)
{
    struct psc_fibre_series_f64 *q = &f->series;
    const struct series_view_f64 view = view_of_f64(q);
    double even[PSC_SERIES_TERMS], odd[PSC_SERIES_TERMS], whole;
    struct fibre_arc_f64 end;
    int j;

    for (j = 0; j < n; j++) {
        struct psc_fibre_f64 o;

        fibre_shape_f64(&f->sheaf, s[j], c[j], &o);
        even[j] = 0.5 * f->sheaf.sin_m * o.weight * per_s[j];
        odd[j] = even[j] / o.k;
    }
    even_fit(n, column, power, even, q->even);
    even_fit(n, column, power, odd, q->odd);
    PSC_KEEP_LOOP
    for (j = 0; j < n; j++) {
        q->even[j] *= f->sheaf.nz;
        q->odd[j] *= f->sheaf.nf * f->sheaf.sin_m;
    }
    integrate_series(n, 1, q->even, q->odd, q->even_integral, q->odd_integral, &q->mean);
    arc_of_f64(f->sheaf.end, &end);
    whole = f->sheaf.clipped ? series_integral_f64(n, &view, 1.0, &end) : PSC_PI * q->mean;
    if (f->sheaf.clipped)
        f->total = whole;
    whole = 1.0 / whole;
    PSC_KEEP_LOOP
    for (j = 0; j < n; j++) {
        q->even[j] *= whole;
        q->odd[j] *= whole;
        q->even_integral[j] *= whole;
        q->odd_integral[j] *= whole;
    }
    q->mean *= whole;
    for (j = 0; j < n; j++) {
        q->even_slope[j] = j < n - 1 ? (j + 1) * q->even[j + 1] : 0.0;
        q->odd_slope[j] = j < n - 1 ? (j + 1) * q->odd[j + 1] : 0.0;
    }
    fit_starts(n, start_steps(n, &f->sheaf), &f->sheaf, q);
}

#endif
