/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Disks: solid angle and projected solid angle, and the radial, parallel and concentric maps of
 * spherical ellipses.
 *
 * Rows of the maps give semi-arcs as exact doubles. They are evaluated from these (arcs.h) as
 * offsets from the axis. An error in x counts in units of sin alpha, one in y in those of
 * sin beta; in the parallel map, which is as steep as a cube root at its ends, divided by that
 * slope. Rows of lights in space have points, or directions, of all three maps.
 */
#include "arcs.h"
#include "calls.h"
#include "golden.h"

/* What is nothing must be nothing. */
static double relative(quad value, quad expected)
{
    if (expected == 0)
        return value == 0 ? 0.0 : HUGE_VAL;
    return (double)quad_abs(value / expected - 1);
}

enum { MAPS = 3 };
static const psc_map maps[MAPS] = {PSC_MAP_RADIAL, PSC_MAP_PARALLEL, PSC_MAP_CONCENTRIC};

/* ---- Solid angle */

static void compare_solid_angle(const struct csv *row, double error[GOLDEN_MEASURES])
{
    static const double origin[3] = {0.0, 0.0, 0.0};
    const double *center = row->number + 1, *normal = row->number + 4, radius = row->number[7];
    const psc_receiver receiver = make_receiver(origin, NULL, 0);
    struct test_sampler s;
    psc_light_sample_f64 sample = {.pdf = NAN};
    double total = NAN;
    int i;

    error[0] = error[2] = 0.0;
    for (i = 0; i < MAPS; i++) {
        const psc_technique technique = make_technique(PSC_MEASURE_SOLID_ANGLE, maps[i]);

        psc_build_disk(make_sampler(&s), &technique, &receiver, center, normal, radius);
        psc_sampler_total(s.sampler, &total);
        error[0] = fmax(error[0], relative(total, row->exact[8]));
        sample_any(32, s.sampler, 0.25, 0.75, &sample);
        error[2] = fmax(error[2], relative(1 / (quad)sample.pdf, row->exact[8]));
    }
    psc_disk_solid_angle(origin, center, normal, radius, &total);
    error[1] = relative(total, row->exact[8]);
}

/* ---- Projected solid angle */

static void compare_projected(const struct csv *row, double error[GOLDEN_MEASURES])
{
    static const double origin[3] = {0.0, 0.0, 0.0};
    const double *center = row->number + 1, *normal = row->number + 4, radius = row->number[7];
    const psc_technique technique =
        make_technique(PSC_MEASURE_PROJECTED_SOLID_ANGLE, PSC_MAP_PARALLEL);
    const psc_receiver receiver = make_receiver(origin, row->number + 8, 0);
    double total = NAN, factor = NAN, whole = NAN;
    struct test_sampler s;

    psc_disk_solid_angle(origin, center, normal, radius, &whole);
    psc_build_disk(make_sampler(&s), &technique, &receiver, center, normal, radius);
    psc_sampler_total(s.sampler, &total);
    psc_disk_form_factor(&receiver, center, normal, radius, &factor);
    error[0] = relative(total, row->exact[11]);
    error[1] = (double)(quad_abs(total - row->exact[11]) / whole);
    error[2] = relative(factor, row->exact[11] / quad_pi());
}

/* ---- Directions */

static psc_result build_arcs(struct test_sampler *s, psc_map map, const struct csv *row)
{
    const psc_technique technique = make_technique(PSC_MEASURE_SOLID_ANGLE, map);

    return psc_build_ellipse_arcs(make_sampler(s), &technique, row->number[1], row->number[2]);
}

static void offset_f64(psc_map map, const struct csv *row, double u, double v, double offset[3])
{
    struct test_sampler s;

    offset[0] = offset[1] = offset[2] = NAN;
    if (build_arcs(&s, map, row) == PSC_SUCCESS)
        psc_sample_cone_offset_f64(s.sampler, u, v, offset);
}

/* The stored direction less the axis; z - 1 from the others where they have more digits. */
static void stored_offset(const struct csv *row, quad offset[3])
{
    const quad square = row->exact[5] * row->exact[5] + row->exact[6] * row->exact[6];

    offset[0] = row->exact[5];
    offset[1] = row->exact[6];
    offset[2] = square < 0.5 ? -square / (1 + quad_sqrt(1 - square)) : row->exact[7] - 1;
}

/* In units of the semi-arcs' sines. */
static double distance(const struct csv *row, const double a[3], const quad b[3])
{
    const quad x = (a[0] - b[0]) / quad_sin(row->number[1]);
    const quad y = (a[1] - b[1]) / quad_sin(row->number[2]);
    const quad z = (a[2] - b[2]) / quad_sin(row->number[1]);

    return (double)quad_sqrt(x * x + y * y + z * z);
}

/* What the point moves per unit of e1: as a cube root does at its ends. */
static double speed(const struct csv *row)
{
    const double end = fmin(row->number[3], 1.0 - row->number[3]);

    return pow(fmax(end, 0x1p-53), -2.0 / 3.0);
}

/* The stored point is moved to e1 and e2 rounded to float by what the double map, which is compared
   with it itself, moves between the two. */
static double error_f32(psc_map map, const struct csv *row)
{
    const float u = (float)row->number[3], v = (float)row->number[4];
    double here[3], there[3];
    struct test_sampler s;
    quad expected[3];
    float f[3] = {NAN, NAN, NAN};
    int i;

    offset_f64(map, row, row->number[3], row->number[4], here);
    offset_f64(map, row, u, v, there);
    stored_offset(row, expected);
    if (build_arcs(&s, map, row) == PSC_SUCCESS)
        psc_sample_cone_offset_f32(s.sampler, u, v, f);
    for (i = 0; i < 3; i++) {
        expected[i] += (quad)there[i] - here[i];
        here[i] = f[i];
    }
    return distance(row, here, expected);
}

static void compare_direction(psc_map map, const struct csv *row, double error[GOLDEN_MEASURES])
{
    const double scale = map == PSC_MAP_PARALLEL ? speed(row) : 1.0;
    struct test_sampler s;
    double here[3], total = NAN;
    quad stored[3];

    stored_offset(row, stored);
    offset_f64(map, row, row->number[3], row->number[4], here);
    error[0] = distance(row, here, stored) / scale;
    error[1] = error_f32(map, row) / scale;
    build_arcs(&s, map, row);
    psc_sampler_total(s.sampler, &total);
    error[2] = relative(total, row->exact[8]);
}

static void compare_radial(const struct csv *row, double error[GOLDEN_MEASURES])
{
    compare_direction(PSC_MAP_RADIAL, row, error);
}

static void compare_parallel(const struct csv *row, double error[GOLDEN_MEASURES])
{
    compare_direction(PSC_MAP_PARALLEL, row, error);
}

static void compare_concentric(const struct csv *row, double error[GOLDEN_MEASURES])
{
    compare_direction(PSC_MAP_CONCENTRIC, row, error);
}

/* ---- Elliptical disks and ellipsoids in space */

/* The same point of the square where the x axis of the cone is the other way round. */
static void turn_round(psc_map map, double u, double v, double uv[2])
{
    uv[0] = map != PSC_MAP_RADIAL ? 1.0 - u : u < 0.5 ? u + 0.5 : u - 0.5;
    uv[1] = map != PSC_MAP_RADIAL ? 1.0 - v : v;
}

/* A light of a row, seen from the origin, at a point of its map. */
static void sample_light(int solid, int bits, psc_map map, const struct csv *row, double u,
                         double v, struct test_sampler *s, psc_light_sample_f64 *sample)
{
    static const double origin[3] = {0.0, 0.0, 0.0};
    const psc_technique technique = make_technique(PSC_MEASURE_SOLID_ANGLE, map);
    const psc_receiver receiver = make_receiver(origin, NULL, 0);
    const double *g = row->number + 1;

    memset(sample, 0xff, sizeof *sample);
    if (solid)
        psc_build_ellipsoid(make_sampler(s), &technique, &receiver, g, g + 3, g + 6, g + 9);
    else
        psc_build_ellipse(make_sampler(s), &technique, &receiver, g, g + 3, g + 6);
    sample_any(bits, s->sampler, u, v, sample);
}

/* Of a flat light the distance on it, along its own axes; of a solid one that of the directions, less
   what they round by, in units of the light's angular size. */
static double apart(int solid, int bits, double size, const psc_light_sample_f64 *a,
                    const quad *expected)
{
    const double *found = solid ? a->direction : a->surface;
    quad square = 0;
    int i;

    for (i = 0; i < (solid ? 3 : 2); i++)
        square += quad_square(found[i] - expected[i]);
    return solid ? fmax((double)quad_sqrt(square) - (bits == 64 ? 0x1p-51 : 0x1p-22), 0.0) / size
                 : (double)quad_sqrt(square);
}

static double map_error(int solid, int bits, psc_map map, double size, const struct csv *row,
                        const quad *expected, double u, double v)
{
    struct test_sampler s;
    psc_light_sample_f64 sample;
    double uv[2], error;

    sample_light(solid, bits, map, row, u, v, &s, &sample);
    error = apart(solid, bits, size, &sample, expected);
    turn_round(map, u, v, uv);
    sample_light(solid, bits, map, row, uv[0], uv[1], &s, &sample);
    return fmin(error, apart(solid, bits, size, &sample, expected));
}

/* Both precisions at the point of the square; float less what rounding that point to float moves
   it, by the double map. */
static void compare_light(int solid, const struct csv *row, double error[GOLDEN_MEASURES])
{
    const int at = solid ? 13 : 10, numbers = solid ? 3 : 2;
    const double u = row->number[at], v = row->number[at + 1];
    const quad *total = row->exact + at + 2 + numbers * MAPS;
    const double size = fmin(sqrt((double)*total / 3.14), 1.0);
    struct test_sampler s;
    psc_light_sample_f64 here, there;
    double value = NAN;
    int i, m;

    error[0] = error[1] = 0.0;
    for (m = 0; m < MAPS; m++) {
        const quad *expected = row->exact + at + 2 + numbers * m;
        const float narrow_u = (float)u, narrow_v = (float)v;
        quad narrow[3];

        error[0] = fmax(error[0], map_error(solid, 64, maps[m], size, row, expected, u, v));
        sample_light(solid, 64, maps[m], row, narrow_u, narrow_v, &s, &there);
        for (i = 0; i < numbers; i++)
            narrow[i] = solid ? there.direction[i] : there.surface[i];
        sample_light(solid, 32, maps[m], row, narrow_u, narrow_v, &s, &here);
        error[1] = fmax(error[1], apart(solid, 32, size, &here, narrow));
    }
    psc_sampler_total(s.sampler, &value);
    error[2] = relative(value, *total);
}

static void compare_ellipse(const struct csv *row, double error[GOLDEN_MEASURES])
{
    compare_light(0, row, error);
}

static void compare_ellipsoid(const struct csv *row, double error[GOLDEN_MEASURES])
{
    compare_light(1, row, error);
}

/* Elliptical disks and ellipsoids by projected solid angle. */
static void compare_projected_light(int solid, const struct csv *row,
                                    double error[GOLDEN_MEASURES])
{
    static const double origin[3] = {0.0, 0.0, 0.0};
    const double *g = row->number + 1;
    const int at = solid ? 13 : 10;
    const quad expected = row->exact[at + 3];
    const psc_technique technique =
        make_technique(PSC_MEASURE_PROJECTED_SOLID_ANGLE, PSC_MAP_PARALLEL);
    const psc_receiver receiver = make_receiver(origin, row->number + at, 0);
    double total = NAN, factor = NAN, whole = NAN;
    struct test_sampler s;
    int hardly;

    make_sampler(&s);
    if (solid) {
        psc_ellipsoid_solid_angle(origin, g, g + 3, g + 6, g + 9, &whole);
        psc_build_ellipsoid(s.sampler, &technique, &receiver, g, g + 3, g + 6, g + 9);
        psc_ellipsoid_form_factor(&receiver, g, g + 3, g + 6, g + 9, &factor);
    } else {
        psc_ellipse_solid_angle(origin, g, g + 3, g + 6, &whole);
        psc_build_ellipse(s.sampler, &technique, &receiver, g, g + 3, g + 6);
        psc_ellipse_form_factor(&receiver, g, g + 3, g + 6, &factor);
    }
    psc_sampler_total(s.sampler, &total);
    /* Of a light that is nearly all around, with the horizon nearly in its outline, less is left
       than the horizon turns by its rounding. */
    hardly = whole > 6.0 && total < 1e-16;
    error[0] = hardly ? 0.0 : relative(total, expected);
    error[1] = (double)(quad_abs(total - expected) / whole);
    error[2] = hardly ? 0.0 : relative(factor, expected / quad_pi());
    error[3] = hardly ? relative(total, expected) : 0.0;
}

static void compare_projected_ellipse(const struct csv *row, double error[GOLDEN_MEASURES])
{
    compare_projected_light(0, row, error);
}

static void compare_projected_ellipsoid(const struct csv *row, double error[GOLDEN_MEASURES])
{
    compare_projected_light(1, row, error);
}

#define COLUMNS "kind,alpha,beta,e1,e2,x,y,z,solid_angle"
#define MEASURES                                                          \
    {                                                                     \
        {"direction f64, in sines of the semi-arcs", 1e-14},              \
        {"direction f32, in sines of the semi-arcs", 2e-6},               \
        {"total, relative", 2e-15},                                       \
        {NULL, 0.0}, {NULL, 0.0}, {NULL, 0.0}                             \
    }

/* Relative to what the horizon leaves, down to 1e-18 of the light. */
#define PROJECTED_MEASURES(relative)                                       \
    {                                                                      \
        {"total, relative", relative},                                     \
        {"total, of the solid angle", 2e-15},                              \
        {"form factor without a sampler, relative", relative},             \
        {"total of a light all around, below but 1e-16, relative", 1e-11}, \
        {NULL, 0.0}, {NULL, 0.0}                                           \
    }

const struct golden_quantity golden_disks[] = {
    {"disk_solid_angle", "kind,cx,cy,cz,nx,ny,nz,radius,solid_angle", 9, compare_solid_angle,
     {{"total, relative", 2e-15},
      {"total without a sampler, relative", 2e-15},
      {"1 / pdf f32, relative", 1e-6},
      {NULL, 0.0}, {NULL, 0.0}, {NULL, 0.0}}},
    {"disk_projected_solid_angle", "kind,cx,cy,cz,nx,ny,nz,radius,Nx,Ny,Nz,projected_solid_angle",
     12, compare_projected,
     {{"total, relative", 2e-15},
      {"total, of the solid angle", 2e-15},
      {"form factor without a sampler, relative", 2e-15},
      {NULL, 0.0}, {NULL, 0.0}, {NULL, 0.0}}},
    {"disk_radial", COLUMNS, 9, compare_radial, MEASURES},
    {"disk_parallel", COLUMNS, 9, compare_parallel, MEASURES},
    {"disk_concentric", COLUMNS, 9, compare_concentric, MEASURES},
    {"ellipse_maps",
     "kind,cx,cy,cz,ux,uy,uz,vx,vy,vz,e1,e2,radial_s,radial_t,parallel_s,parallel_t,concentric_s,"
     "concentric_t,solid_angle",
     19, compare_ellipse,
     {{"point f64, in semi-axes", 1e-14},
      {"point f32, in semi-axes", 2e-6},
      {"total, relative", 2e-15},
      {NULL, 0.0}, {NULL, 0.0}, {NULL, 0.0}}},
    {"ellipsoid_maps",
     "kind,cx,cy,cz,ux,uy,uz,vx,vy,vz,wx,wy,wz,e1,e2,radial_x,radial_y,radial_z,parallel_x,"
     "parallel_y,parallel_z,concentric_x,concentric_y,concentric_z,solid_angle",
     25, compare_ellipsoid,
     {{"direction f64, in the light's size", 1e-14},
      {"direction f32, in the light's size", 2e-6},
      /* conjugate semi-axes of an ellipsoid 1e-4 thin: its thickness is the difference of them */
      {"total, relative", 2e-14},
      {NULL, 0.0}, {NULL, 0.0}, {NULL, 0.0}}},
    {"ellipse_projected_solid_angle",
     "kind,cx,cy,cz,ux,uy,uz,vx,vy,vz,Nx,Ny,Nz,projected_solid_angle", 14,
     compare_projected_ellipse, PROJECTED_MEASURES(1e-14)},
    {"ellipsoid_projected_solid_angle",
     "kind,cx,cy,cz,ux,uy,uz,vx,vy,vz,wx,wy,wz,Nx,Ny,Nz,projected_solid_angle", 17,
     /* as above: thin ones */
     compare_projected_ellipsoid, PROJECTED_MEASURES(2e-14)},
    {NULL, NULL, 0, NULL,
     {{NULL, 0.0}, {NULL, 0.0}, {NULL, 0.0}, {NULL, 0.0}, {NULL, 0.0}, {NULL, 0.0}}},
};
