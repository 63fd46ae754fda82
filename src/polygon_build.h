/* SPDX-License-Identifier: Apache-2.0 */
/* Builds of flat lights with straight edges: what is seen of them, and the maps of their fans. */
#ifndef PSC_SRC_POLYGON_BUILD_H
#define PSC_SRC_POLYGON_BUILD_H

#include "fan_build.h"
#include "polygon_lanes.h"
#include "polygon_projected.h"

/* What was given; it may be there already. */
PSC_LANE void keep_numbers(struct psc_polygon_light *l, const struct psc_request *request,
                           const double *numbers, int count)
{
    int i;

    l->numbers = count;
    copy3(request->position, l->position);
    for (i = 0; numbers != l->corner[0] && i < count; i += 3)
        copy3(numbers + i, l->corner[i / 3]);
}

/* The triangle of the vertices a, b, c of a view, which are at those places of `vertices`. */
PSC_LANE void triangle_words(const struct psc_polygon_view *view, const double *vertices, int a,
                             int b, int c, struct psc_triangle_words *o)
{
    const double *const va = vertices + 3 * a, *const vb = vertices + 3 * b;
    const double *const vc = vertices + 3 * c;

    vertex_words(view, a, &o->a);
    vertex_words(view, b, &o->b);
    vertex_words(view, c, &o->c);
    edge_of(vb, va, view->scale, o->edge_a.high, o->edge_a.low);
    edge_of(vb, vc, view->scale, o->edge_c.high, o->edge_c.low);
    edge_of(va, vc, view->scale, o->edge_ac.high, o->edge_ac.low);
}

/* The receiver's plane: heights of the vertices, and where the light lies to it. */
PSC_LANE psc_case see_horizon(const double *normal, const struct psc_polygon_view *view,
                              double n[3], double up[3], double *height)
{
    int above = 0, below = 0, i;
    double shrink;

    if (!normal) {
        for (i = 0; i < 3; i++)
            n[i] = up[i] = 0.0;
        for (i = 0; i < view->count; i++)
            height[i] = 0.0;
        return PSC_CASE_NO_HORIZON;
    }
    scale_to_one(normal, n);
    shrink = 1.0 / SQRT(dot(n, n));
    for (i = 0; i < 3; i++)
        up[i] = n[i] * shrink;
    for (i = 0; i < view->count; i++) {
        height[i] = height_of(n, shrink, view->vertex[i], view->low[i]);
        above |= height[i] > 0.0;
        below |= height[i] < 0.0;
    }
    return above & below ? PSC_CASE_CLIPPED : above ? PSC_CASE_ABOVE : PSC_CASE_EMPTY;
}

/* Sums over the triangles of a fan. */
struct psc_fan_sums {
    double normal[3], volume, half, parts; /* the length of normal is twice the area */
};

/* B in world space, and the coordinates of the vertices on the light's surface. */
struct psc_fan_places {
    const double *pivot;
    double s_a, t_a, s_b, t_b, s_c, t_c;
};

/* Adds a triangle to the fan, unless nothing is seen of it; by projected solid angle to the sums
   alone. */
PSC_LANE void fan_add(struct psc_polygon_light *l, psc_measure measure,
                      const struct psc_triangle_words *w, const struct psc_fan_places *at,
                      struct psc_fan_sums *sums)
{
    const int area = measure == PSC_MEASURE_AREA;
    const double unit = 1.0 / l->view.scale;
    struct psc_face_f64 *face = l->face + l->triangles;
    struct psc_triangle_view seen;
    double part;
    int i;

    see_triangle(w, &seen);
    for (i = 0; i < 3; i++)
        sums->normal[i] += seen.normal[i];
    if (!(seen.half > 0.0))
        return;
    sums->volume += seen.volume;
    sums->half += seen.half;
    if (measure == PSC_MEASURE_PROJECTED_SOLID_ANGLE)
        return;
    fan_build(&seen, &w->b, &w->edge_c, l->fan + l->triangles);
    for (i = 0; i < 3; i++) {
        face->pivot[i] = at->pivot[i];
        face->edge_a[i] = w->edge_a.high[i] * unit;
        face->edge_c[i] = w->edge_c.high[i] * unit;
    }
    face->s_a = at->s_a;
    face->t_a = at->t_a;
    face->s_b = at->s_b;
    face->t_b = at->t_b;
    face->s_c = at->s_c;
    face->t_c = at->t_c;
    if (area) {
        struct psc_flat *flat = l->flat + l->triangles;

        flat->b = w->b;
        flat->edge_a = w->edge_a;
        flat->edge_c = w->edge_c;
        for (i = 0; i < 3; i++)
            flat->up[i] = l->up[i];
    }
    part = area ? seen.twice_area : seen.half;
    l->below[l->triangles] = sums->parts;
    l->per_share[l->triangles] = part;
    sums->parts += part;
    l->triangles++;
}

/* What is left when all triangles are there. front is the sign of the volume for a receiver that
   the light's normal points to; places are for projected solid angle. */
PSC_LANE psc_result polygon_finish(psc_sampler *s, const struct psc_request *request,
                                   const struct psc_fan_sums *sums, double front,
                                   const struct psc_polygon_places *places)
{
    struct psc_polygon_light *l = &s->polygon;
    const double unit = 1.0 / l->view.scale;
    const double twice_area = SQRT(dot(sums->normal, sums->normal));
    int i;

    if (!(sums->volume != 0.0) || (request->one_sided && sums->volume * front < 0.0) ||
        (s->visibility == PSC_CASE_EMPTY && s->facing == PSC_FACING_ONE))
        return PSC_EMPTY;
    for (i = 0; i < 3; i++)
        l->normal[i] = sums->normal[i] * (-front / twice_area);
    l->turns_left = sums->volume * front < 0.0;
    l->volume = ABS(sums->volume);
    l->solid_angle = 2.0 * sums->half;
    l->area = 0.5 * twice_area * unit * unit;
    if (s->projected) {
        projected_finish(s, places);
        return PSC_SUCCESS;
    }
    for (i = 0; l->triangles > 1 && i < l->triangles; i++) {
        l->below[i] /= sums->parts;
        /* Nothing falls to a share smaller than that. */
        l->per_share[i] = MIN(sums->parts / l->per_share[i], 0x1p96);
    }
    l->unit = unit;
    s->total = s->measure == PSC_MEASURE_AREA ? l->area : l->solid_angle;
    s->sides = 1;
    s->split = 1.0;
    return PSC_SUCCESS;
}

#define NO_SUMS {{0.0, 0.0, 0.0}, 0.0, 0.0, 0.0}

/* ---- Polygons ---- */

/* One plane, and convex: no corner turns back, and the fan about the first vertex neither, nor
   past half a turn. Twice the area is 0 without an error. */
PSC_LANE psc_result check_polygon(const struct psc_polygon_view *view, const double *vertices)
{
    double spoke[PSC_MAX_VERTICES][3], low[3], normal[3] = {0.0, 0.0, 0.0}, across[3], extent = 0.0;
    double size = largest(vertices);
    const int count = view->count;
    int i, c;

    for (i = 1; i < count; i++) {
        edge_of(vertices, vertices + 3 * i, view->scale, spoke[i], low);
        extent = MAX(extent, largest(spoke[i]));
        size = MAX(size, largest(vertices + 3 * i));
    }
    extent += size * view->scale;
    for (i = 1; i + 1 < count; i++) {
        cross(spoke[i], spoke[i + 1], across);
        for (c = 0; c < 3; c++)
            normal[c] += across[c];
    }
    if (!scale_to_one(normal, normal))
        return PSC_SUCCESS;
    for (c = 0; c < 3; c++)
        across[c] = normal[c];
    for (c = 0; c < 3; c++)
        normal[c] /= SQRT(dot(across, across));
    for (i = 1; i < count; i++)
        if (!(ABS(dot(normal, spoke[i])) <= PSC_POLYGON_TOLERANCE * extent))
            return PSC_ERROR_NOT_PLANAR;
    for (c = 0; c < 3; c++)
        spoke[0][c] = 0.0;
    for (i = 0; i < count; i++) {
        const double *const at[3] = {vertices + 3 * i, vertices + 3 * ((i + 1) % count),
                                     vertices + 3 * ((i + 2) % count)};
        double first[3], second[3];

        edge_of(at[0], at[1], view->scale, first, low);
        edge_of(at[1], at[2], view->scale, second, low);
        cross(first, second, across);
        if (!(dot(across, normal) >=
              -PSC_POLYGON_TOLERANCE * SQRT(dot(first, first) * dot(second, second))))
            return PSC_ERROR_NOT_CONVEX;
    }
    for (i = 2; i < count; i++) {
        double step[3];

        cross(spoke[i - 1], spoke[i], step);
        cross(spoke[1], spoke[i], across);
        if (!(dot(step, normal) >= -PSC_POLYGON_TOLERANCE * SQRT(dot(spoke[i - 1], spoke[i - 1]) *
                                                                 dot(spoke[i], spoke[i]))) ||
            !(dot(across, normal) >=
              -PSC_POLYGON_TOLERANCE * SQRT(dot(spoke[1], spoke[1]) * dot(spoke[i], spoke[i]))))
            return PSC_ERROR_NOT_CONVEX;
    }
    return PSC_SUCCESS;
}

/* Coordinates of v on a surface spanned by two edges of a corner: point = corner + s first +
   t second; 0 for edges in line. */
PSC_LANE void surface_places(const double first[3], const double second[3], const double v[3],
                             double *s, double *t)
{
    double normal[3], by_s[3], by_t[3], inverse;

    cross(first, second, normal);
    cross(v, second, by_s);
    cross(first, v, by_t);
    inverse = dot(normal, normal);
    inverse = inverse > 0.0 ? 1.0 / inverse : 0.0;
    *s = dot(by_s, normal) * inverse;
    *t = dot(by_t, normal) * inverse;
}

/* A fan about the first vertex, seen from its front where volumes are positive. */
PSC_APART psc_result exact_polygon_build(psc_sampler *s, const struct psc_request *request,
                                         const double *vertices)
{
    struct psc_polygon_light *l = &s->polygon;
    const int count = request->numbers / 3;
    struct psc_fan_sums sums = NO_SUMS;
    struct psc_polygon_places places;
    double spoke[PSC_MAX_VERTICES][3], place[PSC_MAX_VERTICES][2], low[3];
    psc_result result;
    int i;

    if (!see_polygon(request->position, count, vertices, &l->view))
        return PSC_ERROR_NOT_FINITE;
    result = check_polygon(&l->view, vertices);
    if (result != PSC_SUCCESS)
        return result;
    keep_numbers(l, request, vertices, request->numbers);
    s->visibility = see_horizon(request->normal, &l->view, l->receiver, l->up, l->height);
    for (i = 1; i < count; i++)
        edge_of(vertices, vertices + 3 * i, l->view.scale, spoke[i], low);
    places.first = vertices;
    places.place = (const double(*)[2])place;
    vertex_offsets(vertices, count, &places);
    place[0][0] = place[0][1] = place[1][1] = place[count - 1][0] = 0.0;
    place[1][0] = place[count - 1][1] = 1.0;
    for (i = 2; i + 1 < count; i++)
        surface_places(spoke[1], spoke[count - 1], spoke[i], place[i], place[i] + 1);
    l->triangles = 0;
    l->plain = PSC_NOT_PLAIN;
    if (s->projected) {
        result = plain_projected_build(s, request, count, &places);
        if (result != PSC_PENDING)
            return result;
    }
    for (i = 1; i + 1 < count; i++) {
        const struct psc_fan_places at = {
            vertices, place[i][0], place[i][1], 0.0, 0.0, place[i + 1][0], place[i + 1][1]};
        struct psc_triangle_words words;

        triangle_words(&l->view, vertices, i, 0, i + 1, &words);
        fan_add(l, s->measure, &words, &at, &sums);
    }
    return polygon_finish(s, request, &sums, 1.0, &places);
}

#endif
