/* SPDX-License-Identifier: Apache-2.0 */
/* What a receiver sees of an elliptical disk: lane functions, the same for one element and for
   many. */
#ifndef PSC_SRC_ELLIPSE_LOOK_H
#define PSC_SRC_ELLIPSE_LOOK_H

#include "disk_side.h"
#include "ellipse_view.h"

struct psc_ellipse_look {
    double scale, unit;         /* a power of two that makes lengths about 1, and its inverse */
    struct psc_wide offset[3];  /* of the centre, in units of `unit`, as are the semi-axes */
    double axes[2][3];
    struct psc_outline outline; /* likewise */
    double outward[3], facing;  /* the unit normal; -1 for a receiver in front of the disk */
    double parallelogram, area; /* of the semi-axes; of the disk, in the caller's units */
    double height;              /* of the receiver over the plane */
    double shrink;              /* a power of two that makes the parallelogram about 1 */
    struct psc_wide n[3], nn;   /* the product of the semi-axes times that, and its square */
    double seen;                /* 0 if nothing is */
};

/* How the receiver lies to the plane; geometry is the centre and two conjugate semi-axes. */
PSC_LANE void face_ellipse(const double position[3], const double *geometry,
                           struct psc_ellipse_look *o)
{
    double high[3], size, length, height;
    int i, k;

    for (i = 0; i < 3; i++)
        high[i] = geometry[i] - position[i];
    size = MAX(largest(geometry + 3), largest(geometry + 6));
    o->scale = unit_scale(MAX(largest(high), size));
    o->unit = unit_inverse(o->scale);
    see_offset(position, geometry, o->scale, o->offset);
    PSC_UNROLL
    for (k = 0; k < 2; k++)
        PSC_UNROLL
        for (i = 0; i < 3; i++)
            o->axes[k][i] = geometry[3 + 3 * k + i] * o->scale;
    exact_cross(o->axes[0], o->axes[1], o->n);
    for (i = 0; i < 3; i++)
        high[i] = o->n[i].high;
    o->shrink = unit_scale(largest(high));
    PSC_UNROLL
    for (i = 0; i < 3; i++)
        o->n[i] = wide_times(o->shrink, o->n[i]);
    o->nn = wide_dot(o->n, o->n);
    height = wide_dot(o->n, o->offset).high;
    length = SQRT(o->nn.high);
    o->parallelogram = length * unit_inverse(o->shrink);
    o->area = PSC_PI * o->parallelogram * o->unit * o->unit;
    o->facing = COPYSIGN(1.0, height);
    length = 1.0 / length;
    o->height = ABS(height) * length;
    for (i = 0; i < 3; i++)
        o->outward[i] = o->n[i].high * length;
}

/* For samples by area: the frame of struct psc_laid, and that. */
PSC_LANE void lay_ellipse(const struct psc_ellipse_look *o, double frame[3][3], struct psc_laid *f)
{
    const double high[3] = {o->offset[0].high, o->offset[1].high, o->offset[2].high};
    const double length = SQRT(dot(o->axes[0], o->axes[0])), per = 1.0 / length;
    int i;

    for (i = 0; i < 3; i++) {
        frame[0][i] = o->axes[0][i] * per;
        frame[2][i] = o->facing * o->outward[i];
    }
    cross_rounded(frame[2], frame[0], frame[1]);
    f->x = dot(high, frame[0]);
    f->y = dot(high, frame[1]);
    f->height = o->height;
    f->a = length;
    f->skew = dot(o->axes[1], frame[0]);
    f->b = o->facing * o->parallelogram * per;
    f->scale = PSC_PI * o->height * o->parallelogram;
}

/* The outline of what face_ellipse() left. If `many`, in a loop. */
PSC_LANE void look_at_ellipse(int many, struct psc_ellipse_look *o)
{
    struct psc_wide across[2][3], s, t, square;
    double high[3], up[3], foot[3], per;
    int i;

    scaled_cross(o->axes[1], o->offset, across[0]);
    scaled_cross(o->axes[0], o->offset, across[1]);
    PSC_UNROLL
    for (i = 0; i < 3; i++) {
        across[0][i] = wide_times(o->shrink, across[0][i]);
        across[1][i] = wide_times(o->shrink, across[1][i]);
        high[i] = o->offset[i].high;
        up[i] = o->facing * o->outward[i];
    }
    s = wide_negative(wide_dot(across[0], o->n));
    t = wide_dot(across[1], o->n);
    square = wide_sum(wide_square(s), wide_square(t));
    per = 1.0 / o->nn.high;
    foot[0] = s.high * per;
    foot[1] = t.high * per;
    foot[2] = wide_sum(square, wide_negative(wide_square(o->nn))).high * per * per;
    see_elliptical(o->axes[0], o->axes[1], up, o->parallelogram, o->facing, high, o->height,
                   foot, many, &o->outline);
    o->seen = o->outline.seen.bt;
}

/* The i-th component of the k-th semi-axis that directions are projected along, see
   ellipse_view.h. */
PSC_LANE double ellipse_across(const struct psc_ellipse_look *o, int k, int i)
{
    const double *const side = o->outline.side[k];

    return o->unit * (side[0] * o->axes[0][i] + side[1] * o->axes[1][i]);
}

#endif
