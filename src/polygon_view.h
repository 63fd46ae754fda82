/* SPDX-License-Identifier: Apache-2.0 */
/* What a receiver sees of a polygon: its vertices, and its edges as they are in world space. */
#ifndef PSC_SRC_POLYGON_VIEW_H
#define PSC_SRC_POLYGON_VIEW_H

#include "vector.h"

enum { PSC_MAX_VERTICES = 16 };

/* A polygon as the receiver sees it: vertex + low is vertex minus receiver, exact but for the
   last word's rounding, times scale, the power of two that brings the largest coordinate into
   [1,2). */
struct psc_polygon_view {
    int count;
    double vertex[PSC_MAX_VERTICES][3], low[PSC_MAX_VERTICES][3];
    double scale;
};

/* A vertex or an edge in two words, in units of the view. */
struct psc_word2 {
    double high[3], low[3];
};

/* vertices: count times three coordinates. Returns whether all is finite. */
PSC_LANE int see_polygon(const double position[3], int count, const double *vertices,
                         struct psc_polygon_view *o)
{
    double size = 0.0;
    int i, c;

    o->count = count;
    for (i = 0; i < count; i++) {
        for (c = 0; c < 3; c++)
            two_sum(vertices[3 * i + c], -position[c], &o->vertex[i][c], &o->low[i][c]);
        size = MAX(size, largest(o->vertex[i]));
    }
    o->scale = unit_scale(size);
    for (i = 0; i < count; i++)
        for (c = 0; c < 3; c++) {
            o->vertex[i][c] *= o->scale;
            o->low[i][c] *= o->scale;
        }
    return is_finite(size);
}

/* The difference of two vertices, to - from, in units of the view: high + low is exact but for
   the last word's rounding, however far the receiver. */
PSC_LANE void edge_of(const double from[3], const double to[3], double scale, double high[3],
                      double low[3])
{
    int c;

    for (c = 0; c < 3; c++) {
        two_sum(to[c], -from[c], &high[c], &low[c]);
        high[c] *= scale;
        low[c] *= scale;
    }
}

PSC_LANE void vertex_words(const struct psc_polygon_view *view, int i, struct psc_word2 *to)
{
    int c;

    for (c = 0; c < 3; c++) {
        to->high[c] = view->vertex[i][c];
        to->low[c] = view->low[i][c];
    }
}

/* The difference of two vertices of a view. */
PSC_LANE void edge_between(const struct psc_polygon_view *view, int from, int to,
                           struct psc_word2 *edge)
{
    int c;

    for (c = 0; c < 3; c++) {
        two_sum(view->vertex[to][c], -view->vertex[from][c], &edge->high[c], &edge->low[c]);
        edge->low[c] += view->low[to][c] - view->low[from][c];
        two_sum(edge->high[c], edge->low[c], &edge->high[c], &edge->low[c]);
    }
}

/* The height of a vertex above the plane with normal n, which has length 1 / shrink. */
PSC_LANE double height_of(const double n[3], double shrink, const double high[3],
                          const double low[3])
{
    double sum = 0.0, error = 0.0;
    int c;

    for (c = 0; c < 3; c++)
        add_product(n[c], high[c], &sum, &error);
    return (sum + (error + dot(n, low))) * shrink;
}

#endif
