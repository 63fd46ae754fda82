/* SPDX-License-Identifier: Apache-2.0 */
/*
 * What a receiver sees of an ellipsoid: lane functions, the same for one element and for many.
 *
 * With the semi-axes E = (e1 e2 e3) and c' = E^-1 c the ellipsoid is the unit sphere, and for
 * C = |c'| > 1 its outline that of the elliptical disk with the semi-axes E f1, E f2 across c' and
 * the centre kappa c, kappa^2 = (C - 1)(C + 1) / C^2:
 *     E E' - c c' = g1 g1' + g2 g2' - kappa^2 c c'.
 */
#ifndef PSC_SRC_ELLIPSOID_LOOK_H
#define PSC_SRC_ELLIPSOID_LOOK_H

#include "ellipse_view.h"

struct psc_ellipsoid_look {
    double scale, unit;        /* a power of two that makes lengths about 1, and its inverse */
    struct psc_wide offset[3]; /* of the centre, in units of `unit`, as are the semi-axes */
    double axes[3][3], cofactor[3][3], det;
    double center[3], far_off; /* c' and C */
    double square;             /* C^2 - 1: negative from inside */
    /* From outside. */
    double f[3][3];            /* a right-handed frame, the last along c' */
    double solid_axis[3][3], inverse[3][3]; /* E f, and the transposed inverse */
    double outer, kappa;       /* sqrt(C^2 - 1), and that over C */
    struct psc_outline outline;
};

/* geometry: centre, three conjugate semi-axes. */
PSC_LANE void look_at_ellipsoid(const double position[3], const double *geometry,
                                struct psc_ellipsoid_look *o)
{
    struct psc_wide cofactor[3][3], det, part[3];
    double rough[3], size, per;
    int i, k;

    PSC_UNROLL
    for (i = 0; i < 3; i++)
        rough[i] = geometry[i] - position[i];
    size = MAX(largest(geometry + 3), largest(geometry + 6));
    size = MAX(size, largest(geometry + 9));
    o->scale = unit_scale(MAX(largest(rough), size));
    o->unit = unit_inverse(o->scale);
    see_offset(position, geometry, o->scale, o->offset);
    PSC_UNROLL
    for (k = 0; k < 3; k++)
        PSC_UNROLL
        for (i = 0; i < 3; i++)
            o->axes[k][i] = geometry[3 + 3 * k + i] * o->scale;
    exact_cross(o->axes[1], o->axes[2], cofactor[0]);
    exact_cross(o->axes[2], o->axes[0], cofactor[1]);
    exact_cross(o->axes[0], o->axes[1], cofactor[2]);
    det = scaled_dot(o->axes[0], cofactor[0]);
    o->det = det.high;
    /* c' det, and (C^2 - 1) det^2 */
    part[0] = wide_dot(cofactor[0], o->offset);
    part[1] = wide_dot(cofactor[1], o->offset);
    part[2] = wide_dot(cofactor[2], o->offset);
    o->square = wide_sum(wide_dot(part, part), wide_negative(wide_square(det))).high /
                (det.high * det.high);
    per = 1.0 / det.high;
    PSC_UNROLL
    for (k = 0; k < 3; k++) {
        o->center[k] = part[k].high * per;
        PSC_UNROLL
        for (i = 0; i < 3; i++)
            o->cofactor[k][i] = cofactor[k][i].high;
    }
    o->far_off = SQRT(dot(o->center, o->center));
}

/* The semi-axes and the inverse in the frame f. */
PSC_LANE void turn_ellipsoid(struct psc_ellipsoid_look *o)
{
    const double per = 1.0 / o->det;
    int i, k;

    PSC_UNROLL
    for (k = 0; k < 3; k++)
        PSC_UNROLL
        for (i = 0; i < 3; i++) {
            o->solid_axis[k][i] = (o->f[k][0] * o->axes[0][i] + o->f[k][1] * o->axes[1][i]) +
                                  o->f[k][2] * o->axes[2][i];
            o->inverse[k][i] = ((o->f[k][0] * o->cofactor[0][i] + o->f[k][1] * o->cofactor[1][i]) +
                                o->f[k][2] * o->cofactor[2][i]) *
                               per;
        }
}

/* The rest, from outside. If `many`, in a loop. */
PSC_LANE void look_from_outside(int many, struct psc_ellipsoid_look *o)
{
    double normal[3], center[3], per = 1.0 / o->far_off, area;
    int i;

    PSC_UNROLL
    for (i = 0; i < 3; i++)
        o->f[2][i] = o->center[i] * per;
    perpendicular(o->f[2], o->f[0]);
    cross_rounded(o->f[2], o->f[0], o->f[1]);
    turn_ellipsoid(o);
    o->outer = SQRT(o->square);
    o->kappa = o->outer * per;
    area = SQRT(dot(o->inverse[2], o->inverse[2]));
    per = 1.0 / area;
    PSC_UNROLL
    for (i = 0; i < 3; i++) {
        center[i] = o->kappa * o->offset[i].high;
        normal[i] = o->inverse[2][i] * per;
    }
    see_elliptical(o->solid_axis[0], o->solid_axis[1], normal, area * ABS(o->det),
                   COPYSIGN(1.0, o->det), center, o->outer * per, NULL, many, &o->outline);
}

/* The first two of three vectors in the directions of q_x and q_y. */
PSC_LANE void turn_pair(const double side[2][2], double v[3][3])
{
    int i;

    PSC_UNROLL
    for (i = 0; i < 3; i++) {
        const double a = v[0][i], b = v[1][i];

        v[0][i] = side[0][0] * a + side[0][1] * b;
        v[1][i] = side[1][0] * a + side[1][1] * b;
    }
}

#endif
