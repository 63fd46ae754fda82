/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Polygons by projected solid angle in plain double arithmetic, which is as good as points of two
 * words for all but needles and lights that are edge-on or all but on the horizon; with the test
 * for these.
 *
 * L being the largest distance of a vertex from the first, R that from the receiver, D that from
 * the receiver's normal or L, u a rounding error: in the receiver's frame the first vertex is known
 * to a rounding of each coordinate, and differences of vertices are off by less than 5 u L. Sectors
 * are made of products of a point and an edge, whose z is then off by less than 12 u D L, and of
 * volumes of a point and two edges, off by less than 16 u R L^2: of the same share of the light
 * where
 *  - the volume of the whole is more than R L^2 / 16: no needle, and not edge-on;
 *  - the edges that bound it outwards have a z of more than D L / 16 in all;
 *  - all that is divided by, z of products of one edge and a vertex on the same azimuth, is more
 *    than 1/64 of D times the edge's length: see doubt_across();
 *  - a zenith within it has all edges 1/32 of D away, for next to it a rounding of its place on the
 *    light is much of a turn;
 *  - on each side of the receiver's plane that counts, the light reaches L / 8 far from it or is
 *    not there, so that heights are off by no more of that than 40 u;
 * and what rounding might choose it does not where
 *  - no vertex is within 2^-47 L of the receiver's plane;
 *  - z of an edge is more than 2^-47 D L, or the edge is vertical, or has no length.
 * The planes through the edges, for directions, are known where edges are seen by more than 1/16 of
 * R times their length. Squares leave room for the product of three of them.
 */
#ifndef PSC_SRC_PROJECTION_PLAIN_H
#define PSC_SRC_PROJECTION_PLAIN_H

#include <psc/psc.h>

#include "projection.h"
#include "triangle_plain.h"

/* A light as its vertices are given: the first from the receiver, all from the first. */
struct psc_plain_polygon {
    int count;
    struct psc_word2 first;
    const double (*offset)[3];
};

PSC_LANE void first_words(const double first[3], const double position[3], struct psc_word2 *to)
{
    int c;

    PSC_UNROLL
    for (c = 0; c < 3; c++)
        two_sum(first[c], -position[c], &to->high[c], &to->low[c]);
}

/* What is seen of one but for its sectors. */
struct psc_plain_look {
    struct psc_receiver_view view;
    double normal[3], volume; /* of the light, twice its area long; times the first vertex */
    double far, wide, across; /* squares of R, L and D */
    double longest;           /* and of the longest edge */
    int above, below;         /* whether any is above the receiver's plane, or below */
    int pointed;              /* whether an edge has no length */
};

/* x, y and z of a vector in the frame. */
PSC_LANE void turn_plain(const struct psc_receiver_view *view, const double v[3], double to[3])
{
    to[0] = dot(view->frame[0], v);
    to[1] = dot(view->frame[1], v);
    to[2] = dot(view->frame[2], v);
}

/* The frame, and the first vertex in it. */
PSC_LANE void begin_plain_view(const struct psc_plain_polygon *from, const double normal[3],
                               struct psc_receiver_view *view)
{
    const double shrink = 1.0 / SQRT(dot(normal, normal));
    double slip[2];

    scale3(shrink, normal, view->frame[2]);
    frame_across(view->frame[2], view->frame[0], view->frame[1]);
    frame_slip(view, normal, shrink, slip);
    turn_words(view, normal, shrink, slip, &from->first, &view->point[0].p);
}

/* The vertices as the receiver sees them; whether all are surely above its plane or below, and the
   volume is large. */
PSC_LANE int look_at_plain(const struct psc_plain_polygon *from, const double normal[3], int both,
                           struct psc_plain_look *o)
{
    struct psc_receiver_view *const view = &o->view;
    const struct psc_ring_point *const first = view->point;
    double nearest = DBL_MAX, highest = 0.0, deepest = 0.0;
    int i;

    begin_plain_view(from, normal, view);
    view->count = from->count;
    o->normal[0] = o->normal[1] = o->normal[2] = 0.0;
    o->far = o->wide = o->across = 0.0;
    for (i = 0; i < from->count; i++) {
        struct psc_ring_point *const p = view->point + i;
        double height2, across2, length2, turned[3];

        if (i > 0) {
            turn_plain(view, from->offset[i], p->offset.high);
            add3(first->p.high, p->offset.high, p->p.high);
        } else {
            p->offset.high[0] = p->offset.high[1] = p->offset.high[2] = 0.0;
        }
        if (i > 1) {
            cross_rounded(from->offset[i - 1], from->offset[i], turned);
            add3(o->normal, turned, o->normal);
        }
        p->vertex[0] = p->vertex[1] = i;
        p->share[0] = 1.0;
        p->share[1] = 0.0;
        highest = MAX(p->p.high[2], highest);
        deepest = MIN(p->p.high[2], deepest);
        height2 = p->p.high[2] * p->p.high[2];
        across2 = p->p.high[0] * p->p.high[0] + p->p.high[1] * p->p.high[1];
        length2 = dot(p->offset.high, p->offset.high);
        nearest = MIN(height2, nearest);
        o->across = MAX(across2, o->across);
        o->wide = MAX(length2, o->wide);
        length2 = across2 + height2;
        o->far = MAX(length2, o->far);
    }
    o->across = MAX(o->across, o->wide);
    o->above = highest > 0.0;
    o->below = deepest < 0.0;
    o->volume = dot(from->first.high, o->normal);
    return is_plain_normal(dot(normal, normal)) && o->far > 0x1p-320 && o->far < 0x1p320 &&
           o->wide > 0x1p-320 && nearest > 0x1p-94 * o->wide &&
           (!o->above || highest * highest > 0x1p-6 * o->wide) &&
           (!both || !o->below || deepest * deepest > 0x1p-6 * o->wide) &&
           o->volume * o->volume > 0x1p-8 * o->far * (o->wide * o->wide);
}

/* Products of all vertices and the next; whether all edges are seen, and turn in a sure sense. */
PSC_LANE int view_plain_edges(struct psc_plain_look *o)
{
    struct psc_receiver_view *const view = &o->view;
    int i, sure = 1;

    o->pointed = 0;
    o->longest = 0.0;
    for (i = 0; i < view->count; i++) {
        const struct psc_ring_point *const p = view->point + i;
        const struct psc_ring_point *const q = view->point + (i + 1 < view->count ? i + 1 : 0);
        double *const g = view->edge[i];
        double step[3], z2, flat2, long2;

        plain_step(p, q, step);
        cross_rounded(p->p.high, step, g);
        z2 = g[2] * g[2];
        flat2 = step[0] * step[0] + step[1] * step[1];
        long2 = flat2 + step[2] * step[2];
        o->pointed |= long2 == 0.0;
        o->longest = MAX(long2, o->longest);
        sure &= (g[0] * g[0] + g[1] * g[1]) + z2 >= 0x1p-8 * o->far * long2;
        sure &= (z2 > 0x1p-94 * o->across * o->wide) | (flat2 == 0.0);
    }
    return sure;
}

static int project_plain(struct psc_plain_look *look, const struct psc_projection *what, int both,
                         struct psc_sector_light *o)
{
    return project_view(1, what, both, !(look->below | look->pointed), 0x1p-12 * look->across,
                        look->wide, &look->view, o);
}

#endif
