/* SPDX-License-Identifier: Apache-2.0 */
/* From geometry to what the receiver sees of a disk, an elliptical disk or an ellipsoid: the cone,
   where the light lies in it, and the horizon. */
#ifndef PSC_SRC_DISK_VIEW_H
#define PSC_SRC_DISK_VIEW_H

#include <math.h>

#include "disk_horizon.h"
#include "disk_look.h"
#include "ellipse_look.h"
#include "ellipsoid_look.h"
#include "sampler.h"

static inline void disk_clear(struct psc_disk_light *d, const struct psc_request *request)
{
    int i;

    memset(&d->seen, 0, sizeof d->seen);
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

/* The half space around a unit vector. */
static inline void half_space(const double z[3], struct psc_ellipse *e)
{
    e->a = e->b = 1.0;
    e->ca = e->cb = 0.0;
    e->at = e->bt = (double)INFINITY;
    memcpy(e->z, z, sizeof e->z);
    perpendicular(e->z, e->x);
    cross_rounded(e->z, e->x, e->y);
}

/* From inside, the frame is that of the semi-axes, and the cone is all directions or, by projected
   solid angle, the half space above the receiver. */
static inline void see_inside(psc_sampler *s, const struct psc_request *request,
                              struct psc_ellipsoid_look *o)
{
    static const struct psc_ellipse all = {0.0, -1.0, 0.0, -1.0, 0.0, 0.0,
                                           {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0},
                                           {0.0, 0.0, 1.0}};
    struct psc_disk_light *d = &s->disk;
    int k;

    s->visibility = PSC_CASE_INSIDE;
    memset(o->f, 0, sizeof o->f);
    for (k = 0; k < 3; k++)
        o->f[k][k] = 1.0;
    turn_ellipsoid(o);
    d->seen = all;
    if (request->measure == PSC_MEASURE_PROJECTED_SOLID_ANGLE) {
        half_space(d->receiver, &d->seen);
        horizon_of_frame(&d->seen, d->receiver, 1.0, &d->horizon);
        d->horizon.margin = -1.0;
    }
    d->beyond = -o->square;
    memcpy(d->offset, o->center, sizeof d->offset);
}

/* From outside or on the surface, where the cone is the half space on the inner side of the tangent
   plane. */
static inline psc_result see_outside(psc_sampler *s, const struct psc_request *request,
                                     struct psc_ellipsoid_look *o)
{
    struct psc_disk_light *d = &s->disk;
    int i, k;

    look_from_outside(0, o);
    if (!(o->outer > 0.0)) {
        const double length = 1.0 / SQRT(dot(o->inverse[2], o->inverse[2]));
        double inner[3];

        memset(&o->outline, 0, sizeof o->outline);
        for (i = 0; i < 3; i++)
            inner[i] = o->inverse[2][i] * length;
        half_space(inner, &o->outline.seen);
        o->outline.near = o->outline.far = o->outline.turn[0] = 1.0;
        o->outline.side[0][0] = o->outline.side[1][1] = 1.0;
    } else if (!(o->outline.seen.bt > 0.0)) {
        return PSC_EMPTY;
    }
    if (request->measure == PSC_MEASURE_PROJECTED_SOLID_ANGLE) {
        struct psc_wide wide[3][3];
        double normal[3];

        for (k = 0; k < 3; k++)
            wide_vector(o->axes[k], wide[k]);
        scale_to_one(request->normal, normal);
        light_horizon(&o->outline, normal, (const struct psc_wide(*)[3])wide, 3,
                      (const double(*)[3])o->f, o->offset, o->kappa, &d->horizon);
    }
    take_outline(d, &o->outline, o->unit);
    d->beyond = o->outer;
    turn_pair((const double(*)[2])o->outline.side, o->solid_axis);
    turn_pair((const double(*)[2])o->outline.side, o->inverse);
    return PSC_SUCCESS;
}

/* geometry: centre, three conjugate semi-axes. */
static inline psc_result ellipsoid_see(psc_sampler *s, const struct psc_request *request,
                                       const double *geometry)
{
    struct psc_disk_light *d = &s->disk;
    struct psc_ellipsoid_look o;
    psc_result result;
    int i, k;

    disk_clear(d, request);
    d->solid = 1;
    result = check_axes(request, geometry, 3);
    if (result != PSC_SUCCESS)
        return result;
    look_at_ellipsoid(request->position, geometry, &o);
    if (!(ABS(o.det) > 0.0))
        return PSC_EMPTY;
    s->visibility = disk_case(request, o.offset, (const double(*)[3])o.axes, 3);
    d->inside = o.square < 0.0;
    if (d->inside ? request->one_sided : s->visibility == PSC_CASE_EMPTY)
        return PSC_EMPTY;
    d->unit = o.unit;
    d->far_off = o.far_off;
    memcpy(d->center, geometry, sizeof d->center);
    if (d->inside) {
        see_inside(s, request, &o);
    } else {
        result = see_outside(s, request, &o);
        for (k = 0; k < 2; k++)
            for (i = 0; i < 3; i++)
                d->across[k][i] = o.solid_axis[k][i] * o.unit;
    }
    for (k = 0; k < 3; k++)
        for (i = 0; i < 3; i++) {
            d->solid_axis[k][i] = o.solid_axis[k][i] * o.unit;
            d->inverse[k][i] = o.inverse[k][i];
        }
    return result;
}

#endif
