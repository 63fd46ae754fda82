/* SPDX-License-Identifier: Apache-2.0 */
/* The chord that cuts a given share off a disk. Template: see precision.h. */

/* The cube root of r in [0,1] to 2.1e-5, for starting values. */
PSC_LANE real FN(rough_root)(real r)
{
#if PSC_BITS == 64
    return rough_cbrt(r);
#else
    uint32_t bits;
    float y, y3;

    r = MAX(r, 1e-30f);
    memcpy(&bits, &r, sizeof bits);
    bits = (uint32_t)(((uint64_t)bits * 0x55555556u) >> 32) + 0x2A509849u;
    memcpy(&y, &bits, sizeof y);
    y3 = y * y * y;
    return y * (y3 + 2.0f * r) / (2.0f * y3 + r);
#endif
}

/*
 * Solves H - sin H cos H = pi/2 r for r in [0,1]: sin H, cos H. The start is a polynomial in
 * cbrt r, good to 3e-5 with its rough root, then one step of third order: 1e-16.
 */
PSC_LANE void FN(solve_chord)(real r, real *sine, real *cosine)
{
    const real c = FN(rough_root)(r), q = c * c;
    const real start =
        c * (K(1.33067228) +
             q * (K(0.15687702) +
                  q * (K(0.05064812) +
                       q * (K(0.00276581) +
                            q * (K(0.04799227) + q * (K(-0.04293873) + q * K(0.02477693)))))));
    real sine_defect, versine, s, f, h, cot, limit;

    FN(sine_cosine_defects)(start, &sine_defect, &versine);
    s = start - sine_defect;
    f = sine_defect + s * versine - K(1.57079632679489661923) * r;
    h = K(-0.5) * f / (s * s);
    cot = (K(1.0) - versine) / s;
    h = h * (K(1.0) + h * (-cot + h * (K(2.0) * cot * cot - (cot * cot - K(1.0)) * K(0.333333333333333333))));
    limit = K(0.05) * start;
    h = MIN(MAX(h, -limit), limit);
    *cosine = (K(1.0) - versine) * (K(1.0) - K(0.5) * h * h) - s * (h - h * h * h * K(0.166666666666666667));
    *sine = s * (K(1.0) - K(0.5) * h * h) + (K(1.0) - versine) * (h - h * h * h * K(0.166666666666666667));
}
