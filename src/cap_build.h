/* SPDX-License-Identifier: Apache-2.0 */
/* From what a receiver sees of a cap to a sampler that is ready. */
#ifndef PSC_SRC_CAP_BUILD_H
#define PSC_SRC_CAP_BUILD_H

#include <math.h>

#include "cap_view.h"
#include "projected_build.h"
#include "sampler.h"

/* The lobe of the part of a region up to its total; q = sqrt(q2). */
static inline void lobe_total(struct psc_lobe_f64 *l, enum psc_region region,
                              const struct psc_cap *cap, double h0, double *q)
{
    *q = 0.0;
    switch (region) {
    case PSC_REGION_EMPTY: l->total = 0.0; break;
    case PSC_REGION_ELLIPSE: ellipse_build(l, cap, h0); break;
    case PSC_REGION_BOTH: *q = both_build(l, cap, h0); break;
    case PSC_REGION_LUNE: *q = lune_build(l, cap, h0); break;
    }
}

/* By elements, see copy3(). */
static inline void copy_cap(const struct psc_cap *from, struct psc_cap *to)
{
    to->sin_a = from->sin_a;
    to->cos_a = from->cos_a;
    to->sin_b = from->sin_b;
    to->cos_b = from->cos_b;
    to->q2 = from->q2;
}

static inline struct psc_cap mirrored(const struct psc_cap *cap)
{
    struct psc_cap below = *cap;

    below.sin_b = -below.sin_b;
    return below;
}

/* Where a cap lies to the horizon, given the region above the receiver's plane. */
static inline psc_case cap_case(const struct psc_cap *cap, enum psc_region region,
                                enum psc_facing facing)
{
    static const psc_case cases[] = {PSC_CASE_EMPTY, PSC_CASE_ELLIPSE,
                                     PSC_CASE_ELLIPSE_AND_LUNE, PSC_CASE_LUNE};

    if (facing == PSC_FACING_NONE)
        return PSC_CASE_NO_HORIZON;
    if (facing == PSC_FACING_BOTH && cap->sin_b < 0.0) {
        const struct psc_cap below = mirrored(cap);

        return cases[psc_cap_region(&below)];
    }
    return cases[region];
}

/* The frame of the cone and area maps: x is down towards the horizon, z the axis. */
static inline void cone_side(struct psc_side *side, const struct psc_cap *cap,
                             const struct psc_cap_view *o)
{
    struct psc_lobe_f64 *l = &side->lobe;

    l->sin_a = cap->sin_a;
    l->cos_a = cap->cos_a;
    l->sin_b = cap->sin_b;
    l->cos_b = cap->cos_b;
    l->rise = 1.0;
    copy3(o->axis, side->axis);
    copy3(o->axis, side->z);
    copy3(o->sideways, side->y);
    cross_rounded(side->y, o->axis, side->x);
}

static inline enum psc_cap_map cone_map(psc_map map)
{
    return map == PSC_MAP_RADIAL ? PSC_CAP_RADIAL_CONE : PSC_CAP_CONCENTRIC_CONE;
}

static inline enum psc_cap_map projected_map(psc_map map, enum psc_region region)
{
    static const enum psc_cap_map maps[3][4] = {
        {0, PSC_CAP_RADIAL_ELLIPSE, PSC_CAP_RADIAL_BOTH, PSC_CAP_RADIAL_LUNE},
        {0, PSC_CAP_PARALLEL_ELLIPSE, PSC_CAP_PARALLEL_BOTH, PSC_CAP_PARALLEL_LUNE},
        {0, PSC_CAP_CONCENTRIC_ELLIPSE, PSC_CAP_CONCENTRIC_BOTH, PSC_CAP_CONCENTRIC_LUNE},
    };

    return maps[map][region];
}

/* The frame of the maps by projected solid angle above (sign 1) or below (-1) the receiver's plane,
   of a cap around the axis or, for the other half of all directions, against it (axis_sign). */
static inline void projected_frame(struct psc_side *side, const struct psc_cap_view *o,
                                   double sign, double axis_sign)
{
    copy3(o->sideways, side->y);
    cross_rounded(o->sideways, o->normal, side->x);
    scale3(sign, o->normal, side->z);
    scale3(axis_sign, o->axis, side->axis);
}

/* The lobe and frame of one side; its total. */
static double projected_side(struct psc_side *side, psc_map map, enum psc_region region,
                             const struct psc_cap *cap, double h0, const struct psc_cap_view *o,
                             double sign, double axis_sign)
{
    struct psc_lobe_f64 *l = &side->lobe;
    double q;

    lobe_total(l, region, cap, h0, &q);
    if (region == PSC_REGION_EMPTY)
        return 0.0;
    side->map = projected_map(map, region);
    if (region != PSC_REGION_ELLIPSE) {
        if (map != PSC_MAP_RADIAL)
            parallel_build(l, region == PSC_REGION_LUNE, q);
        else if (region == PSC_REGION_BOTH)
            radial_both_build(l);
        else
            radial_lune_build(l, q);
    }
    projected_frame(side, o, sign, axis_sign);
    return l->total;
}

/* Sets up the sides for projected solid angle of a cap that the horizon cuts, or that is below it,
   or that is all directions. */
static psc_result projected_sides(psc_sampler *s, enum psc_region region,
                                  const struct psc_cap_view *o)
{
    const double h0 = s->cap.inside ? 1.0 : o->h0; /* of half of all directions */
    const double above = projected_side(s->cap.side, s->map, region, &o->cap, h0, o, 1.0, 1.0);

    s->total = above;
    s->sides = above > 0.0;
    if (s->facing == PSC_FACING_BOTH) {
        const struct psc_cap below = s->cap.inside ? o->cap : mirrored(&o->cap);
        const double second =
            projected_side(s->cap.side + s->sides, s->map, psc_cap_region(&below), &below, h0, o,
                           -1.0, s->cap.inside ? -1.0 : 1.0);

        s->sides += second > 0.0;
        s->total = above + second;
        s->split = above / s->total;
    }
    return s->sides > 0 ? PSC_SUCCESS : PSC_EMPTY;
}

/* Sets up the sides for (projected) solid angle. */
static inline psc_result cap_sides(psc_sampler *s, const struct psc_cap_view *o)
{
    const enum psc_region region = psc_cap_region(&o->cap);
    struct psc_side *side = s->cap.side;

    s->visibility = s->cap.inside ? PSC_CASE_INSIDE : cap_case(&o->cap, region, s->facing);
    if (s->visibility == PSC_CASE_EMPTY)
        return PSC_EMPTY;
    if (!s->projected) {
        cone_side(side, &o->cap, o);
        side->lobe.h0 = o->h0;
        side->map = cone_map(s->map);
        s->total = 2.0 * PSC_PI * o->h0;
    } else if (region == PSC_REGION_ELLIPSE && !s->cap.inside) {
        side->map = projected_map(s->map, region);
        ellipse_build(&side->lobe, &o->cap, o->h0);
        projected_frame(side, o, 1.0, 1.0);
        s->total = side->lobe.total;
    } else {
        /* A copy of its own leaves the view of all others in registers. */
        const struct psc_cap_view own = *o;

        return projected_sides(s, region, &own);
    }
    s->sides = 1;
    return PSC_SUCCESS;
}

/* What the area maps need of a sphere, from its view. */
PSC_LANE void area_build(struct psc_lobe_f64 *l, double distance, double radius, double power,
                         int visible)
{
    l->delta = distance / radius;
    l->gap = power / (radius * (distance + radius));
    l->width = visible ? l->gap / l->delta : 2.0;
    l->visible = visible ? 1.0 : 0.0;
    l->total_area = 2.0 * PSC_PI * l->width;
}

/* The area maps of a sphere; on its surface the visible part has no area. */
static inline psc_result area_side(psc_sampler *s, const struct psc_cap_view *o)
{
    struct psc_lobe_f64 *l = &s->cap.side[0].lobe;
    const int visible = s->measure == PSC_MEASURE_VISIBLE_AREA && !s->cap.inside;

    s->visibility = s->cap.inside
                        ? PSC_CASE_INSIDE
                        : cap_case(&o->cap, psc_cap_region(&o->cap), s->facing);
    if (s->visibility == PSC_CASE_EMPTY || o->power == 0.0)
        return PSC_EMPTY;
    cone_side(s->cap.side, &o->cap, o);
    s->cap.side[0].map = s->map == PSC_MAP_RADIAL ? PSC_CAP_RADIAL_AREA : PSC_CAP_CONCENTRIC_AREA;
    area_build(l, o->distance, o->radius, o->power, visible);
    s->sides = 1;
    s->total = l->total_area * (s->cap.radius * s->cap.radius);
    return PSC_SUCCESS;
}

static inline int is_area_measure(psc_measure measure)
{
    return measure == PSC_MEASURE_AREA || measure == PSC_MEASURE_VISIBLE_AREA;
}

/* What is left when there is nothing to see: no size, in any measure. */
static inline void cap_clear(struct psc_cap_light *light)
{
    static const struct psc_cap none = {0.0, 0.0, 0.0, 0.0, 0.0};

    copy_cap(&none, &light->seen);
    light->inside = 0;
    light->radius = 0.0;
}

/* geometry: centre, radius. */
static inline psc_result sphere_build(psc_sampler *s, const struct psc_request *request,
                                      const double *geometry)
{
    const double radius = geometry[3];
    struct psc_cap_view o;

    cap_clear(&s->cap);
    if (radius < 0.0)
        return PSC_ERROR_NEGATIVE_SIZE;
    s->cap.radius = radius;
    copy3(geometry, s->cap.center);
    if (radius == 0.0)
        return PSC_EMPTY;
    see_sphere(request->position, request->normal, geometry, radius, &o);
    if (!is_finite(o.distance))
        return PSC_ERROR_NOT_FINITE;
    s->cap.distance = o.distance * o.unit;
    if (o.power < 0.0 && request->one_sided)
        return PSC_EMPTY;
    s->cap.inside = o.power < 0.0;
    copy_cap(&o.cap, &s->cap.seen);
    if (s->cap.inside) {
        int i;

        s->cap.slack = -o.power / (o.radius * o.radius);
        for (i = 0; i < 3; i++)
            s->cap.offset[i] = (geometry[i] - request->position[i]) * o.scale / o.radius;
    }
    if (is_area_measure(s->measure))
        return area_side(s, &o);
    if (s->cap.inside) {
        /* Light everywhere: the frame is that of the horizon, or any. */
        static const double up[3] = {0.0, 0.0, 1.0};
        static const struct psc_cap all = {1.0, 0.0, 1.0, 0.0, 0.0};

        copy_cap(&all, &o.cap);
        copy_cap(&all, &s->cap.seen);
        copy3(request->normal ? o.normal : up, o.normal);
        copy3(o.normal, o.axis);
        perpendicular(o.axis, o.sideways);
    }
    return cap_sides(s, &o);
}

/* geometry: axis, half-angle. */
static inline psc_result distant_build(psc_sampler *s, const struct psc_request *request,
                                       const double *geometry)
{
    const double half_angle = geometry[3];
    struct psc_cap_view o;

    cap_clear(&s->cap);
    s->cap.distance = (double)INFINITY;
    if (half_angle < 0.0)
        return PSC_ERROR_NEGATIVE_SIZE;
    if (half_angle > (s->projected ? 0.5 * PSC_PI : PSC_PI))
        return PSC_ERROR_HALF_ANGLE;
    if (largest(geometry) == 0.0)
        return PSC_ERROR_ZERO_VECTOR;
    if (half_angle == 0.0)
        return PSC_EMPTY;
    see_cap(request->normal, geometry, half_angle, &o);
    copy_cap(&o.cap, &s->cap.seen);
    return cap_sides(s, &o);
}

#endif
