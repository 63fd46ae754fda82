/* SPDX-License-Identifier: Apache-2.0 */
/* The elementary functions in double, with those that only builds and inverses need. */
#ifndef PSC_SRC_ELEMENTARY_H
#define PSC_SRC_ELEMENTARY_H

#include <stdint.h>
#include <string.h>

#define PSC_BITS 64
#include "precision.h"
#include "elementary_tmpl.h"

#define PSC_PI 3.14159265358979323846

/* (t - atan t) / t^3 of z = t^2, |t| <= 1: 1.6e-16 relative. */
PSC_LANE double atan_polynomial(double z)
{
    static const double c[] = {PSC_ATAN_F64};
    const double z2 = z * z, z4 = z2 * z2, z8 = z4 * z4;

    return (ESTRIN4(c, 0, z, z2) + z4 * ESTRIN4(c, 4, z, z2)) +
           z8 * ((ESTRIN4(c, 8, z, z2) + z4 * ESTRIN4(c, 12, z, z2)) +
                 z8 * (ESTRIN4(c, 16, z, z2) + z4 * c[20]));
}

/* 2 atan t for t in [0,1]. */
PSC_LANE double twice_atan(double t)
{
    const double z = t * t;

    return 2.0 * t * (1.0 - z * atan_polynomial(z));
}

/* The angle in [0, pi] of the vector (c, s), s >= 0, of any length but 0, and what it lacks of
   pi, both accurate relative to themselves. */
PSC_LANE double angle_and_rest(double c, double s, double *rest)
{
    const double m = SQRT(s * s + c * c) + ABS(c);
    const double small = twice_atan(s / (m > 0.0 ? m : 1.0)), large = PSC_PI - small;

    *rest = c >= 0.0 ? large : small;
    return c >= 0.0 ? small : large;
}

PSC_LANE double angle_of(double c, double s)
{
    double rest;

    return angle_and_rest(c, s, &rest);
}

/*
 * The same for a shorter way: the vector is not measured but turned by a multiple of pi/4, so that
 * the tangent of what is left is at most tan(pi/8).
 */
PSC_LANE double arc_and_rest(double c, double s, double *rest)
{
    static const double p[] = {PSC_ATAN_NEAR_F64};
    const double wide = 0.41421356237309503, m = ABS(c);
    const int low = s <= wide * m, high = m <= wide * s;
    const double across = low ? s : high ? -m : s - m;
    const double along = low ? m : high ? s : s + m;
    const double turn = low ? 0.0 : high ? 0.5 * PSC_PI : 0.25 * PSC_PI;
    const double t = across / along, z = t * t, z2 = z * z, z4 = z2 * z2;
    const double defect = (ESTRIN4(p, 0, z, z2) + z4 * ESTRIN4(p, 4, z, z2)) +
                          (z4 * z4) * ((p[8] + z * p[9]) + z2 * p[10]);
    const double small = turn + (t - t * (z * defect)), large = PSC_PI - small;

    *rest = c >= 0.0 ? large : small;
    return c >= 0.0 ? small : large;
}

/* The cube root of r in [0, 1e300] to 2.1e-5 relative, for starting values; the root of 1e-200
   for anything smaller. One third of the exponent, then a Halley step. */
PSC_LANE double rough_cbrt(double r)
{
    uint64_t bits;
    double y, y3;

    r = MAX(r, 1e-200);
    memcpy(&bits, &r, sizeof bits);
    bits = ((((bits >> 32) * 0x55555556u) >> 32) + 0x2A9F7893u) << 32;
    memcpy(&y, &bits, sizeof y);
    y3 = y * y * y;
    return y * (y3 + 2.0 * r) / (2.0 * y3 + r);
}

/* Turns (sine, cosine defect) of an angle by a small dx, |dx| <= 0.01: 1e-17. */
PSC_LANE void turn_by(double dx, double *sine, double *cosine_defect)
{
    const double d2 = dx * dx;
    const double odd = dx * (1.0 - d2 * (1.0 / 6.0 - d2 * (1.0 / 120.0)));
    const double even = d2 * (0.5 - d2 * (1.0 / 24.0 - d2 * (1.0 / 720.0)));
    const double s = *sine, c = 1.0 - *cosine_defect;

    *cosine_defect += s * odd + c * even;
    *sine = s + c * odd - s * even;
}

/*
 * The step from x to the root of f(x) = 0, given f and its derivatives d, d1, d2, d3 there: the
 * inverse series to fourth order, error O(step^5). Clamped to +-limit, also when NaN.
 */
PSC_LANE double quintic_step(double f, double d, double d1, double d2, double d3, double limit)
{
    const double inverse = 1.0 / d;
    const double a2 = 0.5 * d1 * inverse, a3 = (1.0 / 6.0) * d2 * inverse;
    const double a4 = (1.0 / 24.0) * d3 * inverse;
    double h = -f * inverse;

    h = MIN(MAX(h, -limit), limit);
    h = h * (1.0 + h * (-a2 + h * ((2.0 * a2 * a2 - a3) +
                                   h * (5.0 * a2 * (a3 - a2 * a2) - a4))));
    return MIN(MAX(h, -limit), limit);
}

#endif
