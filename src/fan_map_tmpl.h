/* SPDX-License-Identifier: Apache-2.0 */
/* Arvo's map of a spherical triangle [Arv95], and the point of the light it gives. Template: see
   precision.h. */

#undef SHARE_MAX
#if PSC_BITS == 64
#define SHARE_MAX 0x1p300
#else
#define SHARE_MAX 0x1p60f
#endif

/*
 * The area fraction u lies between the arc from B to A and that from B to a point C^ of the arc
 * from A to C; v, the fraction of the cap around B, is then along the arc from B to C^.
 *
 * Arvo solves for C^. As the receiver comes close to the triangle every C^ tends to -B, and that
 * loses the direction; here the angle beta at B is solved for instead. Of the triangle A, B, C^
 * the excess 2 x, the angle alpha and the side c between A and B are known, so with
 *     S = sin x sin(alpha - x),   C = sin alpha sin^2(c / 2) - sin x cos(alpha - x)
 * the angle has tan beta = S / C, and the side a^ from B to C^
 *     sin^2(a^ / 2) = (S^2 + C^2) / M,   cos^2(a^ / 2) = (sin alpha sin c / 2)^2 / M,
 *     M = S^2 + C^2 + (sin alpha sin c / 2)^2.
 * The sine of half the side from B to the sample is sqrt(v) sin(a^ / 2).
 * C is a difference of two products neither of which is above sqrt(M). sin(alpha - x) cancels
 * where A and B are all but antipodal, and nearly the same arcs lead to all C^: what it is at
 * u = 1 keeps samples within the triangle. S, C and the root of M may have any common factor.
 */
PSC_LANE void FN(fan_map)(const struct FN(psc_fan) *f, real u, real v, struct FN(psc_spot) *p)
{
    const real x = u * f->half;
    const real rest = f->rest + (K(1.0) - u) * f->half; /* pi - x */
    const int obtuse = rest < x;
    real sine_defect, cosine_defect, sine, cosine, sine_rest, cosine_rest;
    real s, c, square, inverse, radius;

    FN(sine_cosine_defects)(obtuse ? rest : x, &sine_defect, &cosine_defect);
    sine = (obtuse ? rest : x) - sine_defect;
    cosine = obtuse ? cosine_defect - K(1.0) : K(1.0) - cosine_defect;
    sine_rest = f->sin_a * cosine - f->cos_a * sine;
    cosine_rest = f->cos_a * cosine + f->sin_a * sine;
    sine_rest = MAX(sine_rest, cosine_rest > K(0.0) ? f->sin_rest : K(0.0));
    s = ((f->near + f->far) * sine) * sine_rest;
    c = (f->near * cosine) * sine_rest - (f->far * sine) * cosine_rest;
    square = s * s + c * c;
    inverse = K(2.0) / (square + f->gap);
    radius = SQRT(v * ((K(1.0) - v) * square + f->gap)) * inverse;
    p->b = K(1.0) - v * (square * inverse);
    p->a = radius * c;
    p->c = radius * s;
}

PSC_LANE void FN(fan_direction)(const struct FN(psc_fan) *f, const struct FN(psc_spot) *p,
                                real direction[3])
{
    int i;

    for (i = 0; i < 3; i++)
        direction[i] = p->b * f->b[i] + (p->a * f->toward_a[i] + p->c * f->toward_c[i]);
}

/* The height of a direction above the receiver's plane. */
PSC_LANE real FN(fan_height)(const real up[3], const real direction[3])
{
    return (up[0] * direction[0] + up[1] * direction[1]) + up[2] * direction[2];
}

/* The cosine that counts; without a normal there is none, and 1 stands for it. */
PSC_LANE real FN(fan_cosine)(enum psc_facing facing, real height)
{
    return facing == PSC_FACING_NONE  ? K(1.0)
           : facing == PSC_FACING_ONE ? MAX(height, K(0.0))
                                      : ABS(height);
}

PSC_LANE real FN(fan_share)(real x)
{
    return MIN(MAX(x, K(0.0)), SHARE_MAX);
}

/*
 * Where the direction meets the light: the shares of A, B and C, and the distance in units of the
 * fan. The direction is a sum of a / |a|, b / |b|, c / |c| with
 * positive shares, which follow from its coordinates; no ray is intersected. Where a and b are all
 * but in line, rounding moves much of one share to the other, and what is left of the sum is right:
 * so neither takes more than there is.
 */
PSC_LANE void FN(fan_hit)(const struct FN(psc_fan) *f, const struct FN(psc_spot) *p,
                          real *share_a, real *share_b, real *share_c, real *distance)
{
    const real c = FN(fan_share)(p->c * f->share_c);
    const real first = FN(fan_share)((p->a - c * f->slant) * f->share_a);
    const real rest = p->b - first * f->cos_ab - c * f->cos_bc;
    const real a = FN(fan_share)(first + MIN(rest, K(0.0)) * f->cos_ab);
    const real to_a = FN(fan_share)(a * f->per_a);
    const real to_b = FN(fan_share)(rest * f->per_b);
    const real to_c = FN(fan_share)(c * f->per_c);
    const real sum = to_a + to_b + to_c;
    const real inverse = K(1.0) / MAX(sum, SMALLEST);

    *share_a = to_a * inverse;
    *share_b = to_b * inverse;
    *share_c = to_c * inverse;
    *distance = inverse;
}

PSC_LANE void FN(face_point)(const struct FN(psc_face) *f, real a, real b, real c,
                             real point[3], real *s, real *t)
{
    int i;

    for (i = 0; i < 3; i++)
        point[i] = f->pivot[i] + (a * f->edge_a[i] + c * f->edge_c[i]);
    *s = (a * f->s_a + b * f->s_b) + c * f->s_c;
    *t = (a * f->t_a + b * f->t_b) + c * f->t_c;
}
