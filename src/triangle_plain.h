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
    double size_a, size_b, size_c, reach; /* |a|, |b|, |c|, and their sum */
    double b2;
    double ab[3], size_ab;                /* a x b */
    double dot_ab, dot_bc;
    double normal[3], volume;             /* edge_c x (a - b), and b times that */
    double across;                        /* (a x b) . (a x c) */
    double sine, cosine;                  /* N and D of the solid angle, times |a| |b| |c| */
};

/*
 * Returns whether rounding did no harm. u being a rounding error,
 *  - a x b and a x c are off by less than 4 u of the lengths' products, and the volume, which is
 *    edge_c times the first, by less than 8 u |b| |edge_a| |edge_c|: relative to themselves less than 64 u where the volume is an
 *    eighth of that, or of |a| |edge_a| |edge_ac|;
 *  - the cosine D of the solid angle [OS83], 1 + cos ab + cos ac + cos bc, by less than 6 u; with N
 *    the sine, N^2 + D^2 = 2 (1 + cos ab) (1 + cos ac) (1 + cos bc), so that where that is 1/8 no
 *    side is near half a turn, and the angle of (D, N) is off by less than 17 u;
 *  - every length is the volume divided by two others, none above the sum of |a|, |b| and |c|: so
 *    that the last line keeps all products, and in float the quotients, clear of the range's ends.
 */
PSC_LANE int see_plain_triangle(const double position[3], const double va[3], const double vb[3],
                                const double vc[3], struct psc_plain_triangle *o)
{
    double edge_a[3], edge_ac[3], ac[3], a2, e2, f2, g2, dot_ac, sizes, limit, limit_a;

    subtract3(va, position, o->a);
    subtract3(vb, position, o->b);
    subtract3(vc, position, o->c);
    subtract3(va, vb, edge_a);
    subtract3(vc, vb, o->edge_c);
    subtract3(vc, va, edge_ac);
    a2 = dot(o->a, o->a);
    o->b2 = dot(o->b, o->b);
    o->size_a = SQRT(a2);
    o->size_b = SQRT(o->b2);
    o->size_c = SQRT(dot(o->c, o->c));
    o->reach = (o->size_a + o->size_b) + o->size_c;
    sizes = (o->size_a * o->size_b) * o->size_c;
    o->dot_ab = dot(o->a, o->b);
    o->dot_bc = dot(o->b, o->c);
    dot_ac = dot(o->a, o->c);

    cross_rounded(o->edge_c, edge_a, o->normal);
    cross_rounded(edge_a, o->b, o->ab);
    cross_rounded(o->a, edge_ac, ac);
    o->volume = dot(o->edge_c, o->ab);
    o->sine = ABS(o->volume);
    o->cosine = (sizes + o->dot_ab * o->size_c) + (dot_ac * o->size_b + o->dot_bc * o->size_a);
    o->size_ab = SQRT(dot(o->ab, o->ab));
    o->across = dot(o->ab, ac);

    e2 = dot(edge_a, edge_a);
    f2 = dot(o->edge_c, o->edge_c);
    g2 = dot(edge_ac, edge_ac);
    limit = o->b2 * f2;
    limit_a = a2 * g2;
    limit = e2 * MAX(limit, limit_a);
    return 64.0 * (o->sine * o->sine) > limit &&
           8.0 * (o->cosine * o->cosine + o->sine * o->sine) > sizes * sizes &&
           o->sine > 0x1p-100 * ((o->reach * o->reach) * o->reach) && o->reach > 0x1p-120 &&
           o->reach < 0x1p120;
}

/* What its area map takes. */
struct psc_plain_flat {
    struct psc_flat flat;     /* but for up; in the units of the vertices */
    double normal[3], volume; /* as above */
    double square;            /* |b|^2 + |edge_a|^2 + |edge_c|^2 */
};

/* Returns whether rounding did no harm to the volume, for the same reasons. */
PSC_LANE int see_plain_flat(const double position[3], const double va[3], const double vb[3],
                            const double vc[3], struct psc_plain_flat *o)
{
    const double *const b = o->flat.b.high, *const edge_a = o->flat.edge_a.high;
    const double *const edge_c = o->flat.edge_c.high;
    double ab[3], b2, e2, f2, volume2;
    int i;

    for (i = 0; i < 3; i++) {
        two_sum(vb[i], -position[i], o->flat.b.high + i, o->flat.b.low + i);
        two_sum(va[i], -vb[i], o->flat.edge_a.high + i, o->flat.edge_a.low + i);
        two_sum(vc[i], -vb[i], o->flat.edge_c.high + i, o->flat.edge_c.low + i);
    }
    cross_rounded(edge_c, edge_a, o->normal);
    cross_rounded(edge_a, b, ab);
    o->volume = dot(edge_c, ab);
    volume2 = o->volume * o->volume;
    b2 = dot(b, b);
    e2 = dot(edge_a, edge_a);
    f2 = dot(edge_c, edge_c);
    o->square = (b2 + e2) + f2;
    return 64.0 * volume2 > e2 * (b2 * f2) &&
           volume2 > 0x1p-200 * ((o->square * o->square) * o->square) && o->square > 0x1p-240 &&
           o->square < 0x1p240;
}

/* Half the solid angle. */
PSC_LANE double plain_half(double cosine, double sine)
{
    double rest;

    return arc_and_rest(cosine, sine, &rest);
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

/* The constants of the map, but for half, in units of |b|. */
PSC_LANE void plain_fan(const struct psc_plain_triangle *o, struct psc_plain_fan_f64 *f)
{
    const double more = o->size_a * o->size_b + ABS(o->dot_ab);
    const double per_more = 1.0 / (o->size_ab * more), per_volume = 1.0 / (o->size_a * o->sine);
    const double tangent = o->size_ab * (o->size_ab * per_more);
    const double per_ab = more * per_more, cotangent = more * per_ab;
    const double per_b = 1.0 / o->size_b, per_b2 = per_b * per_b;
    double across[3];

    f->cos_a = o->across * per_volume;
    f->near = o->dot_ab >= 0.0 ? tangent : cotangent;
    f->far = o->dot_ab >= 0.0 ? cotangent : tangent;
    scale3(per_b, o->b, f->b);
    scale3(per_ab, o->ab, across);
    scale3(COPYSIGN(1.0, o->volume), across, f->toward_c);
    cross_rounded(f->b, across, f->toward_a);
    f->per_along = o->b2 * per_ab;
    f->per_above = (o->size_ab * o->size_b) * (o->size_a * per_volume);
    f->slant = dot(o->edge_c, f->toward_a) * per_b;
    f->less_a = 1.0 - o->dot_ab * per_b2;
    f->less_c = 1.0 - o->dot_bc * per_b2;
}

/* The same constants as other triangles have them. */
static inline void fan_of_plain(const struct psc_plain_fan_f64 *from, struct psc_fan_f64 *f)
{
    const double a_b = 1.0 - from->less_a, a_a = 1.0 / from->per_along;
    const double c_b = 1.0 - from->less_c, c_c = 1.0 / from->per_above;
    const double size_a = SQRT(a_b * a_b + a_a * a_a);
    const double size_c = SQRT((c_b * c_b + from->slant * from->slant) + c_c * c_c);

    f->half = from->half;
    f->rest = PSC_PI - from->half;
    f->sin_a = f->gap = f->per_b = 1.0;
    f->cos_a = from->cos_a;
    f->sin_rest = 0.0;
    f->near = from->near;
    f->far = from->far;
    copy3(from->b, f->b);
    copy3(from->toward_a, f->toward_a);
    copy3(from->toward_c, f->toward_c);
    f->share_a = size_a * from->per_along;
    f->share_c = size_c * from->per_above;
    f->per_a = 1.0 / size_a;
    f->per_c = 1.0 / size_c;
    f->slant = from->slant * f->per_c;
    f->cos_ab = a_b * f->per_a;
    f->cos_bc = c_b * f->per_c;
}

#endif
