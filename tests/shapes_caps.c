/* SPDX-License-Identifier: Apache-2.0 */
/* Spheres and distant caps, for the tests of all shapes. */
#include "exact.h"
#include "vectors.h"

/* ---- Made of integers: with the boundaries between the cases of caps ---- */

/* In units of a power of two. */
struct integers {
    int64_t position[3], offset[3], normal[3], radius;
};

/* A radius for a sphere whose centre is this far away. */
static int64_t some_radius(uint64_t *state, int64_t distance)
{
    int64_t part = distance / 4096 * (int64_t)(random_bits(state) % 4096);

    switch (random_below(state, 8)) {
    case 0: return distance + part;                           /* around the receiver */
    case 1: return distance + around(state, 2);               /* touching it */
    case 2: return distance - (distance >> random_below(state, 28)); /* close to it */
    case 3: return distance >> random_below(state, 28);       /* far away */
    default: return part;
    }
}

/* Anything at all. */
static void make_general(uint64_t *state, struct integers *s)
{
    const int shift = random_below(state, 20);
    int64_t squares = 0;
    int i;

    for (i = 0; i < 3; i++) {
        s->position[i] = around(state, 1 << 20);
        s->offset[i] = around(state, 1 << (9 + shift));
        s->normal[i] = around(state, 1 << 20);
        squares += s->offset[i] * s->offset[i];
    }
    s->normal[random_below(state, 3)] |= 1;
    s->radius = some_radius(state, square_root(squares));
}

/* Exactly on the boundaries between the cases, and one unit beside them. */
static void make_boundary(uint64_t *state, struct integers *s)
{
    static const int64_t sides[5][3] = {
        {3, 4, 5}, {5, 12, 13}, {8, 15, 17}, {20, 21, 29}, {1, 0, 1}};
    const int64_t *side = sides[random_below(state, 5)], unit = 1 + around(state, 1 << 20) / 2 * 2;
    const int axis = random_below(state, 3);
    const int64_t distance = side[2] * (unit < 0 ? -unit : unit);
    int64_t height;
    int i;

    for (i = 0; i < 3; i++) {
        s->position[i] = around(state, 1 << 20);
        s->normal[i] = 0;
    }
    s->normal[axis] = around(state, 1) * 2 + 1;
    s->offset[(axis + 1) % 3] = side[0] * unit;
    s->offset[(axis + 2) % 3] = side[1] * unit;
    s->radius = some_radius(state, distance);
    switch (random_below(state, 6)) {
    case 0: height = 0; break;
    case 1: height = around(state, 1); break;
    case 2: height = s->radius + around(state, 1); break;
    case 3: height = -s->radius + around(state, 1); break;
    case 4: height = around(state, s->radius < 1 ? 1 : s->radius); break;
    default: height = -s->radius + (s->radius >> random_below(state, 24)); break;
    }
    s->offset[axis] = height;
    if (random_below(state, 16) == 0) /* straight overhead */
        s->offset[(axis + 1) % 3] = s->offset[(axis + 2) % 3] = 0;
}

static void exact_cap(uint64_t *state, struct light *light)
{
    static const double angles[] = {0x1.921fb54442d18p+0, 0x1.921fb54442d18p+1, 1.0, 0x1p-20,
                                    0x1.921fb54442d17p+0, 0x1.8p+0, 2.0, 0x1p-45};
    const int distant = is_distant(light->shape);
    double scale, normal_scale, half_angle;
    struct integers s;
    int i;

    (random_below(state, 2) ? make_general : make_boundary)(state, &s);
    scale = power_of_two(random_below(state, 80) - 60);
    normal_scale = power_of_two(random_below(state, 80) - 60);
    half_angle = random_below(state, 3) == 0 ? angles[random_below(state, 8)]
                                             : (double)(random_bits(state) >> 11) *
                                                   power_of_two(-52 - random_below(state, 30));
    for (i = 0; i < 3; i++) {
        light->position[i] = (double)s.position[i] * scale;
        light->geometry[i] = distant ? (double)s.offset[i] * normal_scale
                                     : (double)(s.position[i] + s.offset[i]) * scale;
        light->normal[i] = (double)s.normal[i] * normal_scale;
    }
    light->geometry[3] = distant ? half_angle : (double)s.radius * scale;
    memcpy(light->middle, light->geometry, sizeof light->middle);
    light->reach = distant ? 0.0 : light->geometry[3];
}

/* ---- Spheres ---- */

static psc_result sphere_build(psc_sampler *sampler, const psc_technique *technique,
                               const psc_receiver *receiver, const double *g)
{
    return psc_build_sphere(sampler, technique, receiver, g, g[3]);
}

SHAPE_WAVES(sphere, sphere, in[0], in[1])

static psc_result sphere_solid_angle(const double position[3], const double *g, double *value)
{
    return psc_sphere_solid_angle(position, g, g[3], value);
}

static psc_result sphere_form_factor(const psc_receiver *receiver, const double *g, double *value)
{
    return psc_sphere_form_factor(receiver, g, g[3], value);
}

static void sphere_make(uint64_t *state, const struct test_technique *what, int hard, double *g)
{
    (void)state, (void)what, (void)hard;
    g[0] = g[1] = g[2] = 0.0;
    g[3] = 1.0;
}

static double sphere_hit(const double *g, const double from[3], const double direction[3])
{
    const double length2 = dot(direction, direction);
    double to[3], along, beside[3], root;
    int i;

    subtract3(g, from, to);
    along = dot(to, direction) / length2;
    for (i = 0; i < 3; i++)
        beside[i] = to[i] - along * direction[i];
    root = g[3] * g[3] - dot(beside, beside);
    if (root < 0.0)
        return -1.0;
    root = sqrt(root / length2);
    return along > root ? along - root : along + root;
}

static double sphere_surface(const double *g, const double point[3], double normal[3])
{
    double length;

    subtract3(point, g, normal);
    length = sqrt(dot(normal, normal));
    scale3(normal, 1.0 / length, normal);
    return fabs(length - g[3]);
}

static const struct test_technique sphere_techniques[] = {
    {"solid angle, radial", PSC_MEASURE_SOLID_ANGLE, PSC_MAP_RADIAL},
    {"solid angle, concentric", PSC_MEASURE_SOLID_ANGLE, PSC_MAP_CONCENTRIC},
    {"projected, radial", PSC_MEASURE_PROJECTED_SOLID_ANGLE, PSC_MAP_RADIAL},
    {"projected, parallel", PSC_MEASURE_PROJECTED_SOLID_ANGLE, PSC_MAP_PARALLEL},
    {"projected, concentric", PSC_MEASURE_PROJECTED_SOLID_ANGLE, PSC_MAP_CONCENTRIC},
    {"area, radial", PSC_MEASURE_AREA, PSC_MAP_RADIAL},
    {"area, concentric", PSC_MEASURE_AREA, PSC_MAP_CONCENTRIC},
    {"visible area, radial", PSC_MEASURE_VISIBLE_AREA, PSC_MAP_RADIAL},
    {"visible area, concentric", PSC_MEASURE_VISIBLE_AREA, PSC_MAP_CONCENTRIC},
    {NULL, 0, 0},
};

const struct shape shape_sphere = {
    .name = "sphere", .shape = PSC_SHAPE_SPHERE, .parts = "pr",
    .techniques = sphere_techniques, .build = sphere_build,
    .wave_f32 = sphere_wave_f32, .wave_f64 = sphere_wave_f64,
    .solid_angle = sphere_solid_angle, .form_factor = sphere_form_factor,
    .make = sphere_make, .hit = sphere_hit, .surface = sphere_surface, .exact = exact_cap,
};

/* ---- Distant caps ---- */

static psc_result cap_build(psc_sampler *sampler, const psc_technique *technique,
                            const psc_receiver *receiver, const double *g)
{
    return psc_build_cap(sampler, technique, receiver, g, g[3]);
}

SHAPE_WAVES(cap, cap, in[0], in[1])

static psc_result cap_solid_angle(const double position[3], const double *g, double *value)
{
    (void)position;
    return psc_cap_solid_angle(g[3], value);
}

static psc_result cap_form_factor(const psc_receiver *receiver, const double *g, double *value)
{
    return psc_cap_form_factor(receiver, g, g[3], value);
}

static void cap_make(uint64_t *state, const struct test_technique *what, int hard, double *g)
{
    g[0] = g[1] = 0.0;
    g[2] = 1.0;
    g[3] = random_log(state, hard ? 1e-8 : 0.05, 1.57);
    if (what->measure == PSC_MEASURE_SOLID_ANGLE && random_below(state, 3) == 0)
        g[3] = random_between(state, 1.0, 3.14);
}

static double cap_hit(const double *g, const double from[3], const double direction[3])
{
    const double cosine = dot(g, direction) / sqrt(dot(g, g) * dot(direction, direction));

    (void)from;
    return cosine >= cos(g[3]) ? INFINITY : -1.0;
}

/* A point is a direction; the light lies at infinity. */
static double cap_surface(const double *g, const double point[3], double normal[3])
{
    (void)g;
    scale3(point, -1.0, normal);
    return 0.0;
}

static const struct test_technique cap_techniques[] = {
    {"solid angle, radial", PSC_MEASURE_SOLID_ANGLE, PSC_MAP_RADIAL},
    {"solid angle, concentric", PSC_MEASURE_SOLID_ANGLE, PSC_MAP_CONCENTRIC},
    {"projected, radial", PSC_MEASURE_PROJECTED_SOLID_ANGLE, PSC_MAP_RADIAL},
    {"projected, parallel", PSC_MEASURE_PROJECTED_SOLID_ANGLE, PSC_MAP_PARALLEL},
    {"projected, concentric", PSC_MEASURE_PROJECTED_SOLID_ANGLE, PSC_MAP_CONCENTRIC},
    {NULL, 0, 0},
};

const struct shape shape_cap = {
    .name = "cap", .shape = PSC_SHAPE_CAP, .parts = "da",
    .techniques = cap_techniques, .build = cap_build,
    .wave_f32 = cap_wave_f32, .wave_f64 = cap_wave_f64,
    .solid_angle = cap_solid_angle, .form_factor = cap_form_factor,
    .make = cap_make, .hit = cap_hit, .surface = cap_surface, .exact = exact_cap,
};
