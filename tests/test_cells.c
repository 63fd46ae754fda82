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

enum { LIGHTS = 25, N = 6, STEPS = 256, POINTS = 40 };

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

/* Runs from 0 to 1 and lingers at both, where the maps have roots. */
static double graded(double t)
{
    double a = pow(t, 6.0), b = pow(1.0 - t, 6.0);
    return a / (a + b);
}

/* The polygon of the outline of a cell: area with a number of steps along each side. */
static double polygon(const struct plane *p, int column, int row, int steps)
{
    double first[2], before[2], here[2], sum = 0.0;
    int side, i;

    to_plane(p, (double)column / N, (double)row / N, first);
    memcpy(before, first, sizeof before);
    for (side = 0; side < 4; side++)
        for (i = 1; i <= steps; i++) {
            double t = graded((double)i / steps);
            double u = side == 0 ? t : side == 1 ? 1.0 : side == 2 ? 1.0 - t : 0.0;
            double v = side == 0 ? 0.0 : side == 1 ? t : side == 2 ? 1.0 : 1.0 - t;

            to_plane(p, (column + u) / N, (row + v) / N, here);
            sum += (before[0] - first[0]) * (here[1] - first[1]) -
                   (before[1] - first[1]) * (here[0] - first[0]);
            memcpy(before, here, sizeof before);
        }
    return sum / 2.0;
}

/* Twice the steps leave a quarter of the error. */
static double cell_area(const struct plane *p, int column, int row)
{
    double coarse = polygon(p, column, row, STEPS), fine = polygon(p, column, row, 2 * STEPS);
    return fabs(fine + (fine - coarse) / 3.0);
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
        double total;

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
                worst_add(&worst, fabs(cell_area(&plane, column, row) * N * N / total - 1.0),
                          "light %d cell %d, %d: %s", i, column, row, describe_light(&light));
            }
    }
    worst_report(&worst, 1e-6, "%s, %s: area of a cell, relative", shape->name, what->name);
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
