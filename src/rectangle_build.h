/* SPDX-License-Identifier: Apache-2.0 */
/* Builds of rectangles. */
#ifndef PSC_SRC_RECTANGLE_BUILD_H
#define PSC_SRC_RECTANGLE_BUILD_H

#include "polygon_build.h"

/* The edges of a rectangle may be off the right angle by this much, as a cosine. */
#define PSC_RECTANGLE_TOLERANCE 1e-6

/* The sum of a two-word number and a vector. */
PSC_LANE void add_edge(const struct psc_word2 *v, const double edge[3], struct psc_word2 *to)
{
    double low;
    int c;

    for (c = 0; c < 3; c++) {
        two_sum(v->high[c], edge[c], &to->high[c], &low);
        low += v->low[c];
        two_sum(to->high[c], low, &to->high[c], &to->low[c]);
    }
}

/* Corner and edges in units of the view, whose vertices are corner, corner + u, corner + u + v,
   corner + v; whether all is finite. */
struct psc_rectangle_words {
    struct psc_word2 corner, u, v, diagonal;
};

PSC_LANE int see_rectangle(const double position[3], const double *g,
                           struct psc_polygon_view *view, struct psc_rectangle_words *o)
{
    struct psc_word2 vertex[4];
    double size = 0.0;
    int i, c;

    for (c = 0; c < 3; c++) {
        two_sum(g[c], -position[c], &vertex[0].high[c], &vertex[0].low[c]);
        two_sum(g[3 + c], g[6 + c], &o->diagonal.high[c], &o->diagonal.low[c]);
        o->u.high[c] = g[3 + c];
        o->v.high[c] = g[6 + c];
        o->u.low[c] = o->v.low[c] = 0.0;
    }
    add_edge(&vertex[0], o->u.high, &vertex[1]);
    add_edge(&vertex[1], o->v.high, &vertex[2]);
    add_edge(&vertex[0], o->v.high, &vertex[3]);
    for (i = 0; i < 4; i++)
        size = MAX(size, largest(vertex[i].high));
    view->count = 4;
    view->scale = unit_scale(size);
    for (c = 0; c < 3; c++) {
        for (i = 0; i < 4; i++) {
            view->vertex[i][c] = vertex[i].high[c] * view->scale;
            view->low[i][c] = vertex[i].low[c] * view->scale;
        }
        o->corner.high[c] = view->vertex[0][c];
        o->corner.low[c] = view->low[0][c];
        o->u.high[c] *= view->scale;
        o->v.high[c] *= view->scale;
        o->diagonal.high[c] *= view->scale;
        o->diagonal.low[c] *= view->scale;
    }
    return is_finite(size);
}

/* Whether the edges are perpendicular. */
PSC_LANE int is_rectangle(const struct psc_rectangle_words *o)
{
    return ABS(dot(o->u.high, o->v.high)) <=
           PSC_RECTANGLE_TOLERANCE *
               SQRT(dot(o->u.high, o->u.high) * dot(o->v.high, o->v.high));
}

/* g(x) - 1. */
PSC_LANE double rectangle_excess(const struct psc_rectangle *f, double x)
{
    return rectangle_step(0.0, x, f->p0, f->p1);
}

/* What the receiver sees, in the local frame; half is 0 when it is nothing. Edges are taken for
   perpendicular: the part of v across u counts. */
PSC_LANE void rectangle_see(const struct psc_rectangle_words *o, struct psc_rectangle *f,
                            struct psc_triangle_view *seen)
{
    const double width2 = dot(o->u.high, o->u.high), width = SQRT(width2);
    double along = 0.0, along_low = 0.0, across = 0.0, across_low = 0.0, slant = 0.0, slant_low = 0.0;
    double shear, x1, cosine, more, e0, e1, below, above, plain;
    int c;

    see_volume(&o->corner, &o->u, &o->v, seen);
    f->width = width;
    f->height = seen->twice_area / width;
    for (c = 0; c < 3; c++) {
        add_product(o->corner.high[c], o->u.high[c], &along, &along_low);
        add_product(o->corner.high[c], o->v.high[c], &across, &across_low);
        add_product(o->u.high[c], o->v.high[c], &slant, &slant_low);
        f->x[c] = o->u.high[c] / width;
    }
    along_low += dot(o->corner.low, o->u.high);
    across_low += dot(o->corner.low, o->v.high);
    shear = (slant + slant_low) / width2;
    f->x0 = (along + along_low) / width;
    f->y0 = ((across + across_low) - shear * (along + along_low)) / f->height;
    for (c = 0; c < 3; c++) {
        add_product(o->u.high[c], o->u.high[c], &along, &along_low);
        add_product(o->v.high[c], o->v.high[c], &across, &across_low);
    }
    x1 = f->x1 = (along + along_low) / width;
    f->y1 = ((across + across_low) - shear * (along + along_low - width2 + (slant + slant_low))) /
            f->height;
    f->z = ABS(seen->volume) / seen->twice_area;
    for (c = 0; c < 3; c++)
        f->up[c] = COPYSIGN(1.0, seen->volume) * seen->normal[c] / seen->twice_area;
    cross_rounded(seen->normal, f->x, f->y);
    for (c = 0; c < 3; c++)
        f->y[c] /= seen->twice_area;

    f->p0 = SQRT(f->y0 * f->y0 + f->z * f->z);
    f->p1 = SQRT(f->y1 * f->y1 + f->z * f->z);
    f->sine = f->z * f->height / (f->p0 * f->p1);
    cosine = (f->y0 * f->y1 + f->z * f->z) / (f->p0 * f->p1);
    more = one_plus(cosine, f->sine * f->sine);
    e0 = rectangle_excess(f, f->x0);
    e1 = rectangle_excess(f, x1);
    if (f->x0 < 0.0 && x1 > 0.0) {
        below = rectangle_excess(f, -f->x0);
        f->half_below = angle_of((2.0 + below) * more, below * f->sine);
        above = angle_of((2.0 + e1) * more, e1 * f->sine);
        f->half = f->half_below + above;
        f->x_a = 0.0;
        f->t_a = f->g_a = 1.0;
        f->k1 = 2.0 * more;
        f->k2 = more;
        f->most[0] = e1;
        f->most[1] = below;
    } else {
        f->x_a = f->x0;
        f->t_a = rectangle_t(f->x0, SQRT(f->x0 * f->x0 + f->p0 * f->p0), f->p0);
        f->g_a = 1.0 + e0;
        f->k1 = e0 * e0 + 2.0 * f->g_a * more;
        f->k2 = cosine < 0.0 ? e0 + more : f->g_a + cosine;
        f->most[0] = rectangle_step(f->x0, width, f->p0, f->p1);
        f->most[1] = 0.0;
        plain = 1.0 + f->g_a * (1.0 + e1) + (f->g_a + (1.0 + e1)) * cosine;
        f->half_below = 0.0;
        f->half = angle_of(cosine < 0.0 ? e0 * e1 + (2.0 + e0 + e1) * more : plain,
                           f->most[0] * f->sine);
    }
    /* In the plane, or without a size, where the quotients are no numbers. */
    f->half = (seen->volume != 0.0) & (f->half > 0.0) & (f->half <= PSC_PI) ? f->half : 0.0;
}

PSC_LANE psc_result rectangle_build(psc_sampler *s, const struct psc_request *request,
                                    const double *g)
{
    struct psc_polygon_light *l = &s->polygon;
    const int area = s->measure == PSC_MEASURE_AREA;
    struct psc_fan_sums sums = NO_SUMS;
    struct psc_triangle_view seen;
    struct psc_rectangle_words o;
    int c;

    if (!see_rectangle(request->position, g, &l->view, &o))
        return PSC_ERROR_NOT_FINITE;
    if (!is_rectangle(&o))
        return PSC_ERROR_NOT_RECTANGLE;
    s->visibility = see_horizon(request->normal, &l->view, l->up, l->height);
    l->triangles = 0;
    if (s->map == PSC_MAP_PARALLEL) {
        struct psc_rectangle *f = &l->rectangle;

        rectangle_see(&o, f, &seen);
        for (c = 0; c < 3; c++) {
            sums.normal[c] = -seen.normal[c];
            f->start[c] = o.corner.high[c];
            f->low[c] = o.corner.low[c];
            f->along[c] = o.u.high[c];
            f->across[c] = o.v.high[c];
            f->corner[c] = g[c];
            f->edge_u[c] = g[3 + c];
            f->edge_v[c] = g[6 + c];
        }
        sums.twice_area = 2.0 * f->width * f->height;
        sums.volume = f->half > 0.0 ? -2.0 * seen.volume : 0.0;
        sums.half = f->half;
    } else {
        const struct psc_fan_places at[2] = {
            {g, l->height[0], 1.0, 0.0, 0.0, 0.0, 1.0, 1.0},
            {g, l->height[0], 1.0, 1.0, 0.0, 0.0, 0.0, 1.0}};
        struct psc_triangle_words words;

        vertex_words(&l->view, 1, &words.a);
        words.b = o.corner;
        vertex_words(&l->view, 2, &words.c);
        words.edge_a = o.u;
        words.edge_c = o.diagonal;
        words.edge_ac = o.v;
        fan_add(l, area, &words, at, &sums);
        words.a = words.c;
        vertex_words(&l->view, 3, &words.c);
        words.edge_a = o.diagonal;
        words.edge_c = o.v;
        for (c = 0; c < 3; c++)
            words.edge_ac.high[c] = -o.u.high[c];
        words.edge_ac.low[0] = words.edge_ac.low[1] = words.edge_ac.low[2] = 0.0;
        fan_add(l, area, &words, at + 1, &sums);
    }
    return polygon_finish(s, request, &sums, 1.0);
}

#endif
