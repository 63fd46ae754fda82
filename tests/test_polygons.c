/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Triangles, rectangles and polygons wherever they are hard: from 1e-16 of a steradian and less to
 * 2 pi, needles, the receiver next to an edge, a vertex or the plane. Totals and the place of each
 * sample in the unit square are compared with 113-bit quadrature of positive densities, of which
 * no step is one of the library's: for fans that of the angle at the first vertex, 1 - cos of the
 * arc to the far side, where the library has a closed form of excess and side; for rectangles that
 * of strips.
 *
 * A sample tells its place by its direction, which is rounded, and where the light is small by its
 * coordinates on the surface too; but those of a polygon are of one plane, in which rounding does
 * not leave its vertices. How far rounding carries the place is no error, and where that is far,
 * nothing is.
 */
#include "reference_polygons.h"
#include "shapes.h"
#include "vectors.h"
#include "worst.h"

enum { LIGHTS = 240, SAMPLES = 3, VERTICES = 16 };

static const double cdf_bound[2] = {3e-7, 1e-14};

/* ---- A light, and all that is known of it ---- */

struct subject {
    const struct light *light;
    int is_strip;
    struct reference_fan fan;
    struct reference_strip strip;
    quad total;
    quad origin[3], first[3], second[3]; /* of the coordinates on the surface */
    double size;                         /* angle that it fills, as a sine, about */
    double elevation;                    /* sine of that of a vertex over the light's plane */
};

static int make_subject(const struct light *light, struct subject *o)
{
    const int n = part_count(light->shape), rectangle = light->shape->shape == PSC_SHAPE_RECTANGLE;
    const int triangle = light->shape->shape == PSC_SHAPE_TRIANGLE;
    quad v[VERTICES][3], plane[3], extent, nearest;
    int i, c;

    o->light = light;
    o->is_strip = rectangle && light->what->map == PSC_MAP_PARALLEL;
    for (i = 0; i < n; i++)
        for (c = 0; c < 3; c++)
            v[i][c] = light->geometry[3 * i + c] -
                      (rectangle && i > 0 ? 0 : (quad)light->position[c]);
    for (c = 0; c < 3; c++) {
        o->origin[c] = v[0][c];
        o->first[c] = rectangle ? v[1][c] : v[1][c] - v[0][c];
        o->second[c] = rectangle ? v[2][c] : v[n - 1][c] - v[0][c];
    }
    nearest = reference_length(v[0]);
    extent = reference_length(o->first) + reference_length(o->second);
    for (i = 1; i < n && !rectangle; i++) {
        const quad away = reference_length(v[i]);

        nearest = away < nearest ? away : nearest;
    }
    o->size = (double)(extent / nearest);
    reference_cross(o->first, o->second, plane);
    o->elevation = (double)(quad_abs(reference_dot(v[0], plane)) /
                            (reference_length(plane) * reference_length(v[0])));
    if (o->is_strip) {
        reference_strip(v[0], v[1], v[2], &o->strip);
        o->total = o->strip.total;
        return o->total > 0;
    }
    if (rectangle) {
        quad along = reference_dot(v[1], v[2]) / reference_dot(v[1], v[1]);

        for (c = 0; c < 3; c++) {
            const quad across = v[2][c] - along * v[1][c];

            v[1][c] += v[0][c];
            v[2][c] = v[1][c] + across;
            v[3][c] = v[0][c] + across;
        }
    }
    o->fan.corners = 0;
    o->total = 0;
    for (i = 1; i + 1 < (rectangle ? 4 : n); i++) {
        struct reference_corner *k = &o->fan.corner[o->fan.corners];

        if (triangle ? !reference_corner(v[0], v[1], v[2], k)
                     : !reference_corner(v[i], v[0], v[i + 1], k))
            continue;
        o->fan.corners++;
        o->total += k->total;
    }
    return o->total > 0;
}

struct errors {
    struct worst total, u[2], v[2], surface_u[2], surface_v[2];
    long odd;
};

static void check_place(const struct subject *o, const quad w[3], double turn, double u, double v,
                        struct worst *in_u, struct worst *in_v, int bits)
{
    quad here[2];
    double open[2];

    if (o->is_strip)
        reference_in_strip(&o->strip, w, turn, here, open);
    else
        reference_in_fan(&o->fan, w, turn, here, open);
    if (open[0] > 1.0 / 16.0 || open[1] > 1.0 / 16.0)
        return;
    worst_add(in_u, fmax(fabs((double)(here[0] - (quad)u)) - open[0], 0.0), "%s f%d u %a v %a",
              describe_light(o->light), bits, u, v);
    worst_add(in_v, fmax(fabs((double)(here[1] - (quad)v)) - open[1], 0.0), "%s f%d u %a v %a",
              describe_light(o->light), bits, u, v);
}

static void check_sample(const struct subject *o, const psc_sampler *sampler, int wide, double u,
                         double v, struct errors *e)
{
    const double unit = wide ? 0x1p-53 : 0x1p-24;
    psc_light_sample_f64 s;
    quad w[3];
    int c;

    if (!wide) {
        u = (float)u;
        v = (float)v;
    }
    memset(&s, 0xff, sizeof s);
    sample_any(wide ? 64 : 32, sampler, u, v, &s);
    if (!(fabs(dot(s.direction, s.direction) - 1.0) < 16.0 * unit && s.pdf >= 0.0 &&
          s.weight >= 0.0 && s.distance > 0.0))
        e->odd++;
    for (c = 0; c < 3; c++)
        w[c] = s.direction[c];
    check_place(o, w, 6.0 * unit, u, v, &e->u[wide], &e->v[wide], wide ? 64 : 32);
    if (o->size > 0.1 || part_count(o->light->shape) > 3)
        return;
    for (c = 0; c < 3; c++)
        w[c] = o->origin[c] + s.surface[0] * o->first[c] + s.surface[1] * o->second[c];
    check_place(o, w, 6.0 * unit * o->size, u, v, &e->surface_u[wide], &e->surface_v[wide],
                wide ? 64 : 32);
}

/* Next to a vertex or an edge, at a distance in proportion to its length. */
static void come_close(uint64_t *seed, struct light *light)
{
    const double away = random_log(seed, 1e-12, 1e-2) * light->reach;
    const int n = part_count(light->shape), rectangle = light->shape->shape == PSC_SHAPE_RECTANGLE;
    const int i = random_below(seed, n), j = (i + 1) % n;
    const double share = random_below(seed, 2) ? 0.0 : random_uniform(seed);
    const double *g = light->geometry;
    double aside[3];
    int c;

    random_unit(seed, aside);
    for (c = 0; c < 3; c++) {
        const double start = rectangle ? g[c] : g[3 * i + c];
        const double edge = rectangle ? g[3 + 3 * (i % 2) + c] : g[3 * j + c] - g[3 * i + c];

        light->position[c] = start + share * edge + away * aside[c];
    }
}

static void sweep(const struct shape *shape, const struct test_technique *what)
{
    static struct errors e;
    static struct subject o;
    uint64_t seed = 300;
    int i, j, wide;

    memset(&e, 0, sizeof e);
    for (i = 0; i < LIGHTS; i++) {
        struct test_sampler s;
        struct light light;
        double total = 0.0;

        random_hard_light(&seed, shape, what, &light);
        light.technique_flags = 0;
        light.has_normal = 0;
        light.flags = 0;
        if (i % 3 == 0)
            come_close(&seed, &light);
        if (build_light(make_sampler(&s), &light) != PSC_SUCCESS || !make_subject(&light, &o))
            continue;
        psc_sampler_total(s.sampler, &total);
        /* two words tell a height down to 1e-32 of a length */
        if (o.elevation > 1e-16)
            worst_add(&e.total, fabs((double)(total / o.total - 1)), "%s", describe_light(&light));
        for (j = 0; j < SAMPLES; j++) {
            const double u = random_coordinate(&seed), v = random_coordinate(&seed);

            for (wide = 0; wide < 2; wide++)
                check_sample(&o, s.sampler, wide, u, v, &e);
        }
    }
    worst_report(&e.total, 2e-15, "%s, %s: solid angle, relative", shape->name, what->name);
    tap_ok(e.odd == 0, "%s, %s: %ld samples are none", shape->name, what->name, e.odd);
    for (wide = 0; wide < 2; wide++) {
        const int bits = wide ? 64 : 32;

        worst_report(&e.u[wide], cdf_bound[wide], "%s, %s, f%d: CDF in u", shape->name,
                     what->name, bits);
        worst_report(&e.v[wide], cdf_bound[wide], "%s, %s, f%d: CDF in v", shape->name,
                     what->name, bits);
        if (part_count(shape) > 3)
            continue;
        worst_report(&e.surface_u[wide], cdf_bound[wide], "%s, %s, f%d: CDF in u, on the surface",
                     shape->name, what->name, bits);
        worst_report(&e.surface_v[wide], cdf_bound[wide], "%s, %s, f%d: CDF in v, on the surface",
                     shape->name, what->name, bits);
    }
}

int main(void)
{
    static const struct shape *const those[] = {&shape_triangle, &shape_rectangle, &shape_polygon3,
                                                &shape_polygon4, &shape_polygon5,  &shape_polygon8,
                                                &shape_polygon16};
    const struct test_technique *what;
    size_t i;

    for (i = 0; i < sizeof those / sizeof *those; i++)
        for (FOR_TECHNIQUES(those[i], what))
            if (what->measure == PSC_MEASURE_SOLID_ANGLE)
                sweep(those[i], what);
    return tap_done();
}
