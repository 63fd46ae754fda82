/* SPDX-License-Identifier: Apache-2.0 */
/* The series of fibre_series.h, from the density at the nodes of a rule. Needs fit_powers() of
   ellipse_fit_tmpl.h in double. */
#ifndef PSC_SRC_FIBRE_FIT_H
#define PSC_SRC_FIBRE_FIT_H

#include "ellipse_rules.h"
#include "fibre_series.h"

/* Whether the series serves: not slivers, where its sum would lose digits, nor where the horizon
   nearly touches the cone from below or above and the starts are poor. The number of steps. */
static inline int series_serves(const struct psc_sheaf *f, int *steps)
{
    const double low = f->nz * f->cos_m, high = f->nf * f->sin_m;

    *steps = (f->clipped ? f->rest > 0.8 && f->rest < 1.7 : low - high > 0.16 * (low + high)) ? 3
                                                                                             : 4;
    return f->clipped ? f->rest > 0.4 && f->rest < 2.2 : low - high > 0.08 * (low + high);
}

PSC_LANE int fibre_rule(double at)
{
#define FIBRE_RULE(i, m, most) at <= (most) ? (i) :
    return PSC_FIBRE_RULES(FIBRE_RULE) -1;
#undef FIBRE_RULE
}

/* The polynomial in z through four values; the points are apart. */
static inline void through_four(const double z[4], double v[4], double c[4])
{
    double a[4] = {1.0, 0.0, 0.0, 0.0}; /* the product of z - z_j so far */
    int i, j;

    for (i = 1; i < 4; i++)
        for (j = 3; j >= i; j--)
            v[j] = (v[j] - v[j - 1]) / (z[j] - z[j - i]);
    for (i = 0; i < 4; i++)
        c[i] = 0.0;
    for (i = 0; i < 4; i++) {
        for (j = 0; j <= i; j++)
            c[j] += v[i] * a[j];
        for (j = 3; j > 0; j--)
            a[j] = a[j - 1] - z[i] * a[j];
        a[0] *= -z[i];
    }
}

/* Fills the series from the values of the density over sin^2 s at the nodes. */
PSC_LANE void series_fit(int n, const double *wave, const double *power, const double *values,
                         struct psc_fibres *f)
{
    static const double parts[4] = {0.1, 0.25, 0.4, 0.5};
    struct psc_fibre_series *q = &f->series;
    double work[PSC_SERIES_TERMS], z[4], v[4], whole;
    int i, j;

    fit_powers_f64(n, 1, 1, wave, power, values, work, q->density);
    q->integral[n - 1] = 0.0;
    for (j = n - 2; j >= 0; j--)
        q->integral[j] = (q->density[j + 1] +
                          (j < n - 2 ? (j + 2) * q->integral[j + 2] : 0.0)) /
                         (j + 3);
    q->mean = 0.5 * (q->density[0] + q->integral[1]);
    whole = f->sheaf.clipped ? series_share(n, q, 1.0, f->sheaf.end) : PSC_PI * q->mean;
    if (f->sheaf.clipped)
        f->total = whole;
    for (j = 0; j < n; j++) {
        q->density[j] /= whole;
        q->integral[j] /= whole;
    }
    q->mean /= whole;
    for (j = 0; j < 2; j++) {
        for (i = 0; i < 4; i++) {
            const double x = parts[i] * f->sheaf.end, rest = f->sheaf.end - x;
            const int cut = j == 1 && f->sheaf.clipped;
            const double share = cut ? 1.0 - series_share(n, q, 1.0, rest)
                                     : series_share(n, q, j == 0 ? 1.0 : -1.0, x);
            const double root = cut ? SQRT(share) : share_root(share);

            z[i] = cut ? root : root * root;
            v[i] = x / root;
        }
        through_four(z, v, q->start[j]);
    }
    q->middle = series_share(n, q, 1.0, 0.5 * f->sheaf.end);
}

/* The nodes of a rule. */
PSC_LANE void series_build(int n, const double *c, const double *s, const double *wave,
                           const double *power, struct psc_fibres *f)
{
    double values[PSC_SERIES_TERMS];
    int j;

    for (j = 0; j < n; j++) {
        const double sine = 2.0 * c[j] * s[j], cosine = (c[j] - s[j]) * (c[j] + s[j]);
        struct psc_fibre o;

        fibre_shape(&f->sheaf, sine, cosine, &o);
        values[j] = 0.5 * (f->sheaf.nz * o.k + f->sheaf.nf * (f->sheaf.sin_m * cosine)) * o.weight *
                    (f->sheaf.sin_m / (o.k * sine));
    }
    series_fit(n, wave, power, values, f);
}

#endif
