/* SPDX-License-Identifier: Apache-2.0 */
/* Spheres: a cap of directions with sin alpha = radius / distance, and a surface to hit. */
#include "cap_light.h"
#include "vector.h"

/* The sphere as the receiver sees it, in units of a power of two. */
struct view_of_sphere {
    double offset[3];    /* centre minus position */
    double scale;        /* multiplies lengths of the caller */
    double radius, distance;
    double power;        /* distance^2 - radius^2, exact to rounding: 0 on the surface */
    struct psc_cap cap;  /* its horizon only with a normal */
    struct psc_cap_frame frame;
};

static int see_sphere(struct view_of_sphere *o, const struct psc_view *view,
                      const double center[3], double radius)
{
    double low[3], high = 0.0, error = 0.0, d2, inverse;
    int i;

    for (i = 0; i < 3; i++)
        two_sum(center[i], -view->position[i], &o->offset[i], &low[i]);
    d2 = largest(o->offset);
    o->scale = unit_scale(MAX(d2, radius));
    for (i = 0; i < 3; i++) {
        o->offset[i] *= o->scale;
        low[i] *= o->scale;
    }
    o->radius = radius * o->scale;

    /* |offset|^2 - radius^2 with the rounding of every product: its relative error decides how
       well a receiver close to the surface is served. */
    for (i = 0; i < 3; i++)
        add_product(o->offset[i], o->offset[i], &high, &error);
    d2 = high + error;
    add_product(o->radius, -o->radius, &high, &error);
    o->power = high + (error + 2.0 * dot(o->offset, low));
    o->distance = SQRT(d2);

    inverse = 1.0 / o->distance;
    o->cap.sin_a = MIN(o->radius * inverse, 1.0);
    o->cap.cos_a = SQRT(MAX(o->power, 0.0)) * inverse;
    if (o->distance > 0.0)
        for (i = 0; i < 3; i++)
            o->frame.axis[i] = o->offset[i] * inverse;
    else
        for (i = 0; i < 3; i++)
            o->frame.axis[i] = view->facing == PSC_FACING_NONE ? (double)(i == 2)
                                                               : view->normal[i];
    if (view->facing == PSC_FACING_NONE) {
        psc_cap_frame_around(o->frame.axis, &o->frame);
        o->cap.sin_b = 1.0;
        o->cap.cos_b = 0.0;
        o->cap.q2 = 0.0;
    } else {
        double across[3], along[3], reach, height, height_low;
        double up = 0.0, up_low = 0.0, n2 = 0.0, n2_low = 0.0, length;
        const double *n = view->normal;

        for (i = 0; i < 3; i++) {
            add_product(n[i], o->offset[i], &up, &up_low);
            add_product(n[i], n[i], &n2, &n2_low);
        }
        up_low += dot(n, low);
        length = SQRT(n2);
        divide_by_root(up, up_low, n2, n2_low, length, &height, &height_low);
        cross(n, o->offset, across);
        cross(n, low, along);
        for (i = 0; i < 3; i++) {
            o->frame.normal[i] = n[i] / length;
            across[i] += along[i];
        }
        reach = SQRT(dot(across, across));
        if (o->distance == 0.0) {
            memcpy(o->frame.axis, o->frame.normal, sizeof o->frame.axis);
            height = 1.0;
            inverse = 1.0;
        }
        if (reach > 0.0)
            for (i = 0; i < 3; i++)
                o->frame.sideways[i] = across[i] / reach;
        else
            perpendicular(o->frame.normal, o->frame.sideways);
        o->cap.sin_b = height * inverse;
        o->cap.cos_b = reach / length * inverse;
        if (height < 0.0) {
            height = -height;
            height_low = -height_low;
        }
        /* How far the horizon is inside the sphere decides what is left of a thin lune. */
        o->cap.q2 = ((o->radius - height) - height_low) * (o->radius + height) *
                    (inverse * inverse);
    }
    return is_finite(o->distance);
}

static psc_result build_area(psc_sampler *s, const struct view_of_sphere *o)
{
    struct psc_lobe_f64 *l = &s->side[0].lobe;
    const int visible = s->measure == PSC_MEASURE_VISIBLE_AREA && !s->inside;

    if (s->map == PSC_MAP_PARALLEL)
        return PSC_ERROR_UNSUPPORTED_TECHNIQUE;
    s->visibility = s->inside ? PSC_CASE_INSIDE : psc_cap_case(&o->cap, s->facing);
    if (s->visibility == PSC_CASE_EMPTY || o->power == 0.0)
        return PSC_EMPTY;
    psc_cone_side(s->side, &o->cap, &o->frame);
    s->side[0].map = s->map == PSC_MAP_RADIAL ? PSC_CAP_RADIAL_AREA : PSC_CAP_CONCENTRIC_AREA;
    l->delta = o->distance / o->radius;
    l->gap = o->power / (o->radius * (o->distance + o->radius));
    l->width = visible ? l->gap / l->delta : 2.0;
    l->visible = visible ? 1.0 : 0.0;
    l->total_area = 2.0 * PSC_PI * l->width;
    s->sides = 1;
    s->total = l->total_area * (s->radius * s->radius);
    return PSC_SUCCESS;
}

static psc_result build(psc_sampler *s, const struct psc_view *view, const double *g)
{
    struct view_of_sphere o;
    const double radius = g[3];
    double h0;
    int i;

    if (radius < 0.0)
        return PSC_ERROR_NEGATIVE_SIZE;
    if (s->map == PSC_MAP_PARALLEL && !s->projected)
        return PSC_ERROR_UNSUPPORTED_TECHNIQUE;
    s->radius = radius;
    for (i = 0; i < 3; i++) {
        s->center[i] = g[i];
        s->offset[i] = g[i] - view->position[i];
    }
    if (radius == 0.0)
        return PSC_EMPTY;
    if (!see_sphere(&o, view, g, radius))
        return PSC_ERROR_NOT_FINITE;
    s->distance = o.distance / o.scale;
    s->inside = o.power < 0.0;
    s->cap = o.cap;
    if (s->measure == PSC_MEASURE_AREA || s->measure == PSC_MEASURE_VISIBLE_AREA)
        return build_area(s, &o);
    if (s->inside) {
        /* Light everywhere: the frame is that of the horizon, or any. */
        const double up[3] = {0.0, 0.0, 1.0};
        const struct psc_cap all = {1.0, 0.0, 1.0, 0.0, 0.0};

        s->cap = all;
        psc_cap_frame_around(view->facing == PSC_FACING_NONE ? up : o.frame.normal, &o.frame);
    }
    h0 = s->inside ? 2.0 : o.cap.sin_a * o.cap.sin_a / (1.0 + o.cap.cos_a);
    return psc_cap_sides(s, &o.frame, h0);
}

static psc_result area(const psc_sampler *s, double *value)
{
    *value = 4.0 * PSC_PI * (s->radius * s->radius);
    return *value > 0.0 ? PSC_SUCCESS : PSC_EMPTY;
}

const struct psc_shape_row psc_shape_sphere = {
    PSC_SHAPE_SPHERE, "vs", build, psc_cap_whole_solid_angle, psc_cap_projected_solid_angle, area,
    psc_cap_pdf, psc_cap_invert};

psc_result psc_build_sphere(psc_sampler *sampler, const psc_technique *technique,
                            const psc_receiver *receiver, const double center[3], double radius)
{
    const double *const parts[] = {center, &radius};

    return psc_build(sampler, &psc_shape_sphere, technique, receiver, parts);
}

psc_result psc_sphere_sample_n_f64(const psc_technique *technique, size_t count,
                                   const psc_receivers_f64 *receivers,
                                   const psc_input_f64 *center, const psc_input_f64 *radius,
                                   const psc_input_f64 *uv, const psc_samples_f64 *out)
{
    const psc_input_f64 *const parts[] = {center, radius};

    return psc_wavefront_f64(&psc_shape_sphere, technique, count, receivers, parts, uv, out);
}

psc_result psc_sphere_sample_n_f32(const psc_technique *technique, size_t count,
                                   const psc_receivers_f32 *receivers,
                                   const psc_input_f32 *center, const psc_input_f32 *radius,
                                   const psc_input_f32 *uv, const psc_samples_f32 *out)
{
    const psc_input_f32 *const parts[] = {center, radius};

    return psc_wavefront_f32(&psc_shape_sphere, technique, count, receivers, parts, uv, out);
}

psc_result psc_sphere_solid_angle(const double position[3], const double center[3],
                                  double radius, double *solid_angle)
{
    struct view_of_sphere o;
    struct psc_view view;

    if (!position || !center || !solid_angle)
        return PSC_ERROR_NULL_POINTER;
    if (!is_finite3(position) || !is_finite3(center) || !is_finite(radius))
        return PSC_ERROR_NOT_FINITE;
    if (radius < 0.0)
        return PSC_ERROR_NEGATIVE_SIZE;
    *solid_angle = 0.0;
    if (radius == 0.0)
        return PSC_EMPTY;
    psc_check_receiver(0, position, NULL, &view);
    if (!see_sphere(&o, &view, center, radius))
        return PSC_ERROR_NOT_FINITE;
    *solid_angle = o.power < 0.0 ? 4.0 * PSC_PI
                                 : 2.0 * PSC_PI * (o.cap.sin_a * o.cap.sin_a) /
                                       (1.0 + o.cap.cos_a);
    return PSC_SUCCESS;
}

psc_result psc_sphere_form_factor(const psc_receiver *receiver, const double center[3],
                                  double radius, double *form_factor)
{
    struct view_of_sphere o;
    struct psc_view view;
    psc_result result;

    if (!form_factor || !center)
        return PSC_ERROR_NULL_POINTER;
    result = psc_read_receiver(receiver, &view);
    if (result != PSC_SUCCESS)
        return result;
    if (view.facing == PSC_FACING_NONE)
        return PSC_ERROR_NEEDS_NORMAL;
    if (!is_finite3(center) || !is_finite(radius))
        return PSC_ERROR_NOT_FINITE;
    if (radius < 0.0)
        return PSC_ERROR_NEGATIVE_SIZE;
    *form_factor = 0.0;
    if (radius == 0.0)
        return PSC_EMPTY;
    if (!see_sphere(&o, &view, center, radius))
        return PSC_ERROR_NOT_FINITE;
    *form_factor = o.power < 0.0
                       ? (view.facing == PSC_FACING_BOTH ? 2.0 : 1.0)
                       : psc_cap_projected(&o.cap, view.facing == PSC_FACING_BOTH) *
                             (1.0 / PSC_PI);
    return *form_factor > 0.0 ? PSC_SUCCESS : PSC_EMPTY;
}
