/* SPDX-License-Identifier: Apache-2.0 */
/* Random spheres and receivers: near and far, of every size, close to every boundary. */
#ifndef PSC_TESTS_SCENES_H
#define PSC_TESTS_SCENES_H

#include <string.h>

#include "caps.h"
#include "quad.h"
#include "vectors.h"

struct scene {
    double position[3], normal[3], center[3], radius;
};

/* A sphere whose surface is gap radii away from the receiver (negative: around it), with its
   centre at the sine of elevation over the horizon. The receiver, the sphere or neither is at
   the origin; the normal has any length; lengths are around unit. */
static inline void place_sphere(uint64_t *state, double gap, double sine, double unit,
                                struct scene *scene)
{
    double across[3], normal[3], distance, length = random_log(state, 1e-3, 1e3), shift;
    int i, origin = random_below(state, 4);

    random_unit(state, normal);
    random_across(state, normal, across);
    if (random_below(state, 4) == 0) { /* an elevation without any rounding */
        memset(normal, 0, sizeof normal);
        memset(across, 0, sizeof across);
        i = random_below(state, 3);
        normal[i] = random_below(state, 2) ? 1.0 : -1.0;
        across[(i + 1) % 3] = 1.0;
        length = 1.0;
    }
    scene->radius = unit * random_between(state, 0.5, 2.0);
    distance = scene->radius * (1.0 + gap);
    for (i = 0; i < 3; i++) {
        double o = distance * (sine * normal[i] + sqrt((1.0 - sine) * (1.0 + sine)) * across[i]);
        shift = origin > 1 ? 0.0 : distance * random_between(state, -1.0, 1.0);
        scene->position[i] = origin == 3 ? -o : shift;
        scene->center[i] = origin == 3 ? 0.0 : shift + o;
        scene->normal[i] = length * normal[i];
    }
}

/* Any scene with the sphere before the receiver, partly or wholly above its horizon, at a
   distance of 1e-8 to 1e8 radii. */
static inline void random_scene(uint64_t *state, struct scene *scene)
{
    double gap = random_log(state, 1e-8, 1e8), alpha = asin(1.0 / (1.0 + gap)), ignored, beta;
    double margin = random_margin(state), sine = 1.0 / (1.0 + gap);

    switch (random_below(state, 6)) {
    case 0: sine *= 1.0 + (random_below(state, 2) ? margin : -margin); break;
    case 1: sine *= random_below(state, 2) ? margin : -margin; break;
    case 2: sine *= margin - 1.0; break;
    case 3: sine = random_between(state, -sine, 1.0); break;
    case 4: sine = 1.0 - margin; break;
    default:
        random_cap(state, &ignored, &beta);
        sine = sin(fmax(beta, -alpha));
        break;
    }
    place_sphere(state, gap, fmin(sine, 1.0), 1.0, scene);
}

#endif
