/* SPDX-License-Identifier: Apache-2.0 */
/* What a sampler keeps of a light that is seen as a spherical cap. */
#ifndef PSC_SRC_CAP_SIDE_H
#define PSC_SRC_CAP_SIDE_H

#include "lobe.h"

/* The maps of a cap, from spheres and distant lights alike: name, lane function, and whether
   float arithmetic holds its accuracy (1) or the float kernel works in double (0). */
#define PSC_CAP_MAPS(X)                          \
    X(RADIAL_CONE, radial_cone, 1)               \
    X(CONCENTRIC_CONE, concentric_cone, 1)       \
    X(RADIAL_ELLIPSE, radial_ellipse, 1)         \
    X(RADIAL_BOTH, radial_both, 1)               \
    X(RADIAL_LUNE, radial_lune, 0)               \
    X(PARALLEL_ELLIPSE, parallel_ellipse, 1)     \
    X(PARALLEL_BOTH, parallel_both, 1)           \
    X(PARALLEL_LUNE, parallel_lune, 1)           \
    X(CONCENTRIC_ELLIPSE, concentric_ellipse, 1) \
    X(CONCENTRIC_BOTH, concentric_both, 1)       \
    X(CONCENTRIC_LUNE, concentric_lune, 1)

#define PSC_CAP_ENUM(name, lane, native) PSC_CAP_##name,
enum psc_cap_map {
    PSC_CAP_MAPS(PSC_CAP_ENUM)
    PSC_CAP_RADIAL_AREA,
    PSC_CAP_CONCENTRIC_AREA
};
#undef PSC_CAP_ENUM

/* The part of a light above one side of the receiver's plane, and the frame of its lobe. */
struct psc_side {
    struct psc_lobe_f64 lobe;
    double x[3], y[3], z[3], axis[3];
    enum psc_cap_map map;
};

struct psc_cap_light {
    /* Of the sphere; a distant light has radius 0 and the distance infinity. */
    double center[3], radius, distance;
    int inside;
    double offset[3], slack; /* for a receiver inside, in radii: of the centre, and
                                radius^2 - distance^2 */

    struct psc_cap seen; /* for the totals in other measures; all 0 when it has no size */
    struct psc_side side[2];
};

#endif
