/* SPDX-License-Identifier: Apache-2.0 */
/* Vectors of three, exact products and powers of two, for builds. */
#ifndef PSC_SRC_VECTOR_H
#define PSC_SRC_VECTOR_H

#include "elementary.h"

PSC_LANE int is_finite(double x)
{
    return ABS(x) <= DBL_MAX;
}

PSC_LANE int is_finite3(const double v[3])
{
    return is_finite(v[0]) && is_finite(v[1]) && is_finite(v[2]);
}

/* The power of two that brings x >= 0 into [1,2), or a subnormal one near it: exact to multiply
   with, so that units do not matter. */
PSC_LANE double unit_scale(double x)
{
    uint64_t bits;
    double scale;

    x = MIN(MAX(x, DBL_MIN), 0x1p1022);
    memcpy(&bits, &x, sizeof bits);
    bits = ((uint64_t)2046 << 52) - (bits & ((uint64_t)2047 << 52));
    memcpy(&scale, &bits, sizeof scale);
    return scale;
}

/* 1 / scale for a power of two that unit_scale() gave. */
PSC_LANE double unit_inverse(double scale)
{
    uint64_t bits;

    memcpy(&bits, &scale, sizeof bits);
    bits = ((uint64_t)2046 << 52) - bits;
    memcpy(&scale, &bits, sizeof scale);
    return scale;
}

/* Whether the square of a length leaves room for products of two such squares and for the
   roundings of them: all lights and receivers but those in extreme units. */
PSC_LANE int is_fair(double square)
{
    return square > 0x1p-400 && square < 0x1p400;
}

PSC_LANE double largest(const double v[3])
{
    const double a = ABS(v[0]), b = ABS(v[1]), c = ABS(v[2]);
    const double ab = MAX(a, b);

    return MAX(ab, c);
}

/* v times a power of two, its largest component in [1,2); 0 if v is the zero vector. */
PSC_LANE int scale_to_one(const double v[3], double to[3])
{
    const double size = largest(v), scale = unit_scale(size);
    int i;

    for (i = 0; i < 3; i++)
        to[i] = v[i] * scale;
    return size > 0.0;
}

/* By elements, not in a loop: gcc would make it a vector and a rest, and whoever reads single
   elements soon after has to wait until the vector has left for memory. */
PSC_LANE void copy3(const double from[3], double to[3])
{
    to[0] = from[0];
    to[1] = from[1];
    to[2] = from[2];
}

/* scale v, likewise. */
PSC_LANE void scale3(double scale, const double v[3], double to[3])
{
    to[0] = scale * v[0];
    to[1] = scale * v[1];
    to[2] = scale * v[2];
}

/* a - b, likewise. */
PSC_LANE void subtract3(const double a[3], const double b[3], double to[3])
{
    to[0] = a[0] - b[0];
    to[1] = a[1] - b[1];
    to[2] = a[2] - b[2];
}

PSC_LANE void add3(const double a[3], const double b[3], double to[3])
{
    to[0] = a[0] + b[0];
    to[1] = a[1] + b[1];
    to[2] = a[2] + b[2];
}

PSC_LANE double dot(const double a[3], const double b[3])
{
    return (a[0] * b[0] + a[1] * b[1]) + a[2] * b[2];
}

/* a + b = *sum + *error exactly (Knuth). */
PSC_LANE void two_sum(double a, double b, double *sum, double *error)
{
    const double s = a + b, t = s - a;

    *error = (a - (s - t)) + (b - t);
    *sum = s;
}

/* a b = *product + *error exactly, unless the error underflows, for |a|, |b| < 2^995: by one
   fused operation where the CPU has it (the only place where one is used), otherwise by
   splitting (Dekker). Both give the same bits. */
PSC_LANE void two_product(double a, double b, double *product, double *error)
{
    const double p = a * b;
#if defined(__FMA__) || defined(__ARM_FEATURE_FMA)
    *error = __builtin_fma(a, b, -p);
#else
    const double ca = 134217729.0 * a, ah = ca - (ca - a), al = a - ah;
    const double cb = 134217729.0 * b, bh = cb - (cb - b), bl = b - bh;

    *error = ((ah * bh - p) + ah * bl + al * bh) + al * bl;
#endif
    *product = p;
}

/* Adds the exact product a b to the unevaluated sum *high + *low (Ogita, Rump, Oishi). */
PSC_LANE void add_product(double a, double b, double *high, double *low)
{
    double p, e, f;

    two_product(a, b, &p, &e);
    two_sum(*high, p, high, &f);
    *low += e + f;
}

/* a b - c d to 1.5 ulp. */
PSC_LANE double product_difference(double a, double b, double c, double d)
{
    double p, pe, q, qe;

    two_product(a, b, &p, &pe);
    two_product(c, d, &q, &qe);
    return (p - q) + (pe - qe);
}

PSC_LANE void cross(const double a[3], const double b[3], double to[3])
{
    to[0] = product_difference(a[1], b[2], a[2], b[1]);
    to[1] = product_difference(a[2], b[0], a[0], b[2]);
    to[2] = product_difference(a[0], b[1], a[1], b[0]);
}

/* The same with plain rounding. */
PSC_LANE void cross_rounded(const double a[3], const double b[3], double to[3])
{
    to[0] = a[1] * b[2] - a[2] * b[1];
    to[1] = a[2] * b[0] - a[0] * b[2];
    to[2] = a[0] * b[1] - a[1] * b[0];
}

/* A vector perpendicular to v: the longer of two projections, turned. */
PSC_LANE void any_across(const double v[3], double to[3])
{
    const int first = ABS(v[0]) > ABS(v[1]);

    to[0] = first ? -v[2] : 0.0;
    to[1] = first ? 0.0 : v[2];
    to[2] = first ? v[0] : -v[1];
}

PSC_LANE void perpendicular(const double v[3], double to[3])
{
    double length;
    int i;

    any_across(v, to);
    length = 1.0 / SQRT(dot(to, to));
    for (i = 0; i < 3; i++)
        to[i] *= length;
}

#endif
