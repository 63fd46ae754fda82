/* SPDX-License-Identifier: Apache-2.0 */
/* A Cornell box: a room, two blocks, four lights that hang free in it. */
#include "bench.h"

#include <math.h>
#include <string.h>

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
static void place_in_box(uint64_t *state, struct light *light)
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
    light->position[0] = b->x + cosine * local[0] - b->sine * local[1];
    light->position[1] = b->y + b->sine * local[0] + cosine * local[1];
    light->position[2] = local[2] + 0.5 * b->size[2];
    light->normal[0] = cosine * normal[0] - b->sine * normal[1];
    light->normal[1] = b->sine * normal[0] + cosine * normal[1];
    light->normal[2] = normal[2];
}

void place_in_cornell(uint64_t *state, size_t i, struct light *light)
{
    place_in_box(state, light);
    memcpy(light->geometry, lights[i % 4], sizeof lights[0]);
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
        const double center[3] = {s->light[0][i], s->light[1][i], s->light[2][i]};

        build_sphere(sampler, &projected, 0, position, normal, center, s->light[3][i]);
        psc_sampler_describe(sampler, &description);
        counts[description.visibility]++;
    }
}
