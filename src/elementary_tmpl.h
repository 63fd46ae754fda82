/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Elementary functions from + - * / and sqrt alone, so that they give the same bits on every CPU
 * and at every vector width. Polynomials are summed in Estrin's order, which is part of the
 * result. Template: see precision.h.
 */
#include "coefficients.h"

/* The sum of c[i + j] z^j for j up to 3, in pairs. */
#define ESTRIN4(c, i, z, z2) \
    (((c)[i] + (z) * (c)[(i) + 1]) + (z2) * ((c)[(i) + 2] + (z) * (c)[(i) + 3]))

/* Five terms without z^4, which would be subnormal for tiny angles, and slow. */
#define FLOAT5(c, z, z2) \
    (((c)[0] + (z) * (c)[1]) + (z2) * (((c)[2] + (z) * (c)[3]) + (z2) * (c)[4]))

/* (x - sin x) / x^3 and (1 - cos x) / x^2 of z = x^2, |x| <= pi/2: 6.3e-17 and 1.1e-17 relative
   in double, 3.3e-8 and 5.9e-9 in float, before rounding. */
PSC_LANE real FN(sine_polynomial)(real z)
{
    const real z2 = z * z;
#if PSC_BITS == 64
    static const double c[] = {PSC_SINE_F64};
    return ESTRIN4(c, 0, z, z2) + z2 * z2 * ESTRIN4(c, 4, z, z2);
#else
    static const float c[] = {PSC_SINE_F32};
    return FLOAT5(c, z, z2);
#endif
}

PSC_LANE real FN(cosine_polynomial)(real z)
{
    const real z2 = z * z;
#if PSC_BITS == 64
    static const double c[] = {PSC_COSINE_F64};
    return ESTRIN4(c, 0, z, z2) + z2 * z2 * (ESTRIN4(c, 4, z, z2) + z2 * z2 * c[8]);
#else
    static const float c[] = {PSC_COSINE_F32};
    return FLOAT5(c, z, z2);
#endif
}

/* x - sin x and 1 - cos x for |x| <= pi/2, both accurate relative to themselves: what keeps tiny
   lights exact. */
PSC_LANE void FN(sine_cosine_defects)(real x, real *sine_defect, real *cosine_defect)
{
    const real z = x * x;

    *sine_defect = x * z * FN(sine_polynomial)(z);
    *cosine_defect = z * FN(cosine_polynomial)(z);
}

/* Sine, cosine and versine (1 - cosine, accurate relative to itself) of pi (2 t - 1), t in
   [0,1]: t = 1/2 is angle 0, both ends are pi. */
PSC_LANE void FN(turn)(real t, real *sine, real *cosine, real *versine)
{
    const real u = ABS(K(2.0) * t - K(1.0));
    const real r = MIN(K(2.0) * t, K(2.0) - K(2.0) * t);
    const real near = MIN(u, r);
    const real x = K(3.14159265358979323846) * near;
    /* A sign in place of a choice, which gcc would make a branch that no CPU can predict. */
    const real way = COPYSIGN(K(1.0), r - u);
    real sine_defect, cosine_defect;

    FN(sine_cosine_defects)(x, &sine_defect, &cosine_defect);
    *sine = COPYSIGN(x - sine_defect, t - K(0.5));
    *cosine = COPYSIGN(K(1.0) - cosine_defect, way);
    *versine = (K(1.0) - way) + way * cosine_defect;
}

/*
 * The square laid over the unit disk [SC97], u along the cosine: the direction (cosine, sine)
 * from the centre with its versine, the radius, and 1 - radius without cancellation.
 */
PSC_LANE void FN(square_to_disk)(real u, real v, real *cosine, real *sine, real *versine,
                                 real *radius, real *margin)
{
    const real a = K(2.0) * u - K(1.0), b = K(2.0) * v - K(1.0);
    const real edge_u = MIN(u, K(1.0) - u), edge_v = MIN(v, K(1.0) - v);
    const int along_u = edge_u < edge_v;
    const real far = along_u ? a : b;
    const real other = along_u ? b : a;
    const real ratio = other / (far == K(0.0) ? K(1.0) : far);
    const real side = COPYSIGN(K(1.0), far);
    real sine_defect, cosine_defect, x, c, s;

    x = K(0.78539816339744830962) * ratio;
    FN(sine_cosine_defects)(x, &sine_defect, &cosine_defect);
    s = side * (x - sine_defect);
    c = side * (K(1.0) - cosine_defect);
    *cosine = along_u ? c : s;
    *sine = along_u ? s : c;
    *versine = along_u && side > K(0.0) ? cosine_defect : K(1.0) - *cosine;
    *radius = ABS(far);
    *margin = K(2.0) * (along_u ? edge_u : edge_v);
}
