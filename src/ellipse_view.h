/* SPDX-License-Identifier: Apache-2.0 */
/*
 * What a receiver sees of a light whose outline is an elliptic cone, and how the cone's directions
 * meet the light.
 *
 * In gnomonic coordinates scaled by the tangents of the semi-arcs, U = x / (at z) and
 * V = y / (bt z), the cone is the unit disk. An elliptical disk c + s g1 + t g2 is a unit disk in
 * (s,t), and the projection between the two unit disks is a motion of the Klein model of the
 * hyperbolic plane: a turn, a translation along y', and a turn,
 *     x' + i y' = (turn0 - i turn1) (U + i V),
 *     q_x = 2 x' / D,  q_y = (near (1 + y') - far (1 - y')) / D,  D = near (1 + y') + far (1 - y'),
 *     (s,t) = q_x side[0] + q_y side[1],   near far = 1.
 */
#ifndef PSC_SRC_ELLIPSE_VIEW_H
#define PSC_SRC_ELLIPSE_VIEW_H

#include "ellipse.h"
#include "ellipse_plate.h"
#include "wide.h"

struct psc_outline {
    struct psc_ellipse seen;
    double near, far, turn[2];
    double side[2][2];
    double turned[3]; /* z reach as a sum of the semi-axes and the offset; not of a circular disk */
    double reach; /* of the light along z: the receiver is at distance 2 reach / D of the light in
                     the direction whose gnomonic coordinates are divided by their z */
};

/* The vector from the receiver to the light in two words, in units of 1 / scale. */
PSC_LANE void see_offset(const double position[3], const double center[3], double scale,
                         struct psc_wide to[3])
{
    int i;

    for (i = 0; i < 3; i++) {
        two_sum(center[i], -position[i], &to[i].high, &to[i].low);
        to[i].high *= scale;
        to[i].low *= scale;
    }
}

/* How high the centre of a light is over the horizon of a normal, or over either side of that, and
   how far the light goes around it, from its semi-axes. */
PSC_LANE void see_horizon(const double normal[3], int both, const struct psc_wide offset[3],
                          const double axes[][3], int count, double *middle, double *reach)
{
    double n[3], height, sum = 0.0;
    int i;

    (void)scale_to_one(normal, n);
    for (i = 0; i < count; i++)
        sum += dot(n, axes[i]) * dot(n, axes[i]);
    height = scaled_dot(n, offset).high;
    *middle = both ? ABS(height) : height;
    *reach = SQRT(sum);
}

/* What is a unit vector but for roundings, and perpendicular to z but for these, made so. */
PSC_LANE void straighten(const double *z, double v[3])
{
    const double along = z ? dot(z, v) : 0.0;
    double size;
    int i;

    for (i = 0; z && i < 3; i++)
        v[i] -= along * z[i];
    size = 1.5 - 0.5 * dot(v, v);
    for (i = 0; i < 3; i++)
        v[i] *= size;
}

/*
 * An elliptical disk with the conjugate semi-axes g1, g2, normal = side (g1 x g2) / area its unit
 * normal away from the receiver and `height` that of the receiver over its plane. Its cone has the
 * dual matrix g1 g1' + g2 g2' - c c' = W J W', W = (g1 g2 c), J = diag(1, 1, -1); W V with V in
 * SO(2,1) gives the same, and the V that makes the columns of W V perpendicular has the axes of the
 * cone as these columns, the tangents as quotients of their lengths, and the projection. In the
 * frame of struct psc_plate, with lambda from there, tau = p q / (q^2 + lambda) and p' = p lambda /
 * (q^2 + lambda), the last column has the direction (x, -tau x, f h), and a boost along
 * (A, p') / L in the coordinates of the plate takes c there. Two columns perpendicular to it are
 * left, a triangular matrix with entries that are sums of one sign; its singular values and vectors
 * are the rest. See set_plate() for `foot`; if `many`, this is in a loop.
 */
PSC_LANE void see_elliptical(const double g1[3], const double g2[3], const double normal[3],
                             double area, double side, const double offset[3], double height,
                             const double *foot, int many, struct psc_outline *o)
{
    struct psc_ellipse *e = &o->seen;
    struct psc_plate k;
    double x, lambda, tau, tau2, slant, reach, per_reach, along, size, per, per_all, zi, zn;
    double length, flat, top, low, first, second, sinh, cosh, turn, across[3];
    double c1, s1, c2, s2, cl, sl, cr, sr;
    int i;

    set_plate(g1, g2, normal, area, side, offset, height, foot, &k);
    x = plate_root(&k, many);
    lambda = x + height * height;
    reach = SQRT(lambda);
    per_reach = 1.0 / reach;
    per = 1.0 / (k.q * k.q + lambda);
    tau = k.p * k.q * per;
    slant = k.p * lambda * per;
    tau2 = 1.0 + tau * tau;
    along = k.f > 0.0 ? x * k.per_foot : 0.0;
    size = 1.0 / SQRT(along * along * tau2 + height * height);
    zi = along * size;
    zn = height * size;
    for (i = 0; i < 3; i++)
        e->z[i] = zi * (k.axis[0][i] - tau * k.axis[1][i]) + zn * normal[i];
    straighten(NULL, e->z);

    /* what is left: the columns (flat, 0) and (top, low) in the directions -(tau i + j) and z
       across that */
    length = SQRT(k.a * k.a + slant * slant);
    size = SQRT(tau2);
    per_all = 1.0 / (length * (size * reach));
    per = per_all * (size * reach);
    flat = area * size * per;
    low = height * length * (per_all * length);
    top = -(k.f * zi * (slant * k.q) * tau2 +
            height * zn * (tau * (k.a * k.a + k.p * slant) + slant * k.q)) *
          per_all;
    second = half_angle(flat + low, -top, &c1, &s1);
    first = 0.5 * (second + half_angle(flat - low, top, &c2, &s2));
    second = flat * low / first;
    cl = c1 * c2 - s1 * s2;
    sl = s1 * c2 + c1 * s2;
    cr = c1 * c2 + s1 * s2;
    sr = c1 * s2 - s1 * c2;

    for (i = 0; i < 2; i++) {
        const double p = k.light[0][i], q = k.light[1][i];

        o->side[0][i] = (slant * p - k.a * q) * per;
        o->side[1][i] = (k.a * p + slant * q) * per;
    }
    sinh = zi * length * per_reach;
    cosh = (k.f * zi + height * zn) * per_reach;
    o->far = SQRT(1.0 + sinh * sinh) + sinh;
    o->near = 1.0 / o->far;
    o->reach = reach;
    o->turned[0] = -sinh * o->side[1][0];
    o->turned[1] = -sinh * o->side[1][1];
    o->turned[2] = cosh;
    /* the x axis has no sign of its own: s + t grows along it */
    turn = cr * (o->side[0][0] + o->side[0][1]) + sr * cosh * (o->side[1][0] + o->side[1][1]);
    turn = turn < 0.0 ? -1.0 : 1.0;
    o->turn[0] = turn * cr;
    o->turn[1] = -turn * sr;

    size = -(length * reach) * per_all;
    for (i = 0; i < 3; i++)
        across[i] = (tau * k.axis[0][i] + k.axis[1][i]) * size;
    cross_rounded(e->z, across, e->y);
    for (i = 0; i < 3; i++)
        e->x[i] = turn * (cl * across[i] + sl * e->y[i]);
    straighten(e->z, e->x);
    cross_rounded(e->z, e->x, e->y);
    e->at = first * per_reach;
    e->bt = second * per_reach;
    per = 1.0 / SQRT(first * first + lambda);
    e->a = first * per;
    e->ca = reach * per;
    per = 1.0 / SQRT(second * second + lambda);
    e->b = second * per;
    e->cb = reach * per;
}

#endif
