/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Maps of a sphere by its area: uniform in w = 1 - cosine of the angle, at the sphere's centre,
 * from the point nearest the receiver, in [0, width]. With the sphere's radius as unit, delta
 * the distance of its centre and gap = delta - 1 that of the surface (negative from inside),
 *     t^2 = gap^2 + 2 delta w,   direction = ((gap + w) axis + sqrt(w (2 - w)) sideways) / t,
 *     pdf = t^3 / (2 pi width |gap - delta w|):
 * area to solid angle by distance squared over cosine. The frame is that of the cone maps. In
 * double also behind the float interface.
 */
#ifndef PSC_SRC_AREA_MAP_H
#define PSC_SRC_AREA_MAP_H

#include "lobe.h"

/* A point of the surface, margin = 1 - w / width: p->power is w, p->across t; pdf and its inverse
   (0 on the far side and at the limb, where pdf is infinite). facing, gap - delta w, is positive
   on the side that a receiver outside sees. */
PSC_LANE void area_point(const struct psc_lobe_f64 *l, double w, double margin, double cosine,
                         double sine, struct psc_point_f64 *p, double *pdf, double *inverse)
{
    const double facing = l->visible > 0.0 ? l->gap * margin : l->gap - l->delta * w;
    const double side = SQRT(w * ((2.0 - l->width) + l->width * margin));
    const double t2 = l->gap * l->gap + 2.0 * l->delta * w;
    const double t = SQRT(t2), it = 1.0 / t;
    const double r = side * it, along = (l->gap + w) * it;
    const double h = along > 0.0 ? r * r / (1.0 + along) : 1.0 - along;
    const double area = l->total_area * ABS(facing);
    /* A sign, not two comparisons: gcc 12 has no vector code for their equality in AVX-512. */
    const double outwards = l->gap > 0.0 ? 1.0 : -1.0;

    p->x = r * cosine;
    p->y = r * sine;
    p->z = -h;
    p->height = l->sin_b * (1.0 - h) - l->cos_b * p->x;
    p->power = w;
    p->across = t;
    *pdf = t2 * t / area;
    *inverse = facing * outwards > 0.0 ? area / (t2 * t) : 0.0;
}

PSC_LANE void radial_area(const struct psc_lobe_f64 *l, double u, double v,
                          struct psc_point_f64 *p, double *pdf, double *inverse)
{
    const double w = u * l->width;
    double sine, cosine, versine;

    turn_f64(v, &sine, &cosine, &versine);
    area_point(l, w, 1.0 - u, cosine, sine, p, pdf, inverse);
}

PSC_LANE void concentric_area(const struct psc_lobe_f64 *l, double u, double v,
                              struct psc_point_f64 *p, double *pdf, double *inverse)
{
    double cosine, sine, versine, radius, margin, w;

    square_to_disk_f64(u, v, &cosine, &sine, &versine, &radius, &margin);
    w = radius * radius * l->width;
    area_point(l, w, margin * (1.0 + radius), cosine, sine, p, pdf, inverse);
}

#endif
