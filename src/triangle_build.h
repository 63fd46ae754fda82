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
    struct psc_polygon_places places;
    struct psc_triangle_words words;

    const psc_result result = psc_check_numbers(request);

    l->plain = PSC_NOT_PLAIN;
    if (result != PSC_SUCCESS)
        return result;
    if (!is_finite3(vertices) || !is_finite3(vertices + 3) || !is_finite3(vertices + 6) ||
        !see_polygon(request->position, 3, vertices, &l->view))
        return PSC_ERROR_NOT_FINITE;
    keep_numbers(l, request, vertices, 9);
    s->visibility = see_horizon(request->normal, &l->view, l->receiver, l->up, l->height);
    triangle_words(&l->view, vertices, 0, 1, 2, &words);
    l->triangles = 0;
    fan_add(l, s->measure, &words, &at, &sums);
    places.first = vertices;
    places.place = triangle_places;
    vertex_offsets(vertices, 3, &places);
    return polygon_finish(s, request, &sums, -1.0, &places);
}

/* Where a triangle lies to a plane that rounding may have put a vertex on either side of. */
static int see_exact_horizon(const double *position, const double *normal, const double *vertices)
{
    struct psc_polygon_view view;
    double n[3], up[3], height[PSC_MAX_VERTICES];

    see_polygon(position, 3, vertices, &view);
    return (int)see_horizon(normal, &view, n, up, height);
}

/* Where the light lies to the receiver's plane, or PSC_PENDING; reach: at least the length of any
   of a, b and c, which are its vertices as the receiver sees them. */
PSC_LANE int plain_receiver(struct psc_polygon_light *l, const double *position,
                            const double *normal, const double *const vertex[3],
                            const double a[3], const double b[3], const double c[3], double reach)
{
    double square, size;
    int seen;

    if (!normal) {
        l->up[0] = l->up[1] = l->up[2] = 0.0;
        return PSC_CASE_NO_HORIZON;
    }
    square = dot(normal, normal);
    if (!is_plain_normal(square))
        return PSC_PENDING;
    size = SQRT(square);
    seen = (int)see_plain_horizon(a, b, c, normal, size * reach);
    if (seen < 0) {
        double vertices[9];

        copy3(vertex[0], vertices);
        copy3(vertex[1], vertices + 3);
        copy3(vertex[2], vertices + 6);
        seen = see_exact_horizon(position, normal, vertices);
    }
    copy3(normal, l->receiver);
    scale3(1.0 / size, normal, l->up);
    return seen;
}

/* What both measures keep. */
PSC_LANE void keep_triangle(psc_sampler *s, int seen, const double *position,
                            const double *const vertex[3], const double normal[3])
{
    struct psc_polygon_light *l = &s->polygon;
    const double length = SQRT(dot(normal, normal)), per_length = 1.0 / length;

    scale3(per_length, normal, l->normal);
    l->area = 0.5 * length;
    l->triangles = 1;
    l->plain = PSC_PLAIN_TRIANGLE;
    l->numbers = 9;
    copy3(position, l->position);
    copy3(vertex[0], l->corner[0]);
    copy3(vertex[1], l->corner[1]);
    copy3(vertex[2], l->corner[2]);
    s->visibility = (psc_case)seen;
    s->sides = 1;
    s->split = 1.0;
}

/* By solid angle, where plain products suffice; else, and for all that is wrong, PSC_PENDING. */
PSC_LANE psc_result plain_triangle_build(psc_sampler *s, const double *position,
                                         const double *normal, const double *const vertex[3],
                                         int one_sided, enum psc_facing facing)
{
    struct psc_polygon_light *l = &s->polygon;
    struct psc_plain_triangle o;
    int seen;

    if (!see_plain_triangle(position, vertex[0], vertex[1], vertex[2], &o))
        return PSC_PENDING;
    seen = plain_receiver(l, position, normal, vertex, o.a.to, o.pivot.b, o.c.to, o.reach);
    if (seen == PSC_PENDING)
        return PSC_PENDING;
    if ((one_sided && o.sight.volume > 0.0) ||
        (seen == PSC_CASE_EMPTY && facing == PSC_FACING_ONE))
        return PSC_EMPTY;
    plain_fan(&o, &l->rays);
    l->rays.half = half_of_sight(&o.sight);
    copy3(o.pivot.unit, l->b);
    l->unit = o.pivot.size;
    s->total = l->solid_angle = 2.0 * l->rays.half;
    keep_triangle(s, seen, position, vertex, o.sight.normal);
    return PSC_SUCCESS;
}

/* The same by area. */
PSC_LANE psc_result plain_area_build(psc_sampler *s, const double *position, const double *normal,
                                     const double *const vertex[3], int one_sided,
                                     enum psc_facing facing)
{
    struct psc_polygon_light *l = &s->polygon;
    struct psc_plain_flat o;
    double a[3], c[3];
    int seen;

    if (!see_plain_flat(position, vertex[0], vertex[1], vertex[2], &o))
        return PSC_PENDING;
    subtract3(vertex[0], position, a);
    subtract3(vertex[2], position, c);
    seen = plain_receiver(l, position, normal, vertex, a, o.flat.b.high, c,
                          2.0 * SQRT(o.square));
    if (seen == PSC_PENDING)
        return PSC_PENDING;
    if ((one_sided && o.volume > 0.0) || (seen == PSC_CASE_EMPTY && facing == PSC_FACING_ONE))
        return PSC_EMPTY;
    l->flat[0] = o.flat;
    copy3(l->up, l->flat[0].up);
    l->volume = ABS(o.volume);
    l->unit = 1.0;
    keep_triangle(s, seen, position, vertex, o.normal);
    s->total = l->area;
    return PSC_SUCCESS;
}

/* By projected solid angle. */
static psc_result projected_triangle_build(psc_sampler *s, const struct psc_request *request,
                                           const double *vertices)
{
    struct psc_polygon_places places;
    psc_result result;

    places.first = vertices;
    places.place = triangle_places;
    vertex_offsets(vertices, 3, &places);
    result = plain_projected_build(s, request, 3, &places);
    if (result == PSC_PENDING)
        return exact_triangle_build(s, request, vertices);
    keep_numbers(&s->polygon, request, vertices, 9);
    return result;
}

/* The vertices may be where the light keeps them. */
PSC_LANE psc_result triangle_build(psc_sampler *s, const struct psc_request *request,
                                   const double *vertices)
{
    const double *const vertex[3] = {vertices, vertices + 3, vertices + 6};
    psc_result result = PSC_PENDING;

    if (s->projected)
        return projected_triangle_build(s, request, vertices);
    if (s->measure == PSC_MEASURE_SOLID_ANGLE)
        result = plain_triangle_build(s, request->position, request->normal, vertex,
                                      request->one_sided, s->facing);
    else if (s->measure == PSC_MEASURE_AREA)
        result = plain_area_build(s, request->position, request->normal, vertex,
                                  request->one_sided, s->facing);
    return result == PSC_PENDING ? exact_triangle_build(s, request, vertices) : result;
}

#endif
