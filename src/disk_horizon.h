/* SPDX-License-Identifier: Apache-2.0 */
/*
 * How the receiver's horizon lies to the cone of a light, accurate relative to the light's size
 * and, in `margin`, to how little the horizon cuts it: the receiver's normal N enters through its
 * products with the light's own vectors, in two words, not with the frame of the cone.
 *
 * With the semi-axes g1, g2 and the offset c of an elliptical disk, a column of the cone times its
 * length is a Lorentz transform of (g1 g2 c): so are the products with N, and
 *     (N.g1)^2 + (N.g2)^2 - (N.c)^2 = reach^2 (x^2 + y^2 - z^2).
 */
#ifndef PSC_SRC_DISK_HORIZON_H
#define PSC_SRC_DISK_HORIZON_H

#include "ellipse_view.h"
#include "fibres.h"

/* From the frame: where the cone is wide, nothing is lost by that. */
static inline void horizon_of_frame(const struct psc_ellipse *e, const double normal[3],
                                    double length, struct psc_horizon *h)
{
    h->x = MIN(e->at, PSC_WIDEST_TANGENT) * (dot(normal, e->x) / length);
    h->y = MIN(e->bt, PSC_WIDEST_TANGENT) * (dot(normal, e->y) / length);
    h->z = dot(normal, e->z) / length;
    h->margin = (h->x * h->x + h->y * h->y) - h->z * h->z;
}

/* A circular disk with its own normal, as face_disk() has it; N has its largest component in
   [1,2). */
static inline void disk_horizon(const struct psc_wide offset[3], const double normal[3],
                                double radius, const struct psc_outline *o,
                                const double receiver[3], struct psc_horizon *h)
{
    struct psc_wide n[3], up[3], tilt[3], nn, nc, vv, up_c, up_n, rr, difference;
    double square, length, own, aside, outwards, foot;

    wide_vector(normal, n);
    wide_vector(receiver, up);
    square = wide_dot(up, up).high;
    length = SQRT(square);
    horizon_of_frame(&o->seen, receiver, length, h);
    nn = wide_dot(n, n);
    nc = wide_dot(n, offset);
    up_c = wide_dot(up, offset);
    up_n = wide_dot(up, n);
    rr = wide_square(wide_of(radius));
    own = SQRT(nn.high);
    wide_cross(n, offset, tilt);
    vv = wide_dot(tilt, tilt);
    /* radius^2 |N x n|^2 - (N.c)^2 |n|^2 */
    wide_cross(up, n, tilt);
    difference = wide_difference(rr, wide_dot(tilt, tilt), wide_square(up_c), nn);
    if (o->seen.at < PSC_WIDEST_TANGENT)
        h->margin = difference.high / (nn.high * square) / (o->reach * o->reach);
    if (!(vv.high > 0.0))
        return;
    /* N along the foot, in the plane towards the centre: N x n.c - ... over |n| |n x c| */
    foot = wide_difference(up_c, nn, up_n, nc).high / (own * SQRT(vv.high) * length);
    aside = SQRT(vv.high) / own;
    if (o->seen.at < 1.0) {
        const double ca = o->seen.ca, cb = o->seen.cb;
        const double sinh = aside * radius * ca * cb / (o->reach * o->reach);

        h->z = (cb / ca * (up_c.high / length) - sinh * (radius * foot)) / o->reach;
    } else if (o->seen.bt < 1.0 && o->seen.at < PSC_WIDEST_TANGENT) {
        /* from the directions of the nearest and the farthest point of the rim */
        const double gap = wide_sum(vv, wide_negative(wide_product(rr, nn))).high /
                           (nn.high * (aside + radius));

        outwards = ABS(nc.high) / own * (COPYSIGN(1.0, nc.high) * up_n.high / (own * length));
        h->z = 0.5 *
               (o->far * (gap * foot + outwards) + o->near * ((aside + radius) * foot + outwards)) /
               o->reach;
    }
}

/*
 * Any other light, from its semi-axes: those of an elliptical disk, or the three of an ellipsoid,
 * whose outline is that of a disk with two combinations f of them, and the offset times kappa.
 */
static inline void light_horizon(const struct psc_outline *o, const double receiver[3],
                                 const struct psc_wide (*axes)[3], int count, const double (*f)[3],
                                 const struct psc_wide offset[3], double kappa,
                                 struct psc_horizon *h)
{
    const double length = SQRT(dot(receiver, receiver)), scale = o->reach * length;
    struct psc_wide up[3], along[3], high, sum;
    double part[3], seen[3];
    int i;

    horizon_of_frame(&o->seen, receiver, length, h);
    if (!(o->seen.at < PSC_WIDEST_TANGENT))
        return;
    wide_vector(receiver, up);
    high = wide_dot(up, offset);
    sum = wide_negative(wide_square(high));
    for (i = 0; i < count; i++) {
        along[i] = wide_dot(up, axes[i]);
        part[i] = along[i].high;
        sum = wide_sum(sum, wide_square(along[i]));
    }
    h->margin = sum.high / (scale * scale);
    if (o->seen.at < 1.0) {
        seen[0] = f ? dot(f[0], part) : part[0];
        seen[1] = f ? dot(f[1], part) : part[1];
        seen[2] = kappa * high.high;
        h->z = dot(o->turned, seen) / scale;
    } else {
        /* The square of (x, y) has the roundings of the frame times 2 |(x, y)| tan alpha, and as
           margin + z^2 about those of 1: the mean of the two that this leaves to be the best. */
        const double square = h->x * h->x + h->y * h->y;
        const double weight = 4.0 * square * (o->seen.at * o->seen.at);
        const double other = h->margin + (h->z * h->z - square);

        if (square > 0.0) {
            const double more = 0.5 * (other / square) * (weight / (weight + 1.0));

            h->x += more * h->x;
            h->y += more * h->y;
        }
    }
}

#endif
