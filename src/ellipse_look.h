/* SPDX-License-Identifier: Apache-2.0 */
/* What a receiver sees of an elliptical disk: a lane function, the same for one element and for
   many. */
#ifndef PSC_SRC_ELLIPSE_LOOK_H
#define PSC_SRC_ELLIPSE_LOOK_H

#include "ellipse_view.h"

struct psc_ellipse_look {
    double scale, unit;         /* a power of two that makes lengths about 1, and its inverse */
    struct psc_wide offset[3];  /* of the centre, in units of `unit`, as are the semi-axes */
    double axes[2][3];
    struct psc_outline outline; /* likewise */
    double outward[3], area;    /* the unit normal; in the caller's units */
    double facing;              /* -1 for a receiver in front of the disk */
    double seen;                /* 0 in the plane of the disk */
};

/* geometry: centre, two conjugate semi-axes. If `many`, in a loop. */
PSC_LANE void look_at_ellipse(const double position[3], const double *geometry, int many,
                              struct psc_ellipse_look *o)
{
    const double *const g1 = o->axes[0], *const g2 = o->axes[1];
    struct psc_wide n[3], foot[2][3], nn, s, t, nc, square;
    double high[3], rough[3], size, shrink, length, excess, area;
    int i, k;

    PSC_UNROLL
    for (i = 0; i < 3; i++)
        rough[i] = geometry[i] - position[i];
    size = MAX(largest(geometry + 3), largest(geometry + 6));
    o->scale = unit_scale(MAX(largest(rough), size));
    o->unit = 1.0 / o->scale;
    see_offset(position, geometry, o->scale, o->offset);
    PSC_UNROLL
    for (k = 0; k < 2; k++)
        PSC_UNROLL
        for (i = 0; i < 3; i++)
            o->axes[k][i] = geometry[3 + 3 * k + i] * o->scale;
    /* the foot is (-foot[0].n, foot[1].n) over n.n in the unit disk */
    exact_cross(g1, g2, n);
    scaled_cross(g2, o->offset, foot[0]);
    scaled_cross(g1, o->offset, foot[1]);
    for (i = 0; i < 3; i++) {
        rough[i] = o->offset[i].high;
        high[i] = n[i].high;
    }
    /* so that the squares of squares are numbers */
    shrink = unit_scale(largest(high));
    PSC_UNROLL
    for (i = 0; i < 3; i++) {
        n[i] = wide_times(shrink, n[i]);
        foot[0][i] = wide_times(shrink, foot[0][i]);
        foot[1][i] = wide_times(shrink, foot[1][i]);
    }
    nn = wide_dot(n, n);
    nc = wide_dot(n, o->offset);
    s = wide_dot(foot[0], n);
    t = wide_dot(foot[1], n);
    square = wide_sum(wide_square(s), wide_square(t));
    excess = wide_sum(square, wide_negative(wide_square(nn))).high / (nn.high * nn.high);
    length = SQRT(nn.high);
    area = length / shrink;
    o->area = PSC_PI * area * o->unit * o->unit;
    o->facing = COPYSIGN(1.0, nc.high);
    length = 1.0 / length;
    PSC_UNROLL
    for (i = 0; i < 3; i++) {
        o->outward[i] = n[i].high * length;
        high[i] = o->facing * o->outward[i];
    }
    see_elliptical(g1, g2, high, area, o->facing, rough, ABS(nc.high) * length, &excess, many,
                   &o->outline);
    o->seen = ABS(nc.high) > 0.0 ? o->outline.seen.bt : 0.0;
}

/* The i-th component of the k-th semi-axis that directions are projected along, see
   ellipse_view.h. */
PSC_LANE double ellipse_across(const struct psc_ellipse_look *o, int k, int i)
{
    const double *const side = o->outline.side[k];

    return o->unit * (side[0] * o->axes[0][i] + side[1] * o->axes[1][i]);
}

#endif
