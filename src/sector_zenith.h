/* SPDX-License-Identifier: Apache-2.0 */
/* From a ring around the zenith to sectors: one for each edge, the zenith for an inner edge. */
#ifndef PSC_SRC_SECTOR_ZENITH_H
#define PSC_SRC_SECTOR_ZENITH_H

#include "sector_chain.h"

/* The light's point at the zenith, from the triangle of the ring's fan that holds it: shares of its
   corners; returns how high it is. */
PSC_LANE double find_zenith(int plain, const struct psc_ring *ring, int corner[3],
                            double share[3])
{
    double best = -DBL_MAX, sum = 0.0, height = 0.0;
    int i, c;

    corner[0] = 0;
    corner[1] = 1;
    for (i = 1; i + 1 < ring->count; i++) {
        const double across = cross2(plain, ring->point[i + 1], ring->point[0]);
        const double before = cross2(plain, ring->point[0], ring->point[i]);
        const double least = MIN(across, before);

        corner[1] = least > best ? i : corner[1];
        best = MAX(least, best);
    }
    corner[2] = corner[1] + 1;
    for (c = 0; c < 3; c++) {
        const double opposite = cross2(plain, ring->point[corner[(c + 1) % 3]],
                                       ring->point[corner[(c + 2) % 3]]);

        share[c] = MAX(opposite, 0.0);
        height += share[c] * ring->point[corner[c]]->p.high[2];
        sum += share[c];
    }
    for (c = 0; c < 3; c++)
        share[c] /= sum;
    return height / sum;
}

/* Of a plain build: whether the zenith is away from all edges. */
PSC_LANE void doubt_zenith(const struct psc_ring *ring, struct psc_sectors *to)
{
    int i;

    for (i = 0; i < ring->count; i++)
        doubt_across(ring->point[i], ring->point[ring_next(ring, i)], 0.5 * ring->edge[i][2], to);
}

/* The end of a sector below the zenith, which is at the height high. */
static inline void end_at_zenith(const struct psc_ring_point *p, double high,
                                 struct psc_chain_end *end)
{
    end_at(p->p.high, end);
    end->rise = PSC_ZENITH_RISE / end->inverse;
    end->outer[0] = 0.0;
    end->outer[1] = 1.0;
    end->inner[0] = 0.0;
    end->inner[1] = end->rise / high;
}

/* Sectors of a light that holds the zenith; that is corner number `zenith`, at the height high. */
static inline void zenith_sectors(const struct psc_ring *ring, int base, int zenith, double high,
                                  struct psc_sectors *to)
{
    struct psc_chain_end first, second;
    int i;

    end_at_zenith(ring->point[0], high, &first);
    for (i = 0; i < ring->count; i++) {
        const int next = ring_next(ring, i);
        const int corner[4] = {base + i, base + next, zenith, zenith};

        begin_edge(first.outer);
        begin_edge(first.inner);
        end_at_zenith(ring->point[next], high, &second);
        emit_sector(to, &first, &second, ring->edge[i], 1.0, corner);
        first = second;
    }
}

#endif
