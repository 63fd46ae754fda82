/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Maps of a cap wholly above the horizon by projected solid angle: its projection is an ellipse,
 * so that every map is an affine image of one of the disk. Template: see precision.h.
 */

/*
 * The point at rho (margin = 1 - rho, rest = 1 - rho^2) along a direction of the disk. Below the
 * sampled direction lies a point of the disk that cuts the cap off, at the height
 *     z_b = low + zc (1 - rho cosine),    z^2 = z_b^2 + sin^2 alpha (1 - rho^2):
 * positive terms, which keep z accurate relative to itself down to the horizon.
 */
PSC_LANE void FN(ellipse_point)(const struct FN(psc_lobe) *l, real cosine, real sine,
                                real versine, real rho, real margin, real rest,
                                struct FN(psc_point) *p)
{
    const real below = l->low + l->zc * (margin + rho * versine);
    const real a_x = l->sin_a * l->sin_b;

    FN(lift)(l, 1, rho * (a_x * cosine), rho * (l->sin_a * sine),
             below * below + l->sin_a * l->sin_a * rest, p);
    p->power = l->sin_b * l->sin_b * rest;
    p->across = -l->sin_b * below;
}

/* Listing 1 of [UG18] for a fully visible cap: u is the squared radius, v the angle. */
PSC_LANE void FN(radial_ellipse)(const struct FN(psc_lobe) *l, real u, real v,
                                 struct FN(psc_point) *p)
{
    const real rho = SQRT(u);
    real sine, cosine, versine;

    FN(turn)(v, &sine, &cosine, &versine);
    FN(ellipse_point)(l, cosine, sine, versine, rho, K(1.0) - rho, K(1.0) - u, p);
}

/* The square-to-disk map of [SC97] in place of polar coordinates. */
PSC_LANE void FN(concentric_ellipse)(const struct FN(psc_lobe) *l, real u, real v,
                                     struct FN(psc_point) *p)
{
    real cosine, sine, versine, radius, margin;

    FN(square_to_disk)(u, v, &cosine, &sine, &versine, &radius, &margin);
    FN(ellipse_point)(l, cosine, sine, versine, radius, margin, margin * (K(1.0) + radius), p);
}
