/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Projected spherical caps: psc_area, psc_radial, psc_parallel and their stiff rows.
 *
 * A row gives half-angle and elevation as exact doubles. It is evaluated from these (angles.h)
 * as an offset from the axis, since a unit vector cannot hold a direction in a small cap, and
 * for a cross-check through the public interface from an axis vector. That vector rounds the
 * elevation, so that there the error is what is left when the motion of the answer over a few
 * roundings of the elevation, and the rounding of a unit vector, have been taken off.
 *
 * Where a point moves by kappa times the half-angle's sine per unit of t, an error in the point
 * counts as error / kappa in t: all that a map with a good CDF can promise.
 */
#include "angles.h"
#include "calls.h"
#include "golden.h"
#include "reference.h"

#define F64_UNIT 0x1p-53
#define F32_UNIT 0x1p-24

/* How far rounding may move the elevation: two roundings of each component of the axis, and two
   each of the sine and cosine of the half-angle that it is compared with. */
static double elevation_rounding(const struct csv *row)
{
    return F64_UNIT * 2.0 * (fabs(sin(2.0 * row->number[1])) + sin(2.0 * row->number[0]));
}

static psc_technique technique_of(psc_map map)
{
    return make_technique(PSC_MEASURE_PROJECTED_SOLID_ANGLE, map);
}

static psc_result build_angles(psc_sampler *sampler, psc_map map, double alpha, double beta)
{
    psc_technique technique = technique_of(map);

    beta = fmin(fmax(beta, -acos(0.0)), acos(0.0));
    return psc_build_cap_angles(sampler, &technique, alpha, beta);
}

static psc_result build_axis(psc_sampler *sampler, psc_map map, double alpha, double beta)
{
    const double origin[3] = {0.0, 0.0, 0.0}, normal[3] = {0.0, 0.0, 1.0};
    double axis[3] = {cos(beta), 0.0, sin(beta)};
    psc_technique technique = technique_of(map);
    psc_receiver receiver = make_receiver(origin, normal, 0);

    return psc_build_cap(sampler, &technique, &receiver, axis, alpha);
}

/* ---- Areas */

static double area_from_angles(psc_map map, double alpha, double beta)
{
    struct test_sampler s;
    double area = NAN;

    build_angles(make_sampler(&s), map, alpha, beta);
    psc_sampler_total(s.sampler, &area);
    return area;
}

static void compare_area(const struct csv *row, double error[GOLDEN_MEASURES])
{
    static const psc_map maps[3] = {PSC_MAP_RADIAL, PSC_MAP_PARALLEL, PSC_MAP_CONCENTRIC};
    double alpha = row->number[0], beta = row->number[1], area = row->number[2];
    double scale = area > 0.0 ? area : 1.0, step = elevation_rounding(row);
    double public = NAN, factor = NAN, motion;
    struct test_sampler s;
    int i;

    error[0] = 0.0;
    for (i = 0; i < 3; i++) {
        quad difference = area_from_angles(maps[i], alpha, beta) - row->exact[2];
        error[0] = fmax(error[0], (double)quad_abs(difference) / scale);
    }
    motion = fabs(area_from_angles(PSC_MAP_RADIAL, alpha, beta + step) -
                  area_from_angles(PSC_MAP_RADIAL, alpha, beta - step));
    build_axis(make_sampler(&s), PSC_MAP_RADIAL, alpha, beta);
    psc_sampler_projected_solid_angle(s.sampler, &public);
    psc_sampler_form_factor(s.sampler, &factor);
    error[1] = fmax(fabs(public - area) - motion, 0.0) / scale;
    error[2] = fmax(fabs(factor * acos(-1.0) - area) - motion, 0.0) / scale;
}

/* ---- Directions */

static double length_of(const quad v[3])
{
    return (double)quad_sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

/* The stored point as an offset from the axis. */
static void stored_offset(const struct csv *row, quad offset[3])
{
    quad beta = row->number[1];

    offset[0] = row->exact[4] - quad_cos(beta);
    offset[1] = row->exact[5];
    offset[2] = row->exact[6] - quad_sin(beta);
}

static void offset_f64(psc_map map, const struct csv *row, double moved, double s, double t,
                       double offset[3])
{
    struct test_sampler sampler;

    offset[0] = offset[1] = offset[2] = NAN;
    if (build_angles(make_sampler(&sampler), map, row->number[0], row->number[1] + moved) ==
        PSC_SUCCESS)
        psc_sample_offset_f64(sampler.sampler, s, t, offset);
}

/* |a + b - c|, or with b NULL |a - c|. */
static double distance(const double a[3], const quad b[3], const quad c[3])
{
    quad d[3];
    int i;

    for (i = 0; i < 3; i++)
        d[i] = (b ? b[i] : 0) + a[i] - c[i];
    return length_of(d);
}

static double distance_f64(const double a[3], const double b[3])
{
    const quad wide[3] = {b[0], b[1], b[2]};

    return distance(a, NULL, wide);
}

/* Speed of the point in t, in units of the sine of the half-angle. */
static double speed(psc_map map, const struct csv *row)
{
    const double step = 1e-7;
    double low = fmax(row->number[3] - step, 0.0), high = fmin(row->number[3] + step, 1.0);
    double a[3], b[3];

    offset_f64(map, row, 0.0, row->number[2], low, a);
    offset_f64(map, row, 0.0, row->number[2], high, b);
    return distance_f64(a, b) / ((high - low) * sin(row->number[0]));
}

/* Error of the float point at (s, t) rounded to float: the stored point is moved there by what
   the double map, which is compared with it itself, moves between the two. */
static double error_f32(psc_map map, const struct csv *row)
{
    struct test_sampler sampler;
    float s = (float)row->number[2], t = (float)row->number[3], f[3];
    double here[3], there[3];
    quad expected[3];
    int i;

    offset_f64(map, row, 0.0, row->number[2], row->number[3], here);
    offset_f64(map, row, 0.0, s, t, there);
    stored_offset(row, expected);
    build_angles(make_sampler(&sampler), map, row->number[0], row->number[1]);
    psc_sample_offset_f32(sampler.sampler, s, t, f);
    for (i = 0; i < 3; i++) {
        expected[i] += (quad)there[i] - here[i];
        here[i] = f[i];
    }
    return distance(here, NULL, expected);
}

/* The public direction, less what rounding its unit vector and the elevation account for. */
static double error_public(int bits, psc_map map, const struct csv *row)
{
    struct test_sampler sampler;
    psc_light_sample_f64 sample;
    double s = row->number[2], t = row->number[3], step = elevation_rounding(row);
    double low[3], high[3], off;

    offset_f64(map, row, -step, s, t, low);
    offset_f64(map, row, step, s, t, high);
    if (!(low[0] == low[0]))
        return GOLDEN_NONE; /* so thin that its elevation is lost in the axis vector */
    if (build_axis(make_sampler(&sampler), map, row->number[0], row->number[1]) != PSC_SUCCESS ||
        sample_any(bits, sampler.sampler, s, t, &sample) != PSC_SUCCESS)
        return NAN;
    if (bits == 32) {
        /* to be compared at the rounded s and t, as above */
        double here[3], there[3];
        int i;
        offset_f64(map, row, 0.0, s, t, here);
        offset_f64(map, row, 0.0, (float)s, (float)t, there);
        for (i = 0; i < 3; i++)
            sample.direction[i] += here[i] - there[i];
    }
    off = distance(sample.direction, NULL, row->exact + 4);
    return fmax(off - distance_f64(low, high) - 3.0 * (bits == 64 ? F64_UNIT : F32_UNIT), 0.0);
}

static void compare_direction(psc_map map, const struct csv *row, double error[GOLDEN_MEASURES])
{
    double sine = sin(row->number[0]), kappa = speed(map, row), here[3];
    quad stored[3];

    stored_offset(row, stored);
    offset_f64(map, row, 0.0, row->number[2], row->number[3], here);
    error[0] = distance(here, NULL, stored) / sine;
    error[1] = error_f32(map, row) / (sine * (1.0 + kappa));
    error[2] = error_public(64, map, row);
    error[3] = error_public(32, map, row);
    if (error[2] != GOLDEN_NONE) {
        error[2] /= sine;
        error[3] /= sine * (1.0 + kappa);
    }
}

static void compare_radial(const struct csv *row, double error[GOLDEN_MEASURES])
{
    compare_direction(PSC_MAP_RADIAL, row, error);
}

static void compare_parallel(const struct csv *row, double error[GOLDEN_MEASURES])
{
    compare_direction(PSC_MAP_PARALLEL, row, error);
}

/* ---- Stiff rows */

/* |t - (t of the point that is sampled there)| */
static double cdf_error(psc_map map, const struct csv *row, int bits)
{
    struct test_sampler sampler;
    struct reference r;
    double s = row->number[2], t = row->number[3], offset[3], off;
    quad st[2];

    offset_f64(map, row, 0.0, s, t, offset);
    if (bits == 32) {
        float f[3];
        int i;
        t = (float)t;
        build_angles(make_sampler(&sampler), map, row->number[0], row->number[1]);
        psc_sample_offset_f32(sampler.sampler, (float)s, (float)t, f);
        for (i = 0; i < 3; i++)
            offset[i] = f[i];
    }
    reference_from_angles(&r, row->number[0], row->number[1]);
    (map == PSC_MAP_RADIAL ? reference_radial : reference_parallel)(&r, offset[0], offset[1], st);
    off = (double)quad_abs(st[1] - t);
    return map == PSC_MAP_RADIAL && r.visible != REFERENCE_LUNE ? fmin(off, 1.0 - off) : off;
}

static void compare_stiff(psc_map map, const struct csv *row, double error[GOLDEN_MEASURES])
{
    double sine = sin(row->number[0]), kappa = row->number[7], here[3];
    quad stored[3];

    stored_offset(row, stored);
    offset_f64(map, row, 0.0, row->number[2], row->number[3], here);
    error[0] = distance(here, NULL, stored) / (sine * kappa);
    error[1] = cdf_error(map, row, 64);
    error[2] = cdf_error(map, row, 32);
    error[3] = error_public(64, map, row);
    if (error[3] != GOLDEN_NONE)
        error[3] /= sine * kappa;
}

static void compare_radial_stiff(const struct csv *row, double error[GOLDEN_MEASURES])
{
    compare_stiff(PSC_MAP_RADIAL, row, error);
}

static void compare_parallel_stiff(const struct csv *row, double error[GOLDEN_MEASURES])
{
    compare_stiff(PSC_MAP_PARALLEL, row, error);
}

#define DIRECTION_MEASURES                                                               \
    {                                                                                    \
        {"direction f64, in sin alpha", 1e-13},                                          \
        {"direction f32, in sin alpha (1 + kappa)", 5e-7},                               \
        {"public direction f64 beyond its rounding, in sin alpha", 1e-13},               \
        {"public direction f32 beyond its rounding, in sin alpha (1 + kappa)", 5e-7},    \
        {NULL, 0.0}, {NULL, 0.0}                                                         \
    }
#define STIFF_MEASURES                                                                   \
    {                                                                                    \
        {"direction f64, in sin alpha kappa", 1e-14},                                    \
        {"CDF f64", 1e-14},                                                              \
        {"CDF f32", 3e-7},                                                               \
        {"public direction f64 beyond its rounding, in sin alpha kappa", 1e-14},         \
        {NULL, 0.0}, {NULL, 0.0}                                                         \
    }

const struct golden_quantity golden_caps[] = {
    {"psc_area", "alpha,beta,area", 3, compare_area,
     {{"total, relative", 1e-14},
      {"public projected solid angle beyond rounding of the axis, relative", 1e-14},
      {"public form factor beyond rounding of the axis, relative", 1e-14},
      {NULL, 0.0}, {NULL, 0.0}, {NULL, 0.0}}},
    {"psc_radial", "alpha,beta,s,t,x,y,z", 7, compare_radial, DIRECTION_MEASURES},
    {"psc_radial_stiff", "alpha,beta,s,t,x,y,z,kappa", 8, compare_radial_stiff, STIFF_MEASURES},
    {"psc_parallel", "alpha,beta,s,t,x,y,z", 7, compare_parallel, DIRECTION_MEASURES},
    {"psc_parallel_stiff", "alpha,beta,s,t,x,y,z,kappa", 8, compare_parallel_stiff,
     STIFF_MEASURES},
    {NULL, NULL, 0, NULL,
     {{NULL, 0.0}, {NULL, 0.0}, {NULL, 0.0}, {NULL, 0.0}, {NULL, 0.0}, {NULL, 0.0}}},
};
