/* SPDX-License-Identifier: Apache-2.0 */
/*
 * The integral over s of cones that are not wide, as a polynomial: where tan alpha is at most
 * PSC_SERIES_TANGENT and the horizon leaves more than a sliver.
 *
 * The density is sin^2 s Q(cos s) with Q analytic around [-1, 1], also where the horizon cuts the
 * cone and Q is continued below with its sign. For a polynomial Q the integral from the top is
 *     mean (s - sin s cos s) + sin^3 s R(cos s),   Q = 2 mean + 3 X R - (1 - X^2) R',
 * which keeps all its digits where s is small; from the bottom it is the same with R(-X) negated.
 */
#ifndef PSC_SRC_FIBRE_SERIES_H
#define PSC_SRC_FIBRE_SERIES_H

#include "fibre_density.h"

/* The sum of c[k] x^k for k below n, a multiple of 4, in four chains. */
PSC_LANE double sum_by_fours(int n, const double *c, double x)
{
    const double x2 = x * x, x4 = x2 * x2;
    double a = c[n - 4], b = c[n - 3], d = c[n - 2], e = c[n - 1];
    int k;

    PSC_UNROLL
    for (k = n - 8; k >= 0; k -= 4) {
        a = a * x4 + c[k];
        b = b * x4 + c[k + 1];
        d = d * x4 + c[k + 2];
        e = e * x4 + c[k + 3];
    }
    return (a + b * x) + x2 * (d + e * x);
}

/* Sine, cosine and x - sin x cos x for x in [0, pi]. */
PSC_LANE void arc_of(double x, double *sine, double *cosine, double *segment)
{
    const int far = x > 0.5 * PSC_PI;
    const double near = far ? PSC_PI - x : x;
    double defect, versine, lens;

    sine_cosine_defects_f64(near, &defect, &versine);
    *sine = near - defect;
    *cosine = far ? versine - 1.0 : 1.0 - versine;
    lens = defect + *sine * versine;
    *segment = far ? PSC_PI - lens : lens;
}

/* The integral up to x from the top, or from the bottom (sign -1), of the whole; its derivative. */
PSC_LANE double series_at(int n, const struct psc_fibre_series *q, double sign, double sine,
                          double cosine, double segment, double *slope)
{
    const double y = sign * cosine, square = sine * sine;

    *slope = square * sum_by_fours(n, q->density, y);
    return q->mean * segment + sign * (sine * square) * sum_by_fours(n, q->integral, y);
}

/* A step of Newton's towards the place with the given integral. */
PSC_LANE double series_step(int n, const struct psc_fibre_series *q, double sign, double limit,
                            double target, double x)
{
    double sine, cosine, segment, slope, error, next;

    arc_of(x, &sine, &cosine, &segment);
    error = series_at(n, q, sign, sine, cosine, segment, &slope) - target;
    next = x - error / (slope > 0.0 ? slope : DBL_MIN);
    /* no farther than makes sense from either end, where the slope is 0 */
    next = MAX(next, MAX(0.25 * x, 2.0 * x - limit));
    return MIN(next, limit);
}

/* Rules of nodes, see ellipse_rules.h, by the largest tangent of a semi-arc that each serves. */
#define PSC_FIBRE_RULES(X) \
    X(0, 8, 0.03)          \
    X(1, 12, 0.1)          \
    X(2, 16, 0.22)         \
    X(3, 24, PSC_SERIES_TANGENT)
#define PSC_SERIES_TANGENT 0.55

/* The cube root of a share, to 1e-9. */
PSC_LANE double share_root(double x)
{
    const double y = rough_cbrt(x), y3 = y * y * y;

    return y * (y3 + 2.0 * x) / (2.0 * y3 + x);
}

/* Where to start for the share and the rest of the whole: from the top, or from the bottom of a
   whole cone (the sign is -1). */
PSC_LANE double series_start(const struct psc_sheaf *f, const struct psc_fibre_series *q,
                             double share, double rest, double *sign, double *target)
{
    /* as comparisons of numbers, which become vector code */
    const int lower = share > q->middle, cut = share > (f->clipped ? q->middle : 2.0);
    const int mirrored = share > (f->clipped ? 2.0 : q->middle);
    const double c0 = lower ? q->start[1][0] : q->start[0][0];
    const double c1 = lower ? q->start[1][1] : q->start[0][1];
    const double c2 = lower ? q->start[1][2] : q->start[0][2];
    const double c3 = lower ? q->start[1][3] : q->start[0][3];
    const double cube = share_root(lower ? rest : share);
    const double root = cut ? SQRT(rest) : cube, z = cut ? root : root * root;
    const double x = root * ((c0 + z * c1) + (z * z) * (c2 + z * c3));

    *sign = mirrored ? -1.0 : 1.0;
    *target = mirrored ? rest : share;
    return cut ? f->end - x : x;
}

PSC_LANE double series_share(int n, const struct psc_fibre_series *q, double sign, double x)
{
    double sine, cosine, segment, slope;

    arc_of(x, &sine, &cosine, &segment);
    return series_at(n, q, sign, sine, cosine, segment, &slope);
}

#endif
