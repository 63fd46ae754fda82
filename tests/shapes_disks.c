/* SPDX-License-Identifier: Apache-2.0 */
/* Disks, elliptical disks and ellipsoids, for the tests of all shapes. */
#include "exact.h"
#include "vectors.h"

/* ---- Disks ---- */

static psc_result disk_build(psc_sampler *sampler, const psc_technique *technique,
                             const psc_receiver *receiver, const double *g)
{
    return psc_build_disk(sampler, technique, receiver, g, g + 3, g[6]);
}

SHAPE_WAVES(disk, disk, in[0], in[1], in[2])

static psc_result disk_solid_angle(const double position[3], const double *g, double *value)
{
    return psc_disk_solid_angle(position, g, g + 3, g[6], value);
}

static psc_result disk_form_factor(const psc_receiver *receiver, const double *g, double *value)
{
    return psc_disk_form_factor(receiver, g, g + 3, g[6], value);
}

static void disk_make(uint64_t *state, const struct test_technique *what, int hard, double *g)
{
    (void)state, (void)what, (void)hard;
    memset(g, 0, 7 * sizeof *g);
    g[5] = g[6] = 1.0;
}

/* Where a ray meets the plane through g with a normal. */
static double meet_plane(const double *g, const double normal[3], const double from[3],
                         const double direction[3], double offset[3])
{
    double to[3], along;
    int i;

    subtract3(g, from, to);
    along = dot(to, normal) / dot(direction, normal);
    for (i = 0; i < 3; i++)
        offset[i] = along * direction[i] - to[i];
    return along;
}

static double disk_hit(const double *g, const double from[3], const double direction[3])
{
    double offset[3];
    const double along = meet_plane(g, g + 3, from, direction, offset);

    return along > 0.0 && dot(offset, offset) <= g[6] * g[6] ? along : -1.0;
}

/* The unit normal n, and how far a point is off the plane through g. */
static double off_plane(const double *g, const double n[3], const double point[3], double normal[3])
{
    double offset[3];

    scale3(n, 1.0 / sqrt(dot(n, n)), normal);
    subtract3(point, g, offset);
    return fabs(dot(offset, normal));
}

static double disk_surface(const double *g, const double point[3], double normal[3])
{
    const double off = off_plane(g, g + 3, point, normal);
    double offset[3];

    subtract3(point, g, offset);
    return fmax(off, sqrt(dot(offset, offset)) - g[6]);
}

static void disk_texture(const double *g, const double st[2], double point[3])
{
    const double *n = g + 3;
    double s[3] = {0.0, n[2], -n[1]}, t[3], length;
    int i;

    if (fabs(n[0]) > fabs(n[1])) {
        s[0] = -n[2];
        s[1] = 0.0;
        s[2] = n[0];
    }
    length = sqrt(dot(s, s));
    cross(n, s, t);
    for (i = 0; i < 3; i++)
        point[i] = g[i] + g[6] * (st[0] * s[i] / length + st[1] * t[i] / (length * sqrt(dot(n, n))));
}

static const struct test_technique flat_techniques[] = {
    {"solid angle, radial", PSC_MEASURE_SOLID_ANGLE, PSC_MAP_RADIAL},
    {"solid angle, parallel", PSC_MEASURE_SOLID_ANGLE, PSC_MAP_PARALLEL},
    {"solid angle, concentric", PSC_MEASURE_SOLID_ANGLE, PSC_MAP_CONCENTRIC},
    {"solid angle, quasi-uniform", PSC_MEASURE_SOLID_ANGLE, PSC_MAP_QUASI_UNIFORM},
    {"solid angle, tabulated", PSC_MEASURE_SOLID_ANGLE, PSC_MAP_TABULATED},
    {"area, radial", PSC_MEASURE_AREA, PSC_MAP_RADIAL},
    {"area, parallel", PSC_MEASURE_AREA, PSC_MAP_PARALLEL},
    {"area, concentric", PSC_MEASURE_AREA, PSC_MAP_CONCENTRIC},
    {"projected solid angle, parallel", PSC_MEASURE_PROJECTED_SOLID_ANGLE, PSC_MAP_PARALLEL},
    {NULL, 0, 0},
};

const struct shape shape_disk = {
    .name = "disk", .shape = PSC_SHAPE_DISK, .parts = "pdr", .flat = 1,
    .techniques = flat_techniques, .build = disk_build,
    .wave_f32 = disk_wave_f32, .wave_f64 = disk_wave_f64, .solid_angle = disk_solid_angle,
    .form_factor = disk_form_factor, .make = disk_make, .hit = disk_hit,
    .surface = disk_surface, .texture = disk_texture,
};

/* ---- Elliptical disks ---- */

static psc_result ellipse_build(psc_sampler *sampler, const psc_technique *technique,
                                const psc_receiver *receiver, const double *g)
{
    return psc_build_ellipse(sampler, technique, receiver, g, g + 3, g + 6);
}

SHAPE_WAVES(ellipse, ellipse, in[0], in[1], in[2])

static psc_result ellipse_solid_angle(const double position[3], const double *g, double *value)
{
    return psc_ellipse_solid_angle(position, g, g + 3, g + 6, value);
}

static psc_result ellipse_form_factor(const psc_receiver *receiver, const double *g, double *value)
{
    return psc_ellipse_form_factor(receiver, g, g + 3, g + 6, value);
}

/* Semi-axes that are conjugate but not perpendicular, within the unit circle. */
static void ellipse_make(uint64_t *state, const struct test_technique *what, int hard, double *g)
{
    const double aspect = random_log(state, hard ? 1e-8 : 0.1, 1.0);
    const double turn = random_between(state, 0.0, 6.2831853);
    const double skew = random_between(state, 0.0, 6.2831853);

    (void)what;
    memset(g, 0, 9 * sizeof *g);
    g[3] = cos(turn) * cos(skew) - aspect * sin(turn) * sin(skew);
    g[4] = sin(turn) * cos(skew) + aspect * cos(turn) * sin(skew);
    g[6] = -cos(turn) * sin(skew) - aspect * sin(turn) * cos(skew);
    g[7] = -sin(turn) * sin(skew) + aspect * cos(turn) * cos(skew);
}

/* Coordinates of an offset in the plane along the semi-axes. */
static void along_axes(const double *g, const double offset[3], double st[2])
{
    double n[3], m[3];

    exact_cross(g + 3, g + 6, n);
    exact_cross(offset, g + 6, m);
    st[0] = dot(m, n) / dot(n, n);
    exact_cross(g + 3, offset, m);
    st[1] = dot(m, n) / dot(n, n);
}

static double ellipse_hit(const double *g, const double from[3], const double direction[3])
{
    double n[3], offset[3], st[2], along;

    exact_cross(g + 3, g + 6, n);
    along = meet_plane(g, n, from, direction, offset);
    along_axes(g, offset, st);
    return along > 0.0 && st[0] * st[0] + st[1] * st[1] <= 1.0 ? along : -1.0;
}

static double ellipse_surface(const double *g, const double point[3], double normal[3])
{
    double n[3], offset[3], st[2], off, over, size;

    exact_cross(g + 3, g + 6, n);
    off = off_plane(g, n, point, normal);
    subtract3(point, g, offset);
    along_axes(g, offset, st);
    /* beyond the rim: in the direction of the shorter semi-axis */
    over = sqrt(st[0] * st[0] + st[1] * st[1]) - 1.0;
    size = sqrt(dot(n, n)) / sqrt(dot(g + 3, g + 3) + dot(g + 6, g + 6));
    return fmax(off, over * size);
}

static void ellipse_texture(const double *g, const double st[2], double point[3])
{
    int i;

    for (i = 0; i < 3; i++)
        point[i] = g[i] + (st[0] * g[3 + i] + st[1] * g[6 + i]);
}

const struct shape shape_ellipse = {
    .name = "ellipse", .shape = PSC_SHAPE_ELLIPSE, .parts = "pee", .flat = 1, .jumps = 0.02,
    .techniques = flat_techniques, .build = ellipse_build,
    .wave_f32 = ellipse_wave_f32, .wave_f64 = ellipse_wave_f64,
    .solid_angle = ellipse_solid_angle, .form_factor = ellipse_form_factor,
    .make = ellipse_make, .hit = ellipse_hit, .surface = ellipse_surface, .texture = ellipse_texture,
};

/* ---- Ellipsoids ---- */

static psc_result ellipsoid_build(psc_sampler *sampler, const psc_technique *technique,
                                  const psc_receiver *receiver, const double *g)
{
    return psc_build_ellipsoid(sampler, technique, receiver, g, g + 3, g + 6, g + 9);
}

SHAPE_WAVES(ellipsoid, ellipsoid, in[0], in[1], in[2], in[3])

static psc_result ellipsoid_solid_angle(const double position[3], const double *g, double *value)
{
    return psc_ellipsoid_solid_angle(position, g, g + 3, g + 6, g + 9, value);
}

static psc_result ellipsoid_form_factor(const psc_receiver *receiver, const double *g, double *value)
{
    return psc_ellipsoid_form_factor(receiver, g, g + 3, g + 6, g + 9, value);
}

/* Semi-axes in any directions. */
static void ellipsoid_make(uint64_t *state, const struct test_technique *what, int hard, double *g)
{
    const double low = hard ? 1e-4 : 0.4;
    const double size[3] = {1.0, random_log(state, low, 1.0), random_log(state, low, 1.0)};
    double x[3], y[3], z[3];
    int i, k;

    (void)what;
    random_unit(state, x);
    random_across(state, x, y);
    cross(x, y, z);
    memset(g, 0, 12 * sizeof *g);
    for (i = 0; i < 3; i++) {
        const double turned[3] = {x[i], y[i], z[i]};

        for (k = 0; k < 3; k++)
            g[3 + 3 * i + k] = size[k] * turned[k];
    }
}

/* The vector across two semi-axes, in two words. */
static void across_axes(const double *g, int k, double n[3][2])
{
    const double *a = g + 3 + 3 * ((k + 1) % 3), *b = g + 3 + 3 * ((k + 2) % 3);
    int i;

    memset(n, 0, sizeof(double[3][2]));
    for (i = 0; i < 3; i++) {
        add_product(a[(i + 1) % 3], b[(i + 2) % 3], n[i]);
        add_product(-a[(i + 2) % 3], b[(i + 1) % 3], n[i]);
    }
}

/* Its product with v. The three semi-axes of a flat ellipsoid may be nearly in a plane: plain
   products have no digit of its thickness then. */
static double along(const double n[3][2], const double v[3])
{
    double sum[2] = {0.0, 0.0};
    int i;

    for (i = 0; i < 3; i++) {
        add_product(n[i][0], v[i], sum);
        sum[1] += n[i][1] * v[i];
    }
    return sum[0] + sum[1];
}

/* The offset in the coordinates in which the ellipsoid is the unit sphere. */
static void to_sphere(const double *g, const double offset[3], double unit[3])
{
    double n[3][2];
    int k;

    for (k = 0; k < 3; k++) {
        across_axes(g, k, n);
        unit[k] = along((const double(*)[2])n, offset) /
                  along((const double(*)[2])n, g + 3 + 3 * k);
    }
}

static double ellipsoid_hit(const double *g, const double from[3], const double direction[3])
{
    static const double sphere[4] = {0.0, 0.0, 0.0, 1.0};
    double offset[3], place[3], ray[3];

    subtract3(from, g, offset);
    to_sphere(g, offset, place);
    to_sphere(g, direction, ray);
    return shape_sphere.hit(sphere, place, ray);
}

static double ellipsoid_surface(const double *g, const double point[3], double normal[3])
{
    double offset[3], unit[3], n[3][2], length, volume;
    int i, k;

    subtract3(point, g, offset);
    to_sphere(g, offset, unit);
    normal[0] = normal[1] = normal[2] = 0.0;
    for (k = 0; k < 3; k++) {
        across_axes(g, k, n);
        volume = along((const double(*)[2])n, g + 3 + 3 * k);
        for (i = 0; i < 3; i++)
            normal[i] += unit[k] * (n[i][0] + n[i][1]) / volume;
    }
    length = sqrt(dot(normal, normal));
    scale3(normal, 1.0 / length, normal);
    return fabs(dot(unit, unit) - 1.0) / (2.0 * length);
}

static const struct test_technique solid_techniques[] = {
    {"solid angle, radial", PSC_MEASURE_SOLID_ANGLE, PSC_MAP_RADIAL},
    {"solid angle, parallel", PSC_MEASURE_SOLID_ANGLE, PSC_MAP_PARALLEL},
    {"solid angle, concentric", PSC_MEASURE_SOLID_ANGLE, PSC_MAP_CONCENTRIC},
    {"solid angle, quasi-uniform", PSC_MEASURE_SOLID_ANGLE, PSC_MAP_QUASI_UNIFORM},
    {"solid angle, tabulated", PSC_MEASURE_SOLID_ANGLE, PSC_MAP_TABULATED},
    {"projected solid angle, parallel", PSC_MEASURE_PROJECTED_SOLID_ANGLE, PSC_MAP_PARALLEL},
    {NULL, 0, 0},
};

const struct shape shape_ellipsoid = {
    .name = "ellipsoid", .shape = PSC_SHAPE_ELLIPSOID, .parts = "peee", .jumps = 0.1,
    .techniques = solid_techniques, .build = ellipsoid_build,
    .wave_f32 = ellipsoid_wave_f32, .wave_f64 = ellipsoid_wave_f64,
    .solid_angle = ellipsoid_solid_angle, .form_factor = ellipsoid_form_factor,
    .make = ellipsoid_make, .hit = ellipsoid_hit,
    .surface = ellipsoid_surface,
};
