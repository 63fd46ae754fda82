/* SPDX-License-Identifier: Apache-2.0 */
/* What a sampler keeps of a polygon by projected solid angle. */
#ifndef PSC_SRC_SECTOR_LIGHT_H
#define PSC_SRC_SECTOR_LIGHT_H

#include "polygon_view.h"
#include "sector.h"

/* Heights of a polygon that is flat to rounding may change sign at each vertex of an edge along
   the horizon. */
enum {
    PSC_MAX_RING = PSC_MAX_VERTICES + PSC_MAX_VERTICES / 2,
    PSC_MAX_CORNERS = 2 * PSC_MAX_RING + 2,
    PSC_MAX_SECTORS = 44
};

/* The part of the light on one side of the receiver's plane: which sectors and edges are its own,
   and the receiver's frame, z towards this side. */
struct psc_sector_side {
    double x[3], y[3], z[3], total;
    int sector, sectors, edge, edges;
};

struct psc_sector_light {
    struct psc_sector sector[PSC_MAX_SECTORS];
    struct psc_sector_hit hit[PSC_MAX_SECTORS];
    struct psc_sector_side side[2];
    double edge[2 * PSC_MAX_RING][3]; /* normals of the planes around, inwards; of a side */
    double pivot[3];                  /* the first vertex in world space */
    struct {
        double offset[3], place[2]; /* from there, and on the light's surface */
    } corner[PSC_MAX_CORNERS];
};

#endif
