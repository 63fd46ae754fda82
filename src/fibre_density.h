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

#include "ellipse_chord.h"
#include "fibres.h"
#include "segment.h"

#include "fibre_map_tmpl.h"

/* The sine of an angle in [0, pi], given by what it lacks of pi too. */
PSC_LANE double sine_between(double x, double rest)
{
    const double near = MIN(x, rest);

    return near - near * (near * near) * sine_polynomial_f64(near * near);
}

/* Where the fibre at x from the top of the range is, or from its end. */
PSC_LANE void fibre_place_at(const struct psc_sheaf_f64 *f, int clipped, int lower, double x,
                             struct psc_fibre_site_f64 *o)
{
    const double s = lower ? f->end - x : x, back = lower ? f->rest + x : PSC_PI - x;
    const double near = MIN(s, back), e = 0.5 * (lower ? x : f->end - x);
    double defect, versine;

    sine_cosine_defects_f64(near, &defect, &versine);
    /* above 0, so that the ends of a half space, which is infinitely wide, are as the rest */
    o->sine = MAX(near - defect, 1e-40);
    o->cosine = s <= back ? 1.0 - versine : versine - 1.0;
    /* sin m (cos s - cos end) */
    o->rise = clipped ? 2.0 * f->sin_m * sine_between(e, PSC_PI) *
                            sine_between(f->end - e, f->rest + e)
                      : 0.0;
}

PSC_LANE void fibre_at(const struct psc_sheaf_f64 *f, int clipped, int lower, double x,
                       struct psc_fibre_f64 *o)
{
    struct psc_fibre_site_f64 site;

    fibre_place_at(f, clipped, lower, x, &site);
    fibre_of_f64(f, clipped, &site, o);
}

PSC_LANE double fibre_density(const struct psc_sheaf_f64 *f, int lower, double x)
{
    struct psc_fibre_f64 o;

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
static inline double fibre_integral(const struct psc_sheaf_f64 *f, int lower, double from,
                                    double to)
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
static inline double rough_integral(const struct psc_sheaf_f64 *f, int lower, double from,
                                    double to)
{
    const double half = 0.5 * (to - from), middle = 0.5 * (to + from);
    const double inner = 0.33998104358485626480 * half, outer = 0.86113631159405257522 * half;

    return half * (0.65214515486254614263 * (fibre_density(f, lower, middle - inner) +
                                             fibre_density(f, lower, middle + inner)) +
                   0.34785484513745385737 * (fibre_density(f, lower, middle - outer) +
                                             fibre_density(f, lower, middle + outer)));
}

#endif
