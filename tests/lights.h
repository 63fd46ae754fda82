/* SPDX-License-Identifier: Apache-2.0 */
/* Random lights of all kinds, for tests of what holds for every one of them. */
#ifndef PSC_TESTS_LIGHTS_H
#define PSC_TESTS_LIGHTS_H

#include <stdio.h>

#include "calls.h"
#include "scenes.h"

struct light {
    const struct test_technique *what;
    int distant;   /* a cap; the axis is scene.center, the half-angle scene.radius */
    int has_normal;
    uint32_t flags;
    struct scene scene;
};

/* Angles and distances are ordinary here: what is tested must hold to rounding. */
static inline void random_light(uint64_t *state, const struct test_technique *what,
                                struct light *light)
{
    double gap, sine;

    light->what = what;
    light->distant = what->distant && random_below(state, 3) == 0;
    light->flags = random_below(state, 3) == 0 ? PSC_RECEIVER_TWO_SIDED : 0;
    light->has_normal = what->measure == PSC_MEASURE_PROJECTED_SOLID_ANGLE ||
                        random_below(state, 3) > 0;
    if (!light->has_normal)
        light->flags = 0;
    gap = random_below(state, 5) == 0 ? random_between(state, -0.99, 0.0)
                                      : random_log(state, 0.01, 10.0);
    if (light->distant)
        gap = fmax(gap, 0.05);
    sine = random_between(state, -0.9 / fmax(1.0 + gap, 1.0), 1.0);
    place_sphere(state, gap, sine, random_log(state, 0.1, 10.0), &light->scene);
    if (light->distant) {
        int i;
        for (i = 0; i < 3; i++) {
            light->scene.center[i] -= light->scene.position[i];
            light->scene.position[i] = 0.0;
        }
        light->scene.radius = asin(1.0 / (1.0 + gap));
        if (what->measure == PSC_MEASURE_SOLID_ANGLE && random_below(state, 3) == 0)
            light->scene.radius = random_between(state, 1.0, 3.14);
    }
}

static inline psc_result build_light(psc_sampler *sampler, const struct light *light)
{
    const struct scene *s = &light->scene;
    const double *normal = light->has_normal ? s->normal : NULL;

    if (light->distant)
        return build_cap(sampler, light->what, light->flags, normal, s->center, s->radius);
    return build_sphere(sampler, light->what, light->flags, s->position, normal, s->center,
                        s->radius);
}

static inline const char *describe_light(const struct light *light)
{
    static char text[320];
    const struct scene *s = &light->scene;

    snprintf(text, sizeof text,
             "%s%s%s: position %a %a %a normal %a %a %a %s %a %a %a %s %a", light->what->name,
             light->flags ? ", two-sided" : "", light->has_normal ? "" : ", no normal",
             s->position[0], s->position[1], s->position[2], s->normal[0], s->normal[1],
             s->normal[2], light->distant ? "axis" : "center", s->center[0], s->center[1],
             s->center[2], light->distant ? "half-angle" : "radius", s->radius);
    return text;
}

#endif
