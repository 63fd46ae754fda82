/* SPDX-License-Identifier: Apache-2.0 */
/* Builds of triangles. */
#ifndef PSC_SRC_TRIANGLE_BUILD_H
#define PSC_SRC_TRIANGLE_BUILD_H

#include "checks.h"
#include "polygon_build.h"
#include "triangle_plain.h"

/* (v0, v1, v2) are A, B and C in that order, seen from the front where the volume is negative. */
static psc_result exact_triangle_build(psc_sampler *s, const struct psc_request *request,
                                       const double *vertices)
{
    struct psc_polygon_light *l = &s->polygon;
    const struct psc_fan_places at = {vertices + 3, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0};
    struct psc_fan_sums sums = NO_SUMS;
    struct psc_polygon_places places = {.first = vertices, .place = triangle_places};
    struct psc_triangle_words words;

    const psc_result result = psc_check_numbers(request);

    l->plain = 0;
    if (result != PSC_SUCCESS)
        return result;
    if (!is_finite3(vertices) || !is_finite3(vertices + 3) || !is_finite3(vertices + 6) ||
        !see_polygon(request->position, 3, vertices, &l->view))
        return PSC_ERROR_NOT_FINITE;
    s->visibility = see_horizon(request->normal, &l->view, l->receiver, l->up, l->height);
    triangle_words(&l->view, vertices, 0, 1, 2, &words);
    l->triangles = 0;
    fan_add(l, s->measure, &words, &at, &sums);
    vertex_offsets(vertices, 3, &places);
    return polygon_finish(s, request, &sums, -1.0, &places);
}

/* Where a triangle lies to a plane that rounding may have put a vertex on either side of. */
static int see_exact_horizon(const struct psc_request *request, const double *vertices)
{
    struct psc_polygon_view view;
    double normal[3], up[3], height[PSC_MAX_VERTICES];

    see_polygon(request->position, 3, vertices, &view);
    return (int)see_horizon(request->normal, &view, normal, up, height);
}

/* The vertices may be where the light keeps them. */
PSC_LANE psc_result triangle_build(psc_sampler *s, const struct psc_request *request,
                                   const double *vertices)
{
    struct psc_polygon_light *l = &s->polygon;
    struct psc_plain_triangle o;
    double length, size = 1.0, inverse;
    int seen = PSC_CASE_NO_HORIZON;

    if (s->measure != PSC_MEASURE_SOLID_ANGLE ||
        !see_plain_triangle(request->position, vertices, &o))
        return exact_triangle_build(s, request, vertices);
    if (request->normal) {
        const double square = dot(request->normal, request->normal);

        if (!is_plain_normal(square))
            return exact_triangle_build(s, request, vertices);
        size = SQRT(square);
        seen = (int)see_plain_horizon(o.a, o.b, o.c, request->normal,
                                 size * ((o.size_a + o.size_b) + o.size_c));
        if (seen < 0)
            seen = see_exact_horizon(request, vertices);
    }
    s->visibility = (psc_case)seen;
    if ((request->one_sided && o.volume > 0.0) ||
        (seen == PSC_CASE_EMPTY && s->facing == PSC_FACING_ONE))
        return PSC_EMPTY;

    plain_fan(&o, l->fan);
    length = SQRT(dot(o.normal, o.normal));
    inverse = 1.0 / (size * length);
    scale3(size * inverse, o.normal, l->normal);
    if (request->normal) {
        copy3(request->normal, l->receiver);
        scale3(length * inverse, request->normal, l->up);
    } else {
        l->up[0] = l->up[1] = l->up[2] = 0.0;
    }
    l->area = 0.5 * length;
    l->unit = o.size_b;
    l->triangles = 1;
    l->plain = 1;
    copy3(request->position, l->position);
    if (vertices != l->corner[0]) {
        copy3(vertices, l->corner[0]);
        copy3(vertices + 3, l->corner[1]);
        copy3(vertices + 6, l->corner[2]);
    }
    s->total = l->solid_angle = 2.0 * o.half;
    s->sides = 1;
    s->split = 1.0;
    return PSC_SUCCESS;
}

#endif
