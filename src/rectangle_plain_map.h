/* SPDX-License-Identifier: Apache-2.0 */
/*
 * The map of rectangle_map.h by a shorter way, which asks for a receiver that is not close to the
 * plane of the light.
 *
 * Lengths are in units of the height over the receiver. The line at x = tan theta is at the angle
 *     omega(x) = asin(b_1 sin theta) - asin(b_0 sin theta),   b_j = y_j / p_j,  p_j^2 = 1 + y_j^2
 * from that at 0: this is the solid angle between them. Solved for theta,
 *     (sin theta, cos theta) ~ (sin omega, sqrt(Q)),
 *     Q = (cos omega - cos(beta_1 - beta_0)) (cos omega + cos(beta_1 + beta_0)),   b = sin beta.
 * Steps go from the end that is farther from x = 0, at omega = -a. There both factors of Q are
 * smallest, and what a step adds to them, cos omega - cos a, is positive. A point of the line is at
 * e = (1 - v) e_0 + v e_1, e = y / r being the sine of its elevation, and
 *     1 - e^2 = (1 - v) (1 - e_0^2) + v (1 - e_1^2) + v (1 - v) (e_1 - e_0)^2.
 */
#ifndef PSC_SRC_RECTANGLE_PLAIN_MAP_H
#define PSC_SRC_RECTANGLE_PLAIN_MAP_H

#include "vector.h"

struct psc_plain_rectangle {
    double x[3], y[3], up[3]; /* the local frame, x towards the end that is nearer */
    double unit;              /* the height, which other lengths are in units of */
    double side;              /* 1 where x runs along edge_u, -1 against it */
    double half;              /* half the solid angle */
    double far, width, y0, y1, height; /* x from -far to width - far */
    double r0, r1;            /* the distances of the corners at the far end */
    double sine, cosine;      /* of a */
    double least, most;       /* the factors of Q there */
    double per_step;          /* takes steps to fractions of the width */
};

/* A sampled point: direction in the frame, distance in world space, fractions of the edges. */
struct psc_plain_point {
    double x, y, z, distance, u, v;
};

/* surface: whether more than the direction is wanted. */
PSC_LANE void plain_rectangle_map(const struct psc_plain_rectangle *f, int surface, double u,
                                  double v, struct psc_plain_point *p)
{
    const double angle = (f->side < 0.0 ? 1.0 - u : u) * f->half, rest = PSC_PI - angle;
    const int obtuse = rest < angle;
    const double less = 1.0 - v;
    double sine_defect, cosine_defect, s, c, step, x, q, z, d2, d, r02, r12, r0, r1, rr;
    double across, e, b, bd, inverse;

    sine_cosine_defects_f64(obtuse ? rest : angle, &sine_defect, &cosine_defect);
    s = (obtuse ? rest : angle) - sine_defect;
    c = obtuse ? cosine_defect - 1.0 : 1.0 - cosine_defect;
    step = (2.0 * s) * (f->sine * c - f->cosine * s);
    x = f->sine - (2.0 * s) * (f->sine * s + f->cosine * c);
    q = (f->least + step) * (f->most + step);
    d2 = x * x + q;
    r02 = d2 + (f->y0 * f->y0) * q;
    r12 = d2 + (f->y1 * f->y1) * q;
    z = SQRT(q);
    d = SQRT(d2);
    r0 = SQRT(r02);
    r1 = SQRT(r12);
    rr = r0 * r1;
    inverse = 1.0 / (d * rr);
    across = f->y1 * r0 - f->y0 * r1;
    b = SQRT(d2 * (less * r12 + v * r02) + (v * less) * (q * (across * across)));
    e = z * (less * (f->y0 * r1) + v * (f->y1 * r0));
    p->x = -x * (b * inverse);
    p->y = (e * d) * inverse;
    p->z = z * (b * inverse);
    if (!surface)
        return;

    bd = b + d * r1;
    {
        const int around = f->far < f->width, both = f->y0 * f->y1 > 0.0;
        const double sum = ABS(f->y1) * r0 + ABS(f->y0) * r1;
        const double dy = both ? ABS(f->y0 + f->y1) * d2 : sum;
        const double under = (both ? sum : f->height) * bd;
        const double per_y = 1.0 / (under * (b * z));
        const double first = around ? f->far * z - x : step * (r0 * f->r1 + f->r0 * r1);
        const double per_x = around ? f->width : (x + z * f->far) * f->per_step;
        const double t = first / (z * per_x);
        const double w = v * (dy * z) * ((r02 * r1 + b * d) + (e * f->y0) * z) * per_y;
        const double within = MIN(MAX(t, 0.0), 1.0);

        p->u = f->side < 0.0 ? 1.0 - within : within;
        p->v = MIN(MAX(w, 0.0), 1.0);
        p->distance = (f->unit * (d * rr)) * (under * per_y);
    }
}

#endif
