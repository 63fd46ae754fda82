/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Maps of a sphere by its area: uniform in w = 1 - cosine of the angle, at the sphere's centre,
 * from the point nearest the receiver, in [0, width]. With the sphere's radius as unit, delta
 * the distance of its centre and gap = delta - 1 that of the surface (negative from inside),
 *     t^2 = gap^2 + 2 delta w,   direction = ((gap + w) axis + sqrt(w (2 - w)) sideways) / t,
 *     pdf = t^3 / (2 pi width |gap - delta w|):
 * area to solid angle by distance squared over cosine. The frame is that of the cone maps.
 * Template: see precision.h.
 */

/* A point of the surface, margin = 1 - w / width: p->power is w; pdf and its inverse (0 on the
   far side and at the limb, where pdf is infinite). facing, gap - delta w, is positive on the
   side that a receiver outside sees. */
PSC_LANE void FN(area_point)(const struct FN(psc_lobe) *l, real w, real margin, real cosine,
                             real sine, struct FN(psc_point) *p, real *pdf, real *inverse)
{
    const real facing = l->visible > K(0.0) ? l->gap * margin : l->gap - l->delta * w;
    const real side = SQRT(w * ((K(2.0) - l->width) + l->width * margin));
    const real t2 = l->gap * l->gap + K(2.0) * l->delta * w;
    const real t = SQRT(t2), it = K(1.0) / t;
    const real r = side * it, along = (l->gap + w) * it;
    const real h = along > K(0.0) ? r * r / (K(1.0) + along) : K(1.0) - along;
    const real area = l->total_area * ABS(facing);

    p->x = r * cosine;
    p->y = r * sine;
    p->z = -h;
    p->height = l->sin_b * (K(1.0) - h) - l->cos_b * p->x;
    p->power = w;
    p->across = K(0.0);
    *pdf = t2 * t / area;
    *inverse = (facing > K(0.0)) == (l->gap > K(0.0)) ? area / (t2 * t) : K(0.0);
}

PSC_LANE void FN(radial_area)(const struct FN(psc_lobe) *l, real u, real v,
                              struct FN(psc_point) *p, real *pdf, real *inverse)
{
    const real w = u * l->width;
    real sine, cosine, versine;

    FN(turn)(v, &sine, &cosine, &versine);
    FN(area_point)(l, w, K(1.0) - u, cosine, sine, p, pdf, inverse);
}

PSC_LANE void FN(concentric_area)(const struct FN(psc_lobe) *l, real u, real v,
                                  struct FN(psc_point) *p, real *pdf, real *inverse)
{
    real cosine, sine, versine, radius, margin, w;

    FN(square_to_disk)(u, v, &cosine, &sine, &versine, &radius, &margin);
    w = radius * radius * l->width;
    FN(area_point)(l, w, margin * (K(1.0) + radius), cosine, sine, p, pdf, inverse);
}
