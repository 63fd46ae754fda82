/* SPDX-License-Identifier: Apache-2.0 */
/* The part of a polygon on one side of the receiver's plane: a ring of points and edges. */
#ifndef PSC_SRC_RING_H
#define PSC_SRC_RING_H

#include "fan_build.h"
#include "sector_light.h"

struct psc_ring_point {
    double p[3]; /* in the receiver's frame */
    /* p is at this vertex and an offset, and so are its coordinates on the light's surface: small
       differences of points are exact to rounding. */
    int at;
    double offset[3], place[2];
    int own;         /* except that this is not to be used */
    double scale;    /* p is the light's point times this */
    int vertex[2];   /* the light's point is between these vertices, */
    double share[2]; /* with these shares */
};

struct psc_ring {
    int count;
    struct psc_ring_point point[PSC_MAX_RING];
    double edge[PSC_MAX_RING][3]; /* cross product of a point and the next */
};

/* A polygon in the receiver's frame, from one side of its plane: below it, z is the other way
   round. */
struct psc_receiver_view {
    const struct psc_polygon_view *view;
    double frame[3][3];
    struct psc_ring_point point[PSC_MAX_VERTICES];
    double edge[PSC_MAX_VERTICES][3];
    const double (*place)[2]; /* coordinates of the vertices on the light's surface, if these are
                                 exact; otherwise NULL */
    double volume;            /* triple product of three points whose coordinates turn left around
                                 an area of 1/2 */
    int reversed;             /* the vertices run clockwise */
};

/* A vector in the receiver's frame. */
PSC_LANE void turn_into(const struct psc_receiver_view *view, const double v[3], double to[3])
{
    int i;

    for (i = 0; i < 3; i++)
        to[i] = dot(view->frame[i], v);
}

/* q - p. */
PSC_LANE void ring_step(const struct psc_receiver_view *view, const struct psc_ring_point *p,
                        const struct psc_ring_point *q, double step[3])
{
    const struct psc_polygon_view *const v = view->view;
    double between[3], turned[3];
    int c;

    for (c = 0; c < 3; c++)
        between[c] = (v->vertex[q->at][c] - v->vertex[p->at][c]) +
                     (v->low[q->at][c] - v->low[p->at][c]);
    turn_into(view, between, turned);
    for (c = 0; c < 3; c++)
        step[c] = p->own | q->own ? q->p[c] - p->p[c]
                                  : turned[c] + (q->offset[c] - p->offset[c]);
}

/* The same of coordinates on the light's surface. */
PSC_LANE void ring_place_step(const struct psc_receiver_view *view, const struct psc_ring_point *p,
                              const struct psc_ring_point *q, double step[2])
{
    int c;

    for (c = 0; c < 2; c++)
        step[c] = (view->place[q->at][c] - view->place[p->at][c]) + (q->place[c] - p->place[c]);
}

/* z of p x q; with the difference of the two, and the one nearer to the zenith's axis. */
PSC_LANE double cross2(const struct psc_receiver_view *view, const struct psc_ring_point *p,
                       const struct psc_ring_point *q)
{
    const int first = p->p[0] * p->p[0] + p->p[1] * p->p[1] <=
                      q->p[0] * q->p[0] + q->p[1] * q->p[1];
    double step[3];

    ring_step(view, p, q, step);
    return p->own | q->own ? product_difference(p->p[0], q->p[1], p->p[1], q->p[0])
                           : product_difference(first ? p->p[0] : q->p[0], step[1],
                                                first ? p->p[1] : q->p[1], step[0]);
}

/* x and y across a unit vector z [DBC17]. */
PSC_LANE void frame_across(const double z[3], double x[3], double y[3])
{
    const double sign = COPYSIGN(1.0, z[2]);
    const double a = -1.0 / (sign + z[2]), b = z[0] * z[1] * a;

    x[0] = 1.0 + sign * z[0] * z[0] * a;
    x[1] = sign * b;
    x[2] = -sign * z[0];
    y[0] = b;
    y[1] = sign + z[1] * z[1] * a;
    y[2] = -z[1];
}

PSC_LANE void vertex_words(const struct psc_polygon_view *view, int i, struct psc_word2 *to)
{
    int c;

    for (c = 0; c < 3; c++) {
        to->high[c] = view->vertex[i][c];
        to->low[c] = view->low[i][c];
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

/* The view from above, or mirrored from below. up is the normal with length 1, rounded. */
static inline void see_from_receiver(const struct psc_polygon_view *view, const double up[3],
                                     const double normal[3], const double *height,
                                     const double (*place)[2], double volume, int turns_left,
                                     int mirrored, struct psc_receiver_view *o)
{
    static const double none[3] = {0.0, 0.0, 0.0};
    const int n = view->count;
    double slip[2];
    int i, c;

    o->view = view;
    o->place = place;
    o->volume = mirrored ? -volume : volume;
    o->reversed = turns_left == mirrored;
    frame_across(up, o->frame[0], o->frame[1]);
    for (c = 0; c < 2; c++)
        slip[c] = height_of(normal, 1.0 / SQRT(dot(normal, normal)), o->frame[c], none);
    for (c = 0; c < 3; c++)
        o->frame[2][c] = mirrored ? -up[c] : up[c];
    for (i = 0; i < n; i++) {
        const int next = i + 1 < n ? i + 1 : 0;
        struct psc_ring_point *const p = o->point + i;
        struct psc_word2 edge, vertex;
        double across[3];

        /* The frame is perpendicular to rounding, which for a small light at the zenith is not
           enough. */
        for (c = 0; c < 2; c++)
            p->p[c] = height_of(o->frame[c], 1.0, view->vertex[i], view->low[i]) -
                      slip[c] * height[i];
        p->p[2] = mirrored ? 0.0 - height[i] : height[i];
        p->at = i;
        for (c = 0; c < 3; c++)
            p->offset[c] = 0.0;
        p->place[0] = p->place[1] = 0.0;
        p->own = 0;
        p->scale = 1.0;
        p->vertex[0] = p->vertex[1] = i;
        p->share[0] = 1.0;
        p->share[1] = 0.0;

        edge_between(view, i, next, &edge);
        vertex_words(view, i, &vertex);
        cross_words(&edge, &vertex, across);
        turn_into(o, across, o->edge[i]);
        /* A vector product does not mirror as the vectors do. */
        for (c = 0; c < 3; c++)
            o->edge[i][c] = mirrored ? o->edge[i][c] : -o->edge[i][c];
    }
    for (i = 0; i < n; i++) {
        const struct psc_ring_point *const p = o->point + i;
        const struct psc_ring_point *const q = o->point + (i + 1 < n ? i + 1 : 0);
        const double from = p->p[0] * p->p[0] + p->p[1] * p->p[1];
        const double till = q->p[0] * q->p[0] + q->p[1] * q->p[1];
        double step[3];

        /* Near the zenith its own cross product has the smaller error. */
        ring_step(o, p, q, step);
        if (dot(o->edge[i], o->edge[i]) >=
            MIN(from, till) * (step[0] * step[0] + step[1] * step[1]))
            o->edge[i][2] = cross2(o, p, q);
    }
}

PSC_LANE void add_point(struct psc_ring *ring, const struct psc_ring_point *p,
                        const double edge[3], double share)
{
    int c;

    ring->point[ring->count] = *p;
    for (c = 0; c < 3; c++)
        ring->edge[ring->count][c] = edge[c] * share;
    ring->count++;
}

/* Where the edge from a to b, with the cross product g, meets the horizon; up: on its way up.
   Returns the share of g that is the cross product of the part above. */
static inline double meet_horizon(const struct psc_receiver_view *view,
                                  const struct psc_ring_point *a, const struct psc_ring_point *b,
                                  const double g[3], int up, struct psc_ring_point *o)
{
    const double high = ABS(a->p[2]), deep = ABS(b->p[2]);
    const double tb = high / (high + deep), ta = deep / (high + deep);
    const double side = up ? -ta : tb;
    double length, reach, step[3];
    int c;

    ring_step(view, a, b, step);
    for (c = 0; c < 3; c++) {
        o->p[c] = a->p[c] * ta + b->p[c] * tb;
        o->offset[c] = step[c] * side;
    }
    o->at = up ? b->at : a->at;
    for (c = 0; c < 2; c++)
        o->place[c] = view->place ? (view->place[b->at][c] - view->place[a->at][c]) * side : 0.0;
    o->p[2] = 0.0;
    o->own = 0;
    o->scale = 1.0;
    o->vertex[0] = a->vertex[0];
    o->vertex[1] = b->vertex[0];
    o->share[0] = ta;
    o->share[1] = tb;
    length = SQRT(o->p[0] * o->p[0] + o->p[1] * o->p[1]);
    reach = ta * SQRT(dot(a->p, a->p));
    if (length < 0.1 * reach) {
        /* The vertices are nearly antipodal: from their plane. */
        const double across = SQRT(g[0] * g[0] + g[1] * g[1]), signed_reach = up ? -reach : reach;

        o->own = 1;
        o->p[0] = signed_reach * (g[1] / across);
        o->p[1] = -signed_reach * (g[0] / across);
        o->scale = reach / MAX(length, DBL_MIN);
        return (up ? deep : high) * (reach / across);
    }
    return up ? ta : tb;
}

/* The part with z >= 0, counterclockwise seen from the receiver, from the first vertex on, without
   edges that have no length. */
static inline void clip_ring(const struct psc_receiver_view *view, struct psc_ring *ring)
{
    const int reversed = view->reversed, n = view->view->count;
    int horizon[PSC_MAX_RING], i, k;

    ring->count = 0;
    for (k = 0; k < n; k++) {
        const int from = reversed ? (n - k) % n : k;
        const int to = reversed ? n - 1 - k : (k + 1) % n, edge = reversed ? to : from;
        const double flip = reversed ? -1.0 : 1.0;
        const double g[3] = {view->edge[edge][0] * flip, view->edge[edge][1] * flip,
                             view->edge[edge][2] * flip};
        const struct psc_ring_point *const a = view->point + from, *const b = view->point + to;
        const int leaves = (a->p[2] > 0.0) & (b->p[2] < 0.0);
        const int enters = (a->p[2] < 0.0) & (b->p[2] > 0.0);
        struct psc_ring_point meet;
        double above = 1.0;

        if (leaves | enters)
            above = meet_horizon(view, a, b, g, enters, &meet);
        if (a->p[2] >= 0.0) {
            horizon[ring->count] = (a->p[2] == 0.0) & (b->p[2] < 0.0);
            add_point(ring, a, g, above);
        }
        if (leaves | enters) {
            horizon[ring->count] = leaves;
            add_point(ring, &meet, g, above);
        }
    }
    for (i = 0; i < ring->count; i++)
        if (horizon[i]) {
            const double across =
                cross2(view, ring->point + i, ring->point + (i + 1 < ring->count ? i + 1 : 0));

            ring->edge[i][0] = ring->edge[i][1] = 0.0;
            ring->edge[i][2] = MAX(across, 0.0);
        }
    for (i = 0, k = 0; i < ring->count; i++)
        if (largest(ring->edge[i]) > 0.0) {
            ring->point[k] = ring->point[i];
            memcpy(ring->edge[k++], ring->edge[i], sizeof ring->edge[i]);
        }
    ring->count = k;
}

#endif
