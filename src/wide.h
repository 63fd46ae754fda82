/* SPDX-License-Identifier: Apache-2.0 */
/* Unevaluated sums of two doubles, for differences of large products: about 100 bits. */
#ifndef PSC_SRC_WIDE_H
#define PSC_SRC_WIDE_H

#include "vector.h"

struct psc_wide {
    double high, low;
};

PSC_LANE struct psc_wide wide_sum(struct psc_wide a, struct psc_wide b)
{
    struct psc_wide r;
    double e;

    two_sum(a.high, b.high, &r.high, &e);
    two_sum(r.high, e + (a.low + b.low), &r.high, &r.low);
    return r;
}

PSC_LANE struct psc_wide wide_product(struct psc_wide a, struct psc_wide b)
{
    struct psc_wide r;
    double e;

    two_product(a.high, b.high, &r.high, &e);
    two_sum(r.high, e + (a.high * b.low + a.low * b.high), &r.high, &r.low);
    return r;
}

PSC_LANE struct psc_wide wide_negative(struct psc_wide a)
{
    const struct psc_wide r = {-a.high, -a.low};

    return r;
}

PSC_LANE struct psc_wide wide_square(struct psc_wide a)
{
    return wide_product(a, a);
}

PSC_LANE struct psc_wide wide_of(double a)
{
    const struct psc_wide r = {a, 0.0};

    return r;
}

/* a b - c d */
PSC_LANE struct psc_wide wide_difference(struct psc_wide a, struct psc_wide b, struct psc_wide c,
                                         struct psc_wide d)
{
    return wide_sum(wide_product(a, b), wide_negative(wide_product(c, d)));
}

PSC_LANE void wide_cross(const struct psc_wide a[3], const struct psc_wide b[3],
                         struct psc_wide to[3])
{
    to[0] = wide_difference(a[1], b[2], a[2], b[1]);
    to[1] = wide_difference(a[2], b[0], a[0], b[2]);
    to[2] = wide_difference(a[0], b[1], a[1], b[0]);
}

PSC_LANE struct psc_wide wide_dot(const struct psc_wide a[3], const struct psc_wide b[3])
{
    return wide_sum(wide_sum(wide_product(a[0], b[0]), wide_product(a[1], b[1])),
                    wide_product(a[2], b[2]));
}

PSC_LANE void wide_vector(const double v[3], struct psc_wide to[3])
{
    int i;

    for (i = 0; i < 3; i++)
        to[i] = wide_of(v[i]);
}

/* Products and sums of plain numbers and numbers in two words. */
PSC_LANE struct psc_wide exact_product(double a, double b)
{
    struct psc_wide r;

    two_product(a, b, &r.high, &r.low);
    return r;
}

PSC_LANE struct psc_wide scaled(double a, struct psc_wide b)
{
    struct psc_wide r;
    double e;

    two_product(a, b.high, &r.high, &e);
    two_sum(r.high, e + a * b.low, &r.high, &r.low);
    return r;
}

PSC_LANE struct psc_wide scaled_dot(const double a[3], const struct psc_wide b[3])
{
    return wide_sum(wide_sum(scaled(a[0], b[0]), scaled(a[1], b[1])), scaled(a[2], b[2]));
}

PSC_LANE struct psc_wide scaled_difference(double a, struct psc_wide b, double c, struct psc_wide d)
{
    return wide_sum(scaled(a, b), wide_negative(scaled(c, d)));
}

/* a x b, in two words. */
PSC_LANE void exact_cross(const double a[3], const double b[3], struct psc_wide to[3])
{
    to[0] = wide_sum(exact_product(a[1], b[2]), wide_negative(exact_product(a[2], b[1])));
    to[1] = wide_sum(exact_product(a[2], b[0]), wide_negative(exact_product(a[0], b[2])));
    to[2] = wide_sum(exact_product(a[0], b[1]), wide_negative(exact_product(a[1], b[0])));
}

/* a x b */
PSC_LANE void scaled_cross(const double a[3], const struct psc_wide b[3], struct psc_wide to[3])
{
    to[0] = scaled_difference(a[1], b[2], a[2], b[1]);
    to[1] = scaled_difference(a[2], b[0], a[0], b[2]);
    to[2] = scaled_difference(a[0], b[1], a[1], b[0]);
}

/* Times a power of two. */
PSC_LANE struct psc_wide wide_times(double scale, struct psc_wide a)
{
    const struct psc_wide r = {scale * a.high, scale * a.low};

    return r;
}

#endif
