/* SPDX-License-Identifier: Apache-2.0 */
/* Directions in the frame of a side: whether its sectors hold them, and the inverse of the map. */
#ifndef PSC_SRC_SECTOR_INVERSE_H
#define PSC_SRC_SECTOR_INVERSE_H

#include "sector_build.h"

/* Whether a direction is on this side of the receiver's plane and within all edges. */
static inline int side_holds(const struct psc_sector_light *l, const struct psc_sector_side *side,
                             const double direction[3], double slack, double local[3])
{
    int i, holds;

    local[0] = dot(side->x, direction);
    local[1] = dot(side->y, direction);
    local[2] = dot(side->z, direction);
    holds = local[2] > 0.0;
    for (i = 0; i < side->edges; i++) {
        const double *const g = l->edge[side->edge + i];

        holds &= dot(g, local) >= -slack * length_of(g[0], g[1], g[2]);
    }
    return holds;
}

/* The sector whose azimuths include that of p, or come next to it. */
static inline const struct psc_sector *find_sector(const struct psc_sector_light *l,
                                                   const struct psc_sector_side *side,
                                                   const double p[3])
{
    const struct psc_sector *best = l->sector + side->sector;
    double most = -DBL_MAX;
    int i;

    for (i = 0; i < side->sectors; i++) {
        const struct psc_sector *const s = l->sector + side->sector + i;
        const double after = s->ax * p[1] - s->ay * p[0], before = p[0] * s->by - p[1] * s->bx;
        const double within = MIN(after, before);

        best = within > most ? s : best;
        most = MAX(within, most);
    }
    return best;
}

/* u of the azimuth of p, v of its distance from the receiver's normal, both in the first sector
   that u belongs to. */
static inline void side_invert(const struct psc_sector_light *l,
                               const struct psc_sector_side *side, const double p[3],
                               double uv[2])
{
    const struct psc_sector *const s = find_sector(l, side, p);
    const double after = s->ax * p[1] - s->ay * p[0], before = p[0] * s->by - p[1] * s->bx;
    const double a = MAX(after, 0.0), b = MAX(before, 0.0);
    const double across = SQRT(p[0] * p[0] + p[1] * p[1]);
    const double share = a + b > 0.0 ? a / (a + b) : 0.5;
    const int upper = share >= 0.5;
    struct psc_sector_place node, at;
    double x, y, length, z, high, inside;

    sector_place(s, upper ? 0.75 : 0.25, &node);
    uv[0] = (upper ? s->last : s->quarter) + sector_mass(s, &node, share - (upper ? 0.75 : 0.25));

    /* W and U with the same x and y as p, which is scaled to those of the sector. */
    sector_place(s, share, &at);
    x = (1.0 - share) * s->ax + share * s->bx;
    y = (1.0 - share) * s->ay + share * s->by;
    length = SQRT(x * x + y * y);
    z = across > 0.0 ? p[2] * (length / across) : 0x1p100;
    z = MIN(z, 0x1p100);
    high = at.uz + at.d;
    inside = (high - z) * (high + z) * at.uu;
    uv[1] = inside / MAX((length * length + z * z) * at.q, DBL_MIN);
}

#endif
