/* SPDX-License-Identifier: Apache-2.0 */
#include "bench.h"

#include <math.h>

#include "../calls.h"
#include "../scenes.h"

const struct bench_case bench_cases[CASES] = {
    {"ellipse", "wholly above the horizon: half-angle 0.5, elevation 1.2", 0.5, 1.2},
    {"mixed", "ellipse and lune: 0.8, 0.4", 0.8, 0.4},
    {"lune", "mostly below the horizon: 0.8, -0.3", 0.8, -0.3},
    {"thin", "a thin lune: 0.8, -0.7", 0.8, -0.7},
    {"sun", "ellipse and lune, as small as the sun: 0.00465, 0.002", 0.00465, 0.002},
    {"cornell", "what the surfaces of a Cornell box see of four spheres", 0.0, 0.0},
};

struct stage_f32 stages_f32[CASES];
struct stage_f64 stages_f64[CASES];

static void set_element(int which, size_t i, const struct scene *scene, double u, double v)
{
    struct stage_f32 *f = &stages_f32[which];
    struct stage_f64 *d = &stages_f64[which];
    int c;

    for (c = 0; c < 3; c++) {
        f->position[c][i] = (float)(d->position[c][i] = scene->position[c]);
        f->normal[c][i] = (float)(d->normal[c][i] = scene->normal[c]);
        f->center[c][i] = (float)(d->center[c][i] = scene->center[c]);
    }
    f->radius[i] = (float)(d->radius[i] = scene->radius);
    f->u[i] = (float)(d->u[i] = u);
    f->v[i] = (float)(d->v[i] = v);
    f->count = d->count = i + 1;
}

/* One light at the half-angle and elevation of a case, anywhere. */
static void place_light(uint64_t *state, const struct bench_case *c, struct scene *scene)
{
    double across[3];
    const double distance = random_between(state, 1.0, 8.0);
    int i;

    random_unit(state, scene->normal);
    random_across(state, scene->normal, across);
    scene->radius = distance * sin(c->alpha);
    for (i = 0; i < 3; i++) {
        scene->position[i] = random_between(state, -1.0, 1.0);
        scene->center[i] = scene->position[i] + distance * (sin(c->beta) * scene->normal[i] +
                                                            cos(c->beta) * across[i]);
    }
}

/* ---- The Cornell box: a room, two blocks, four lights that hang free in it ---- */

static const double lights[4][4] = {{-0.68, 0.35, 1.60, 0.24},
                                    {0.76, 0.45, 1.36, 0.17},
                                    {0.06, -0.55, 0.15, 0.12},
                                    {-0.78, -0.30, 0.30, 0.14}};

/* Boxes: middle of the floor, size, turn as its sine; the room itself is seen from inside. */
static const struct box {
    double x, y, size[3], sine, side;
} boxes[3] = {{0.0, 0.0, {2.0, 2.0, 2.0}, 0.0, -1.0},
              {-0.36, 0.38, {0.56, 0.56, 1.15}, 0.30, 1.0},
              {0.44, -0.10, {0.52, 0.52, 0.55}, -0.31, 1.0}};

/* A point on one of the boxes, all surfaces equally likely by area. */
static void place_in_box(uint64_t *state, struct scene *scene)
{
    const struct box *b;
    double local[3], normal[3] = {0.0, 0.0, 0.0}, cosine, area;
    int face, axis, i;

    do { /* the largest face is 2 by 2 */
        b = boxes + random_below(state, 3);
        face = random_below(state, 6);
        axis = face / 2;
        area = b->size[(axis + 1) % 3] * b->size[(axis + 2) % 3];
    } while (random_between(state, 0.0, 4.0) > area);
    for (i = 0; i < 3; i++)
        local[i] = b->size[i] * (i == axis ? face % 2 - 0.5 : random_between(state, -0.5, 0.5));
    normal[axis] = b->side * (face % 2 ? 1.0 : -1.0);
    cosine = sqrt(1.0 - b->sine * b->sine);
    scene->position[0] = b->x + cosine * local[0] - b->sine * local[1];
    scene->position[1] = b->y + b->sine * local[0] + cosine * local[1];
    scene->position[2] = local[2] + 0.5 * b->size[2];
    scene->normal[0] = cosine * normal[0] - b->sine * normal[1];
    scene->normal[1] = b->sine * normal[0] + cosine * normal[1];
    scene->normal[2] = normal[2];
}

void make_stages(void)
{
    uint64_t state = 20180701;
    int which;
    size_t i;

    for (which = 0; which < CASES; which++)
        for (i = 0; i < (which == CASE_CORNELL ? STAGE_MAX : STAGE_MANY); i++) {
            struct scene scene;

            if (which == CASE_CORNELL) {
                place_in_box(&state, &scene);
                memcpy(scene.center, lights[i % 4], sizeof scene.center);
                scene.radius = lights[i % 4][3];
            } else {
                place_light(&state, &bench_cases[which], &scene);
            }
            set_element(which, i, &scene, random_uniform(&state), random_uniform(&state));
        }
}

void count_cornell(size_t counts[6])
{
    const struct stage_f64 *s = &stages_f64[CASE_CORNELL];
    static const struct test_technique projected = {
        "projected, radial", PSC_MEASURE_PROJECTED_SOLID_ANGLE, PSC_MAP_RADIAL};
    struct test_sampler memory;
    psc_sampler *sampler = make_sampler(&memory);
    psc_description description;
    size_t i;

    memset(counts, 0, 6 * sizeof *counts);
    description.struct_size = sizeof description;
    for (i = 0; i < s->count; i++) {
        const double position[3] = {s->position[0][i], s->position[1][i], s->position[2][i]};
        const double normal[3] = {s->normal[0][i], s->normal[1][i], s->normal[2][i]};
        const double center[3] = {s->center[0][i], s->center[1][i], s->center[2][i]};

        build_sphere(sampler, &projected, 0, position, normal, center, s->radius[i]);
        psc_sampler_describe(sampler, &description);
        counts[description.visibility]++;
    }
}
