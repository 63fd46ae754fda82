/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Triangles, rectangles and polygons, for a receiver at the origin: triangle_solid_angle,
 * triangle_arvo, rectangle_solid_angle and rectangle_ufk by solid angle, and
 * polygon_projected_solid_angle and triangle_projected.
 *
 * A direction is compared in units of its precision's rounding times 1 + amp_xi, the sum of the
 * lengths of its derivatives by xi1 and xi2: the least that rounding xi moves it by.
 */
#include "calls.h"
#include "golden.h"

#include <math.h>

static const double origin[3] = {0.0, 0.0, 0.0};
static const double unit_of[2] = {0x1p-24, 0x1p-53};

static psc_result build_triangle(psc_sampler *sampler, const double *v)
{
    const psc_technique technique = make_technique(PSC_MEASURE_SOLID_ANGLE, PSC_MAP_RADIAL);
    const psc_receiver receiver = make_receiver(origin, NULL, 0);

    return psc_build_triangle(sampler, &technique, &receiver, v, v + 3, v + 6);
}

static double relative(double value, quad exact)
{
    return (double)(quad_abs(value - exact) / exact);
}

/* The total, the handle-free function, and the density in both precisions. */
static void compare_total(const psc_sampler *sampler, double alone, quad exact,
                          double error[GOLDEN_MEASURES])
{
    psc_light_sample_f64 sample;
    double total = NAN;

    psc_sampler_solid_angle(sampler, &total);
    error[0] = fmax(relative(total, exact), relative(alone, exact));
    sample.pdf = NAN;
    sample_any(64, sampler, 0.5, 0.5, &sample);
    error[1] = relative(1.0 / sample.pdf, exact);
    sample.pdf = NAN;
    sample_any(32, sampler, 0.5, 0.5, &sample);
    error[2] = relative(1.0 / sample.pdf, exact);
}

static void compare_triangle(const struct csv *row, double error[GOLDEN_MEASURES])
{
    const double *v = row->number;
    struct test_sampler s;
    double alone = NAN;

    build_triangle(make_sampler(&s), v);
    psc_triangle_solid_angle(origin, v, v + 3, v + 6, &alone);
    compare_total(s.sampler, alone, row->exact[9], error);
}

static psc_result build_rectangle(psc_sampler *sampler, psc_map map, const double *g)
{
    const psc_technique technique = make_technique(PSC_MEASURE_SOLID_ANGLE, map);
    const psc_receiver receiver = make_receiver(origin, NULL, 0);

    return psc_build_rectangle(sampler, &technique, &receiver, g, g + 3, g + 6);
}

/* Along the edges, and in the fourth place as a fan. */
static void compare_rectangle(const struct csv *row, double error[GOLDEN_MEASURES])
{
    const double *g = row->number;
    struct test_sampler s;
    double alone = NAN, fan = NAN;

    build_rectangle(make_sampler(&s), PSC_MAP_PARALLEL, g);
    psc_rectangle_solid_angle(origin, g, g + 3, g + 6, &alone);
    compare_total(s.sampler, alone, row->exact[9], error);
    build_rectangle(s.sampler, PSC_MAP_RADIAL, g);
    psc_sampler_total(s.sampler, &fan);
    error[3] = relative(fan, row->exact[9]);
}

/* Error of the direction at (u, v), in units of what its precision can hold. */
static double direction_error(const psc_sampler *sampler, int bits, double u, double v,
                              const quad exact[3], double amp)
{
    psc_light_sample_f64 sample;
    quad sum = 0;
    int i;

    if (sample_any(bits, sampler, u, v, &sample) != PSC_SUCCESS)
        return NAN;
    for (i = 0; i < 3; i++)
        sum += quad_square(sample.direction[i] - exact[i]);
    return (double)quad_sqrt(sum) / (unit_of[bits == 64] * (1.0 + amp));
}

static void compare_arvo(const struct csv *row, double error[GOLDEN_MEASURES])
{
    const double *v = row->number;
    struct test_sampler s;

    build_triangle(make_sampler(&s), v);
    error[0] = direction_error(s.sampler, 64, v[9], v[10], row->exact + 11, v[14]);
    error[1] = direction_error(s.sampler, 32, v[9], v[10], row->exact + 11, v[14]);
}

static void compare_ufk(const struct csv *row, double error[GOLDEN_MEASURES])
{
    const double *g = row->number;
    struct test_sampler s;

    build_rectangle(make_sampler(&s), PSC_MAP_PARALLEL, g);
    error[0] = direction_error(s.sampler, 64, g[9], g[10], row->exact + 13, g[16]);
    error[1] = direction_error(s.sampler, 32, g[9], g[10], row->exact + 13, g[16]);
}

/* ---- Projected solid angle */

/* In units of what rounding the vertices changes it by; no result at all counts as 0. */
static void compare_projected(const struct csv *row, double error[GOLDEN_MEASURES])
{
    const double *v = row->number + 1, scale = 1.0 + row->number[29];
    const size_t count = (size_t)row->number[0];
    const psc_technique projected =
        make_technique(PSC_MEASURE_PROJECTED_SOLID_ANGLE, PSC_MAP_RADIAL);
    const psc_technique around = make_technique(PSC_MEASURE_SOLID_ANGLE, PSC_MAP_RADIAL);
    const psc_receiver receiver = make_receiver(origin, row->number + 25, 0);
    const ptrdiff_t stride = 3 * sizeof *v;
    double value[4] = {NAN, NAN, NAN, NAN};
    struct test_sampler s;
    int i;

    psc_build_polygon(make_sampler(&s), &projected, &receiver, count, v, stride);
    psc_sampler_total(s.sampler, value);
    psc_sampler_projected_solid_angle(s.sampler, value + 1);
    psc_build_polygon(s.sampler, &around, &receiver, count, v, stride);
    psc_sampler_projected_solid_angle(s.sampler, value + 2);
    psc_polygon_form_factor(&receiver, count, v, stride, value + 3);
    value[3] *= 3.14159265358979323846;
    error[0] = error[1] = 0.0;
    for (i = 0; i < 4; i++)
        if (row->number[28] > 0.0)
            error[i == 3] = fmax(error[i == 3], relative(value[i], row->exact[28]) / scale);
        else
            error[i == 3] = fmax(error[i == 3], fabs(value[i]));
}

static void compare_sector_map(const struct csv *row, double error[GOLDEN_MEASURES])
{
    const double *v = row->number;
    const psc_technique technique =
        make_technique(PSC_MEASURE_PROJECTED_SOLID_ANGLE, PSC_MAP_RADIAL);
    const psc_receiver receiver = make_receiver(origin, v + 9, 0);
    struct test_sampler s;

    psc_build_triangle(make_sampler(&s), &technique, &receiver, v, v + 3, v + 6);
    error[0] = direction_error(s.sampler, 64, v[12], v[13], row->exact + 14, v[17]);
    error[1] = direction_error(s.sampler, 32, v[12], v[13], row->exact + 14, v[17]);
}

#define TOTAL_MEASURES                                                                  \
    {                                                                                   \
        {"solid angle, relative", 1e-15},                                               \
        {"density f64, relative", 1e-15},                                               \
        {"density f32, relative", 1e-7},                                                \
        {NULL, 0.0}, {NULL, 0.0}, {NULL, 0.0}                                           \
    }
#define DIRECTION_MEASURES                                                              \
    {                                                                                   \
        {"direction f64, in eps (1 + amp)", 8.0},                                       \
        {"direction f32, in eps (1 + amp)", 8.0},                                       \
        {NULL, 0.0}, {NULL, 0.0}, {NULL, 0.0}, {NULL, 0.0}                              \
    }

const struct golden_quantity golden_polygons[] = {
    {"triangle_solid_angle", "ax,ay,az,bx,by,bz,cx,cy,cz,omega", 10, compare_triangle,
     TOTAL_MEASURES},
    {"triangle_arvo", "ax,ay,az,bx,by,bz,cx,cy,cz,xi1,xi2,dx,dy,dz,amp_xi,amp_v", 16,
     compare_arvo, DIRECTION_MEASURES},
    {"rectangle_solid_angle", "sx,sy,sz,exx,exy,exz,eyx,eyy,eyz,omega", 10, compare_rectangle,
     {{"solid angle, relative", 2e-15},
      {"density f64, relative", 2e-15},
      {"density f32, relative", 1e-7},
      {"solid angle of radial maps, relative", 2e-15},
      {NULL, 0.0}, {NULL, 0.0}}},
    {"rectangle_ufk",
     "sx,sy,sz,exx,exy,exz,eyx,eyy,eyz,xi1,xi2,s_fraction,t_fraction,dx,dy,dz,amp_xi", 17,
     compare_ufk, DIRECTION_MEASURES},
    {"polygon_projected_solid_angle",
     "n,x0,y0,z0,x1,y1,z1,x2,y2,z2,x3,y3,z3,x4,y4,z4,x5,y5,z5,x6,y6,z6,x7,y7,z7,nx,ny,nz,psa,amp_v",
     30, compare_projected,
     {{"projected solid angle, relative / (1 + amp)", 1e-15},
      {"form factor, relative / (1 + amp)", 1e-15},
      {NULL, 0.0}, {NULL, 0.0}, {NULL, 0.0}, {NULL, 0.0}}},
    {"triangle_projected", "ax,ay,az,bx,by,bz,cx,cy,cz,nx,ny,nz,xi1,xi2,dx,dy,dz,amp_xi,amp_v", 19,
     compare_sector_map, DIRECTION_MEASURES},
    {NULL, NULL, 0, NULL,
     {{NULL, 0.0}, {NULL, 0.0}, {NULL, 0.0}, {NULL, 0.0}, {NULL, 0.0}, {NULL, 0.0}}},
};
