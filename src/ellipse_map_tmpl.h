/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Maps of a cap wholly above the horizon by projected solid angle: its projection is an ellipse,
 * so that every map is an affine image of one of the disk. Template: see precision.h.
 */

/* Listing 1 of [UG18] for a fully visible cap: u is the squared radius, v the angle. */
PSC_LANE void FN(radial_ellipse)(const struct FN(psc_lobe) *l, real u, real v,
                                 struct FN(psc_point) *p)
{
    const real rho = SQRT(u);
    real sine, cosine, versine;

    FN(turn)(v, &sine, &cosine, &versine);
    FN(radial_point)(l, 1, l->sin_a * l->sin_b * cosine, l->sin_a * sine,
                     l->low + l->zc * versine, rho, (K(1.0) - u) / (K(1.0) + rho), p);
    p->power = l->sin_a * l->sin_b * (l->sin_a * l->sin_b) * (K(1.0) - u);
}

/* The square-to-disk map of [SC97] in place of polar coordinates. */
PSC_LANE void FN(concentric_ellipse)(const struct FN(psc_lobe) *l, real u, real v,
                                     struct FN(psc_point) *p)
{
    real cosine, sine, versine, radius, margin;

    FN(square_to_disk)(u, v, &cosine, &sine, &versine, &radius, &margin);
    FN(radial_point)(l, 1, l->sin_a * l->sin_b * cosine, l->sin_a * sine,
                     l->low + l->zc * versine, radius, margin, p);
    p->power = l->sin_a * l->sin_b * (l->sin_a * l->sin_b) * (margin * (K(1.0) + radius));
}
