/* SPDX-License-Identifier: Apache-2.0 */
/*
 * A polygon in the receiver's frame, z upwards. Points are kept in two words: what is left of the
 * differences and vector products of a sliver's points is then still exact to rounding. `plain`,
 * here and in what is built on it, is a constant: the first words alone count, see
 * projection_plain.h.
 */
#ifndef PSC_SRC_RECEIVER_VIEW_H
#define PSC_SRC_RECEIVER_VIEW_H

#include "fan_build.h"
#include "sector_light.h"

struct psc_ring_point {
    struct psc_word2 p, offset; /* in the receiver's frame; and from the first vertex */
    int vertex[2];              /* the light's point is between these vertices, */
    double share[2];            /* with these shares */
};

struct psc_receiver_view {
    int count;
    double frame[3][3];
    struct psc_ring_point point[PSC_MAX_VERTICES];
    double edge[PSC_MAX_VERTICES][3]; /* vector product of a point and the next */
    int clockwise;                    /* the vertices run so seen from the receiver */
};

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

/* ---- Two words ---- */

/* m . v */
PSC_LANE void dot_words(const double m[3], const struct psc_word2 *v, double *high, double *low)
{
    double sum, error;

    two_product(m[0], v->high[0], &sum, &error);
    add_product(m[1], v->high[1], &sum, &error);
    add_product(m[2], v->high[2], &sum, &error);
    error += dot(m, v->low);
    *high = sum + error;
    *low = (sum - *high) + error;
}

/* a b - c d, each of two words, rounded: components i of a and b and so on. */
PSC_LANE double words_difference(const struct psc_word2 *a, int i, const struct psc_word2 *b, int j)
{
    double p, pe, q, qe;

    two_product(a->high[i], b->high[j], &p, &pe);
    two_product(a->high[j], b->high[i], &q, &qe);
    return (p - q) + ((pe - qe) + ((a->high[i] * b->low[j] + a->low[i] * b->high[j]) -
                                   (a->high[j] * b->low[i] + a->low[j] * b->high[i])));
}

/* q - p. */
PSC_LANE void ring_step(const struct psc_ring_point *p, const struct psc_ring_point *q,
                        struct psc_word2 *step)
{
    int c;

    PSC_UNROLL
    for (c = 0; c < 3; c++) {
        two_sum(q->offset.high[c], -p->offset.high[c], &step->high[c], &step->low[c]);
        step->low[c] += q->offset.low[c] - p->offset.low[c];
    }
}

PSC_LANE void plain_step(const struct psc_ring_point *p, const struct psc_ring_point *q,
                         double step[3])
{
    subtract3(q->offset.high, p->offset.high, step);
}

/* z of p x q. */
PSC_LANE double cross2(int plain, const struct psc_ring_point *p, const struct psc_ring_point *q)
{
    struct psc_word2 step;

    if (plain) {
        plain_step(p, q, step.high);
        return p->p.high[0] * step.high[1] - p->p.high[1] * step.high[0];
    }
    ring_step(p, q, &step);
    return words_difference(&p->p, 0, &step, 1);
}

/* p x q. */
PSC_LANE void ring_cross(int plain, const struct psc_ring_point *p,
                         const struct psc_ring_point *q, double to[3])
{
    struct psc_word2 step;

    if (plain) {
        plain_step(p, q, step.high);
        cross_rounded(p->p.high, step.high, to);
        return;
    }
    ring_step(p, q, &step);
    to[0] = words_difference(&p->p, 1, &step, 2);
    to[1] = words_difference(&p->p, 2, &step, 0);
    to[2] = words_difference(&p->p, 0, &step, 1);
}

/* (p, q, r), the triple product. */
PSC_LANE double ring_volume(int plain, const struct psc_ring_point *p,
                            const struct psc_ring_point *q, const struct psc_ring_point *r)
{
    struct psc_word2 second, first;
    struct psc_triangle_view seen;

    if (plain) {
        plain_step(p, q, second.high);
        plain_step(p, r, first.high);
        cross_rounded(second.high, first.high, seen.normal);
        return dot(p->p.high, seen.normal);
    }
    ring_step(p, q, &second);
    ring_step(p, r, &first);
    see_volume(&p->p, &second, &first, &seen);
    return seen.volume;
}

/* ---- The view ---- */

/* x and y of the frame are perpendicular to the normal to rounding, which for a small light at the
   zenith is not enough: they slip by that much of the height. */
PSC_LANE void turn_words(const struct psc_receiver_view *view, const double normal[3],
                         double shrink, const double slip[2], const struct psc_word2 *v,
                         struct psc_word2 *to)
{
    double high, low, p, e;
    int c;

    dot_words(normal, v, &high, &low);
    two_product(high, shrink, &to->high[2], &to->low[2]);
    to->low[2] += low * shrink;
    for (c = 0; c < 2; c++) {
        dot_words(view->frame[c], v, &high, &low);
        two_product(slip[c], to->high[2], &p, &e);
        two_sum(high, -p, &high, &p);
        two_sum(high, p + (low - e), &to->high[c], &to->low[c]);
    }
}

/* By how much x and y of the frame are not perpendicular to the normal. */
PSC_LANE void frame_slip(const struct psc_receiver_view *view, const double normal[3],
                         double shrink, double slip[2])
{
    int c;

    for (c = 0; c < 2; c++) {
        double sum, error;

        two_product(normal[0], view->frame[c][0], &sum, &error);
        add_product(normal[1], view->frame[c][1], &sum, &error);
        add_product(normal[2], view->frame[c][2], &sum, &error);
        slip[c] = (sum + error) * shrink;
    }
}

/* Products of all points and the next. */
PSC_LANE void view_edges(struct psc_receiver_view *view)
{
    int i;

    for (i = 0; i < view->count; i++)
        ring_cross(0, view->point + i, view->point + (i + 1 < view->count ? i + 1 : 0),
                   view->edge[i]);
}

/* The view from above. up is the normal with length 1, rounded. */
static inline void see_from_receiver(const struct psc_polygon_view *view, const double up[3],
                                     const double normal[3], int clockwise,
                                     struct psc_receiver_view *o)
{
    const double shrink = 1.0 / SQRT(dot(normal, normal));
    double slip[2];
    int i, c;

    o->count = view->count;
    o->clockwise = clockwise;
    frame_across(up, o->frame[0], o->frame[1]);
    for (c = 0; c < 3; c++)
        o->frame[2][c] = up[c];
    frame_slip(o, normal, shrink, slip);
    memset(&o->point[0].offset, 0, sizeof o->point[0].offset);
    for (i = 0; i < view->count; i++) {
        struct psc_ring_point *const p = o->point + i;
        struct psc_word2 vertex, edge;

        vertex_words(view, i, &vertex);
        turn_words(o, normal, shrink, slip, &vertex, &p->p);
        if (i > 0) {
            edge_between(view, 0, i, &edge);
            turn_words(o, normal, shrink, slip, &edge, &p->offset);
        }
        p->vertex[0] = p->vertex[1] = i;
        p->share[0] = 1.0;
        p->share[1] = 0.0;
    }
    view_edges(o);
}

/* The same from below the receiver's plane, mirrored: z is downwards. */
PSC_LANE void mirror_view(int plain, struct psc_receiver_view *view)
{
    int i, c;

    view->clockwise = !view->clockwise;
    for (c = 0; c < 3; c++)
        view->frame[2][c] = -view->frame[2][c];
    for (i = 0; i < view->count; i++) {
        struct psc_ring_point *const p = view->point + i;

        p->p.high[2] = 0.0 - p->p.high[2];
        p->offset.high[2] = 0.0 - p->offset.high[2];
        if (!plain) {
            p->p.low[2] = 0.0 - p->p.low[2];
            p->offset.low[2] = 0.0 - p->offset.low[2];
        }
        /* A vector product does not mirror as the vectors do. */
        view->edge[i][0] = 0.0 - view->edge[i][0];
        view->edge[i][1] = 0.0 - view->edge[i][1];
    }
}

#endif
