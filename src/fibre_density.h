/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Projected solid angle of an elliptic cone above a horizon, exactly and without cancellation.
 *
 * Planes through the horizontal axis E, perpendicular to the axis z of the cone, cut the cone in
 * fibres; F is the third axis, upwards, and a plane at the angle psi from z towards F meets the
 * cone where
 *     sin psi = sin m cos s,   0 <= s <= pi,   tan chi = shear cos s -+ width sin s,
 * m being the largest psi and chi the angle along the fibre from the plane of F and z: in these
 * variables both ends of a fibre are plain waves. With k = cos psi and the height of the fibre's
 * middle over the horizon, sin(elevation of z + psi), projected solid angle has the density
 *     height / 2 W sin m sin s / k   in s,   W = integral of 2 cos^2 chi over the fibre,
 * and cos^2 chi along the fibre: both integrals are of positive functions, of which the second is
 * elementary. The horizon is a fibre itself, s = end.
 */
#ifndef PSC_SRC_FIBRE_DENSITY_H
#define PSC_SRC_FIBRE_DENSITY_H

#include "elementary.h"
#include "fibres.h"

struct psc_fibre {
    double sine, cosine;  /* of s */
    double k;             /* cosine of psi */
    double height;        /* of the middle over the horizon */
    double middle, half;  /* shear cos s, width sin s: (tan chi_2 +- tan chi_1) / 2 */
    double first, second; /* 1 / cos chi at both ends */
    double angle;         /* chi_2 - chi_1 */
    double weight;        /* W */
};

/* x - sin x, x in [0, pi], given the sine. */
PSC_LANE double angle_excess(double x, double sine)
{
    const double z = x * x;

    return x <= 0.5 * PSC_PI ? x * z * sine_polynomial_f64(z) : x - sine;
}

/* The sine of an angle in [0, pi], given by what it lacks of pi too. */
PSC_LANE double sine_between(double x, double rest)
{
    const double near = MIN(x, rest);

    return near - near * (near * near) * sine_polynomial_f64(near * near);
}

/* All of a fibre but its height. */
PSC_LANE void fibre_shape(const struct psc_sheaf *f, double sine, double cosine,
                          struct psc_fibre *o)
{
    double d, t1, t2, product, sum, spread;

    o->sine = sine;
    o->cosine = cosine;
    o->k = SQRT(f->cos_m * f->cos_m + (f->sin_m * sine) * (f->sin_m * sine));
    o->middle = f->shear * cosine;
    o->half = f->width * sine;
    t1 = o->middle - o->half;
    t2 = o->middle + o->half;
    product = t1 * t2;
    o->first = SQRT(1.0 + t1 * t1);
    o->second = SQRT(1.0 + t2 * t2);
    d = o->first * o->second;
    spread = 2.0 * o->half / d;
    o->angle = angle_of(1.0 + product, 2.0 * o->half);
    /* W = angle - sin angle + sin angle (1 + cos(chi_1 + chi_2)) */
    product = 1.0 - product;
    sum = product >= 0.0 ? 1.0 + product / d : 4.0 * (o->middle * o->middle) / (d * (d - product));
    o->weight = angle_excess(o->angle, spread) + spread * sum;
}

/* The fibre at x from the top of the range, or from its end. */
PSC_LANE void fibre_at(const struct psc_sheaf *f, int clipped, int lower, double x,
                       struct psc_fibre *o)
{
    const double s = lower ? f->end - x : x, back = lower ? f->rest + x : PSC_PI - x;
    const double near = MIN(s, back);
    double defect, versine;

    sine_cosine_defects_f64(near, &defect, &versine);
    /* above 0, so that the ends of a half space, which is infinitely wide, are as the rest */
    fibre_shape(f, MAX(near - defect, 1e-40), s <= back ? 1.0 - versine : versine - 1.0, o);
    if (clipped) {
        /* sin(psi - psi_end) from sin psi - sin psi_end = sin m (cos s - cos end) */
        const double e = 0.5 * (lower ? x : f->end - x);
        const double rise =
            2.0 * f->sin_m * sine_between(e, PSC_PI) * sine_between(f->end - e, f->rest + e);
        const double sum = o->k + f->nf;

        o->height = 2.0 * rise * sum / (sum * sum + rise * rise);
    } else {
        o->height = MAX(f->nz * o->k + f->nf * (f->sin_m * o->cosine), 0.0);
    }
}

PSC_LANE double fibre_density(const struct psc_sheaf *f, int lower, double x)
{
    struct psc_fibre o;

    fibre_at(f, f->clipped, lower, x, &o);
    return 0.5 * o.height * o.weight * f->sin_m * (o.sine / o.k);
}

#define PSC_GAUSS 16
static const double psc_gauss_node[PSC_GAUSS / 2] = {
    0.9894009349916499326, 0.94457502307323257608, 0.86563120238783174388, 0.7554044083550030339,
    0.61787624440264374845, 0.45801677765722738634, 0.28160355077925891323,
    0.095012509837637440185};
static const double psc_gauss_weight[PSC_GAUSS / 2] = {
    0.027152459411754094852, 0.062253523938647892863, 0.09515851168249278481,
    0.12462897125553387205, 0.14959598881657673208, 0.16915651939500253819,
    0.18260341504492358887, 0.18945061045506849629};

/* The integral of the density between two places on one half. */
static inline double fibre_integral(const struct psc_sheaf *f, int lower, double from, double to)
{
    const double half = 0.5 * (to - from);
    double value[PSC_GAUSS], sum = 0.0;
    int i;

    for (i = 0; i < PSC_GAUSS; i++) {
        const int j = i < PSC_GAUSS / 2 ? i : PSC_GAUSS - 1 - i;
        const double node = psc_gauss_node[j];
        const double x = i < PSC_GAUSS / 2 ? from + half * (1.0 - node) : to - half * (1.0 - node);

        value[i] = fibre_density(f, lower, x);
    }
    for (i = 0; i < PSC_GAUSS / 2; i++)
        sum += psc_gauss_weight[i] * (value[i] + value[PSC_GAUSS - 1 - i]);
    return half * sum;
}

/* The same with four nodes. */
static inline double rough_integral(const struct psc_sheaf *f, int lower, double from, double to)
{
    const double half = 0.5 * (to - from), middle = 0.5 * (to + from);
    const double inner = 0.33998104358485626480 * half, outer = 0.86113631159405257522 * half;

    return half * (0.65214515486254614263 * (fibre_density(f, lower, middle - inner) +
                                             fibre_density(f, lower, middle + inner)) +
                   0.34785484513745385737 * (fibre_density(f, lower, middle - outer) +
                                             fibre_density(f, lower, middle + outer)));
}

#endif
