/* SPDX-License-Identifier: Apache-2.0 */
/* Directions seen from the frame of a triangle of a fan: whether it holds them, and the inverse of
   Arvo's map. */
#ifndef PSC_SRC_FAN_INVERSE_H
#define PSC_SRC_FAN_INVERSE_H

#include "fan.h"

/* A direction in the frame at B, of length 1 there. b is taken off first: what is left of a light
   smaller than the rounding of b is that of the direction alone. */
PSC_LANE void fan_look(const struct psc_fan_f64 *f, const double direction[3],
                       struct psc_spot_f64 *p)
{
    double off[3], inverse;
    int i;

    for (i = 0; i < 3; i++)
        off[i] = direction[i] - f->b[i];
    p->b = dot(direction, f->b);
    p->a = dot(off, f->toward_a);
    p->c = dot(off, f->toward_c);
    inverse = 1.0 / SQRT((p->a * p->a + p->c * p->c) + p->b * p->b);
    p->b *= inverse;
    p->a *= inverse;
    p->c *= inverse;
}

/* The vertex C, and the unit normals of the planes of B and C and of C and A, inwards. */
struct psc_fan_edges {
    struct psc_spot_f64 a, c, bc, ca;
};

PSC_LANE void fan_edges(const struct psc_fan_f64 *f, struct psc_fan_edges *e)
{
    const double sine = 1.0 / f->share_a, rise = 1.0 / f->share_c;
    double inverse = 1.0 / SQRT(rise * rise + f->slant * f->slant);

    e->a.b = f->cos_ab;
    e->a.a = sine;
    e->a.c = 0.0;
    e->c.b = f->cos_bc;
    e->c.a = f->slant;
    e->c.c = rise;
    e->bc.b = 0.0;
    e->bc.a = rise * inverse;
    e->bc.c = -f->slant * inverse;
    e->ca.b = sine * rise;
    e->ca.a = -f->cos_ab * rise;
    e->ca.c = f->cos_ab * f->slant - sine * f->cos_bc;
    inverse = 1.0 / SQRT((e->ca.a * e->ca.a + e->ca.c * e->ca.c) + e->ca.b * e->ca.b);
    e->ca.b *= inverse;
    e->ca.a *= inverse;
    e->ca.c *= inverse;
}

PSC_LANE double spot_dot(const struct psc_spot_f64 *p, const struct psc_spot_f64 *q)
{
    return p->b * q->b + (p->a * q->a + p->c * q->c);
}

/* Whether p, on the great circle with normal `plane`, is on the arc between two points of it. */
PSC_LANE int on_arc(const struct psc_spot_f64 *p, const struct psc_spot_f64 *plane,
                    const struct psc_spot_f64 *from, const struct psc_spot_f64 *to, double slack)
{
    const double after = (plane->a * from->c - plane->c * from->a) * p->b +
                         ((plane->c * from->b - plane->b * from->c) * p->a +
                          (plane->b * from->a - plane->a * from->b) * p->c);
    const double before = (to->a * plane->c - to->c * plane->a) * p->b +
                          ((to->c * plane->b - to->b * plane->c) * p->a +
                           (to->b * plane->a - to->a * plane->b) * p->c);

    return (after >= -slack) & (before >= -slack) & (spot_dot(p, from) + spot_dot(p, to) >= -slack);
}

/* Whether the direction is in the triangle, to within slack: clearly inside, or along an edge.
   Only the sides of the arcs tell for slivers that are thinner than slack. */
PSC_LANE int fan_holds(const struct psc_fan_f64 *f, const struct psc_spot_f64 *p, double slack)
{
    static const struct psc_spot_f64 b = {1.0, 0.0, 0.0}, ab = {0.0, 0.0, 1.0};
    struct psc_fan_edges e;
    double at_bc, at_ca;

    if (p->c < -slack)
        return 0;
    fan_edges(f, &e);
    at_bc = spot_dot(p, &e.bc);
    at_ca = spot_dot(p, &e.ca);
    if (!(at_bc >= -slack && at_ca >= -slack))
        return 0;
    return (p->c > slack && at_bc > slack && at_ca > slack) ||
           (p->c <= slack && on_arc(p, &ab, &b, &e.a, slack)) ||
           (at_bc <= slack && on_arc(p, &e.bc, &e.c, &b, slack)) ||
           (at_ca <= slack && on_arc(p, &e.ca, &e.a, &e.c, slack));
}

/* The point of the square: from the angle beta at B the side a^ to the far arc and the excess of
   the triangle A, B, C^, by half-angle tangents. */
PSC_LANE void fan_invert(const struct psc_fan_f64 *f, const struct psc_spot_f64 *p, double uv[2])
{
    const double sine = 1.0 / f->share_a, tan_c = SQRT(f->near / f->far);
    const double across = SQRT(p->a * p->a + p->c * p->c);
    const int at_b = across == 0.0;
    const double cos_beta = at_b ? 1.0 : p->a / across;
    const double sin_beta = at_b ? 0.0 : MAX(p->c, 0.0) / across;
    const double y = sine * f->sin_a;
    const double x = f->cos_ab * cos_beta * f->sin_a + sin_beta * f->cos_a;
    const double h = SQRT(x * x + y * y);
    const double tan_a = x >= 0.0 ? y / (h + x) : (h - x) / y;
    const double half_sine2 =
        0.5 * (p->b > 0.0 ? across * across / (1.0 + p->b) : 1.0 - p->b);

    uv[0] = angle_of(1.0 + tan_c * tan_a * cos_beta, tan_c * tan_a * sin_beta) / f->half;
    uv[1] = half_sine2 * (1.0 + 1.0 / (tan_a * tan_a));
}

#endif
