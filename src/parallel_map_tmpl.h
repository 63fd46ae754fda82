/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Chords of an ellipse (section 4.1 of [UG18]): the area beyond the chord at height
 * a_y cos H is proportional to H - sin H cos H. Template: see precision.h.
 */

/* power and across of a point on a chord between two points of the outline. */
PSC_LANE void FN(whole_chord_power)(const struct FN(psc_lobe) *l, real u, real rest, real sine,
                                    real zl, real zr, struct FN(psc_point) *p)
{
    const real half = l->sin_b * sine;

    p->power = K(4.0) * u * rest * (half * half);
    p->across = -l->sin_b * (rest * zl + u * zr);
}

/* The parallel map of a cap wholly above the horizon. */
PSC_LANE void FN(parallel_ellipse)(const struct FN(psc_lobe) *l, real u, real v,
                                   struct FN(psc_point) *p)
{
    const real r = K(2.0) * MIN(v, K(1.0) - v), side = COPYSIGN(K(1.0), v - K(0.5));
    real sine, cosine, half, zl, zr;

    FN(solve_chord)(r, &sine, &cosine);
    half = l->sin_a * l->sin_b * sine;
    zl = l->cos_a * l->sin_b + l->zc * sine;
    zr = l->low + l->zc * (cosine * cosine / (K(1.0) + sine));
    FN(chord_point)(l, 1, -half, side * l->sin_a * cosine, K(2.0) * half, zl, zr, u,
                    K(1.0) - u, p);
    FN(whole_chord_power)(l, u, K(1.0) - u, sine, zl, zr, p);
}
