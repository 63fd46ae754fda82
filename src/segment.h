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

/*
 * N at a, and its divided difference (N(b) - N(a)) / (b - a) by Horner's rule for differences.
 * Even and odd powers go separately, N(w) = E(w^2) + w O(w^2), which halves the chain of
 * dependent operations:
 *     N[a,b] = (E[a^2,b^2] + b O[a^2,b^2]) (a + b) + O(a^2).
 */
PSC_LANE double segment(double a, double b, double *difference)
{
    static const double c[] = {1.0, PSC_SEGMENT_F64};
    const double a2 = a * a, b2 = b * b;
    double even = c[16], odd = c[15], even_d = 0.0, odd_d = 0.0;

#define STEP(j)                      \
    even_d = even_d * b2 + even;     \
    even = even * a2 + c[j];
    STEP(14) STEP(12) STEP(10) STEP(8) STEP(6) STEP(4) STEP(2) STEP(0)
#undef STEP
#define STEP(j)                  \
    odd_d = odd_d * b2 + odd;    \
    odd = odd * a2 + c[j];
    STEP(13) STEP(11) STEP(9) STEP(7) STEP(5) STEP(3) STEP(1)
#undef STEP
    *difference = (even_d + b * odd_d) * (a + b) + odd;
    return even + a * odd;
}

#endif
