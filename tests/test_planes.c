/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Which vertices make a polygon: those in one plane, as far as float can tell where a renderer
 * keeps them in that, and those that turn one way, once. What is sampled where they are in no plane
 * is the fan of triangles.
 */
#include <psc/psc.h>

#include "tap.h"
#include "vectors.h"

enum { MOST = 16 };

static const psc_measure measures[] = {PSC_MEASURE_SOLID_ANGLE, PSC_MEASURE_PROJECTED_SOLID_ANGLE,
                                       PSC_MEASURE_AREA};

/* A polygon on a circle of that radius, whose corners are visited with `turns` turns. */
static void on_circle(uint64_t *state, int count, int turns, const double center[3], double radius,
                      double v[3 * MOST])
{
    const double start = random_between(state, 0.0, 6.2831853071795862);
    double z[3], x[3], y[3];
    int i, c;

    random_unit(state, z);
    random_across(state, z, x);
    cross(z, x, y);
    for (i = 0; i < count; i++) {
        const double angle = start + 6.2831853071795862 * turns * i / count;

        for (c = 0; c < 3; c++)
            v[3 * i + c] = center[c] + radius * (cos(angle) * x[c] + sin(angle) * y[c]);
    }
}

/* How far vertices are off the plane through the first, across the sum of the areas; *extent: the
   largest coordinate from there. */
static double off_plane(int count, const double *v, double normal[3], double *extent)
{
    double off = 0.0;
    int i, c;

    *extent = normal[0] = normal[1] = normal[2] = 0.0;
    for (i = 1; i < count; i++) {
        double first[3], second[3], across[3];

        subtract3(v + 3 * i, v, first);
        subtract3(v + 3 * ((i + 1) % count), v, second);
        exact_cross(first, second, across);
        for (c = 0; c < 3; c++) {
            normal[c] += across[c];
            *extent = fmax(*extent, fabs(first[c]));
        }
    }
    scale3(normal, 1.0 / sqrt(dot(normal, normal)), normal);
    for (i = 1; i < count; i++) {
        double spoke[3];

        subtract3(v + 3 * i, v, spoke);
        off = fmax(off, fabs(dot(normal, spoke)));
    }
    return off;
}

static psc_result build(psc_sampler_storage *room, psc_sampler **s, psc_measure measure,
                        const double center[3], double radius, int count, const double *v)
{
    const double position[3] = {center[0] + 3.0 * radius, center[1] - 2.0 * radius,
                                center[2] + 4.0 * radius};
    const double normal[3] = {-3.0, 2.0, -4.0};
    const psc_technique technique = {sizeof technique, measure, PSC_MAP_RADIAL, 0, NULL};
    const psc_receiver receiver = {sizeof receiver, PSC_RECEIVER_TWO_SIDED, position, normal};

    psc_sampler_init(room, sizeof *room, s);
    return psc_build_polygon(*s, &technique, &receiver, (size_t)count, v, 3 * sizeof(double));
}

/* Whether all calls for a polygon say so. */
static int all_say(psc_result expected, const double center[3], double radius, int count,
                   const double *v)
{
    psc_sampler_storage room;
    psc_sampler *s;
    double value;
    int i, same = 1;

    for (i = 0; i < 3; i++)
        same &= build(&room, &s, measures[i], center, radius, count, v) == expected;
    value = 0.0;
    return same & (psc_polygon_solid_angle(center, (size_t)count, v, 3 * sizeof(double), &value) ==
                       expected ||
                   (expected == PSC_SUCCESS && value == 0.0));
}

static void float_vertices(void)
{
    uint64_t state = 500;
    long steep = 0, refused = 0, lifted_refused = 0;
    int i, k;

    for (k = 0; k < 2000; k++) {
        const int count = 3 + random_below(&state, MOST - 2);
        double center[3], v[3 * MOST], normal[3], extent, radius, size = 0.0, step;

        for (i = 0; i < 3; i++)
            center[i] = random_between(&state, -1000.0, 1000.0);
        for (i = 0; i < 3; i++)
            size = fmax(size, fabs(center[i]));
        /* corners are turned by more than rounding can turn them back */
        radius = size * random_log(&state, 1e-4, 1e-1);
        on_circle(&state, count, 1, center, radius, v);
        for (i = 0; i < 3 * count; i++)
            v[i] = (float)v[i];
        steep += off_plane(count, v, normal, &extent) > 1e-6 * extent;
        refused += !all_say(PSC_SUCCESS, center, radius, count, v);
        if (count == 3)
            continue;
        step = 128.0 * 0x1p-24 * size + 1e-5 * extent;
        for (i = 0; i < 3; i++)
            v[6 + i] += step * normal[i];
        lifted_refused += !all_say(PSC_ERROR_NOT_PLANAR, center, radius, count, v);
    }
    tap_ok(steep > 500, "%ld of 2000 polygons in float are off their plane by 1e-6 of their extent",
           steep);
    tap_ok(refused == 0, "%ld of them are refused", refused);
    tap_ok(lifted_refused == 0, "%ld are taken with a vertex lifted by 128 roundings and 1e-5",
           lifted_refused);
}

/* The tolerance where the largest coordinate is about the extent. */
static void double_vertices(void)
{
    static const double center[3] = {0.0, 0.0, 0.0};
    uint64_t state = 501;
    long refused = 0, taken = 0;
    int i, k;

    for (k = 0; k < 500; k++) {
        const int count = 4 + random_below(&state, MOST - 3);
        double v[3 * MOST], w[3 * MOST], normal[3], extent, size = 0.0, most;

        on_circle(&state, count, 1, center, 1.0, v);
        off_plane(count, v, normal, &extent);
        for (i = 0; i < 3 * count; i++)
            size = fmax(size, fabs(v[i]));
        most = 1e-6 * (extent + size);
        for (i = 0; i < 3 * count; i++)
            w[i] = v[i] + (i / 3 == 2 ? random_between(&state, 0.4, 3.0) * most * normal[i % 3]
                                      : 0.0);
        if (off_plane(count, w, normal, &extent) < 0.999 * most)
            refused += !all_say(PSC_SUCCESS, center, 1.0, count, w);
        else if (off_plane(count, w, normal, &extent) > 1.001 * most)
            taken += !all_say(PSC_ERROR_NOT_PLANAR, center, 1.0, count, w);
    }
    tap_ok(refused == 0, "%ld polygons are refused below the tolerance", refused);
    tap_ok(taken == 0, "%ld polygons are taken above it", taken);
}

static void corners(void)
{
    static const double center[3] = {1.0, 2.0, 3.0};
    uint64_t state = 502;
    long taken = 0, refused = 0;
    int i, k, c;

    for (k = 0; k < 500; k++) {
        const int count = 5 + random_below(&state, MOST - 4), at = random_below(&state, count);
        const double *next, *before;
        double v[3 * MOST], w[3 * MOST];

        on_circle(&state, count, 1, center, 1.0, v);
        for (i = 0; i < 3 * count; i++)
            w[i] = v[i];
        before = v + 3 * ((at + count - 1) % count);
        next = v + 3 * ((at + 1) % count);
        for (c = 0; c < 3; c++) /* in line with its neighbours, and off that a little */
            w[3 * at + c] = 0.5 * (before[c] + next[c]);
        refused += !all_say(PSC_SUCCESS, center, 1.0, count, w);
        for (c = 0; c < 3; c++)
            w[3 * at + c] += 1e-4 * (center[c] - w[3 * at + c]);
        taken += !all_say(PSC_ERROR_NOT_CONVEX, center, 1.0, count, w);
        on_circle(&state, count, 2, center, 1.0, v);
        taken += count % 2 && !all_say(PSC_ERROR_NOT_CONVEX, center, 1.0, count, v);
    }
    tap_ok(refused == 0, "%ld polygons with a vertex in line are refused", refused);
    tap_ok(taken == 0, "%ld polygons with a dent, or that turn twice, are taken", taken);
}

/* How far a point is from a triangle, of which it is a sum with shares not below 0. */
static double from_triangle(const double *a, const double *b, const double *c,
                            const double point[3], double slack)
{
    double first[3], second[3], offset[3], n[3], s[3], t[3], square;

    subtract3(b, a, first);
    subtract3(c, a, second);
    subtract3(point, a, offset);
    exact_cross(first, second, n);
    exact_cross(offset, second, s);
    exact_cross(first, offset, t);
    square = dot(n, n);
    return dot(s, n) / square < -slack || dot(t, n) / square < -slack ||
                   (dot(s, n) + dot(t, n)) / square > 1.0 + slack
               ? HUGE_VAL
               : fabs(dot(offset, n)) / sqrt(square);
}

static void points_of_fans(void)
{
    uint64_t state = 503;
    double worst = 0.0, least = HUGE_VAL;
    int i, j, k, m;

    for (k = 0; k < 200; k++) {
        const int count = 4 + random_below(&state, MOST - 3);
        const double center[3] = {0.7, -0.9, 0.8}, radius = random_log(&state, 1e-3, 1e-2);
        double v[3 * MOST], normal[3], extent;

        on_circle(&state, count, 1, center, radius, v);
        for (i = 0; i < 3 * count; i++)
            v[i] = (float)v[i];
        least = fmin(least, off_plane(count, v, normal, &extent) / extent);
        for (m = 0; m < 3; m += 2) {
            psc_sampler_storage room;
            psc_sampler *s;

            if (build(&room, &s, measures[m], center, radius, count, v) != PSC_SUCCESS)
                continue;
            for (j = 0; j < 20; j++) {
                psc_light_sample_f64 sample;
                double off = HUGE_VAL;

                psc_sample_f64(s, random_uniform(&state), random_uniform(&state), &sample);
                for (i = 1; i + 1 < count; i++)
                    off = fmin(off, from_triangle(v, v + 3 * i, v + 3 * i + 3, sample.point,
                                                  1e-9));
                worst = fmax(worst, off);
            }
        }
    }
    tap_ok(least > 0.0, "polygons in float are off their planes");
    tap_ok(worst < 4e-16, "samples are off the triangles of the fan by %.3g", worst);
}

int main(void)
{
    float_vertices();
    double_vertices();
    corners();
    points_of_fans();
    return tap_done();
}
