/* SPDX-License-Identifier: Apache-2.0 */
/* Single triangles in plain double arithmetic, see fan_lanes.h. */
#ifndef PSC_SRC_TRIANGLE_PLAIN_H
#define PSC_SRC_TRIANGLE_PLAIN_H

#include <psc/psc.h>

#include "fan_lanes.h"

/* A triangle as the receiver sees it, in the units of its vertices. */
struct psc_plain_triangle {
    struct psc_fan_pivot pivot;
    struct psc_fan_ray a, c;
    struct psc_fan_sight sight;
    double reach; /* |a| + |b| + |c| */
};

/* Returns whether rounding did no harm: that of a fan's triangle, and the volume is an eighth of
   what it is relative to, so that its error and those of a x b and a x c are below 64 u. */
PSC_LANE int see_plain_triangle(const double position[3], const double va[3], const double vb[3],
                                const double vc[3], struct psc_plain_triangle *o)
{
    double far[3];
    int fit;

    see_pivot(vb, position, &o->pivot);
    subtract3(va, position, o->a.to);
    subtract3(vc, position, o->c.to);
    subtract3(va, vb, o->a.spoke);
    subtract3(vc, vb, o->c.spoke);
    subtract3(vc, va, far);
    measure_ray(&o->pivot, &o->a);
    measure_ray(&o->pivot, &o->c);
    o->reach = (o->a.size + o->pivot.size) + o->c.size;
    fit = see_fan_triangle(&o->pivot, &o->a, &o->c, far, &o->sight);
    return fit & (64.0 * (o->sight.sine * o->sight.sine) > o->sight.limit);
}

PSC_LANE void plain_fan(const struct psc_plain_triangle *o, struct psc_ray_fan_f64 *f)
{
    build_ray_fan(&o->pivot, &o->a, &o->c, &o->sight, f);
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

#endif
