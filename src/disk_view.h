/* SPDX-License-Identifier: Apache-2.0 */
/* From geometry to what the receiver sees of a disk, an elliptical disk or an ellipsoid: the cone,
   where the light lies in it, and the horizon. */
#ifndef PSC_SRC_DISK_VIEW_H
#define PSC_SRC_DISK_VIEW_H

#include <math.h>

#include "disk_horizon.h"
#include "disk_look.h"
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

/* The light's side of an outline, in the caller's lengths; axes are the light's. */
static inline void disk_outline(struct psc_disk_light *d, const struct psc_outline *o,
                                const double axes[2][3], double unit)
{
    int i, k;

    take_outline(d, o, unit);
    for (k = 0; k < 2; k++)
        for (i = 0; i < 3; i++)
            d->across[k][i] = o->side[k][0] * axes[0][i] + o->side[k][1] * axes[1][i];
}

/* The height of the light above the receiver's horizon for axes of a flat or solid light. */
static inline psc_case disk_case(const struct psc_request *request, const struct psc_wide offset[3],
                                 const double axes[][3], int count)
{
    struct psc_wide n[3];
    double normal[3], reach = 0.0;
    int i;

    if (request->facing == PSC_FACING_NONE)
        return PSC_CASE_NO_HORIZON;
    scale_to_one(request->normal, normal);
    wide_vector(normal, n);
    for (i = 0; i < count; i++)
        reach += dot(normal, axes[i]) * dot(normal, axes[i]);
    return horizon_case(request->facing, wide_dot(n, offset).high, SQRT(reach));
}

/* The end of the build of a flat light with the semi-axes axes, from the outline in units of
   1 / scale. */
static inline psc_result flat_see(psc_sampler *s, const struct psc_request *request,
                                  const struct psc_wide offset[3], const double axes[2][3],
                                  double scale, const struct psc_outline *o)
{
    const double unit = 1.0 / scale;
    double long_axes[2][3];
    int i, k;

    s->visibility = disk_case(request, offset, axes, 2);
    if (s->visibility == PSC_CASE_EMPTY)
        return PSC_EMPTY;
    for (k = 0; k < 2; k++)
        for (i = 0; i < 3; i++)
            long_axes[k][i] = axes[k][i] * unit;
    disk_outline(&s->disk, o, (const double(*)[3])long_axes, unit);
    return PSC_SUCCESS;
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
    look_at_disk(request->position, geometry, &o);
    if (!(o.seen > 0.0) || (request->one_sided && o.facing > 0.0))
        return PSC_EMPTY;
    if (request->measure == PSC_MEASURE_PROJECTED_SOLID_ANGLE) {
        scale_to_one(request->normal, rough);
        disk_horizon(o.offset, o.normal, o.radius, &o.outline, rough, &d->horizon);
    }
    s->visibility = PSC_CASE_NO_HORIZON;
    if (request->facing != PSC_FACING_NONE) {
        look_at_horizon(request->normal, request->facing == PSC_FACING_BOTH, &o);
        s->visibility = horizon_case(request->facing, o.middle, o.reach);
    }
    if (s->visibility == PSC_CASE_EMPTY)
        return PSC_EMPTY;
    memcpy(d->center, geometry, sizeof d->center);
    memcpy(d->normal, o.outward, sizeof d->normal);
    take_outline(d, &o.outline, o.unit);
    for (k = 0; k < 2; k++)
        for (i = 0; i < 3; i++)
            d->across[k][i] = disk_across(&o, radius, k, i);
    return PSC_SUCCESS;
}

/* The centre as seen from the receiver, and the semi-axes that follow it in the geometry, in units
   of 1 / scale: rounded and in two words. PSC_EMPTY without size. */
static inline psc_result see_axes(const struct psc_request *request, const double *geometry,
                                  int count, struct psc_wide offset[3], double axes[][3],
                                  struct psc_wide wide[][3], double *scale)
{
    double size = 0.0, rough[3];
    int i, k;

    for (k = 0; k < count; k++)
        size = MAX(size, largest(geometry + 3 + 3 * k));
    if (size == 0.0)
        return PSC_EMPTY;
    for (i = 0; i < 3; i++)
        rough[i] = geometry[i] - request->position[i];
    if (!is_finite3(rough))
        return PSC_ERROR_NOT_FINITE;
    *scale = unit_scale(MAX(largest(rough), size));
    see_offset(request->position, geometry, *scale, offset);
    for (k = 0; k < count; k++) {
        for (i = 0; i < 3; i++)
            axes[k][i] = geometry[3 + 3 * k + i] * *scale;
        wide_vector(axes[k], wide[k]);
    }
    return PSC_SUCCESS;
}

/* geometry: centre, two conjugate semi-axes. */
static inline psc_result elliptical_see(psc_sampler *s, const struct psc_request *request,
                                          const double *geometry)
{
    struct psc_disk_light *d = &s->disk;
    double axes[2][3], high[3], scale, length;
    struct psc_wide offset[3], wide[2][3], normal[3], det;
    struct psc_outline o;
    psc_result result;
    struct psc_foot foot;
    int i;

    disk_clear(d, request);
    result = see_axes(request, geometry, 2, offset, axes, wide, &scale);
    if (result != PSC_SUCCESS)
        return result;
    wide_cross(wide[0], wide[1], normal);
    det = wide_dot(normal, offset);
    for (i = 0; i < 3; i++)
        high[i] = normal[i].high;
    scale_to_one(high, d->normal);
    length = SQRT(dot(d->normal, d->normal));
    if (!(length > 0.0))
        return PSC_EMPTY;
    d->area = PSC_PI * (length / unit_scale(largest(high))) / scale / scale;
    for (i = 0; i < 3; i++) {
        d->normal[i] /= length;
        high[i] = offset[i].high;
    }
    see_foot((const struct psc_wide(*)[3])wide, normal, offset, &foot);
    if (det.high == 0.0 || (request->one_sided && det.high > 0.0) ||
        !see_elliptical(axes[0], axes[1], high, det.high, &foot, &o))
        return PSC_EMPTY;
    if (request->measure == PSC_MEASURE_PROJECTED_SOLID_ANGLE) {
        scale_to_one(request->normal, high);
        light_horizon(&o, high, (const struct psc_wide(*)[3])wide, 2, NULL, offset, 1.0,
                      &d->horizon);
    }
    memcpy(d->center, geometry, sizeof d->center);
    return flat_see(s, request, offset, (const double(*)[3])axes, scale, &o);
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

/* The first two of three vectors in the directions of q_x and q_y. */
static inline void turn_pair(const double side[2][2], double v[3][3])
{
    int i;

    for (i = 0; i < 3; i++) {
        const double a = v[0][i], b = v[1][i];

        v[0][i] = side[0][0] * a + side[0][1] * b;
        v[1][i] = side[1][0] * a + side[1][1] * b;
    }
}

/*
 * geometry: centre, three conjugate semi-axes, E = (e1 e2 e3). With c' = E^-1 c the ellipsoid is
 * the unit sphere, and for C = |c'| > 1 its outline that of the elliptical disk with the
 * semi-axes E f1, E f2 across c' and the centre kappa c, kappa^2 = (C - 1)(C + 1) / C^2:
 *     E E' - c c' = g1 g1' + g2 g2' - kappa^2 c c'.
 */
static inline psc_result ellipsoid_see(psc_sampler *s, const struct psc_request *request,
                                         const double *geometry)
{
    struct psc_disk_light *d = &s->disk;
    struct psc_wide offset[3], e[3][3], cofactor[3][3], det, part[3], square;
    double axes[3][3], high[3], f[3][3], g[2][3], center[3], scale, kappa, outer, length;
    struct psc_outline o;
    psc_result result;
    int i, k;

    disk_clear(d, request);
    d->solid = 1;
    result = see_axes(request, geometry, 3, offset, axes, e, &scale);
    if (result != PSC_SUCCESS)
        return result;
    for (k = 0; k < 3; k++)
        wide_cross(e[(k + 1) % 3], e[(k + 2) % 3], cofactor[k]);
    det = wide_dot(e[0], cofactor[0]);
    if (!(ABS(det.high) > 0.0))
        return PSC_EMPTY;
    s->visibility = disk_case(request, offset, (const double(*)[3])axes, 3);
    /* c' det, and (C^2 - 1) det^2 */
    for (k = 0; k < 3; k++)
        part[k] = wide_dot(cofactor[k], offset);
    square = wide_sum(wide_dot(part, part), wide_negative(wide_square(det)));
    d->inside = square.high < 0.0;
    if (d->inside ? request->one_sided : s->visibility == PSC_CASE_EMPTY)
        return PSC_EMPTY;
    if (d->inside)
        s->visibility = PSC_CASE_INSIDE;
    d->unit = 1.0 / scale;
    d->beyond = square.high / (det.high * det.high);
    for (k = 0; k < 3; k++)
        center[k] = part[k].high / det.high;
    d->far_off = SQRT(dot(center, center));
    memcpy(d->center, geometry, sizeof d->center);

    /* f: any frame from inside, else the last along c' */
    memset(f, 0, sizeof f);
    for (k = 0; k < 3; k++)
        f[k][k] = 1.0;
    if (!d->inside) {
        for (i = 0; i < 3; i++)
            f[2][i] = center[i] / d->far_off;
        perpendicular(f[2], f[0]);
        cross_rounded(f[2], f[0], f[1]);
    }
    for (k = 0; k < 3; k++)
        for (i = 0; i < 3; i++) {
            d->solid_axis[k][i] =
                ((f[k][0] * axes[0][i] + f[k][1] * axes[1][i]) + f[k][2] * axes[2][i]);
            d->inverse[k][i] = ((f[k][0] * cofactor[0][i].high + f[k][1] * cofactor[1][i].high) +
                                f[k][2] * cofactor[2][i].high) /
                               det.high;
        }
    if (d->inside) {
        static const struct psc_ellipse all = {0.0, -1.0, 0.0, -1.0, 0.0, 0.0,
                                               {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0},
                                               {0.0, 0.0, 1.0}};

        d->seen = all;
        if (request->measure == PSC_MEASURE_PROJECTED_SOLID_ANGLE) {
            half_space(d->receiver, &d->seen);
            horizon_of_frame(&d->seen, d->receiver, 1.0, &d->horizon);
            d->horizon.margin = -1.0;
        }
        d->beyond = -d->beyond;
        memcpy(d->offset, center, sizeof center);
    } else {
        memcpy(g, d->solid_axis, sizeof g);
        outer = SQRT(d->beyond);
        kappa = outer / d->far_off;
        for (i = 0; i < 3; i++)
            high[i] = kappa * offset[i].high;
        if (d->beyond > 0.0 ? !see_elliptical(g[0], g[1], high, outer * det.high, NULL, &o) : 0)
            return PSC_EMPTY;
        d->beyond = outer;
        if (!(outer > 0.0)) {
            /* On the surface: the half space on the inner side of its tangent plane. */
            memset(&o, 0, sizeof o);
            length = 1.0 / SQRT(dot(d->inverse[2], d->inverse[2]));
            for (i = 0; i < 3; i++)
                high[i] = d->inverse[2][i] * length;
            half_space(high, &o.seen);
            o.near = o.far = o.turn[0] = o.side[0][0] = o.side[1][1] = 1.0;
        }
        if (request->measure == PSC_MEASURE_PROJECTED_SOLID_ANGLE) {
            scale_to_one(request->normal, high);
            light_horizon(&o, high, (const struct psc_wide(*)[3])e, 3, (const double(*)[3])f,
                          offset, kappa, &d->horizon);
        }
        for (k = 0; k < 2; k++)
            for (i = 0; i < 3; i++)
                g[k][i] *= d->unit;
        disk_outline(d, &o, (const double(*)[3])g, d->unit);
        turn_pair((const double(*)[2])o.side, d->solid_axis);
        turn_pair((const double(*)[2])o.side, d->inverse);
    }
    for (k = 0; k < 3; k++)
        for (i = 0; i < 3; i++)
            d->solid_axis[k][i] *= d->unit;
    return PSC_SUCCESS;
}

#endif
