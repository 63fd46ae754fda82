/* SPDX-License-Identifier: Apache-2.0 */
/*
 * The one transcendental function behind the areas of clipped caps,
 *
 *     N(x) = 3/2 (x - sin x cos x) / sin^3 x,   x in [0, pi/2],
 *
 * which is 1 at 0 and grows to 3 pi/4: a circular segment of half-angle x has the area
 * 2/3 sin^3 x N(x). Equations 12, 15 and 20 of [UG18] subtract such segments of the horizon
 * circle and of the ellipse from each other; written with N and its divided difference, nothing
 * cancels, however thin the lune between them is.
 *
 * N is a polynomial in w = z / (1 + (sqrt 2 - 1) z), z = tan^2(x/2), a variable that puts the
 * two singularities of N (z = -1 and infinity) equally far from the interval.
 */
#ifndef PSC_SRC_SEGMENT_H
#define PSC_SRC_SEGMENT_H

#include "elementary.h"

#define PSC_KAPPA 0.41421356237309504880

/* N at w_psi, and the divided difference (N(w_theta) - N(w_psi)) / (w_theta - w_psi). */
PSC_LANE double segment(double w_psi, double w_theta, double *difference)
{
    static const double c[] = {1.0, PSC_SEGMENT_F64};
    double n = c[16], d = 0.0;

#define STEP(j)             \
    d = d * w_theta + n; \
    n = n * w_psi + c[j];
    STEP(15) STEP(14) STEP(13) STEP(12) STEP(11) STEP(10) STEP(9) STEP(8)
    STEP(7) STEP(6) STEP(5) STEP(4) STEP(3) STEP(2) STEP(1) STEP(0)
#undef STEP
    *difference = d;
    return n;
}

#endif
