/* SPDX-License-Identifier: Apache-2.0 */
/* A rectangle as the receiver sees it, from exact products. */
#ifndef PSC_SRC_RECTANGLE_VIEW_H
#define PSC_SRC_RECTANGLE_VIEW_H

#include "polygon_build.h"

/* The edges of a rectangle may be off the right angle by this much, as a cosine. */
#define PSC_RECTANGLE_TOLERANCE 1e-6

/* Corner, edges and diagonal in units of the view, whose vertices are corner, corner + u, corner +
   u + v, corner + v. */
struct psc_rectangle_words {
    struct psc_word2 corner, u, v, diagonal;
};

PSC_LANE void add_words(const struct psc_word2 *a, const struct psc_word2 *b, struct psc_word2 *to)
{
    double low;
    int c;

    for (c = 0; c < 3; c++) {
        two_sum(a->high[c], b->high[c], &to->high[c], &low);
        low += a->low[c] + b->low[c];
        two_sum(to->high[c], low, &to->high[c], &to->low[c]);
    }
}

PSC_LANE void scale_words(struct psc_word2 *w, double scale)
{
    int c;

    for (c = 0; c < 3; c++) {
        w->high[c] *= scale;
        w->low[c] *= scale;
    }
}

/* What edge_v has across edge_u, in two words: rounding leaves edges of no caller exactly
   perpendicular, and maps and totals that take a needle for different shapes differ by more than
   rounding. Whether they are to within the tolerance. */
PSC_LANE int straighten(const double u[3], const double v[3], struct psc_word2 *to)
{
    const double scale_u = unit_scale(largest(u)), scale_v = unit_scale(largest(v));
    double uu = 0.0, vv = 0.0, uv = 0.0, error = 0.0, shear, p, low;
    int c;

    for (c = 0; c < 3; c++) {
        const double a = u[c] * scale_u, b = v[c] * scale_v;

        uu += a * a;
        vv += b * b;
        add_product(a, b, &uv, &error);
    }
    uv += error;
    shear = uu > 0.0 ? uv / uu : 0.0;
    for (c = 0; c < 3; c++) {
        two_product(-shear, u[c] * scale_u, &p, &low);
        two_sum(v[c] * scale_v, p, &to->high[c], &p);
        to->low[c] = p + low;
    }
    scale_words(to, 1.0 / scale_v);
    return ABS(uv) <= PSC_RECTANGLE_TOLERANCE * SQRT(uu * vv);
}

/* g: corner, edge_u and edge_v. Whether the angle is a right one; *size: of the largest
   coordinate, which may be none. */
PSC_LANE int rectangle_words(const double position[3], const double *g,
                             struct psc_polygon_view *view, struct psc_rectangle_words *o,
                             double *size)
{
    struct psc_word2 vertex[4];
    int i, c, square;

    for (c = 0; c < 3; c++) {
        two_sum(g[c], -position[c], &vertex[0].high[c], &vertex[0].low[c]);
        o->u.high[c] = g[3 + c];
        o->u.low[c] = 0.0;
    }
    square = straighten(g + 3, g + 6, &o->v);
    add_words(&o->u, &o->v, &o->diagonal);
    add_words(&vertex[0], &o->u, &vertex[1]);
    add_words(&vertex[0], &o->diagonal, &vertex[2]);
    add_words(&vertex[0], &o->v, &vertex[3]);
    *size = 0.0;
    for (i = 0; i < 4; i++)
        *size = MAX(*size, largest(vertex[i].high));
    view->count = 4;
    view->scale = unit_scale(*size);
    for (i = 0; i < 4; i++) {
        scale_words(&vertex[i], view->scale);
        for (c = 0; c < 3; c++) {
            view->vertex[i][c] = vertex[i].high[c];
            view->low[i][c] = vertex[i].low[c];
        }
    }
    o->corner = vertex[0];
    scale_words(&o->u, view->scale);
    scale_words(&o->v, view->scale);
    scale_words(&o->diagonal, view->scale);
    return square;
}

PSC_LANE psc_result see_rectangle(const double position[3], const double *g,
                                  struct psc_polygon_view *view, struct psc_rectangle_words *o)
{
    double size;

    return !rectangle_words(position, g, view, o, &size) ? PSC_ERROR_NOT_RECTANGLE
           : !is_finite(size)                            ? PSC_ERROR_NOT_FINITE
                                                         : PSC_SUCCESS;
}

/* g(x) - 1. */
PSC_LANE double rectangle_excess(const struct psc_rectangle *f, double x)
{
    return rectangle_step(0.0, x, f->p0, f->p1);
}

/* What follows for the map from the place in the local frame. */
PSC_LANE void rectangle_constants(struct psc_rectangle *f)
{
    const double x1 = f->x1;
    double cosine, more, e0, e1, away, t_a, beside, plain, first, above;
    int around;

    f->sine = f->z * f->height / (f->p0 * f->p1);
    cosine = (f->y0 * f->y1 + f->z * f->z) / (f->p0 * f->p1);
    more = one_plus(cosine, f->sine * f->sine);
    e0 = rectangle_excess(f, f->x0);
    e1 = rectangle_excess(f, x1);
    /* Choices of numbers, not of ways: loops over elements are vector code. */
    around = (f->x0 < 0.0) & (x1 > 0.0);
    f->x_a = around ? 0.0 : f->x0;
    away = rectangle_step(f->x_a, around ? -f->x0 : f->width, f->p0, f->p1);
    t_a = rectangle_t(f->x0, SQRT(f->x0 * f->x0 + f->p0 * f->p0), f->p0);
    f->t_a = around ? 1.0 : t_a;
    f->g_a = around ? 1.0 : 1.0 + e0;
    f->k1 = around ? 2.0 * more : e0 * e0 + 2.0 * f->g_a * more;
    beside = cosine < 0.0 ? e0 + more : f->g_a + cosine;
    f->k2 = around ? more : beside;
    f->most[0] = around ? e1 : away;
    f->most[1] = around ? away : 0.0;
    plain = 1.0 + f->g_a * (1.0 + e1) + (f->g_a + (1.0 + e1)) * cosine;
    beside = cosine < 0.0 ? e0 * e1 + (2.0 + e0 + e1) * more : plain;
    first = angle_of(around ? (2.0 + away) * more : beside, away * f->sine);
    above = angle_of(around ? (2.0 + e1) * more : 1.0, around ? e1 * f->sine : 0.0);
    f->half_below = around ? first : 0.0;
    f->half = first + above;
}

/* Adds the product of v and w to the unevaluated sum *high + *low. */
PSC_LANE void add_dot(const struct psc_word2 *v, const struct psc_word2 *w, double *high,
                      double *low)
{
    int c;

    for (c = 0; c < 3; c++)
        add_product(v->high[c], w->high[c], high, low);
    *low += dot(v->low, w->high) + dot(v->high, w->low);
}

/* What the receiver sees, in the local frame; half is 0 when it is nothing. */
PSC_LANE void rectangle_see(const struct psc_rectangle_words *o, struct psc_rectangle *f,
                            struct psc_triangle_view *seen)
{
    double along = 0.0, along_low = 0.0, across = 0.0, across_low = 0.0;
    int c, shown;

    see_volume(&o->corner, &o->u, &o->v, seen);
    f->width = SQRT(dot(o->u.high, o->u.high));
    f->height = seen->twice_area / f->width;
    add_dot(&o->corner, &o->u, &along, &along_low);
    add_dot(&o->corner, &o->v, &across, &across_low);
    f->x0 = (along + along_low) / f->width;
    f->y0 = (across + across_low) / f->height;
    add_dot(&o->u, &o->u, &along, &along_low);
    add_dot(&o->v, &o->v, &across, &across_low);
    f->x1 = (along + along_low) / f->width;
    f->y1 = (across + across_low) / f->height;
    for (c = 0; c < 3; c++)
        f->x[c] = o->u.high[c] / f->width;
    f->z = ABS(seen->volume) / seen->twice_area;
    for (c = 0; c < 3; c++)
        f->up[c] = COPYSIGN(1.0, seen->volume) * seen->normal[c] / seen->twice_area;
    cross_rounded(seen->normal, f->x, f->y);
    for (c = 0; c < 3; c++)
        f->y[c] /= seen->twice_area;

    rectangle_planes(f);
    rectangle_constants(f);
    /* In the plane, or without a size, where the quotients are no numbers. */
    shown = (seen->volume != 0.0) & (f->half > 0.0) & (f->half <= PSC_PI);
    f->half = shown ? f->half : 0.0;
}

#endif
