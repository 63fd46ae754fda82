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
 * two singularities of N (z = -1 and infinity) equally far from the interval. Template: see
 * precision.h.
 */
#undef PSC_KAPPA
#define PSC_KAPPA K(0.41421356237309504880)

/* N of w. */
PSC_LANE real FN(segment)(real w)
{
    const real w2 = w * w, w4 = w2 * w2, w8 = w4 * w4;
#if PSC_BITS == 64
    static const double c[] = {1.0, PSC_SEGMENT_F64};

    return ((ESTRIN4(c, 0, w, w2) + w4 * ESTRIN4(c, 4, w, w2)) +
            w8 * (ESTRIN4(c, 8, w, w2) + w4 * ESTRIN4(c, 12, w, w2))) +
           w8 * w8 * c[16];
#else
    static const float c[] = {1.0f, PSC_SEGMENT_F32};

    return (ESTRIN4(c, 0, w, w2) + w4 * ESTRIN4(c, 4, w, w2)) + w8 * c[8];
#endif
}

/* The share of a disk beyond a chord at the height cosine, 2 / pi (H - sin H cos H) for the
   half-angle H of that segment; square and sine are sin^2 H and its root. */
PSC_LANE real FN(segment_share)(real cosine, real sine, real square)
{
    const real versine = square / (K(1.0) + cosine);
    const real w = versine / ((K(1.0) + cosine) + PSC_KAPPA * versine);

    return K(4.0) / (K(3.0) * K(3.14159265358979323846)) * (sine * square) * FN(segment)(w);
}

/*
 * N at a, and its divided difference (N(b) - N(a)) / (b - a) by Horner's rule for differences;
 * excess: both without their first terms, 1 and 6/5, for sums that these would cancel in. The four
 * residues of the exponent go separately, N(w) = sum of w^k P_k(w^4), which shortens the chain of
 * dependent operations: with D_k the divided difference of P_k in w^4,
 *     N[a,b] = P_1 + (a + b) P_2 + (a^2 + a b + b^2) P_3
 *            + (a + b) (a^2 + b^2) (D_0 + b D_1 + b^2 D_2 + b^3 D_3).
 */
PSC_LANE real FN(segment_difference)(real a, real b, int excess, real *difference)
{
    const real a2 = a * a, b2 = b * b, a4 = a2 * a2, b4 = b2 * b2;
#if PSC_BITS == 64
    static const double c[] = {1.0, PSC_SEGMENT_F64};
    double p0 = c[16], p1 = c[13], p2 = c[14], p3 = c[15];
#else
    static const float c[] = {1.0f, PSC_SEGMENT_F32};
    float p0 = c[8], p1 = c[5], p2 = c[6], p3 = c[7];
#endif
    real d0 = K(0.0), d1 = K(0.0), d2 = K(0.0), d3 = K(0.0);

#define STEP(k, term)        \
    d##k = d##k * b4 + p##k; \
    p##k = p##k * a4 + term;
#if PSC_BITS == 64
    STEP(0, c[12])
    STEP(0, c[8]) STEP(1, c[9]) STEP(2, c[10]) STEP(3, c[11])
    STEP(0, c[4]) STEP(1, c[5]) STEP(2, c[6]) STEP(3, c[7])
#else
    STEP(0, c[4])
#endif
    STEP(0, (excess ? K(0.0) : c[0])) STEP(1, (excess ? K(0.0) : c[1])) STEP(2, c[2]) STEP(3, c[3])
#undef STEP
    *difference = ((p1 + (a + b) * p2) + (a2 + b * (a + b)) * p3) +
                  (a + b) * (a2 + b2) * ((d0 + b * d1) + b2 * (d2 + b * d3));
    return (p0 + a * (excess ? p1 + c[1] : p1)) + a2 * (p2 + a * p3);
}
