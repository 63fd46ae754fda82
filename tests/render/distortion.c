/* SPDX-License-Identifier: Apache-2.0 */
#include "maps.h"

#include <stdlib.h>

/* Steps of the difference quotients. Points are at least 2^-11 from the edges of the unit square,
   where maps have their roots, so that what the quotients leave out is below 1e-7 of the
   derivative; what is rounded, below 1e-7 of the light's size. */
static const double step = 0x1p-24;

void map_lattice(warped *w, double shift)
{
    for (int i = 0; i < LATTICE; ++i) {
        w->u[i] = (i + shift) / LATTICE;
        w->v[i] = (i * 275 % LATTICE + shift) / LATTICE;
    }
}

void map_warp(const psc_sampler *sampler, warped *w, int count)
{
    const psc_input_f64 uv = {{w->u, w->v}, sizeof(double)};
    const psc_samples_f64 out = {
        .struct_size = sizeof out,
        .direction = {{w->direction[0], w->direction[1], w->direction[2]}, sizeof(double)},
        .pdf = {{w->pdf}, sizeof(double)},
        .point = {{w->point[0], w->point[1], w->point[2]}, sizeof(double)},
        .status = {w->status, sizeof(psc_result)}};
    map_check(psc_sample_n_f64(sampler, (size_t)count, &uv, &out), "sampling");
}

/* Where the measure is area. */
static void place(const warped *w, psc_measure measure, int i, double p[3])
{
    const int area = measure == PSC_MEASURE_AREA || measure == PSC_MEASURE_VISIBLE_AREA;
    for (int c = 0; c < 3; ++c)
        p[c] = area ? w->point[c][i] : w->direction[c][i];
    if (measure == PSC_MEASURE_PROJECTED_SOLID_ANGLE)
        p[2] = 0;
}

static double squared_distance(const double a[3], const double b[3])
{
    return (a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) +
           (a[2] - b[2]) * (a[2] - b[2]);
}

static void find_neighbours(const psc_sampler *sampler, psc_measure measure, distortion *d)
{
    static double p[LATTICE][3];
    static warped w;
    double total, sum = 0, least = INFINITY;

    map_check(psc_sampler_total(sampler, &total), "the total");
    map_lattice(&w, 0);
    map_warp(sampler, &w, LATTICE);
    for (int i = 0; i < LATTICE; ++i)
        place(&w, measure, i, p[i]);
    for (int i = 0; i < LATTICE; ++i) {
        double nearest = INFINITY;
        for (int k = 0; k < LATTICE; ++k)
            if (k != i)
                nearest = fmin(nearest, squared_distance(p[i], p[k]));
        sum += sqrt(nearest);
        least = fmin(least, sqrt(nearest));
    }
    d->least_distance = least / sqrt(total / LATTICE);
    d->mean_distance = sum / LATTICE / sqrt(total / LATTICE);
}

static int by_size(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* Difference quotients of positions (in the measure) and directions, by u or by v. */
static void differentiate(const psc_sampler *sampler, psc_measure measure, int by_v,
                          double position[LATTICE][3], double direction[LATTICE][3])
{
    static warped low, high;

    map_lattice(&low, 0.5);
    high = low;
    for (int i = 0; i < LATTICE; ++i) {
        (by_v ? low.v : low.u)[i] -= step;
        (by_v ? high.v : high.u)[i] += step;
    }
    map_warp(sampler, &low, LATTICE);
    map_warp(sampler, &high, LATTICE);
    for (int i = 0; i < LATTICE; ++i) {
        double a[3], b[3];
        place(&low, measure, i, a);
        place(&high, measure, i, b);
        for (int c = 0; c < 3; ++c) {
            position[i][c] = (b[c] - a[c]) / (2 * step);
            direction[i][c] = (high.direction[c][i] - low.direction[c][i]) / (2 * step);
        }
    }
}

distortion map_distortion(const psc_sampler *sampler, psc_measure measure)
{
    static double du[LATTICE][3], dv[LATTICE][3], wu[LATTICE][3], wv[LATTICE][3];
    static warped w;
    double ratio[LATTICE];
    distortion d = {0};

    find_neighbours(sampler, measure, &d);
    map_lattice(&w, 0.5);
    map_warp(sampler, &w, LATTICE);
    differentiate(sampler, measure, 0, du, wu);
    differentiate(sampler, measure, 1, dv, wv);
    for (int i = 0; i < LATTICE; ++i) {
        double uu = 0, uv = 0, vv = 0, ww = 0;
        for (int c = 0; c < 3; ++c) {
            const int j = (c + 1) % 3, k = (c + 2) % 3;
            const double n = wu[i][j] * wv[i][k] - wu[i][k] * wv[i][j];
            uu += du[i][c] * du[i][c];
            uv += du[i][c] * dv[i][c];
            vv += dv[i][c] * dv[i][c];
            ww += n * n;
        }
        /* squared singular values: half trace +- root, of which the product is the determinant */
        const double half = (uu + vv) / 2;
        const double root = sqrt((uu - vv) * (uu - vv) / 4 + uv * uv);
        ratio[i] = (half + root) / sqrt(uu * vv - uv * uv);
        const double density = fabs(sqrt(ww) * w.pdf[i] - 1);
        if (!(density <= d.density)) /* for a NaN too */
            d.density = density;
    }
    qsort(ratio, LATTICE, sizeof *ratio, by_size);
    d.median_ratio = ratio[LATTICE / 2];
    d.high_ratio = ratio[LATTICE * 95 / 100];
    return d;
}
