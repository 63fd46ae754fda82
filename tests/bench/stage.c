/* SPDX-License-Identifier: Apache-2.0 */
#include "bench.h"

#include <math.h>
#include <string.h>

#include "../vectors.h"

const struct bench_family bench_families[FAMILIES] = {
    {"sphere", "cone", "libm", "cone sampling"},
    {"disk", "area, concentric", "calls", "area sampling, concentric"},
    {"ellipse", "area, concentric", "calls", "area sampling, concentric"},
    {"ellipsoid", "solid angle, quasi-uniform", "calls", "the quasi-uniform map"},
    {"triangle", "area, radial", "calls", "area sampling"},
    {"rectangle", "area, parallel", "calls", "area sampling"},
    {"5-gon", "area, radial", "calls", "area sampling"},
};

#define SIZES(family, name)                                                                     \
    {family, name, "half-angle 0.5, elevation 1.0, normals up to 60 degrees off", 0.5, 1.0},    \
    {family, name "_small", "the same at half-angle 0.001", 0.001, 1.0},                        \
    {family, name "_wide", "the same at half-angle 1.2", 1.2, 1.0},                             \
    {family, name "_cut", "half-angle 0.5, elevation 0.1: below the horizon in part", 0.5, 0.1}

const struct bench_case bench_cases[CASES] = {
    {FAMILY_SPHERE, "ellipse", "wholly above the horizon: half-angle 0.5, elevation 1.2", 0.5,
     1.2},
    {FAMILY_SPHERE, "mixed", "ellipse and lune: 0.8, 0.4", 0.8, 0.4},
    {FAMILY_SPHERE, "lune", "mostly below the horizon: 0.8, -0.3", 0.8, -0.3},
    {FAMILY_SPHERE, "thin", "a thin lune: 0.8, -0.7", 0.8, -0.7},
    {FAMILY_SPHERE, "sun", "ellipse and lune, as small as the sun: 0.00465, 0.002", 0.00465,
     0.002},
    {FAMILY_SPHERE, "cornell", "what the surfaces of a Cornell box see of four spheres", 0.0, 0.0},
    SIZES(FAMILY_DISK, "disk"),
    SIZES(FAMILY_ELLIPSE, "edisk"),
    SIZES(FAMILY_ELLIPSOID, "esolid"),
    SIZES(FAMILY_TRIANGLE, "tri"),
    SIZES(FAMILY_RECTANGLE, "rect"),
    SIZES(FAMILY_POLYGON, "pent"),
};

struct stage_f32 stages_f32[CASES];
struct stage_f64 stages_f64[CASES];

static int chosen = -1; /* a family; negative: all */

int choose_family(const char *shape)
{
    for (chosen = FAMILIES - 1; chosen >= 0; chosen--)
        if (strcmp(bench_families[chosen].shape, shape) == 0)
            break;
    return chosen >= 0;
}

const struct shape *family_shape(enum family family)
{
    int i;

    for (i = 0; shapes[i] && (chosen < 0 || chosen == (int)family); i++)
        if (strcmp(shapes[i]->name, bench_families[family].shape) == 0)
            return shapes[i];
    return NULL;
}

static void set_element(int which, size_t i, const struct light *light, double u, double v)
{
    struct stage_f32 *f = &stages_f32[which];
    struct stage_f64 *d = &stages_f64[which];
    int c;

    for (c = 0; c < 3; c++) {
        f->position[c][i] = (float)(d->position[c][i] = light->position[c]);
        f->normal[c][i] = (float)(d->normal[c][i] = light->normal[c]);
    }
    for (c = 0; c < LIGHT_MAX; c++)
        f->light[c][i] = (float)(d->light[c][i] = light->geometry[c]);
    f->u[i] = (float)(d->u[i] = u);
    f->v[i] = (float)(d->v[i] = v);
    f->count = d->count = i + 1;
}

/* A frame whose z is at most 60 degrees from where the receiver is: flat lights are seen from
   their front, and not edge-on. */
static void face_receiver(uint64_t *state, const double to[3], struct motion *m)
{
    const double distance = sqrt(dot(to, to));

    do
        random_unit(state, m->z);
    while (dot(m->z, to) > -0.5 * distance);
    random_across(state, m->z, m->x);
    cross(m->z, m->x, m->y);
}

/* One light at the half-angle and elevation of a case. It is at the origin, so that coordinates in
   float are still those of a flat polygon where that is small. */
static void place_at(uint64_t *state, const struct shape *shape, const struct bench_case *c,
                     struct light *light)
{
    const double distance = random_between(state, 1.0, 8.0);
    double across[3], to[3];
    struct motion m;
    int i;

    light->shape = shape;
    random_unit(state, light->normal);
    random_across(state, light->normal, across);
    for (i = 0; i < 3; i++) {
        to[i] = distance * (sin(c->beta) * light->normal[i] + cos(c->beta) * across[i]);
        light->position[i] = -to[i];
        m.shift[i] = 0.0;
    }
    m.scale = distance * sin(c->alpha);
    face_receiver(state, to, &m);
    shape->make(state, shape->techniques, 0, light->geometry);
    move_geometry(&m, 1.0, light);
}

void make_stages(void)
{
    int which;
    size_t i;

    for (which = 0; which < CASES; which++) {
        const struct shape *shape = family_shape(bench_cases[which].family);
        uint64_t state = 20180701 + (uint64_t)which; /* the same lights whatever else is timed */

        for (i = 0; shape && i < (which == CASE_CORNELL ? STAGE_MAX : STAGE_MANY); i++) {
            struct light light;

            memset(&light, 0, sizeof light);
            if (which == CASE_CORNELL)
                place_in_cornell(&state, i, &light);
            else
                place_at(&state, shape, &bench_cases[which], &light);
            set_element(which, i, &light, random_uniform(&state), random_uniform(&state));
        }
    }
}
