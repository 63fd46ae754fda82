/* SPDX-License-Identifier: Apache-2.0 */
/* Builds of rectangles. */
#ifndef PSC_SRC_RECTANGLE_BUILD_H
#define PSC_SRC_RECTANGLE_BUILD_H

#include "checks.h"
#include "rectangle_plain.h"
#include "rectangle_view.h"

/* The two triangles of the radial maps; what they add up to is as much as the whole. */
static inline void rectangle_fan(psc_sampler *s, const struct psc_rectangle_words *o,
                                 const double *g, struct psc_fan_sums *sums)
{
    struct psc_polygon_light *const l = &s->polygon;
    const struct psc_fan_places at[2] = {{g, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0},
                                         {g, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0}};
    struct psc_fan_sums fan = NO_SUMS;
    struct psc_triangle_words words;
    int c;

    vertex_words(&l->view, 1, &words.a);
    words.b = o->corner;
    vertex_words(&l->view, 2, &words.c);
    words.edge_a = o->u;
    words.edge_c = o->diagonal;
    words.edge_ac = o->v;
    fan_add(l, s->measure, &words, at, &fan);
    words.a = words.c;
    vertex_words(&l->view, 3, &words.c);
    words.edge_a = o->diagonal;
    words.edge_c = o->v;
    for (c = 0; c < 3; c++)
        words.edge_ac.high[c] = -o->u.high[c];
    words.edge_ac.low[0] = words.edge_ac.low[1] = words.edge_ac.low[2] = 0.0;
    fan_add(l, s->measure, &words, at + 1, &fan);
    sums->parts = fan.parts;
    sums->volume = l->triangles > 0 ? sums->volume : 0.0;
}

/* Half the solid angle: the plain one where it is as good. */
static inline psc_result rectangle_half(const double position[3], const double *g, double *half)
{
    struct psc_plain_rectangle plain;
    struct psc_rectangle_sight sight;
    struct psc_rectangle_words words;
    struct psc_rectangle exact;
    struct psc_triangle_view seen;
    struct psc_polygon_view view;
    psc_result result;

    if (see_plain_rectangle(position, g, &sight)) {
        plain_rectangle(g, &sight, &plain);
        *half = plain.half;
        return PSC_SUCCESS;
    }
    result = see_rectangle(position, g, &view, &words);
    if (result == PSC_SUCCESS) {
        rectangle_see(&words, &exact, &seen);
        *half = exact.half;
    }
    return result;
}

/* By projected solid angle, or PSC_PENDING where rounding may have had a say. */
PSC_LANE psc_result projected_rectangle_build(psc_sampler *s, const struct psc_request *request,
                                          const double *g)
{
    const double *const u = g + 3, *const v = g + 6;
    const double uu = dot(u, u), vv = dot(v, v), uv = dot(u, v);
    const double limit = 0.25 * PSC_RECTANGLE_TOLERANCE * PSC_RECTANGLE_TOLERANCE;
    struct psc_polygon_places places;
    double along[3];

    if (!(is_fair(uu) && is_fair(vv) && uv * uv <= limit * (uu * vv)))
        return PSC_PENDING;
    places.first = g;
    places.place = rectangle_places;
    places.offset[0][0] = places.offset[0][1] = places.offset[0][2] = 0.0;
    copy3(u, places.offset[1]);
    scale3(uv / uu, u, along);
    subtract3(v, along, places.offset[3]);
    add3(u, places.offset[3], places.offset[2]);
    return plain_projected_build(s, request, 4, &places);
}

static psc_result exact_rectangle_build(psc_sampler *s, const struct psc_request *request,
                                        const double *g)
{
    struct psc_polygon_light *l = &s->polygon;
    struct psc_fan_sums sums = NO_SUMS;
    struct psc_polygon_places places;
    struct psc_rectangle *const f = &l->rectangle;
    struct psc_triangle_view seen;
    struct psc_rectangle_words o;
    psc_result result = psc_check_numbers(request);
    int c;

    if (result == PSC_SUCCESS && !(is_finite3(g) && is_finite3(g + 3) && is_finite3(g + 6)))
        result = PSC_ERROR_NOT_FINITE;
    if (result != PSC_SUCCESS)
        return result;
    keep_numbers(l, request, g, 9);
    if (s->projected) {
        result = projected_rectangle_build(s, request, g);
        if (result != PSC_PENDING)
            return result;
    }
    result = see_rectangle(request->position, g, &l->view, &o);
    if (result != PSC_SUCCESS)
        return result;
    s->visibility = see_horizon(request->normal, &l->view, l->receiver, l->up, l->height);
    l->triangles = 0;
    l->plain = PSC_NOT_PLAIN;
    places.first = g;
    places.place = rectangle_places;
    for (c = 0; c < 3; c++) {
        places.offset[0][c] = 0.0;
        places.offset[1][c] = g[3 + c];
        places.offset[3][c] = o.v.high[c] * (1.0 / l->view.scale);
        places.offset[2][c] = g[3 + c] + places.offset[3][c];
    }
    rectangle_see(&o, f, &seen);
    f->start = o.corner;
    f->along = o.u;
    f->across = o.v;
    for (c = 0; c < 3; c++)
        sums.normal[c] = -2.0 * seen.normal[c];
    sums.volume = f->half > 0.0 ? -2.0 * seen.volume : 0.0;
    sums.half = f->half;
    if (s->map == PSC_MAP_RADIAL && f->half > 0.0)
        rectangle_half(request->position, g, &sums.half);
    if (s->map == PSC_MAP_RADIAL && !s->projected)
        rectangle_fan(s, &o, g, &sums);
    copy3(places.offset[3], l->edge_v);
    return polygon_finish(s, request, &sums, 1.0, &places);
}

/* Where a rectangle lies to a plane that rounding may have put a corner on either side of. */
static int see_exact_rectangle_horizon(const double *position, const double *normal,
                                       const double *g)
{
    struct psc_rectangle_words words;
    struct psc_polygon_view view;
    double n[3], up[3], height[PSC_MAX_VERTICES];

    see_rectangle(position, g, &view, &words);
    return (int)see_horizon(normal, &view, n, up, height);
}

/* Along the edges by solid angle, or by area, where plain products suffice; else, and for all that
   is wrong, PSC_PENDING. g: what the light keeps. */
PSC_LANE psc_result plain_rectangle_build(psc_sampler *s, int area, const double *position,
                                          const double *normal, const double *g, int one_sided,
                                          enum psc_facing facing)
{
    struct psc_polygon_light *l = &s->polygon;
    struct psc_rectangle_sight o;
    int seen = PSC_CASE_NO_HORIZON;

    if (!see_plain_rectangle(position, g, &o))
        return PSC_PENDING;
    l->up[0] = l->up[1] = l->up[2] = 0.0;
    if (normal) {
        const double square = dot(normal, normal), size = SQRT(square);

        if (!is_plain_normal(square))
            return PSC_PENDING;
        seen = (int)see_rectangle_horizon(g, &o, normal, size);
        if (seen < 0 && facing == PSC_FACING_ONE) /* as wavefronts do */
            return PSC_PENDING;
        if (seen < 0)
            seen = see_exact_rectangle_horizon(position, normal, g);
        copy3(normal, l->receiver);
        scale3(1.0 / size, normal, l->up);
    }
    if ((one_sided && o.volume > 0.0) || (seen == PSC_CASE_EMPTY && facing == PSC_FACING_ONE))
        return PSC_EMPTY;

    if (area) {
        plain_words(position, g, &o, &l->rectangle);
        s->total = o.area;
    } else {
        plain_rectangle(g, &o, &l->plain_rectangle);
        s->total = l->solid_angle = 2.0 * l->plain_rectangle.half;
    }
    scale3(1.0 / o.area, o.normal, l->normal);
    l->area = o.area;
    l->volume = 2.0 * ABS(o.volume);
    l->unit = 1.0;
    l->plain = PSC_PLAIN_RECTANGLE;
    l->numbers = 9;
    copy3(position, l->position);
    copy3(o.edge_v, l->edge_v);
    s->visibility = (psc_case)seen;
    s->sides = 1;
    s->split = 1.0;
    return PSC_SUCCESS;
}

/* The geometry may be where the light keeps it. */
PSC_LANE psc_result rectangle_build(psc_sampler *s, const struct psc_request *request,
                                    const double *g)
{
    double *const kept = s->polygon.corner[0];
    psc_result result = PSC_PENDING;

    if (s->map == PSC_MAP_PARALLEL) {
        if (g != kept)
            memcpy(kept, g, 9 * sizeof *g);
        result = plain_rectangle_build(s, s->measure == PSC_MEASURE_AREA, request->position,
                                       request->normal, kept, request->one_sided, s->facing);
    }
    return result == PSC_PENDING ? exact_rectangle_build(s, request, g) : result;
}

/* The rectangle in its local frame; `own` is for one that was built without. */
PSC_LANE const struct psc_rectangle *rectangle_of(const struct psc_polygon_light *l,
                                                  struct psc_rectangle *own)
{
    struct psc_rectangle_sight o;

    if (!l->plain)
        return &l->rectangle;
    see_plain_rectangle(l->position, l->corner[0], &o);
    plain_frame(l->corner[0], &o, own);
    return own;
}

/* The same with what inverses by solid angle take. */
PSC_LANE const struct psc_rectangle *rectangle_to_invert(const psc_sampler *s,
                                                         struct psc_rectangle *own)
{
    const struct psc_rectangle *const f = rectangle_of(&s->polygon, own);

    if (f == own && s->measure == PSC_MEASURE_SOLID_ANGLE)
        rectangle_constants(own);
    return f;
}

#endif
