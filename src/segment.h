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

/* The share of a disk beyond a chord at the height cosine, 2 / pi (H - sin H cos H) for the
   half-angle H of that segment; square and sine are sin^2 H and its root. */
PSC_LANE double segment_share(double cosine, double sine, double square)
{
    static const double c[] = {1.0, PSC_SEGMENT_F64};
    const double versine = square / (1.0 + cosine);
    const double w = versine / ((1.0 + cosine) + PSC_KAPPA * versine);
    const double w2 = w * w, w4 = w2 * w2, w8 = w4 * w4;
    const double n = ((ESTRIN4(c, 0, w, w2) + w4 * ESTRIN4(c, 4, w, w2)) +
                      w8 * (ESTRIN4(c, 8, w, w2) + w4 * ESTRIN4(c, 12, w, w2))) +
                     w8 * w8 * c[16];

    return 4.0 / (3.0 * PSC_PI) * (sine * square) * n;
}

/*
 * N at a, and its divided difference (N(b) - N(a)) / (b - a) by Horner's rule for differences.
 * The four residues of the exponent go separately, N(w) = sum of w^k P_k(w^4), which shortens the
 * chain of dependent operations: with D_k the divided difference of P_k in w^4,
 *     N[a,b] = P_1 + (a + b) P_2 + (a^2 + a b + b^2) P_3
 *            + (a + b) (a^2 + b^2) (D_0 + b D_1 + b^2 D_2 + b^3 D_3).
 */
PSC_LANE double segment(double a, double b, double *difference)
{
    static const double c[] = {1.0, PSC_SEGMENT_F64};
    const double a2 = a * a, b2 = b * b, a4 = a2 * a2, b4 = b2 * b2;
    double p0 = c[16], d0 = 0.0, p1 = c[13], d1 = 0.0, p2 = c[14], d2 = 0.0, p3 = c[15], d3 = 0.0;

#define STEP(k, j)           \
    d##k = d##k * b4 + p##k; \
    p##k = p##k * a4 + c[j];
    STEP(0, 12)
    STEP(0, 8) STEP(1, 9) STEP(2, 10) STEP(3, 11)
    STEP(0, 4) STEP(1, 5) STEP(2, 6) STEP(3, 7)
    STEP(0, 0) STEP(1, 1) STEP(2, 2) STEP(3, 3)
#undef STEP
    *difference = ((p1 + (a + b) * p2) + (a2 + b * (a + b)) * p3) +
                  (a + b) * (a2 + b2) * ((d0 + b * d1) + b2 * (d2 + b * d3));
    return (p0 + a * p1) + a2 * (p2 + a * p3);
}

#endif
