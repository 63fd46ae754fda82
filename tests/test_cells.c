/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Equal areas: the images of the cells of an N x N grid on the square have the same measure,
 * one N^2-th of the total. And the pdf, also of maps that are only nearly uniform, is one over the
 * Jacobian of the map at every point.
 *
 * The area of an image is the integral around its outline in a plane to which the measure is
 * carried over exactly: the tangent plane of the receiver for projected solid angle (projection
 * keeps cosine times solid angle), Lambert's azimuthal plane for solid angle, for the area of a
 * flat light its own plane, and for that of a sphere Lambert's plane again, of its normals.
 */
#include "shapes.h"
#include "vectors.h"
#include "worst.h"

enum { LIGHTS = 25, N = 6, STEPS = 8, POINTS = 40 };

struct plane {
    const struct light *light;
    const psc_sampler *sampler;
    double center[3], x[3], y[3];
};

static void scale_to_unit(double v[3])
{
    scale3(v, 1.0 / sqrt(dot(v, v)), v);
}

static int is_area(const struct plane *p)
{
    return p->light->what->measure >= PSC_MEASURE_AREA;
}

/* Whether a plane takes the points as they are, or directions of any kind by Lambert's map. */
static int is_plain(const struct plane *p)
{
    return p->light->what->measure == PSC_MEASURE_PROJECTED_SOLID_ANGLE ||
           (is_area(p) && p->light->shape->flat);
}

/* The direction that is looked at; for area the point of a flat light, the normal of a sphere. */
static void look(const struct plane *p, double u, double v, double w[3])
{
    psc_light_sample_f64 s;

    psc_sample_f64(p->sampler, u, v, &s);
    if (is_area(p) && p->light->shape->flat)
        subtract3(s.point, p->light->middle, w);
    else
        memcpy(w, is_area(p) ? s.normal : s.direction, sizeof s.direction);
}

/* The plane of the light, or one that touches the sphere of directions at the receiver's normal
   or in the cell itself. */
static void make_plane(uint64_t *state, double u, double v, struct plane *p)
{
    psc_light_sample_f64 s;

    if (p->light->what->measure == PSC_MEASURE_PROJECTED_SOLID_ANGLE)
        memcpy(p->center, p->light->normal, sizeof p->center);
    else if (is_plain(p)) {
        psc_sample_f64(p->sampler, u, v, &s);
        memcpy(p->center, s.normal, sizeof p->center);
    } else
        look(p, u, v, p->center);
    scale_to_unit(p->center);
    random_across(state, p->center, p->x);
    cross(p->center, p->x, p->y);
    scale_to_unit(p->y);
}

static void to_plane(const struct plane *p, double u, double v, double xy[2])
{
    double scale = 1.0, w[3], sum[3];
    int i;

    look(p, u, v, w);
    if (!is_plain(p)) {
        for (i = 0; i < 3; i++)
            sum[i] = w[i] + p->center[i];
        scale = 2.0 / sqrt(dot(sum, sum)); /* sqrt(2 / (1 + cosine)) */
    }
    if (is_area(p) && !is_plain(p))
        scale *= p->light->reach; /* the radius of the sphere */
    xy[0] = scale * dot(w, p->x);
    xy[1] = scale * dot(w, p->y);
}

/* A point of a cell's outline, t going around it from 0 to 4. */
static void on_outline(const struct plane *p, int column, int row, double t, double xy[2])
{
    const double u = t < 1.0 ? t : t < 2.0 ? 1.0 : t < 3.0 ? 3.0 - t : 0.0;
    const double v = t < 1.0 ? 0.0 : t < 2.0 ? t - 1.0 : t < 3.0 ? 1.0 : 4.0 - t;

    to_plane(p, (column + u) / N, (row + v) / N, xy);
}

static double triangle(const double a[2], const double b[2], const double c[2])
{
    return 0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
}

struct outline {
    const struct plane *plane;
    int column, row;
    double small; /* an area that does not matter */
};

/* The area between a chord of the outline and its arc: that of the triangle with the middle of the
   arc, and of what is left on both sides. Where that is little the arc is a parabola, with a third
   of the triangle left, unless it has a kink there, where it does not matter. One little triangle
   may be by chance, as where an arc turns from left to right: small counts them. */
static double segment(const struct outline *o, double from, const double a[2], double to,
                      const double b[2], int small)
{
    const double middle = 0.5 * (from + to);
    double m[2], area;

    on_outline(o->plane, o->column, o->row, middle, m);
    area = triangle(a, m, b);
    small = fabs(area) <= o->small ? small + 1 : 0;
    if (small == 2 || to - from < 1e-12)
        return 4.0 / 3.0 * area;
    return area + segment(o, from, a, middle, m, small) + segment(o, middle, m, to, b, small);
}

static double cell_area(const struct plane *p, int column, int row, double expected)
{
    const struct outline o = {p, column, row, 4e-8 * expected};
    double first[2], before[2], here[2], sum = 0.0;
    int i;

    on_outline(p, column, row, 0.0, first);
    memcpy(before, first, sizeof before);
    for (i = 1; i <= 4 * STEPS; i++) {
        const double from = (i - 1.0) / STEPS, to = (double)i / STEPS;

        on_outline(p, column, row, to, here);
        sum += triangle(first, before, here) + segment(&o, from, before, to, here, 0);
        memcpy(before, here, sizeof before);
    }
    return fabs(sum);
}

static void cells(const struct shape *shape, const struct test_technique *what)
{
    struct worst worst = {0};
    uint64_t seed = 70;
    int i, column, row;

    for (i = 0; i < LIGHTS; i++) {
        struct test_sampler s;
        struct light light;
        struct plane plane;
        double total, area;

        random_light(&seed, shape, what, &light);
        light.flags = 0; /* two-sided lights are two such pictures, with a cell across the seam */
        if (build_light(make_sampler(&s), &light) != PSC_SUCCESS)
            continue;
        plane.light = &light;
        plane.sampler = s.sampler;
        psc_sampler_total(s.sampler, &total);
        for (column = 0; column < N; column++)
            for (row = 0; row < N; row++) {
                make_plane(&seed, (column + 0.5) / N, (row + 0.5) / N, &plane);
                area = cell_area(&plane, column, row, total / (N * N));
                worst_add(&worst, fabs(area * N * N / total - 1.0), "light %d cell %d, %d: %s", i,
                          column, row, describe_light(&light));
            }
    }
    worst_report(&worst, 2e-7, "%s, %s: area of a cell, relative", shape->name, what->name);
}

/* The solid angle per area of the square, from difference quotients; `same` is whether the density
   is the same at all of their ends. */
static double jacobian(const psc_sampler *sampler, double u, double v, int *same)
{
    const double step = 2e-6;
    double along[2][3], area[3];
    int i, k;

    *same = 1;
    for (k = 0; k < 2; k++) {
        const double du = (k == 0) * step, dv = (k == 1) * step;
        psc_light_sample_f64 a, b;

        psc_sample_f64(sampler, u - du, v - dv, &a);
        psc_sample_f64(sampler, u + du, v + dv, &b);
        *same &= a.pdf == b.pdf;
        for (i = 0; i < 3; i++)
            along[k][i] = (b.direction[i] - a.direction[i]) / (2.0 * step);
    }
    cross(along[0], along[1], area);
    return sqrt(dot(area, area));
}

/* Not next to the limb of a closed light, where a density by area changes too fast for that. */
static void densities(const struct shape *shape, const struct test_technique *what)
{
    const int closed = !shape->flat && what->measure >= PSC_MEASURE_AREA;
    struct worst worst = {0};
    uint64_t seed = 71;
    int i, j;

    for (i = 0; i < LIGHTS; i++) {
        struct test_sampler s;
        struct light light;

        random_light(&seed, shape, what, &light);
        light.flags = 0; /* no edge of the maps of both sides inside the square */
        if (build_light(make_sampler(&s), &light) != PSC_SUCCESS)
            continue;
        for (j = 0; j < POINTS; j++) {
            const double u = random_between(&seed, 0.01, 0.99);
            const double v = random_between(&seed, 0.01, 0.99);
            psc_light_sample_f64 sample;
            double area;
            int same;

            psc_sample_f64(s.sampler, u, v, &sample);
            area = jacobian(s.sampler, u, v, &same);
            if (is_tabulated(what) && (sample.pdf == 0.0 || !same))
                continue; /* across the edge of a cell */
            if (closed && fabs(dot(sample.direction, sample.normal)) < 0.05)
                continue;
            worst_add(&worst, fabs(sample.pdf * area - 1.0),
                      "light %d, u %a v %a: %s", i, u, v, describe_light(&light));
        }
    }
    worst_report(&worst, 1e-6, "%s, %s: pdf by the Jacobian, relative", shape->name, what->name);
}

int main(void)
{
    const struct test_technique *what;
    int i;

    for (i = 0; shapes[i]; i++)
        for (FOR_TECHNIQUES(shapes[i], what)) {
            if (!is_uneven(what))
                cells(shapes[i], what);
            densities(shapes[i], what);
        }
    return tap_done();
}
