/* SPDX-License-Identifier: Apache-2.0 */
/* Many sheaves and their series next to each other, or one. */
#ifndef PSC_SRC_FIBRE_LOT_H
#define PSC_SRC_FIBRE_LOT_H

#include "fibre_series.h"

/* Sheaves of one kind and their series, one or many next to each other: each row of coefficients,
   nodes and places is `stride` long, and `count` of it are in use. Of a loop over rows and one over
   elements the longer becomes vector code; each element has the same bits in either. */
struct psc_series_lot {
    size_t count, stride;
    const double *sin_m, *cos_m, *shear, *width, *nz, *nf, *end; /* see PSC_SHEAF */
    double *total;             /* given for whole cones */
    const double *start_steps; /* of each, and the most */
    int most_start_steps;
    double *mean, *start, *even, *odd, *even_integral, *odd_integral, *even_slope, *odd_slope;
    double *values[2], *waves[2], *place, *number; /* to work in: places are 2 PSC_START_TERMS */
};

/* What the loops read of a sheaf. */
PSC_LANE struct psc_sheaf_f64 lot_sheaf(const struct psc_series_lot *k, size_t e, int clipped)
{
    struct psc_sheaf_f64 f;

    f.sin_m = k->sin_m[e];
    f.cos_m = k->cos_m[e];
    f.shear = k->shear[e];
    f.width = k->width[e];
    f.nz = k->nz[e];
    f.nf = k->nf[e];
    f.end = k->end[e];
    f.clipped = clipped;
    return f;
}

PSC_LANE struct series_view_f64 lot_view(const struct psc_series_lot *k, size_t e)
{
    const struct series_view_f64 view = {
        k->stride,           k->mean + e,       k->start + e,
        k->even + e,         k->odd + e,        k->even_integral + e,
        k->odd_integral + e, k->even_slope + e, k->odd_slope + e};

    return view;
}

/* The sums of values[j] rows[j n + i] over j, times the first factor for i = 0 and the other for
   the rest. */
PSC_LANE void row_sums(int n, const double *rows, double first, double other, size_t count,
                       size_t stride, const double *restrict values, double *restrict to)
{
    size_t e;
    int i, j;

    PSC_KEEP_LOOP
    for (i = 0; i < n; i++)
        for (e = 0; e < count; e++) {
            double sum = 0.0;

            PSC_UNROLL
            for (j = 0; j < n; j++)
                sum += values[(size_t)j * stride + e] * rows[j * n + i];
            to[(size_t)i * stride + e] = sum * (i > 0 ? other : first);
        }
}

/* Each row times the same numbers. */
PSC_LANE void scale_rows(int n, size_t count, size_t stride, const double *by, double *restrict to)
{
    size_t e;
    int i;

    PSC_KEEP_LOOP
    for (i = 0; i < n; i++)
        for (e = 0; e < count; e++)
            to[(size_t)i * stride + e] *= by[e];
}

#endif
