/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Triangles by solid angle in plain double arithmetic, which is as good as exact products for all
 * but needles, receivers all but in the plane of the triangle, and triangles as wide as half the
 * sky; with the test for these.
 */
#ifndef PSC_SRC_TRIANGLE_PLAIN_H
#define PSC_SRC_TRIANGLE_PLAIN_H

#include <psc/psc.h>

#include "fan.h"

/* A triangle as the receiver sees it, in the units of its vertices. */
struct psc_plain_triangle {
    double a[3], b[3], c[3], edge_c[3];
    double a2, b2, c2;
    double size_a, size_b, size_c, sizes;   /* |a|, |b|, |c|, and |a| |b| |c| */
    double ab[3], size_ab;                  /* a x b */
    double dot_ab, dot_bc;
    double normal[3], volume;               /* (c - b) x (a - b), and b times that */
    double across;                          /* (a x b) . (a x c) */
    double half, rest;                      /* half the solid angle, and what it lacks of pi */
};

/*
 * Returns whether rounding did no harm. u being a rounding error,
 *  - the volume is off by less than 8 u |b| |edge_a| |edge_c|, and a x b and a x c by less than
 *    4 u of the lengths' products: relative to themselves less than 64 u where the volume is an
 *    eighth of that, or of |a| |edge_a| |edge_ac|;
 *  - the cosine D of the solid angle [OS83], 1 + cos ab + cos ac + cos bc, by less than 6 u; with N
 *    the sine, N^2 + D^2 = 2 (1 + cos ab) (1 + cos ac) (1 + cos bc), so that where that is 1/8 no
 *    side is near half a turn, and the angle of (D, N) is off by less than 17 u;
 *  - squares leave room for the product of three of them.
 */
PSC_LANE int see_plain_triangle(const double position[3], const double *vertices,
                                struct psc_plain_triangle *o)
{
    double edge_a[3], edge_ac[3], ac[3], e2, f2, g2, dot_ac, cosine, sine, reach, reach_a, least;

    subtract3(vertices, position, o->a);
    subtract3(vertices + 3, position, o->b);
    subtract3(vertices + 6, position, o->c);
    subtract3(vertices, vertices + 3, edge_a);
    subtract3(vertices + 6, vertices + 3, o->edge_c);
    subtract3(vertices + 6, vertices, edge_ac);
    o->a2 = dot(o->a, o->a);
    o->b2 = dot(o->b, o->b);
    o->c2 = dot(o->c, o->c);
    o->size_a = SQRT(o->a2);
    o->size_b = SQRT(o->b2);
    o->size_c = SQRT(o->c2);
    o->sizes = (o->size_a * o->size_b) * o->size_c;
    o->dot_ab = dot(o->a, o->b);
    o->dot_bc = dot(o->b, o->c);
    dot_ac = dot(o->a, o->c);

    cross_rounded(o->edge_c, edge_a, o->normal);
    o->volume = dot(o->b, o->normal);
    sine = ABS(o->volume);
    cosine = (o->sizes + o->dot_ab * o->size_c) + (dot_ac * o->size_b + o->dot_bc * o->size_a);
    o->half = arc_and_rest(cosine, sine, &o->rest);

    cross_rounded(edge_a, o->b, o->ab);
    cross_rounded(o->a, edge_ac, ac);
    o->size_ab = SQRT(dot(o->ab, o->ab));
    o->across = dot(o->ab, ac);

    e2 = dot(edge_a, edge_a);
    f2 = dot(o->edge_c, o->edge_c);
    g2 = dot(edge_ac, edge_ac);
    reach = o->b2 * f2;
    reach_a = o->a2 * g2;
    reach = e2 * MAX(reach, reach_a);
    least = MIN(e2, f2);
    least = MIN(least, g2);
    least = MIN(least, o->a2);
    least = MIN(least, o->b2);
    least = MIN(least, o->c2);
    return 64.0 * (o->volume * o->volume) > reach &&
           8.0 * (cosine * cosine + sine * sine) > o->sizes * o->sizes && least > 0x1p-320 &&
           (o->a2 + o->b2) + o->c2 < 0x1p320;
}

/* Whether the square of a normal's length leaves room for that of a product with it. */
PSC_LANE int is_plain_normal(double square)
{
    return square > 0x1p-320 && square < 0x1p320;
}

/* Where a triangle lies to the plane of a receiver: a psc_case, or -1 where rounding would decide,
   both as numbers that loops over doubles may choose from.
   size: at least the product of the lengths of the normal and of any of the vertices. */
PSC_LANE double see_plain_horizon(const double a[3], const double b[3], const double c[3],
                               const double normal[3], double size)
{
    const double at_a = dot(normal, a), at_b = dot(normal, b), at_c = dot(normal, c);
    const double slack = 0x1p-49 * size;
    const double low_ab = MIN(at_a, at_b), low = MIN(low_ab, at_c);
    const double high_ab = MAX(at_a, at_b), high = MAX(high_ab, at_c);
    const double near_ab = MIN(ABS(at_a), ABS(at_b)), near = MIN(near_ab, ABS(at_c));

    return low > slack     ? (double)PSC_CASE_ABOVE
           : high < -slack ? (double)PSC_CASE_EMPTY
           : near > slack  ? (double)PSC_CASE_CLIPPED
                           : -1.0;
}

/* The constants of the map in units of |b|: as only ratios count, sin alpha and half the sine of
   side c are 1. Divisions are slow, so that some share one. */
PSC_LANE void plain_fan(const struct psc_plain_triangle *o, struct psc_fan_f64 *f)
{
    const double more = o->size_a * o->size_b + ABS(o->dot_ab);
    const double per_sizes = 1.0 / o->sizes, per_more = 1.0 / (o->size_ab * more);
    const double per_volume = 1.0 / (o->size_a * ABS(o->volume));
    const double tangent = o->size_ab * (o->size_ab * per_more);
    const double per_ab = more * per_more, cotangent = more * per_ab;
    const double per_b = per_sizes * (o->size_a * o->size_c);
    const double by_a = per_sizes * o->size_a, by_c = per_sizes * o->size_c;
    const double side = COPYSIGN(per_ab, o->volume);
    double across[3];

    f->half = o->half;
    f->rest = o->rest;
    f->sin_a = 1.0;
    f->cos_a = o->across * per_volume;
    f->sin_rest = 0.0;
    f->near = o->dot_ab >= 0.0 ? tangent : cotangent;
    f->far = o->dot_ab >= 0.0 ? cotangent : tangent;
    f->gap = 1.0;
    scale3(per_b, o->b, f->b);
    scale3(per_ab, o->ab, across);
    scale3(side, o->ab, f->toward_c);
    cross_rounded(f->b, across, f->toward_a);
    f->share_a = (o->size_a * o->size_b) * per_ab;
    f->share_c = (o->size_ab * o->size_c) * (o->size_a * per_volume);
    f->slant = dot(o->edge_c, f->toward_a) * (per_sizes * (o->size_a * o->size_b));
    f->cos_ab = o->dot_ab * by_c;
    f->cos_bc = o->dot_bc * by_a;
    f->per_a = o->b2 * by_c;
    f->per_b = 1.0;
    f->per_c = o->b2 * by_a;
}

#endif
