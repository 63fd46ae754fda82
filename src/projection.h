/* SPDX-License-Identifier: Apache-2.0 */
/* Polygons by projected solid angle: both sides of the receiver's plane, and what a hit needs. */
#ifndef PSC_SRC_PROJECTION_H
#define PSC_SRC_PROJECTION_H

#include "sector_zenith.h"

/* The vertices of a light: from the first in world space, and on its surface. */
struct psc_projection {
    const double (*offset)[3], (*place)[2];
};

/* A corner from the shares of some others, or of vertices. */
PSC_LANE void add_corner(struct psc_sector_light *o, int to, const double *offset,
                              const double *place, double share)
{
    int c;

    for (c = 0; c < 3; c++)
        o->corner[to].offset[c] += share * offset[c];
    for (c = 0; c < 2; c++)
        o->corner[to].place[c] += share * place[c];
}

PSC_LANE void vertex_corner(const struct psc_projection *what, int vertex,
                            struct psc_sector_light *o, int to)
{
    copy3(what->offset[vertex], o->corner[to].offset);
    o->corner[to].place[0] = what->place[vertex][0];
    o->corner[to].place[1] = what->place[vertex][1];
}

/* From the nearer one on: coordinates on the surface may be large, and each of their roundings
   moves the point. */
PSC_LANE double between(double a, double b, const double share[2])
{
    return share[1] <= 0.5 ? a + share[1] * (b - a) : b + share[0] * (a - b);
}

static inline void ring_corners(const struct psc_projection *what, const struct psc_ring *ring,
                                int base, struct psc_sector_light *o)
{
    int i, k;

    for (i = 0; i < ring->count; i++) {
        const struct psc_ring_point *const p = ring->point[i];
        const int a = p->vertex[0], b = p->vertex[1];

        if (a == b) {
            vertex_corner(what, a, o, base + i);
            continue;
        }
        for (k = 0; k < 3; k++)
            o->corner[base + i].offset[k] =
                between(what->offset[a][k], what->offset[b][k], p->share);
        for (k = 0; k < 2; k++)
            o->corner[base + i].place[k] = between(what->place[a][k], what->place[b][k], p->share);
    }
}

static inline void ring_edges(const struct psc_ring *ring, struct psc_sector_side *side,
                              struct psc_sector_light *o)
{
    int i;

    side->edges = ring->count;
    for (i = 0; i < ring->count; i++)
        copy3(ring->edge[i], o->edge[side->edge + i]);
}

/* Of a plain build: whether the outer edges turn enough about the normal. */
PSC_LANE void doubt_turn(const struct psc_ring *ring, struct psc_sectors *to)
{
    double turn = 0.0;
    int i;

    for (i = 0; i < ring->count; i++)
        turn += MAX(ring->edge[i][2], 0.0);
    to->doubtful |= !(turn * turn > 0x1p4 * to->reach * to->wide);
}

/* The sectors of one side; `base` is the number of its first corner. Returns its projected solid
   angle. */
PSC_LANE double project_side(int plain, const struct psc_projection *what,
                             const struct psc_ring *ring, int base, struct psc_sectors *to,
                             struct psc_sector_light *o)
{
    int outer[2], inner[2], around;

    to->sum = 0.0;
    if (ring->count < 3)
        return 0.0;
    around = !find_chains(plain, ring, outer, inner);
    if (plain) {
        doubt_turn(ring, to);
        if (around)
            doubt_zenith(ring, to);
        if (to->doubtful)
            return 0.0;
    }
    ring_corners(what, ring, base, o);
    if (!around) {
        chain_sectors(plain, ring, outer, inner, base, to);
    } else {
        int corner[3], i;
        double share[3];
        const double high = find_zenith(plain, ring, corner, share);

        memset(o->corner + base + ring->count, 0, sizeof o->corner[0]);
        for (i = 0; i < 3; i++)
            add_corner(o, base + ring->count, o->corner[base + corner[i]].offset,
                       o->corner[base + corner[i]].place, share[i]);
        zenith_sectors(ring, base, base + ring->count, MAX(high, 0x1p-200), to);
    }
    return MIN(0.5 * to->sum, PSC_PI);
}

/* Fills all but the pivot from a view, which is mirrored when both sides of the receiver's plane
   count; whole: what is_whole() says of it. Returns the number of sides with any projected solid
   angle, which are put first; plain: -1 where that will not do. */
PSC_LANE int project_view(int plain, const struct psc_projection *what, int both, int whole,
                          double reach, double wide, struct psc_receiver_view *view,
                          struct psc_sector_light *o)
{
    struct psc_sectors to = {o->sector, o->hit, 0, 0, 0.0, reach, wide, 0};
    struct psc_ring ring;
    int side, sides = 0, corners = 0, edges = 0;

    /* Without halvings there are fewer sectors than points. */
    to.halvings = PSC_MAX_SECTORS - (whole ? view->count : most_points(view, both));
    for (side = 0; side <= (both && !whole); side++) {
        struct psc_sector_side *const at = o->side + sides;

        if (side == 1)
            mirror_view(plain, view);
        if (whole)
            whole_ring(view, &ring);
        else
            clip_ring(plain, view, &ring);
        at->sector = to.count;
        at->edge = edges;
        at->total = project_side(plain, what, &ring, corners, &to, o);
        at->sectors = to.count - at->sector;
        if (!(at->total > 0.0))
            continue;
        copy3(view->frame[0], at->x);
        copy3(view->frame[1], at->y);
        copy3(view->frame[2], at->z);
        share_sectors(&to, at->sector);
        ring_edges(&ring, at, o);
        edges += ring.count;
        corners += ring.count + 1;
        sides++;
    }
    return to.doubtful ? -1 : sides;
}

/* The same of a light in two words. both: what is below the receiver's plane counts too. */
static int project(const struct psc_projection *what, int both, struct psc_receiver_view *view,
                   struct psc_sector_light *o)
{
    return project_view(0, what, both, is_whole(view), 0.0, 0.0, view, o);
}

#endif
