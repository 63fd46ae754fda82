/* SPDX-License-Identifier: Apache-2.0 */
/*
 * The build that a path tracer makes for each light and ray: a sphere by projected solid angle,
 * from outside, in view of a one-sided receiver, where plain products suffice. From the public
 * call's arguments straight to the sampler: no request, no branch but those that are never taken.
 * Everything else, and everything that is wrong, is left to the build for all.
 */
#ifndef PSC_SRC_SPHERE_QUICK_H
#define PSC_SRC_SPHERE_QUICK_H

#include "cap_build.h"

/* With a view of its own, so that nobody else's is kept in memory. */
static psc_result sphere_quick_clipped(psc_sampler *s, enum psc_region region,
                                       const struct psc_cap_view *o)
{
    s->total = projected_side(s->cap.side, s->map, region, &o->cap, o->h0, o, 1.0, 1.0);
    if (!(s->total > 0.0))
        return PSC_PENDING;
    s->inverse_total = 1.0 / s->total;
    return PSC_SUCCESS;
}

/* PSC_SUCCESS, the sampler being complete but for what the caller knows of itself (kernels and
   shape), or PSC_PENDING: not one of these. */
static psc_result sphere_quick(psc_sampler *s, const psc_technique *technique,
                               const psc_receiver *receiver, const double *const vectors[],
                               double radius)
{
    const double *const center = vectors[0];
    const double *position, *normal;
    struct psc_side *side;
    enum psc_region region;
    struct psc_cap_view o;

    if (!technique || technique->struct_size != sizeof *technique ||
        technique->measure != PSC_MEASURE_PROJECTED_SOLID_ANGLE ||
        technique->map > PSC_MAP_CONCENTRIC || technique->flags != 0)
        return PSC_PENDING;
    if (!receiver || receiver->struct_size != sizeof *receiver || receiver->flags != 0)
        return PSC_PENDING;
    position = receiver->position;
    normal = receiver->normal;
    if (!position || !normal || !center || !sphere_is_plain(position, normal, center, radius))
        return PSC_PENDING;
    see_sphere_as(1, position, normal, center, radius, &o);
    region = psc_cap_region(&o.cap);
    if (region == PSC_REGION_EMPTY)
        return PSC_PENDING;

    s->measure = PSC_MEASURE_PROJECTED_SOLID_ANGLE;
    s->map = technique->map;
    s->visibility = PSC_CASE_ELLIPSE;
    s->facing = PSC_FACING_ONE;
    s->projected = 1;
    s->sides = 1;
    copy3(center, s->cap.center);
    s->cap.radius = radius;
    s->cap.distance = o.distance;
    s->cap.inside = 0;
    copy_cap(&o.cap, &s->cap.seen);
    if (region != PSC_REGION_ELLIPSE) {
        const struct psc_cap_view own = o;

        s->visibility = region == PSC_REGION_BOTH ? PSC_CASE_ELLIPSE_AND_LUNE : PSC_CASE_LUNE;
        return sphere_quick_clipped(s, region, &own);
    }
    side = s->cap.side;
    side->map = projected_map(technique->map, region);
    ellipse_build(&side->lobe, &o.cap, o.h0);
    projected_frame(side, &o, 1.0, 1.0);
    s->total = side->lobe.total;
    s->inverse_total = 1.0 / s->total;
    return s->total > 0.0 ? PSC_SUCCESS : PSC_PENDING;
}

#endif
