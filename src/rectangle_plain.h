/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rectangles along their edges in plain double arithmetic, which is as good as exact products for
 * all but receivers close to the plane or next to a long light; with the test for these.
 */
#ifndef PSC_SRC_RECTANGLE_PLAIN_H
#define PSC_SRC_RECTANGLE_PLAIN_H

#include <psc/psc.h>

#include "rectangle_map.h"
#include "rectangle_plain_map.h"
#include "triangle_plain.h"

/* A rectangle as the receiver sees it, in the units of its edges. */
struct psc_rectangle_sight {
    double corner[3], edge_v[3]; /* from the receiver; and at the right angle */
    double normal[3], volume;    /* edge_u x edge_v, and the corner times that */
    double square_u, square_n;   /* of the lengths of edge_u and normal */
    double size_u, area;         /* those lengths */
    double longest;              /* the square of the corner's length or an edge's, which is most */
};

/*
 * Returns whether rounding did no harm. u being a rounding error, |c|, |e|, |f| the lengths of
 * corner and edges, which are at a right angle by the first test,
 *  - the normal is off by less than 2 u |e| |f| and the volume by less than 6 u |c| |e| |f|: at a
 *    height z over the plane of an eighth of |c| at least, by 48 u of itself;
 *  - the axes are off by less than 8 u, and the foot of the corner in them by less than 8 u |c|,
 *    which is 64 u z at most; as all of it is farther than z, its density z / r^3 and with it the
 *    solid angle move by less than three times as much of themselves, of which sweeps find a
 *    fourth;
 *  - as |e| and |f| are less than 8 z too, the local coordinates are below 16 z, and squares leave
 *    room for all products.
 */
PSC_LANE int see_plain_rectangle(const double position[3], const double *g,
                                 struct psc_rectangle_sight *o)
{
    const double *const u = g + 3, *const v = g + 6;
    const double uv = dot(u, v), vv = dot(v, v);
    double corner, least;

    o->square_u = dot(u, u);
    subtract3(g, position, o->corner);
    scale3(uv / o->square_u, u, o->edge_v);
    subtract3(v, o->edge_v, o->edge_v);
    cross_rounded(u, v, o->normal);
    o->volume = dot(o->corner, o->normal);
    o->square_n = dot(o->normal, o->normal);
    o->size_u = SQRT(o->square_u);
    o->area = SQRT(o->square_n);

    corner = dot(o->corner, o->corner);
    least = MIN(o->square_u, vv);
    o->longest = MAX(o->square_u, vv);
    o->longest = MAX(o->longest, corner);
    return 0x1p42 * (uv * uv) <= o->square_u * vv &&
           64.0 * (o->volume * o->volume) > o->square_n * o->longest && least > 0x1p-240 &&
           o->longest < 0x1p240;
}

/*
 * Where a rectangle lies to the plane of a receiver: a psc_case, or -1 where rounding would decide,
 * both as numbers that loops over doubles may choose from. size: the length of the normal,
 * whose square has to be as is_plain_normal() asks. Heights are off by less than 24 u of that times
 * the longest of corner and edges, which is less than eight times the height over the rectangle.
 */
PSC_LANE double see_rectangle_horizon(const double *g, const struct psc_rectangle_sight *o,
                                      const double normal[3], double size)
{
    const double at = dot(normal, o->corner), u = dot(normal, g + 3), v = dot(normal, o->edge_v);
    const double at_u = at + u, at_v = at + v, at_uv = at_u + v;
    const double low_u = MIN(at, at_u), low_v = MIN(at_v, at_uv), low = MIN(low_u, low_v);
    const double high_u = MAX(at, at_u), high_v = MAX(at_v, at_uv), high = MAX(high_u, high_v);
    const double near_u = MIN(ABS(at), ABS(at_u)), near_v = MIN(ABS(at_v), ABS(at_uv));
    const double near = MIN(near_u, near_v), slack = 0x1p-44 * (size * ABS(o->volume));

    return low * o->area > slack     ? (double)PSC_CASE_ABOVE
           : high * o->area < -slack ? (double)PSC_CASE_EMPTY
           : near * o->area > slack  ? (double)PSC_CASE_CLIPPED
                                     : -1.0;
}

/* The line at x >= 0, an end of the rectangle or its mirror image. With q^2 = 1 + x^2, gap = q^2 +
   r_0 r_1 + y_0 y_1 and p = p_0 p_1 the solid angle omega between it and that at 0 has
       sin omega = x h (r_0 + r_1) / (p gap),   cos omega = (r_0 r_1 + x^2 y_0 y_1) / (p q^2),
   and gap (gap - 2 y_0 y_1) = q^2 (r_0 + r_1)^2. */
struct psc_rectangle_end {
    double x, r0, r1, sum;     /* r_0 + r_1 */
    double over, under;        /* 1 / gap */
    double sine, cosine;       /* of omega, times p under */
};

PSC_LANE void rectangle_end(double x, double height, double yy0, double yy1, double yy,
                            struct psc_rectangle_end *o)
{
    const double square = 1.0 + x * x;
    double rr, gap, factor;

    o->x = x;
    o->r0 = SQRT(square + yy0);
    o->r1 = SQRT(square + yy1);
    o->sum = o->r0 + o->r1;
    rr = o->r0 * o->r1;
    gap = square + (rr + ABS(yy));
    factor = yy >= 0.0 ? gap : o->sum * o->sum;
    o->over = yy >= 0.0 ? square : gap;
    o->under = square * factor;
    o->sine = (x * height) * (o->sum * o->over);
    o->cosine = (rr + (x * x) * yy) * factor;
}

/* The solid angle and the constants of the map, but for the cosines from terms of one sign. */
PSC_LANE void plain_rectangle(const double *g, const struct psc_rectangle_sight *s,
                              struct psc_plain_rectangle *o)
{
    const double volume = ABS(s->volume);
    const double per_height = 1.0 / (s->size_u * volume), per_size = 1.0 / (s->size_u * s->area);
    const double x0 = dot(s->corner, g + 3) * (s->area * per_height);
    const double y0 = dot(s->corner, s->edge_v) * (s->square_u * per_height);
    const double width = s->square_u * (s->area * per_height), height = s->square_n * per_height;
    const double x1 = x0 + width, y1 = y0 + height;
    const double side = ABS(x0) >= ABS(x1) ? 1.0 : -1.0, far = MAX(ABS(x0), ABS(x1));
    const double near = width - far, yy0 = y0 * y0, yy1 = y1 * y1, yy = y0 * y1;
    const double planes = SQRT((1.0 + yy0) * (1.0 + yy1));
    struct psc_rectangle_end a, n;
    double inverse, part, cosines, sines, first, second, f, rest;
    int around;

    rectangle_end(far, height, yy0, yy1, yy, &a);
    rectangle_end(ABS(near), height, yy0, yy1, yy, &n);
    /* tan(a / 2 + b / 2) = (sin a + sin b) / (cos a + cos b),
       tan(a / 2 - b / 2) = (cos b - cos a) / (sin a + sin b) */
    cosines = a.cosine * n.under + n.cosine * a.under;
    sines = a.sine * n.under + n.sine * a.under;
    first = a.r0 + n.r0;
    second = a.r1 + n.r1;
    f = first * second;
    around = near > 0.0;
    o->half = arc_and_rest(around ? cosines : sines * f,
                           around ? sines
                                  : ((height * height) * (a.over * n.over)) *
                                        ((width * (far + n.x)) *
                                         (f + (a.r0 * first + n.r1 * second))),
                           &rest);
    inverse = 1.0 / (planes * a.under);
    part = inverse * a.over;
    scale3(side * (s->area * per_size), g + 3, o->x);
    scale3(s->square_u * per_size, s->edge_v, o->y);
    scale3(COPYSIGN(s->size_u * per_size, s->volume), s->normal, o->up);
    o->unit = volume * (s->size_u * per_size);
    o->side = side;
    o->far = far;
    o->width = width;
    o->y0 = y0;
    o->y1 = y1;
    o->height = height;
    o->r0 = a.r0;
    o->r1 = a.r1;
    o->sine = a.sine * inverse;
    o->cosine = a.cosine * inverse;
    o->least = (height * height) * part;
    o->most = (a.sum * a.sum) * part;
    o->per_step = ((width * height) * a.sum) * (part * planes);
}

/* For points of the area map, in world space. */
PSC_LANE void plain_words(const double position[3], const double *g,
                          const struct psc_rectangle_sight *o, struct psc_rectangle *f)
{
    int c;

    for (c = 0; c < 3; c++) {
        two_sum(g[c], -position[c], &f->start.high[c], &f->start.low[c]);
        f->along.high[c] = g[3 + c];
        f->across.high[c] = o->edge_v[c];
        f->along.low[c] = f->across.low[c] = 0.0;
    }
}

/* The local frame of rectangle_map.h, in world space. */
PSC_LANE void plain_frame(const double *g, const struct psc_rectangle_sight *o,
                          struct psc_rectangle *f)
{
    const double per_size = 1.0 / (o->size_u * o->area), per_u = o->area * per_size;

    scale3(per_u, g + 3, f->x);
    scale3(o->square_u * per_size, o->edge_v, f->y);
    scale3(COPYSIGN(o->size_u * per_size, o->volume), o->normal, f->up);
    f->width = o->size_u;
    f->height = o->square_n * per_size;
    f->x0 = dot(o->corner, g + 3) * per_u;
    f->y0 = dot(o->corner, o->edge_v) * (o->square_u * per_size);
    f->x1 = f->x0 + f->width;
    f->y1 = f->y0 + f->height;
    f->z = ABS(o->volume) * (o->size_u * per_size);
    rectangle_planes(f);
}

#endif
