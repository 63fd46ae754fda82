/* SPDX-License-Identifier: Apache-2.0 */
/* Polygons by projected solid angle: both sides of the receiver's plane, and what a hit needs. */
#ifndef PSC_SRC_PROJECTION_H
#define PSC_SRC_PROJECTION_H

#include "sector_chain.h"

/* A polygon as a receiver with a normal sees it. */
struct psc_projection {
    const struct psc_polygon_view *view;
    const double *up, *normal; /* up is the normal with length 1, rounded */
    int turns_left; /* the vertices run counterclockwise seen from the receiver */
    /* Of the vertices: from the first in world space, and on the light's surface. NULL: totals are
       all that is wanted. */
    const double (*offset)[3], (*place)[2];
};

/* A corner from the shares of some others, or of vertices. */
static inline void add_corner(struct psc_sector_light *o, int to, const double *offset,
                              const double *place, double share)
{
    int c;

    for (c = 0; c < 3; c++)
        o->corner[to].offset[c] += share * offset[c];
    for (c = 0; c < 2; c++)
        o->corner[to].place[c] += share * place[c];
}

static inline void ring_corners(const struct psc_projection *what, const struct psc_ring *ring,
                                int base, struct psc_sector_light *o)
{
    int i, k;

    memset(o->corner + base, 0, (size_t)(ring->count + 1) * sizeof o->corner[0]);
    for (i = 0; i < ring->count; i++)
        for (k = 0; k < 2; k++) {
            const int vertex = ring->point[i]->vertex[k];

            add_corner(o, base + i, what->offset[vertex], what->place[vertex],
                       ring->point[i]->share[k]);
        }
}

static inline void ring_edges(const struct psc_ring *ring, struct psc_sector_side *side,
                              struct psc_sector_light *o)
{
    int i, c;

    side->edges = ring->count;
    for (i = 0; i < ring->count; i++) {
        const double *const g = ring->edge[i];
        const double inverse = 1.0 / length_of(g[0], g[1], g[2]);

        for (c = 0; c < 3; c++)
            o->edge[side->edge + i][c] = g[c] * inverse;
    }
}

/* The sectors of one side; `base` is the number of its first corner. Returns its projected solid
   angle. */
static inline double project_side(const struct psc_projection *what,
                                  const struct psc_ring *ring, int base, struct psc_sectors *to,
                                  struct psc_sector_light *o)
{
    int outer[2], inner[2];

    to->sum = 0.0;
    if (ring->count < 3)
        return 0.0;
    if (what->offset)
        ring_corners(what, ring, base, o);
    if (find_chains(ring, outer, inner)) {
        chain_sectors(ring, outer, inner, base, to);
    } else {
        int corner[3], i;
        double share[3];
        const double high = find_zenith(ring, corner, share);

        for (i = 0; what->offset && i < 3; i++)
            add_corner(o, base + ring->count, o->corner[base + corner[i]].offset,
                       o->corner[base + corner[i]].place, share[i]);
        zenith_sectors(ring, base, base + ring->count, MAX(high, 0x1p-200), to);
    }
    return MIN(0.5 * to->sum, PSC_PI);
}

/* Fills all but the pivot; returns the number of sides with any projected solid angle, which are
   put first. both: the light below the receiver's plane counts too. */
static inline int project(const struct psc_projection *what, int both, struct psc_sector_light *o)
{
    struct psc_sectors to = {o->sector, o->hit, 0, 0, 0.0};
    struct psc_receiver_view view;
    struct psc_ring ring;
    int side, sides = 0, corners = 0, edges = 0;

    see_from_receiver(what->view, what->up, what->normal, !what->turns_left, &view);
    /* Without halvings there are fewer sectors than points. */
    to.halvings = PSC_MAX_SECTORS - most_points(&view, both);
    for (side = 0; side <= both; side++) {
        struct psc_sector_side *const at = o->side + sides;

        if (side == 1)
            mirror_view(&view);
        clip_ring(&view, &ring);
        at->sector = to.count;
        at->edge = edges;
        at->total = project_side(what, &ring, corners, &to, o);
        at->sectors = to.count - at->sector;
        if (!(at->total > 0.0))
            continue;
        copy3(view.frame[0], at->x);
        copy3(view.frame[1], at->y);
        copy3(view.frame[2], at->z);
        share_sectors(&to, at->sector);
        if (what->offset)
            ring_edges(&ring, at, o);
        edges += ring.count;
        corners += ring.count + 1;
        sides++;
    }
    return sides;
}

#endif
