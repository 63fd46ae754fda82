/* SPDX-License-Identifier: Apache-2.0 */
/* The part of a polygon on one side of the receiver's plane: a ring of points and edges. */
#ifndef PSC_SRC_RING_H
#define PSC_SRC_RING_H

#include "receiver_view.h"

struct psc_ring {
    int count;
    const struct psc_ring_point *point[PSC_MAX_RING];
    double edge[PSC_MAX_RING][3];                 /* vector product of a point and the next */
    struct psc_ring_point horizon[PSC_MAX_RING];  /* points that are not vertices */
};

PSC_LANE int ring_next(const struct psc_ring *ring, int i)
{
    return i + 1 < ring->count ? i + 1 : 0;
}

PSC_LANE int ring_last(const struct psc_ring *ring, int i)
{
    return i > 0 ? i - 1 : ring->count - 1;
}

PSC_LANE void add_point(struct psc_ring *ring, const struct psc_ring_point *p,
                        const double edge[3], double share)
{
    int c;

    ring->point[ring->count] = p;
    for (c = 0; c < 3; c++)
        ring->edge[ring->count][c] = edge[c] * share;
    ring->count++;
}

PSC_LANE int crosses_horizon(const struct psc_ring_point *a, const struct psc_ring_point *b)
{
    return (a->p.high[2] > 0.0 && b->p.high[2] < 0.0) || (a->p.high[2] < 0.0 && b->p.high[2] > 0.0);
}

/* How many points the ring above the receiver's plane has at most, or both. */
static inline int most_points(const struct psc_receiver_view *view, int both)
{
    int i, points = 0;

    for (i = 0; i < view->count; i++) {
        const struct psc_ring_point *const a = view->point + i;
        const struct psc_ring_point *const b = view->point + (i + 1 < view->count ? i + 1 : 0);

        points += (a->p.high[2] >= 0.0) + (both && a->p.high[2] <= 0.0) +
                  (1 + both) * crosses_horizon(a, b);
    }
    return points;
}

/* A component of v plus step, of two words. */
PSC_LANE void move_word(const struct psc_word2 *v, int c, double step, double step_low,
                        struct psc_word2 *to)
{
    double sum, rest;

    two_sum(v->high[c], step, &sum, &rest);
    two_sum(sum, rest + (step_low + v->low[c]), &to->high[c], &to->low[c]);
}

/* Where the edge from a to b meets the horizon. Returns how far from a, as a share of the edge. */
PSC_LANE double meet_horizon(int plain, const struct psc_ring_point *a,
                             const struct psc_ring_point *b, struct psc_ring_point *o)
{
    const double high = ABS(a->p.high[2]), deep = ABS(b->p.high[2]);
    double low, deep_low, sum, sum_low, share, share_low, product, error;
    struct psc_word2 step;
    int c;

    if (plain) {
        share = high / (high + deep);
        plain_step(a, b, step.high);
        for (c = 0; c < 3; c++) {
            o->p.high[c] = a->p.high[c] + share * step.high[c];
            o->offset.high[c] = a->offset.high[c] + share * step.high[c];
        }
    } else {
        low = COPYSIGN(1.0, a->p.high[2]) * a->p.low[2];
        deep_low = COPYSIGN(1.0, b->p.high[2]) * b->p.low[2];
        two_sum(high, deep, &sum, &sum_low);
        sum_low += low + deep_low;
        share = high / sum;
        two_product(share, sum, &product, &error);
        share_low = (((high - product) - error) + (low - share * sum_low)) / sum;
        ring_step(a, b, &step);
        for (c = 0; c < 3; c++) {
            two_product(share, step.high[c], &product, &error);
            error += share * step.low[c] + share_low * step.high[c];
            move_word(&a->p, c, product, error, &o->p);
            move_word(&a->offset, c, product, error, &o->offset);
        }
    }
    o->p.high[2] = o->p.low[2] = 0.0;
    o->vertex[0] = a->vertex[0];
    o->vertex[1] = b->vertex[0];
    o->share[0] = deep / (high + deep);
    o->share[1] = share;
    return share;
}

/* Whether z > 0 all over, and no edge is without a length. */
PSC_LANE int is_whole(const struct psc_receiver_view *view)
{
    int i, whole = 1;

    for (i = 0; i < view->count; i++)
        whole &= view->point[i].p.high[2] > 0.0 && largest(view->edge[i]) > 0.0;
    return whole;
}

/* Of such a light: all of it, counterclockwise. */
PSC_LANE void whole_ring(const struct psc_receiver_view *view, struct psc_ring *ring)
{
    const int clockwise = view->clockwise, n = view->count;
    int k;

    for (k = 0; k < n; k++) {
        const int from = clockwise && k > 0 ? n - k : k;

        ring->point[k] = view->point + from;
        scale3(clockwise ? -1.0 : 1.0, view->edge[clockwise ? n - 1 - k : k], ring->edge[k]);
    }
    ring->count = n;
}

/* The part with z >= 0, counterclockwise seen from the receiver, from the first vertex on, without
   edges that have no length. */
PSC_LANE void clip_ring(int plain, const struct psc_receiver_view *view, struct psc_ring *ring)
{
    const int clockwise = view->clockwise, n = view->count;
    int horizon[PSC_MAX_RING], i, k, meets = 0;

    ring->count = 0;
    for (k = 0; k < n; k++) {
        const int from = clockwise && k > 0 ? n - k : k;
        const int to = clockwise ? n - 1 - k : k + 1 < n ? k + 1 : 0;
        const double flip = clockwise ? -1.0 : 1.0;
        const double *const g = view->edge[clockwise ? to : from];
        const struct psc_ring_point *const a = view->point + from, *const b = view->point + to;
        const double high = a->p.high[2], next = b->p.high[2];
        const int crosses = crosses_horizon(a, b);
        double share = 0.0;

        if (crosses)
            share = meet_horizon(plain, a, b, ring->horizon + meets);
        if (high >= 0.0) {
            horizon[ring->count] = high == 0.0 && next < 0.0;
            add_point(ring, a, g, crosses ? flip * share : flip);
        }
        if (crosses) {
            horizon[ring->count] = high > 0.0;
            add_point(ring, ring->horizon + meets, g, flip * ring->horizon[meets].share[0]);
            meets++;
        }
    }
    for (i = 0; i < ring->count; i++)
        if (horizon[i]) {
            const double across = cross2(plain, ring->point[i], ring->point[ring_next(ring, i)]);

            ring->edge[i][0] = ring->edge[i][1] = 0.0;
            ring->edge[i][2] = MAX(across, 0.0);
        }
    for (i = 0, k = 0; i < ring->count; i++)
        if (largest(ring->edge[i]) > 0.0) {
            ring->point[k] = ring->point[i];
            copy3(ring->edge[i], ring->edge[k++]);
        }
    ring->count = k;
}

#endif
