/* SPDX-License-Identifier: Apache-2.0 */
/*
 * What a receiver sees of a circular disk: lane functions, the same for one element and for many.
 *
 * With d the distance to the plane, y that of the centre from the plane's nearest point and m1,
 * m2 the distances of the nearest and the farthest point of the rim,
 *     sin alpha = 2 r / (m1 + m2),   lp - lm = m1^2 - ... = (y - r)(y + r) + d^2 = T,
 *     lp lm = (d r)^2,   sin^2 beta = lm / (m1 m2),
 * from the roots lp > 0 > -lm of the quadratic form d^2 X^2 + lp Y^2 = lm Z^2 of the cone. Nothing
 * cancels but y - r, which comes from squares in two words. 8e-16 relative, all in all.
 */
#ifndef PSC_SRC_DISK_LOOK_H
#define PSC_SRC_DISK_LOOK_H

#include "disk_side.h"
#include "ellipse_view.h"

struct psc_disk_look {
    double scale, unit;         /* a power of two that makes lengths about 1, and its inverse */
    struct psc_wide offset[3];  /* of the centre, in units of `unit`, as is radius */
    double normal[3], radius;   /* the largest component of the normal is in [1,2) */
    struct psc_outline outline; /* likewise */
    double axes[2][3];          /* unit vectors across the normal */
    double outward[3];          /* the unit normal */
    double facing, height;      /* -1 for a receiver in front of the disk; of it over the plane */
    struct psc_wide nn, nc;     /* squares and products of the normal and the offset */
    double seen;                /* 0 if nothing is */
    double middle, reach;       /* height of the centre over the horizon, and what is around it */
};

/* How the receiver lies to the plane; geometry is the centre, the normal and the radius. */
PSC_LANE void face_disk(const double position[3], const double geometry[7],
                        struct psc_disk_look *o)
{
    double high[3], shrink;
    int i;

    for (i = 0; i < 3; i++)
        high[i] = geometry[i] - position[i];
    o->scale = unit_scale(MAX(largest(high), geometry[6]));
    o->unit = unit_inverse(o->scale);
    see_offset(position, geometry, o->scale, o->offset);
    (void)scale_to_one(geometry + 3, o->normal);
    o->radius = geometry[6] * o->scale;
    o->nn = wide_sum(wide_sum(exact_product(o->normal[0], o->normal[0]),
                              exact_product(o->normal[1], o->normal[1])),
                     exact_product(o->normal[2], o->normal[2]));
    o->nc = scaled_dot(o->normal, o->offset);
    shrink = 1.0 / SQRT(o->nn.high);
    o->facing = COPYSIGN(1.0, o->nc.high);
    o->height = ABS(o->nc.high) * shrink;
    for (i = 0; i < 3; i++)
        o->outward[i] = o->normal[i] * shrink;
    perpendicular(o->outward, o->axes[0]);
    cross_rounded(o->outward, o->axes[0], o->axes[1]);
}

/* For samples by area: the frame of struct psc_laid, and that. */
PSC_LANE void lay_disk(const struct psc_disk_look *o, double frame[3][3], struct psc_laid *f)
{
    const double high[3] = {o->offset[0].high, o->offset[1].high, o->offset[2].high};
    int i;

    for (i = 0; i < 3; i++) {
        frame[0][i] = o->axes[0][i];
        frame[1][i] = o->axes[1][i];
        frame[2][i] = o->facing * o->outward[i];
    }
    f->x = dot(high, o->axes[0]);
    f->y = dot(high, o->axes[1]);
    f->height = o->height;
    f->a = f->b = o->radius;
    f->skew = 0.0;
    f->scale = PSC_PI * o->height * (o->radius * o->radius);
}

/* The outline of what face_disk() left. */
PSC_LANE void look_at_disk(struct psc_disk_look *o)
{
    struct psc_ellipse *e = &o->outline.seen;
    struct psc_wide v[3], vv, rr;
    double shrink, y, y_part, gap, sum, m1, m2, t, p, root, other;
    double root_lp, root_lm, foot[3], up[3], across[3], x, z, size, on_axis;
    const double d = o->height;
    int i;

    for (i = 0; i < 3; i++)
        v[i] = scaled_difference(o->normal[(i + 1) % 3], o->offset[(i + 2) % 3],
                                 o->normal[(i + 2) % 3], o->offset[(i + 1) % 3]);
    vv = wide_dot(v, v);
    shrink = 1.0 / SQRT(o->nn.high);
    y_part = SQRT(vv.high);
    y = y_part * shrink;
    rr = wide_product(exact_product(o->radius, o->radius), o->nn);
    sum = y + o->radius;
    gap = wide_sum(vv, wide_negative(rr)).high / (o->nn.high * sum);
    m1 = SQRT(gap * gap + d * d);
    m2 = SQRT(sum * sum + d * d);
    t = gap * sum + d * d;
    p = m1 * m2;
    root = SQRT(0.5 * (ABS(t) + p));
    other = d * o->radius / root;
    root_lp = t < 0.0 ? other : root;
    root_lm = t < 0.0 ? root : other;
    size = 1.0 / (m1 + m2);
    e->a = MIN(2.0 * o->radius * size, 1.0);
    e->ca = 2.0 * root_lp * size;
    size = 1.0 / SQRT(p);
    e->b = root_lm * size;
    e->cb = root_lp * size;
    o->outline.near = m1 * size;
    o->outline.far = m2 * size;
    /* Divided: what the horizon leaves of a light may hang on their last digits. */
    e->at = o->radius / root_lp;
    e->bt = root_lm / root_lp;
    o->seen = root_lp > 0.0 ? root_lm : 0.0;

    /* up: the normal away from the receiver; foot: in the plane towards the centre */
    for (i = 0; i < 3; i++)
        up[i] = o->facing * o->outward[i];
    on_axis = vv.high > 0.0 ? 0.0 : 1.0;
    size = -o->facing / (on_axis > 0.0 ? 1.0 : y_part);
    for (i = 0; i < 3; i++) {
        across[i] = size * v[i].high;
        e->x[i] = on_axis > 0.0 ? o->facing * o->axes[0][i] : across[i];
    }
    cross_rounded(up, e->x, foot);
    /* z is y foot + (d + r bt) up, stretched by root_lp */
    x = y * root_lp;
    z = d * root_lp + o->radius * root_lm;
    size = 1.0 / SQRT(x * x + z * z);
    x *= size;
    z *= size;
    for (i = 0; i < 3; i++) {
        e->z[i] = x * foot[i] + z * up[i];
        e->y[i] = z * foot[i] - x * up[i];
    }

    o->outline.turn[0] = 1.0;
    o->outline.turn[1] = 0.0;
    o->outline.reach = root_lp;
    for (i = 0; i < 2; i++) {
        o->outline.side[0][i] = dot(e->x, o->axes[i]);
        o->outline.side[1][i] = dot(foot, o->axes[i]);
    }
}

/* A unit vector along v, which is not 0. */
PSC_LANE void unit_normal(const double v[3], double to[3])
{
    double length;
    int i;

    (void)scale_to_one(v, to);
    length = 1.0 / SQRT(dot(to, to));
    for (i = 0; i < 3; i++)
        to[i] *= length;
}

PSC_LANE double disk_area(double radius)
{
    return PSC_PI * (radius * radius);
}

/* The i-th component of the k-th semi-axis of the disk that directions are projected along, see
   ellipse_view.h. */
PSC_LANE double disk_across(const struct psc_disk_look *o, double radius, int k, int i)
{
    return radius * (o->outline.side[k][0] * o->axes[0][i] + o->outline.side[k][1] * o->axes[1][i]);
}

/* How high the light is over the horizon of a normal, or of either side of that. */
PSC_LANE void look_at_horizon(const double normal[3], int both, struct psc_disk_look *o)
{
    double n[3], first, second, middle;

    (void)scale_to_one(normal, n);
    first = dot(n, o->axes[0]) * o->radius;
    second = dot(n, o->axes[1]) * o->radius;
    middle = scaled_dot(n, o->offset).high;
    o->middle = both ? ABS(middle) : middle;
    o->reach = SQRT(first * first + second * second);
}

#endif
