/* SPDX-License-Identifier: Apache-2.0 */
/*
 * A spherical cap above a horizon, in the terms of [UG18]: half-angle alpha, elevation beta of
 * its axis. Angles are never needed, only their sines and cosines.
 *
 * Local frame (equation 6): z is the receiver's normal, the axis is (cos beta, 0, sin beta).
 */
#ifndef PSC_SRC_CAP_H
#define PSC_SRC_CAP_H

#include "elementary.h"

struct psc_cap {
    double sin_a, cos_a; /* of alpha, in (0, pi/2] */
    double sin_b, cos_b; /* of beta, in [-pi/2, pi/2] */
    double q2;           /* sin^2 alpha - sin^2 beta: positive when the horizon cuts the cap */
};

/* How the cap lies to the horizon: the cases of [UG18], section 3.2. */
enum psc_region { PSC_REGION_EMPTY, PSC_REGION_ELLIPSE, PSC_REGION_BOTH, PSC_REGION_LUNE };

/* Where |a_x| is less than this share of cos beta - cos alpha, the lune is that of beta = 0 to
   1e-17 of the total; taking it for that one avoids 0/0. */
#define PSC_FLAT_LUNE 1e-17

PSC_LANE enum psc_region psc_cap_region(const struct psc_cap *cap)
{
    const double a_x = -cap->sin_a * cap->sin_b;
    const int flat = a_x * (cap->cos_a + cap->cos_b) < PSC_FLAT_LUNE * cap->q2;

    return cap->q2 <= 0.0      ? (cap->sin_b > 0.0 ? PSC_REGION_ELLIPSE : PSC_REGION_EMPTY)
           : cap->sin_b >= 0.0 ? PSC_REGION_BOTH
           : flat              ? PSC_REGION_BOTH
                               : PSC_REGION_LUNE;
}

/* 1 - cos alpha without cancellation, also for the wide caps of solid angle. */
PSC_LANE double psc_cap_versine(const struct psc_cap *cap)
{
    return cap->cos_a > 0.0 ? cap->sin_a * cap->sin_a / (1.0 + cap->cos_a) : 1.0 - cap->cos_a;
}

#endif
