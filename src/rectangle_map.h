/* SPDX-License-Identifier: Apache-2.0 */
/*
 * The map of a rectangle by solid angle that keeps its grid [UFK13]: u moves along edge_u, v along
 * edge_v. In double behind both precisions.
 *
 * Local frame: x and y along the edges, z > 0 the height over the receiver. The lune between the
 * planes of the lines y = y0 and y = y1 through the receiver has its apex at x = -infinity, and
 * the solid angle omega of its part between x_a and x is elementary in
 *     g(x) = t_0(x) t_1(x),   t_j(x) = exp asinh(x / p_j),   p_j^2 = y_j^2 + z^2 :
 *     tan(omega / 2) = (g - g_a) sin / (1 + g g_a + (g + g_a) cos),
 * sin and cos being those of the angle between the planes, z (y1 - y0) / (p_0 p_1) and (y0 y1 +
 * z^2) / (p_0 p_1). Solved for g, and g for t_0^2 = g (p_0 + p_1 g) / (p_1 + p_0 g), this gives x
 * without an arctangent, and in steps from x_a that are products of positive terms. x_a is 0 where
 * the rectangle reaches both sides of it, else x_0.
 */
#ifndef PSC_SRC_RECTANGLE_MAP_H
#define PSC_SRC_RECTANGLE_MAP_H

#include "polygon_view.h"

struct psc_rectangle {
    double half, half_below;  /* half the solid angle, and half that of x < 0 if x_a = 0 */
    double x_a, t_a, g_a;     /* where steps begin, t_0 and g there */
    double sine, k1, k2;      /* g_a^2 + 1 + 2 g_a cos and g_a + cos */
    double most[2];           /* g - g_a at both ends, x_1 and, mirrored, x_0 */
    double p0, p1, x0, x1, y0, y1, z, width, height;
    double x[3], y[3], up[3];             /* the local frame */
    struct psc_word2 start, along, across; /* corner and edges in the view */
};

/* A sampled point: local x and y, and the fractions of the edges. */
struct psc_rectangle_point {
    double x, y, u, v;
};

/* exp asinh(x / p), r^2 = x^2 + p^2. */
PSC_LANE double rectangle_t(double x, double r, double p)
{
    return x >= 0.0 ? (r + x) / p : p / (r - x);
}

/* g(x) - g(x_a) for x = x_a + dx, as a sum of terms of the sign of dx. */
PSC_LANE double rectangle_step(double x_a, double dx, double p0, double p1)
{
    const double x = x_a + dx;
    const double a0 = SQRT(x_a * x_a + p0 * p0), r0 = SQRT(x * x + p0 * p0);
    const double a1 = SQRT(x_a * x_a + p1 * p1), r1 = SQRT(x * x + p1 * p1);
    const double ta0 = rectangle_t(x_a, a0, p0), t0 = rectangle_t(x, r0, p0);
    const double ta1 = rectangle_t(x_a, a1, p1), t1 = rectangle_t(x, r1, p1);

    return dx * ((ta0 + t0) / (a0 + r0) * t1 + ta0 * ((ta1 + t1) / (a1 + r1)));
}

/* sin e of the elevations of two points at y0 and y1 = y0 + dy of a line at the distance d,
   r_j^2 = d^2 + y_j^2: their difference. */
PSC_LANE double elevation_step(double d2, double y0, double r0, double y1, double r1, double dy)
{
    const double product = y0 * y1;
    const double q = product > 0.0 ? d2 * (d2 + y0 * y0 + y1 * y1) / (r0 * r1 + product)
                                   : r0 * r1 - product;

    return dy * (d2 + q) / (r0 * r1 * (r0 + r1));
}

/* 1 - y / r and 1 + y / r. */
PSC_LANE void elevation_gaps(double d2, double y, double r, double *minus, double *plus)
{
    const double h = y / r, small = d2 / (r * r * (1.0 + ABS(h)));

    *minus = h > 0.0 ? small : 1.0 - h;
    *plus = h > 0.0 ? 1.0 + h : small;
}

/* Of the edges along x, from the receiver. */
PSC_LANE void rectangle_planes(struct psc_rectangle *f)
{
    f->p0 = SQRT(f->y0 * f->y0 + f->z * f->z);
    f->p1 = SQRT(f->y1 * f->y1 + f->z * f->z);
}

PSC_LANE void rectangle_map(const struct psc_rectangle *f, double u, double v,
                            struct psc_rectangle_point *p)
{
    const double w = u * f->half - f->half_below;
    const double side = COPYSIGN(1.0, w), angle = ABS(w);
    const double rest = (PSC_PI - angle) + 1.2246467991473532e-16;
    const int obtuse = rest < angle, around = (f->y0 < 0.0) & (f->y1 > 0.0);
    const double most = w < 0.0 ? f->most[1] : f->most[0];
    double sine_defect, cosine_defect, sine, cosine, down, dg, g, dr, t, dx, first;
    double d2, d, r0, r1, m0, m1, n0, n1, mv, nv, cv, c0, de, between, dy;

    sine_cosine_defects_f64(obtuse ? rest : angle, &sine_defect, &cosine_defect);
    sine = (obtuse ? rest : angle) - sine_defect;
    cosine = obtuse ? cosine_defect - 1.0 : 1.0 - cosine_defect;
    down = f->sine * cosine - f->k2 * sine;
    dg = f->k1 * sine / (down > 0.0 ? down : 1.0);
    dg = down > 0.0 ? MIN(dg, most) : most;
    g = f->g_a + dg;
    dr = dg * (f->p0 * f->p1 * (1.0 + g * f->g_a) + f->p1 * f->p1 * (g + f->g_a)) /
         ((f->p1 + f->p0 * g) * (f->p1 + f->p0 * f->g_a));
    t = SQRT(f->t_a * f->t_a + dr);
    dx = side * (0.5 * f->p0 * dr * (1.0 + t * f->t_a) / ((t + f->t_a) * t * f->t_a));
    p->x = f->x_a + dx;
    first = ((f->x_a - f->x0) + dx) / f->width;
    p->u = MIN(MAX(first, 0.0), 1.0);

    d2 = p->x * p->x + f->z * f->z;
    d = SQRT(d2);
    r0 = SQRT(d2 + f->y0 * f->y0);
    r1 = SQRT(d2 + f->y1 * f->y1);
    elevation_gaps(d2, f->y0, r0, &m0, &n0);
    elevation_gaps(d2, f->y1, r1, &m1, &n1);
    mv = (1.0 - v) * m0 + v * m1;
    nv = (1.0 - v) * n0 + v * n1;
    cv = SQRT(mv * nv);
    between = d * ((1.0 - v) * (f->y0 / r0) + v * (f->y1 / r1)) / cv;
    c0 = d / r0;
    de = v * elevation_step(d2, f->y0, r0, f->y1, r1, f->height);
    dy = 2.0 * r0 * de * (c0 + cv) / (((c0 + cv) * (c0 + cv) + de * de) * cv);
    dy = around ? between - f->y0 : dy;
    p->v = MIN(MAX(dy / f->height, 0.0), 1.0);
    p->y = f->y0 + p->v * f->height;
    p->y = around ? MIN(MAX(between, f->y0), f->y1) : p->y;
}

/* The fractions of the solid angle at fractions p->u and p->v of the edges; around: x_a is 0. */
PSC_LANE void rectangle_invert(const struct psc_rectangle *f, int around,
                               const struct psc_rectangle_point *p, double uv[2])
{
    const double dx = p->x - f->x_a, away = ABS(around ? dx : p->u * f->width);
    const double dg = rectangle_step(f->x_a, away, f->p0, f->p1);
    const double w = angle_of(f->k1 + dg * f->k2, dg * f->sine);
    const double d2 = p->x * p->x + f->z * f->z;
    const double r0 = SQRT(d2 + f->y0 * f->y0), r1 = SQRT(d2 + f->y1 * f->y1);
    const double r = SQRT(d2 + p->y * p->y);

    uv[0] = (f->half_below + (around ? COPYSIGN(w, dx) : w)) / f->half;
    uv[1] = elevation_step(d2, f->y0, r0, p->y, r, p->v * f->height) /
            elevation_step(d2, f->y0, r0, f->y1, r1, f->height);
}

/* The receiver's vector to a point of the solid angle map. */
PSC_LANE void rectangle_vector(const struct psc_rectangle *f, const struct psc_rectangle_point *p,
                               double to[3])
{
    int c;

    for (c = 0; c < 3; c++)
        to[c] = (p->x * f->x[c] + p->y * f->y[c]) + f->z * f->up[c];
}

/* Where a direction meets the rectangle; how far it is within all edges, as a sine, and a number
   that is positive where it points to the light: directions along the plane, which the four edges
   let pass, must. */
PSC_LANE void rectangle_meet(const struct psc_rectangle *f, const double direction[3],
                             struct psc_rectangle_point *p, double *within, double *ahead)
{
    const double x = dot(direction, f->x), y = dot(direction, f->y), z = dot(direction, f->up);
    const double to_x0 = (f->z * x - f->x0 * z) / SQRT(f->x0 * f->x0 + f->z * f->z);
    const double to_x1 = (f->x1 * z - f->z * x) / SQRT(f->x1 * f->x1 + f->z * f->z);
    const double to_y0 = (f->z * y - f->y0 * z) / f->p0, to_y1 = (f->y1 * z - f->z * y) / f->p1;
    const double to_x = MIN(to_x0, to_x1), to_y = MIN(to_y0, to_y1);
    const double up = MAX(z, 0x1p-1000);

    p->x = MIN(MAX(f->z * x / up, f->x0), f->x1);
    p->y = MIN(MAX(f->z * y / up, f->y0), f->y1);
    p->u = MIN((p->x - f->x0) / f->width, 1.0);
    p->v = MIN((p->y - f->y0) / f->height, 1.0);
    *within = MIN(to_x, to_y);
    *ahead = x * p->x + y * p->y + z * f->z;
}

/* The same, and whether it meets it to within slack. */
PSC_LANE int rectangle_look(const struct psc_rectangle *f, const double direction[3], double slack,
                            struct psc_rectangle_point *p)
{
    double within, ahead;

    rectangle_meet(f, direction, p, &within, &ahead);
    return (within >= -slack) & (ahead > 0.0);
}

/* The density of a point per steradian; volume is the area times twice the height over it. */
PSC_LANE double rectangle_pdf(const struct psc_rectangle *f, const struct psc_rectangle_point *p,
                              int area, double volume, double inverse_total)
{
    double vector[3], distance;

    rectangle_vector(f, p, vector);
    distance = SQRT(dot(vector, vector));
    return area ? 2.0 * (distance * distance * distance) / volume : inverse_total;
}

#endif
