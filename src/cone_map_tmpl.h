/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Maps of a cap by solid angle: the height above the cap's base is uniform (Archimedes; for a
 * light, [Wan92]). Any half-angle up to pi. The frame is x towards the horizon below the axis,
 * z the axis itself. Template: see precision.h.
 */
PSC_LANE void FN(cone_point)(const struct FN(psc_lobe) *l, real h, real x, real y, real depth,
                             struct FN(psc_point) *p)
{
    p->x = x;
    p->y = y;
    p->z = -h;
    p->height = l->sin_b * (K(1.0) - h) - l->cos_b * x;
    p->power = depth;
    p->across = K(0.0);
}

PSC_LANE void FN(radial_cone)(const struct FN(psc_lobe) *l, real u, real v,
                              struct FN(psc_point) *p)
{
    const real h = u * l->h0;
    const real r = SQRT(h * ((K(2.0) - l->h0) + l->h0 * (K(1.0) - u)));
    real sine, cosine, versine;

    FN(turn)(v, &sine, &cosine, &versine);
    FN(cone_point)(l, h, r * cosine, r * sine, (K(1.0) - u) * l->h0, p);
}

PSC_LANE void FN(concentric_cone)(const struct FN(psc_lobe) *l, real u, real v,
                                  struct FN(psc_point) *p)
{
    real cosine, sine, versine, radius, margin, depth, r;

    FN(square_to_disk)(u, v, &cosine, &sine, &versine, &radius, &margin);
    depth = margin * (K(1.0) + radius) * l->h0;
    r = radius * SQRT(l->h0 * ((K(2.0) - l->h0) + depth));
    FN(cone_point)(l, radius * radius * l->h0, r * cosine, r * sine, depth, p);
}
