/* SPDX-License-Identifier: Apache-2.0 */
/* Builds of polygons by solid angle in plain double arithmetic. */
#ifndef PSC_SRC_FAN_PLAIN_H
#define PSC_SRC_FAN_PLAIN_H

#include "checks.h"
#include "polygon_build.h"

/* What is seen of each triangle of a fan. */
struct psc_fan_seen {
    double normal[3][PSC_FAN_LANES], doubt[PSC_FAN_LANES];
    double side[PSC_FAN_LANES];  /* 1 or -1 where it is fit for plain arithmetic and seen from its
                                    front or its back, else 0 */
    double where[PSC_FAN_LANES]; /* the last vertex, see where_is() */
};

PSC_LANE void load_vertex(const struct psc_ray_fans *f, int i, double to[3])
{
    to[0] = f->vertex[0][i];
    to[1] = f->vertex[1][i];
    to[2] = f->vertex[2][i];
}

/* Where a vertex is: above the receiver's plane, below it, or where rounding would decide. Sums of
   these over the vertices of a light tell how many are where. height: the product of vertex and
   normal; square: that of their lengths' product. */
#define ABOVE_PLANE 1.0
#define BELOW_PLANE 32.0
#define NEAR_PLANE 1024.0
PSC_LANE double where_is(double height, double square)
{
    return !(height * height > 0x1p-98 * square) ? NEAR_PLANE
           : height > 0.0                        ? ABOVE_PLANE
                                                 : BELOW_PLANE;
}

/* A vertex next to B. */
PSC_LANE void see_ray(const struct psc_fan_pivot *pivot, const double position[3],
                      const double b[3], const double vertex[3], struct psc_fan_ray *o)
{
    subtract3(vertex, position, o->to);
    subtract3(vertex, b, o->spoke);
    measure_ray(pivot, o);
}

PSC_APART void build_fan_step(const struct psc_fan_pivot *pivot, const double position[3],
                              const double normal[3], int first, struct psc_ray_fans *restrict f,
                              struct psc_fan_seen *restrict to)
{
    const double square = dot(normal, normal);
    int k;

    PSC_KEEP_LOOP
    for (k = first; k < first + PSC_FAN_STEP; k++) {
        struct psc_fan_ray ray_a, ray_c;
        struct psc_fan_sight o;
        struct psc_ray_fan_f64 fan;
        double a[3], b[3], c[3], far[3];
        int fit;

        load_vertex(f, k + 1, a);
        load_vertex(f, 0, b);
        load_vertex(f, k + 2, c);
        see_ray(pivot, position, b, a, &ray_a);
        see_ray(pivot, position, b, c, &ray_c);
        subtract3(c, a, far);
        fit = see_fan_triangle(pivot, &ray_a, &ray_c, far, &o);
        build_ray_fan(pivot, &ray_a, &ray_c, &o, &fan);
        fan.half = half_of_sight(&o);
        store_ray_fan(f, k, &fan);
        to->normal[0][k] = o.normal[0];
        to->normal[1][k] = o.normal[1];
        to->normal[2][k] = o.normal[2];
        to->doubt[k] = o.doubt;
        to->where[k] = where_is(dot(normal, ray_c.to), square * ray_c.square);
        to->side[k] = !fit ? 0.0 : o.volume > 0.0 ? 1.0 : -1.0;
    }
}

/* Which of the triangles belong to a polygon, their shares of u and the places of their last
   vertices on the surface. */
PSC_APART void place_fan_step(const struct psc_fan_frame *frame, double parts, int first,
                              struct psc_polygon_light *restrict l,
                              struct psc_fan_seen *restrict to)
{
    struct psc_ray_fans *const f = &l->fans;
    const double inverse = 1.0 / parts;
    int k;

    PSC_KEEP_LOOP
    for (k = first; k < first + PSC_FAN_STEP; k++) {
        double b[3], one[3], a[3], c[3], next[3], spoke[3], far[3], further[3];
        double place_a[2], place_c[2], place_far[2], place_further[2];
        int belongs;

        load_vertex(f, 0, b);
        load_vertex(f, 1, one);
        load_vertex(f, k + 1, a);
        load_vertex(f, k + 2, c);
        load_vertex(f, k + 3, next);
        subtract3(c, a, far);
        subtract3(next, c, further);
        subtract3(one, b, one);
        subtract3(a, b, a);
        subtract3(c, b, spoke);
        belongs = is_in_plane(frame, c, spoke);
        place_on(frame, a, place_a);
        place_on(frame, spoke, place_c);
        place_on(frame, far, place_far);
        place_on(frame, further, place_further);
        belongs &= fan_turns(frame, place_a, place_c, place_far, place_further, dot(one, one),
                             dot(spoke, spoke), dot(far, far), dot(further, further));
        to->side[k] = belongs ? to->side[k] : 0.0;
        f->place[0][k + 2] = place_c[0];
        f->place[1][k + 2] = place_c[1];
        l->below[k] *= inverse;
        l->per_share[k] = parts / f->half[k];
    }
}

/* Where a polygon lies to the receiver's plane, from exact products. */
PSC_APART int see_polygon_horizon(const struct psc_request *request, const double *vertices)
{
    struct psc_polygon_view view;
    double normal[3], up[3], height[PSC_MAX_VERTICES];

    see_polygon(request->position, request->numbers / 3, vertices, &view);
    return (int)see_horizon(request->normal, &view, normal, up, height);
}

/* The vertices number by number, and as many of the last as steps go beyond. */
PSC_LANE void store_vertices(int count, const double *vertices, struct psc_ray_fans *f)
{
    const double *const last = vertices + 3 * (count - 1);
    const double x = last[0], y = last[1], z = last[2];
    int i;

    for (i = 0; i < count; i++) {
        f->vertex[0][i] = vertices[3 * i];
        f->vertex[1][i] = vertices[3 * i + 1];
        f->vertex[2][i] = vertices[3 * i + 2];
    }
    for (i = count; i < count + PSC_FAN_STEP; i++) {
        f->vertex[0][i] = x;
        f->vertex[1][i] = y;
        f->vertex[2][i] = z;
    }
}

/* Returns PSC_PENDING for what takes exact products. */
PSC_LANE psc_result plain_polygon_build(psc_sampler *s, const struct psc_request *request,
                                        const double *vertices)
{
    static const double none[3];
    struct psc_polygon_light *const l = &s->polygon;
    struct psc_ray_fans *const f = &l->fans;
    const int count = request->numbers / 3, triangles = count - 2;
    const double *const normal = request->normal ? request->normal : none;
    const double square = dot(normal, normal);
    double sums[3] = {0.0, 0.0, 0.0}, first[3], last[3], one[3];
    double parts = 0.0, doubts = 0.0, where = 0.0, side = 0.0;
    int k, seen_by = PSC_CASE_NO_HORIZON;
    struct psc_fan_pivot pivot;
    struct psc_fan_frame frame;
    struct psc_fan_seen seen;

    store_vertices(count, vertices, f);
    see_pivot(vertices, request->position, &pivot);
    for (k = 0; k < triangles; k += PSC_FAN_STEP)
        build_fan_step(&pivot, request->position, normal, k, f, &seen);
    for (k = 0; k < triangles; k++) {
        sums[0] += seen.normal[0][k];
        sums[1] += seen.normal[1][k];
        sums[2] += seen.normal[2][k];
        l->below[k] = parts;
        parts += f->half[k];
        doubts += seen.doubt[k];
        where += seen.where[k];
    }
    subtract3(vertices + 3, vertices, first);
    subtract3(vertices + 3 * count - 3, vertices, last);
    if (!(find_frame(sums, first, last, &frame) & is_in_plane(&frame, vertices + 3, first) &
          is_sure_fan(triangles, doubts, parts)))
        return PSC_PENDING;
    for (k = 0; k < triangles; k += PSC_FAN_STEP)
        place_fan_step(&frame, parts, k, l, &seen);
    for (k = 0; k < triangles; k++)
        side += seen.side[k];
    if (ABS(side) != (double)triangles)
        return PSC_PENDING;
    l->up[0] = l->up[1] = l->up[2] = 0.0;
    if (request->normal) {
        if (!(square > 0x1p-320 && square < 0x1p320))
            return PSC_PENDING;
        subtract3(vertices + 3, request->position, one);
        where += where_is(dot(normal, pivot.b), square * pivot.b2) +
                 where_is(dot(normal, one), square * dot(one, one));
        seen_by = where >= NEAR_PLANE            ? see_polygon_horizon(request, vertices)
                  : where == count * ABOVE_PLANE ? PSC_CASE_ABOVE
                  : where == count * BELOW_PLANE ? PSC_CASE_EMPTY
                                                 : PSC_CASE_CLIPPED;
        copy3(normal, l->receiver);
        scale3(1.0 / SQRT(square), normal, l->up);
    }
    s->visibility = (psc_case)seen_by;
    if ((request->one_sided && side < 0.0) ||
        (seen_by == PSC_CASE_EMPTY && s->facing == PSC_FACING_ONE))
        return PSC_EMPTY;

    copy3(frame.front, l->normal);
    copy3(pivot.unit, f->b);
    f->place[0][1] = f->place[1][count - 1] = 1.0;
    f->place[1][1] = f->place[0][count - 1] = 0.0;
    l->area = 0.5 * SQRT(dot(sums, sums));
    l->unit = pivot.size;
    l->triangles = triangles;
    l->numbers = request->numbers;
    l->plain = PSC_PLAIN_FAN;
    copy3(request->position, l->position);
    s->total = l->solid_angle = 2.0 * parts;
    s->sides = 1;
    s->split = 1.0;
    return PSC_SUCCESS;
}
/* The numbers may be any: they are looked at where that build does not take them. */
PSC_LANE psc_result polygon_build(psc_sampler *s, const struct psc_request *request,
                                  const double *vertices)
{
    psc_result result = PSC_PENDING;
    int i;

    if (s->measure == PSC_MEASURE_SOLID_ANGLE)
        result = plain_polygon_build(s, request, vertices);
    if (result != PSC_PENDING)
        return result;
    result = psc_check_numbers(request);
    for (i = 0; i < request->numbers && result == PSC_SUCCESS; i += 3)
        result = is_finite3(vertices + i) ? PSC_SUCCESS : PSC_ERROR_NOT_FINITE;
    return result == PSC_SUCCESS ? exact_polygon_build(s, request, vertices) : result;
}

#endif
