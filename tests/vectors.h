/* SPDX-License-Identifier: Apache-2.0 */
/* Vectors of three, written plainly. */
#ifndef PSC_TESTS_VECTORS_H
#define PSC_TESTS_VECTORS_H

#include "random.h"

static inline void cross(const double a[3], const double b[3], double c[3])
{
    c[0] = a[1] * b[2] - a[2] * b[1];
    c[1] = a[2] * b[0] - a[0] * b[2];
    c[2] = a[0] * b[1] - a[1] * b[0];
}

/* Adds the product a b to the unevaluated sum of two numbers. */
static inline void add_product(double a, double b, double sum[2])
{
    const double p = a * b, error = fma(a, b, -p);
    const double s = sum[0] + p, t = s - sum[0];

    sum[1] += (sum[0] - (s - t)) + (p - t) + error;
    sum[0] = s;
}

/* The cross product, whose length is as right as its direction: the plain one of two edges of a
   needle may have no digit that is. */
static inline void exact_cross(const double a[3], const double b[3], double out[3])
{
    int i;

    for (i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        double sum[2] = {0.0, 0.0};

        add_product(a[j], b[k], sum);
        add_product(-a[k], b[j], sum);
        out[i] = sum[0] + sum[1];
    }
}

static inline double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static inline void scale3(const double v[3], double factor, double out[3])
{
    int i;

    for (i = 0; i < 3; i++)
        out[i] = factor * v[i];
}

static inline void subtract3(const double a[3], const double b[3], double out[3])
{
    int i;

    for (i = 0; i < 3; i++)
        out[i] = a[i] - b[i];
}

/* A unit vector at a right angle to n, which has any length, to rounding. */
static inline void random_across(uint64_t *state, const double n[3], double across[3])
{
    double v[3], length;

    do {
        random_unit(state, v);
        cross(n, v, across);
        length = sqrt(dot(across, across));
    } while (length < 0.1 * sqrt(dot(n, n)));
    scale3(across, 1.0 / length, across);
}

#endif
