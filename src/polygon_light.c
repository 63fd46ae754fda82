/* SPDX-License-Identifier: Apache-2.0 */
#include "polygon_light.h"

#include "fan_inverse.h"
#include "rectangle_build.h"
#include "sector_inverse.h"
#include "triangle_build.h"

#undef PSC_BITS
#define PSC_BITS 64
#include "precision.h"
#include "fan_map_tmpl.h"

/* ---- Totals ---- */

/* Of a light that was built without what this takes: of one that is built for it. */
static double built_total(const psc_sampler *s, psc_measure measure)
{
    const struct psc_polygon_light *const l = &s->polygon;
    const int projected = measure == PSC_MEASURE_PROJECTED_SOLID_ANGLE;
    const struct psc_request request = {.measure = measure,
                                        .map = projected ? PSC_MAP_RADIAL : s->map,
                                        .facing = projected ? s->facing : PSC_FACING_NONE,
                                        .position = l->position,
                                        .normal = projected ? l->receiver : NULL,
                                        .numbers = l->numbers};
    double numbers[3 * PSC_MAX_VERTICES];
    psc_sampler other;
    int i;

    psc_clear(&other);
    other.measure = request.measure;
    other.map = request.map;
    other.facing = request.facing;
    other.projected = projected;
    for (i = 0; i < request.numbers; i++)
        numbers[i] = l->plain == PSC_PLAIN_FAN ? l->fans.vertex[i % 3][i / 3]
                                               : l->corner[i / 3][i % 3];
    s->f64->build(&other, &request, numbers);
    return other.total;
}

psc_result psc_polygon_solid_angle_of(const psc_sampler *s, double *value)
{
    const int known = !s->projected && !(s->polygon.plain && s->measure == PSC_MEASURE_AREA);

    *value = s->sides == 0 ? 0.0
             : known       ? s->polygon.solid_angle
                           : built_total(s, PSC_MEASURE_SOLID_ANGLE);
    return *value > 0.0 ? PSC_SUCCESS : PSC_EMPTY;
}

psc_result psc_polygon_projected_solid_angle(const psc_sampler *s, double *value)
{
    if (s->facing == PSC_FACING_NONE)
        return PSC_ERROR_NEEDS_NORMAL;
    *value = s->sides == 0  ? 0.0
             : s->projected ? s->total
                            : built_total(s, PSC_MEASURE_PROJECTED_SOLID_ANGLE);
    return *value > 0.0 ? PSC_SUCCESS : PSC_EMPTY;
}

psc_result psc_polygon_area(const psc_sampler *s, double *value)
{
    *value = s->sides == 0 ? 0.0 : s->polygon.area;
    return *value > 0.0 ? PSC_SUCCESS : PSC_EMPTY;
}

/* ---- Directions ---- */

/* Of a triangle by area that was built without a fan. */
static void fan_of_corners(const struct psc_polygon_light *l, struct psc_fan_f64 *f)
{
    struct psc_plain_triangle plain;
    double unit;

    if (see_plain_triangle(l->position, l->corner[0], l->corner[1], l->corner[2], &plain)) {
        struct psc_ray_fan_f64 rays;

        plain_fan(&plain, &rays);
        rays.half = half_of_sight(&plain.sight);
        fan_of_rays(&rays, plain.pivot.unit, f);
        unit = plain.pivot.inverse;
    } else {
        struct psc_triangle_words words;
        struct psc_triangle_view seen;
        struct psc_polygon_view view;

        see_polygon(l->position, 3, l->corner[0], &view);
        triangle_words(&view, l->corner[0], 0, 1, 2, &words);
        see_triangle(&words, &seen);
        fan_build(&seen, &words.b, &words.edge_c, f);
        unit = view.scale;
    }
    f->per_a *= unit;
    f->per_b *= unit;
    f->per_c *= unit;
}

/* Triangle k of the fan. own: where it is put if it is not kept in this form. */
static const struct psc_fan_f64 *fan_at(const psc_sampler *s, int k, struct psc_fan_f64 *own)
{
    const struct psc_polygon_light *l = &s->polygon;
    struct psc_ray_fan_f64 rays;

    switch (l->plain) {
    case PSC_PLAIN_TRIANGLE:
        if (s->measure == PSC_MEASURE_AREA)
            fan_of_corners(l, own);
        else
            fan_of_rays(&l->rays, l->b, own);
        return own;
    case PSC_PLAIN_FAN:
        load_ray_fan(&l->fans, k, &rays);
        fan_of_rays(&rays, l->fans.b, own);
        return own;
    default:
        return l->fan + k;
    }
}

/* The number of the triangle of the fan that holds the direction, itself, and the direction in its
   frame; -1 outside. */
static int find_triangle(const psc_sampler *s, const double direction[3], double epsilon,
                         struct psc_fan_f64 *fan, struct psc_spot_f64 *p)
{
    const double slack = 32.0 * epsilon;
    int i, found = -1;
    double best = 0.0;

    for (i = 0; i < s->polygon.triangles; i++) {
        struct psc_fan_f64 own;
        const struct psc_fan_f64 *const f = fan_at(s, i, &own);
        struct psc_fan_edges e;
        struct psc_spot_f64 q;
        double inside;

        fan_look(f, direction, &q);
        if (!fan_holds(f, &q, slack))
            continue;
        /* Between two triangles both may claim it. */
        fan_edges(f, &e);
        inside = MIN(q.c, spot_dot(&q, &e.bc));
        if (found < 0 || inside > best) {
            found = i;
            best = inside;
            *fan = *f;
            *p = q;
        }
    }
    return found;
}

/* The side whose directions include this one, which is then in its frame; NULL outside. */
static const struct psc_sector_side *find_side(const psc_sampler *s, const double direction[3],
                                               double epsilon, double local[3])
{
    const struct psc_sector_light *const l = &s->polygon.projected;
    int i;

    for (i = 0; i < s->sides; i++)
        if (side_holds(l, l->side + i, direction, 32.0 * epsilon, local))
            return l->side + i;
    return NULL;
}

static double projected_pdf(const psc_sampler *s, const double direction[3], double epsilon)
{
    double local[3];

    return find_side(s, direction, epsilon, local) ? local[2] * s->inverse_total : 0.0;
}

static int projected_invert(const psc_sampler *s, const double direction[3], double epsilon,
                            double uv[2])
{
    const struct psc_sector_light *const l = &s->polygon.projected;
    double local[3];
    const struct psc_sector_side *const side = find_side(s, direction, epsilon, local);

    if (!side)
        return 0;
    side_invert(l, side, local, uv);
    if (s->sides == 2)
        uv[0] = side == l->side ? uv[0] * s->split : 1.0 - uv[0] * (1.0 - s->split);
    return 1;
}

double psc_polygon_pdf(const psc_sampler *s, const double direction[3], double epsilon)
{
    const struct psc_polygon_light *l = &s->polygon;
    double t;

    if (s->projected)
        return projected_pdf(s, direction, epsilon);
    if (s->map == PSC_MAP_PARALLEL) {
        struct psc_rectangle own;
        const struct psc_rectangle *const f = rectangle_of(l, &own);
        struct psc_rectangle_point p;

        return rectangle_look(f, direction, 32.0 * epsilon, &p)
                   ? rectangle_pdf(f, &p, s->measure == PSC_MEASURE_AREA, l->volume,
                                   s->inverse_total)
                   : 0.0;
    } else {
        struct psc_fan_f64 fan;
        struct psc_spot_f64 p;
        double a, b, c;

        if (find_triangle(s, direction, epsilon, &fan, &p) < 0)
            return 0.0;
        if (s->measure != PSC_MEASURE_AREA)
            return s->inverse_total;
        fan_hit_f64(&fan, &p, &a, &b, &c, &t);
    }
    return 2.0 * (t * t * t) / l->volume;
}

static void invert_rectangle(const psc_sampler *s, const struct psc_rectangle *f,
                             const struct psc_rectangle_point *p, double uv[2])
{
    if (s->measure == PSC_MEASURE_AREA) {
        uv[0] = p->u;
        uv[1] = p->v;
    } else {
        rectangle_invert(f, f->x_a == 0.0, p, uv);
    }
}

static void invert_fan(const psc_sampler *s, const struct psc_fan_f64 *fan, int k,
                       const struct psc_spot_f64 *p, double uv[2])
{
    const struct psc_polygon_light *l = &s->polygon;

    if (s->measure == PSC_MEASURE_AREA) {
        double a, b, c, t, rest;

        fan_hit_f64(fan, p, &a, &b, &c, &t);
        rest = a + c;
        uv[0] = rest > 0.0 ? c / rest : 0.0;
        uv[1] = rest * rest;
    } else {
        fan_invert(fan, p, uv);
    }
    if (l->triangles > 1)
        uv[0] = l->below[k] + MIN(MAX(uv[0], 0.0), 1.0) / l->per_share[k];
}

psc_result psc_polygon_invert(const psc_sampler *s, const double direction[3], double epsilon,
                              double uv[2])
{
    int i;

    if (s->projected) {
        if (!projected_invert(s, direction, epsilon, uv))
            return PSC_OUTSIDE;
    } else if (s->map == PSC_MAP_PARALLEL) {
        struct psc_rectangle own;
        const struct psc_rectangle *const f = rectangle_to_invert(s, &own);
        struct psc_rectangle_point p;

        if (!rectangle_look(f, direction, 32.0 * epsilon, &p))
            return PSC_OUTSIDE;
        invert_rectangle(s, f, &p, uv);
    } else {
        struct psc_fan_f64 fan;
        struct psc_spot_f64 p;
        const int k = find_triangle(s, direction, epsilon, &fan, &p);

        if (k < 0)
            return PSC_OUTSIDE;
        invert_fan(s, &fan, k, &p, uv);
    }
    for (i = 0; i < 2; i++)
        uv[i] = MIN(MAX(uv[i], 0.0), 1.0);
    return PSC_SUCCESS;
}
