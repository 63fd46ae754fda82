/* SPDX-License-Identifier: Apache-2.0 */
/* From geometry to what the receiver sees of a disk or an elliptical disk: the cone and where the
   light lies in it, or how it lies in its plane, and the horizon. */
#ifndef PSC_SRC_DISK_VIEW_H
#define PSC_SRC_DISK_VIEW_H

#include <math.h>

#include "disk_horizon.h"
#include "disk_look.h"
#include "ellipse_look.h"
#include "sampler.h"

static inline void disk_clear(struct psc_disk_light *d, const struct psc_request *request)
{
    int i;

    d->seen.a = 0.0; /* nothing */
    d->solid = d->inside = 0;
    d->area = 0.0;
    d->cdf.terms = 0;
    for (i = 0; i < 3; i++)
        d->receiver[i] = 0.0;
    if (request->normal)
        unit_normal(request->normal, d->receiver);
}

/* Whether anything is above the horizon, and how it lies: middle is the height of the centre,
   reach how far the light goes above and below that. */
static inline psc_case horizon_case(enum psc_facing facing, double middle, double reach)
{
    if (facing == PSC_FACING_NONE)
        return PSC_CASE_NO_HORIZON;
    if (facing == PSC_FACING_BOTH)
        middle = ABS(middle);
    return middle >= reach ? PSC_CASE_ABOVE : middle > -reach ? PSC_CASE_CLIPPED : PSC_CASE_EMPTY;
}

/* An outline in units of `unit`. */
static inline void take_outline(struct psc_disk_light *d, const struct psc_outline *o, double unit)
{
    d->seen = o->seen;
    d->near = o->near;
    d->far = o->far;
    d->reach = o->reach * unit;
    memcpy(d->turn, o->turn, sizeof d->turn);
    memcpy(d->side, o->side, sizeof d->side);
}

/* A light that is sampled by area, see struct psc_laid, in units of `unit`: directions are sums
   of the frame alone, and its points are in terms of its own semi-axes. */
static inline void take_frame(struct psc_disk_light *d, double frame[3][3], double unit)
{
    copy3(frame[0], d->seen.x);
    copy3(frame[1], d->seen.y);
    copy3(frame[2], d->seen.z);
    d->reach = unit;
    d->side[0][0] = d->side[1][1] = 1.0;
    d->side[0][1] = d->side[1][0] = 0.0;
}

/* The height of the light above the receiver's horizon, from its semi-axes. */
static inline psc_case disk_case(const struct psc_request *request, const struct psc_wide offset[3],
                                 const double axes[][3], int count)
{
    double middle, reach;

    if (request->facing == PSC_FACING_NONE)
        return PSC_CASE_NO_HORIZON;
    see_horizon(request->normal, request->facing == PSC_FACING_BOTH, offset, axes, count, &middle,
                &reach);
    return horizon_case(request->facing, middle, reach);
}

/* geometry: centre, normal, radius. */
static inline psc_result disk_see(psc_sampler *s, const struct psc_request *request,
                                    const double *geometry)
{
    struct psc_disk_light *d = &s->disk;
    const double radius = geometry[6];
    struct psc_disk_look o;
    double rough[3];
    int i, k;

    disk_clear(d, request);
    if (largest(geometry + 3) == 0.0)
        return PSC_ERROR_ZERO_VECTOR;
    if (radius < 0.0)
        return PSC_ERROR_NEGATIVE_SIZE;
    d->area = disk_area(radius);
    if (radius == 0.0)
        return PSC_EMPTY;
    for (i = 0; i < 3; i++)
        rough[i] = geometry[i] - request->position[i];
    if (!is_finite3(rough))
        return PSC_ERROR_NOT_FINITE;
    face_disk(request->position, geometry, &o);
    if (!(o.height > 0.0) || (request->one_sided && o.facing > 0.0))
        return PSC_EMPTY;
    s->visibility = PSC_CASE_NO_HORIZON;
    if (request->facing != PSC_FACING_NONE) {
        look_at_horizon(request->normal, request->facing == PSC_FACING_BOTH, &o);
        s->visibility = horizon_case(request->facing, o.middle, o.reach);
    }
    if (s->visibility == PSC_CASE_EMPTY)
        return PSC_EMPTY;
    copy3(geometry, d->center);
    copy3(o.outward, d->normal);
    if (request->measure == PSC_MEASURE_AREA) {
        double frame[3][3];

        lay_disk(&o, frame, &d->laid);
        take_frame(d, frame, o.unit);
        for (k = 0; k < 2; k++)
            scale3(radius, o.axes[k], d->across[k]);
        return PSC_SUCCESS;
    }
    look_at_disk(&o);
    if (!(o.seen > 0.0))
        return PSC_EMPTY;
    if (request->measure == PSC_MEASURE_PROJECTED_SOLID_ANGLE) {
        scale_to_one(request->normal, rough);
        disk_horizon(o.offset, o.normal, o.radius, &o.outline, rough, &d->horizon);
    }
    take_outline(d, &o.outline, o.unit);
    for (k = 0; k < 2; k++)
        for (i = 0; i < 3; i++)
            d->across[k][i] = disk_across(&o, radius, k, i);
    return PSC_SUCCESS;
}

/* PSC_EMPTY without any size; whether the centre is in reach of numbers. */
static inline psc_result check_axes(const struct psc_request *request, const double *geometry,
                                    int count)
{
    double size = 0.0, rough[3];
    int i;

    for (i = 0; i < count; i++)
        size = MAX(size, largest(geometry + 3 + 3 * i));
    if (size == 0.0)
        return PSC_EMPTY;
    for (i = 0; i < 3; i++)
        rough[i] = geometry[i] - request->position[i];
    return is_finite3(rough) ? PSC_SUCCESS : PSC_ERROR_NOT_FINITE;
}

/* geometry: centre, two conjugate semi-axes. */
static inline psc_result elliptical_see(psc_sampler *s, const struct psc_request *request,
                                        const double *geometry)
{
    struct psc_disk_light *d = &s->disk;
    struct psc_ellipse_look o;
    psc_result result;
    int i, k;

    disk_clear(d, request);
    result = check_axes(request, geometry, 2);
    if (result != PSC_SUCCESS)
        return result;
    face_ellipse(request->position, geometry, &o);
    if (!(o.area > 0.0))
        return PSC_EMPTY;
    d->area = o.area;
    if (!(o.height > 0.0) || (request->one_sided && o.facing > 0.0))
        return PSC_EMPTY;
    s->visibility = disk_case(request, o.offset, (const double(*)[3])o.axes, 2);
    if (s->visibility == PSC_CASE_EMPTY)
        return PSC_EMPTY;
    copy3(geometry, d->center);
    copy3(o.outward, d->normal);
    if (request->measure == PSC_MEASURE_AREA) {
        double frame[3][3];

        lay_ellipse(&o, frame, &d->laid);
        take_frame(d, frame, o.unit);
        copy3(geometry + 3, d->across[0]);
        copy3(geometry + 6, d->across[1]);
        return PSC_SUCCESS;
    }
    look_at_ellipse(0, &o);
    if (!(o.seen > 0.0))
        return PSC_EMPTY;
    if (request->measure == PSC_MEASURE_PROJECTED_SOLID_ANGLE) {
        struct psc_wide wide[2][3];
        double normal[3];

        wide_vector(o.axes[0], wide[0]);
        wide_vector(o.axes[1], wide[1]);
        scale_to_one(request->normal, normal);
        light_horizon(&o.outline, normal, (const struct psc_wide(*)[3])wide, 2, NULL, o.offset, 1.0,
                      &d->horizon);
    }
    take_outline(d, &o.outline, o.unit);
    for (k = 0; k < 2; k++)
        for (i = 0; i < 3; i++)
            d->across[k][i] = ellipse_across(&o, k, i);
    return PSC_SUCCESS;
}

#endif
