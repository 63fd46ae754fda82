/* SPDX-License-Identifier: Apache-2.0 */
/* From the geometry of an ellipsoid to what the receiver sees of it, also from inside. */
#ifndef PSC_SRC_ELLIPSOID_SEE_H
#define PSC_SRC_ELLIPSOID_SEE_H

#include "disk_view.h"
#include "ellipsoid_look.h"

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
