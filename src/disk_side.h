/* SPDX-License-Identifier: Apache-2.0 */
/* What a sampler keeps of a light that is seen as an elliptic cone: disks, elliptical disks and
   ellipsoids. */
#ifndef PSC_SRC_DISK_SIDE_H
#define PSC_SRC_DISK_SIDE_H

#include "ellipse_cdf.h"
#include "fibres.h"

/* Rules of interpolation, by the smallest quotient cos alpha / cos beta that each serves: nodes,
   steps of fit_node(). */
#define PSC_RULES_F64(X) \
    X(0, 4, 1, 0.9995)   \
    X(1, 6, 1, 0.99)     \
    X(2, 8, 2, 0.95)     \
    X(3, 12, 2, 0.83)    \
    X(4, 16, 2, 0.7)     \
    X(5, 24, 2, PSC_ELLIPSE_REGULAR)
#define PSC_RULES_F32(X) \
    X(0, 3, 1, 0.97)     \
    X(1, 4, 1, 0.9)      \
    X(2, 6, 1, 0.7)      \
    X(3, 10, 1, PSC_ELLIPSE_REGULAR)
#define PSC_MOST_TERMS_F64 24
#define PSC_MOST_TERMS_F32 12

/* The same of the parallel map, see span_fit_tmpl.h, by the smallest cos alpha: the share of a
   chord to 2e-15 at the lower end of the last rule and 1e-16 elsewhere, 4e-8 in float. */
#define PSC_SPAN_RULES_F64(X) \
    X(0, 6, 1, 0.997)         \
    X(1, 8, 1, 0.97)          \
    X(2, 12, 2, 0.83)         \
    X(3, 16, 2, 0.66)         \
    X(4, 24, 2, 0.36)
#define PSC_SPAN_RULES_F32(X) \
    X(0, 4, 1, 0.98)          \
    X(1, 6, 1, 0.84)          \
    X(2, 12, 2, 0.36)

enum psc_disk_map {
    PSC_DISK_RADIAL,
    PSC_DISK_CONCENTRIC,
    PSC_DISK_PARALLEL,
    PSC_DISK_QUASI_UNIFORM,
    PSC_DISK_TABULATED,
    PSC_DISK_AREA_RADIAL,
    PSC_DISK_AREA_CONCENTRIC,
    PSC_DISK_AREA_PARALLEL,
    /* From inside an ellipsoid, all directions. */
    PSC_DISK_AROUND_RADIAL,
    PSC_DISK_AROUND_CONCENTRIC,
    PSC_DISK_AROUND_PARALLEL,
    /* By projected solid angle, see fibre_density.h. */
    PSC_DISK_FIBRES
};

/* What the density of a direction follows from. */
enum psc_disk_density { PSC_DISK_CONSTANT, PSC_DISK_BY_AREA, PSC_DISK_QUASI };

static inline enum psc_disk_density disk_density_of(enum psc_disk_map map)
{
    return map == PSC_DISK_QUASI_UNIFORM ? PSC_DISK_QUASI
           : map >= PSC_DISK_AREA_RADIAL && map <= PSC_DISK_AREA_PARALLEL ? PSC_DISK_BY_AREA
                                                                          : PSC_DISK_CONSTANT;
}

/* How a direction finds its point of the light. */
enum psc_disk_hit {
    PSC_DISK_HIT_FLAT,
    PSC_DISK_HIT_CHORD, /* by the parallel map */
    PSC_DISK_HIT_SOLID,
    PSC_DISK_HIT_SOLID_CHORD,
    PSC_DISK_HIT_AREA,
    PSC_DISK_HIT_INSIDE
};

static inline enum psc_disk_hit disk_hit_of(enum psc_disk_map map, int solid)
{
    return map >= PSC_DISK_AROUND_RADIAL ? PSC_DISK_HIT_INSIDE
           : map >= PSC_DISK_AREA_RADIAL ? PSC_DISK_HIT_AREA
           : map == PSC_DISK_PARALLEL    ? (solid ? PSC_DISK_HIT_SOLID_CHORD : PSC_DISK_HIT_CHORD)
           : solid                       ? PSC_DISK_HIT_SOLID
                                         : PSC_DISK_HIT_FLAT;
}

/*
 * How a flat light lies to a receiver that samples it by area, in units of `reach`: the vector to
 * the point (s, t) of the light is
 *     (x + a s + skew t) i + (y + b t) j + height n,
 * with n the normal away from the receiver, and i, j, n where a cone has its frame.
 */
struct psc_laid {
    double x, y, height, a, skew, b;
    double scale; /* pi height |a b|: the density at the distance r is r^3 / scale */
};

/* Numbers of the geometry, at most. */
#define PSC_DISK_NUMBERS 12

struct psc_disk_light {
    struct psc_ellipse seen;
    double axis[3]; /* what an offset from the axis is added to: seen.z; 0 by area */
    enum psc_disk_map map;
    const float *shares; /* of PSC_DISK_TABULATED: the row of the table, with one more than cells */
    uint32_t cells;
    int rule_f64, rule_f32; /* -1: none, disk_solve.h */
    double fit_f64[3 * PSC_MOST_TERMS_F64]; /* or a span */
    float fit_f32[3 * PSC_MOST_TERMS_F32];
    struct psc_cdf cdf;

    /* The hit, see ellipse_view.h: point = center + q_x across[0] + q_y across[1]. */
    double near, far, turn[2], side[2][2], reach;
    double center[3], across[2][3];
    double receiver[3]; /* unit normal of the receiver, or 0 */
    double normal[3]; /* of a flat light */
    double area;      /* likewise */
    struct psc_laid laid;

    /* An ellipsoid, seen from the distance `far_off` in the units in which it is the unit sphere:
       solid_axis[2] is from the receiver to the centre, inverse the transposed inverse of
       solid_axis in units of 1 / unit. */
    int solid, inside;
    double far_off, beyond; /* and beyond^2 = far_off^2 - 1, negated from inside */
    double solid_axis[3][3], inverse[3][3], unit;
    double offset[3]; /* from inside, of the centre, in those units */

    /* Projected solid angle, by sides of the receiver's plane. */
    struct psc_horizon horizon;
    struct psc_fibres fibres[2];

    /* What this was built with, for questions in other measures: of receivers with a normal, and by
       area. */
    double given_position[3], given_normal[3], given[PSC_DISK_NUMBERS];
    int numbers;
};

#endif
