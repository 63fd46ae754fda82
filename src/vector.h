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

/* The power of two that brings x > 0 into [1,2), or a subnormal one near it: exact to multiply
   with, so that units do not matter. */
PSC_LANE double unit_scale(double x)
{
    uint64_t bits;
    double scale;

    memcpy(&bits, &x, sizeof bits);
    bits >>= 52;
    bits = 2046 - MIN(MAX(bits, 1), 2045);
    bits <<= 52;
    memcpy(&scale, &bits, sizeof scale);
    return scale;
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

/* a b = *product + *error exactly (Dekker), for |a|, |b| < 2^995 whose product is normal. */
PSC_LANE void two_product(double a, double b, double *product, double *error)
{
    const double p = a * b;
    const double ca = 134217729.0 * a, ah = ca - (ca - a), al = a - ah;
    const double cb = 134217729.0 * b, bh = cb - (cb - b), bl = b - bh;

    *error = ((ah * bh - p) + ah * bl + al * bh) + al * bl;
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

/* (a + a_low) / sqrt(b + b_low) as *high + *low, given root = sqrt(b) as rounded. */
PSC_LANE void divide_by_root(double a, double a_low, double b, double b_low, double root,
                             double *high, double *low)
{
    const double q = (a + a_low) / root;
    double p, e, root_low;

    two_product(root, root, &p, &e);
    root_low = ((b - p) - e + b_low) / (2.0 * root);
    two_product(q, root, &p, &e);
    *low = ((a - p) - e + a_low - q * root_low) / root;
    *high = q;
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

/* Any unit vector perpendicular to the unit vector v: the longer of two projections. */
PSC_LANE void perpendicular(const double v[3], double to[3])
{
    const int first = ABS(v[0]) > ABS(v[1]);
    const double a = first ? v[0] : v[1];
    const double inverse = 1.0 / SQRT(a * a + v[2] * v[2]);

    to[0] = first ? -v[2] * inverse : 0.0;
    to[1] = first ? 0.0 : v[2] * inverse;
    to[2] = first ? v[0] * inverse : -v[1] * inverse;
}

#endif
