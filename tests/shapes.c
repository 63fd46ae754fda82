/* SPDX-License-Identifier: Apache-2.0 */
/* Lights of any shape, put before receivers. */
#include "shapes.h"

#include <stdio.h>

#include "exact.h"
#include "vectors.h"

#define LIST(name) &shape_##name,
const struct shape *const shapes[] = {TEST_SHAPES(LIST) NULL};
#undef LIST

int is_offered(const struct test_technique *what, int facing)
{
    return facing != FACING_NONE || what->measure != PSC_MEASURE_PROJECTED_SOLID_ANGLE;
}

/* ---- As a light is made: about the origin ---- */

/* The receiver of a closed light: its distance from the middle is a factor of the surface's. */
static void before_solid(uint64_t *state, const struct light *light, int place, double from[3])
{
    static const double middle[3] = {0.0, 0.0, 0.0};
    double direction[3], factor = 1.0;

    switch (place) {
    case PLACE_ORDINARY: factor += random_log(state, 0.01, 10.0); break;
    case PLACE_FAR: factor += random_log(state, 10.0, 1e3); break;
    case PLACE_TINY: factor += random_log(state, 1e3, 1e8); break;
    case PLACE_CLOSE: factor += random_log(state, 1e-9, 0.1); break;
    case PLACE_INSIDE: factor = random_between(state, 0.01, 0.999); break;
    default: break;
    }
    random_unit(state, direction);
    factor *= light->shape->hit(light->geometry, middle, direction);
    scale3(direction, factor, from);
}

/* The receiver of a flat light, which lies in the plane z = 0. */
static void before_flat(uint64_t *state, int place, double from[3])
{
    double direction[3], height = 0.0, beside = random_log(state, 0.05, 5.0);

    switch (place) {
    case PLACE_ORDINARY: height = random_log(state, 0.05, 5.0); break;
    case PLACE_FAR: height = random_log(state, 10.0, 1e3); break;
    case PLACE_TINY: height = random_log(state, 1e3, 1e8); break;
    case PLACE_CLOSE:
        height = random_log(state, 1e-9, 0.1);
        beside = random_between(state, 0.0, 0.5);
        break;
    case PLACE_GRAZING: height = random_log(state, 1e-9, 0.1); break;
    default: break;
    }
    random_unit(state, direction);
    if (place == PLACE_FAR || place == PLACE_TINY)
        scale3(direction, height, from);
    else {
        const double length = hypot(direction[0], direction[1]);

        from[0] = beside * direction[0] / length;
        from[1] = beside * direction[1] / length;
        from[2] = copysign(height, direction[2]);
    }
}

/* The sine of the middle's elevation, for a light that fills an angle with this sine. */
static double elevation_sine(uint64_t *state, int horizon, double size)
{
    const double margin = random_below(state, 8) == 0 ? 0.0 : random_log(state, 1e-12, 0.1);
    const double side = random_below(state, 2) ? 1.0 : -1.0;

    switch (horizon) {
    case HORIZON_ABOVE: return random_between(state, size, 1.0);
    case HORIZON_TOUCH: return fmin(size * (1.0 + side * margin), 1.0);
    case HORIZON_CUT:
        return random_below(state, 4) == 0 ? side * size * margin
                                           : random_between(state, -0.5, 0.9) * size;
    case HORIZON_LOW: return size * (margin - 1.0);
    case HORIZON_BELOW: return -random_between(state, size, 1.0);
    default: return random_between(state, fmax(-0.95 * size, -1.0), 1.0);
    }
}

static void face_light(uint64_t *state, const struct light *light, int horizon,
                       const double from[3], double normal[3])
{
    double towards[3] = {0.0, 0.0, 1.0}, across[3], size = 1.0, sine;
    const int aside = horizon == HORIZON_ABOVE || horizon == HORIZON_BELOW;
    const double length = sqrt(dot(from, from));
    int i;

    if (is_distant(light->shape))
        size = light->geometry[3] < 1.57 ? sin(light->geometry[3]) : 1.0;
    else if (light->shape->flat && length < 1.0 && aside) /* which a plane alone makes sure of */
        towards[2] = -copysign(1.0, from[2]);
    else if (length > 0.0) {
        size = fmin(1.0 / length, 1.0);
        scale3(from, -1.0 / length, towards);
    }
    sine = elevation_sine(state, horizon, size);
    random_across(state, towards, across);
    for (i = 0; i < 3; i++)
        normal[i] = sine * towards[i] + sqrt((1.0 - sine) * (1.0 + sine)) * across[i];
}

/* ---- In the world ---- */

static void rotate(const struct motion *m, const double v[3], double out[3])
{
    int i;

    for (i = 0; i < 3; i++)
        out[i] = v[0] * m->x[i] + v[1] * m->y[i] + v[2] * m->z[i];
}

/* Any rotation, or one without any rounding; the receiver, the light or neither is at the
   origin. */
static void random_motion(uint64_t *state, const double from[3], struct motion *m)
{
    const int origin = random_below(state, 4);
    double v[3];
    int i;

    memset(m, 0, sizeof *m);
    if (random_below(state, 4) == 0) {
        i = random_below(state, 3);
        m->x[i] = 1.0;
        m->y[(i + 1) % 3] = random_below(state, 2) ? 1.0 : -1.0;
    } else {
        random_unit(state, m->x);
        random_across(state, m->x, m->y);
    }
    cross(m->x, m->y, m->z);
    m->scale = random_log(state, 0.1, 10.0);
    rotate(m, from, v);
    for (i = 0; i < 3; i++)
        m->shift[i] = origin == 3   ? 0.0
                      : origin == 2 ? -m->scale * v[i]
                                    : m->scale * random_between(state, -2.0, 2.0);
}

void move_geometry(const struct motion *m, double length, struct light *light)
{
    double *g = light->geometry, v[3];
    const char *part;
    int i;

    for (part = light->shape->parts; *part; g += part_size(*part), part++) {
        if (*part == 'r')
            g[0] *= m->scale;
        if (part_size(*part) == 1)
            continue;
        rotate(m, g, v);
        for (i = 0; i < 3; i++)
            g[i] = *part == 'd'   ? length * v[i]
                   : *part == 'e' ? m->scale * v[i]
                                  : m->shift[i] + m->scale * v[i];
    }
}

static void set_facing(struct light *light, int facing)
{
    light->has_normal = facing != FACING_NONE;
    light->flags = facing == FACING_BOTH ? PSC_RECEIVER_TWO_SIDED : 0;
}

static void place(uint64_t *state, const struct shape *shape, const struct test_technique *what,
                  int hard, int where, int horizon, int facing, struct light *light)
{
    static const double up[3] = {0.0, 0.0, 1.0};
    double from[3] = {0.0, 0.0, 0.0}, normal[3], v[3];
    struct motion m;
    int i;

    memset(light, 0, sizeof *light);
    light->shape = shape;
    light->what = what;
    set_facing(light, facing);
    shape->make(state, what, hard, light->geometry);
    if (shape->flat)
        before_flat(state, where, from);
    else if (!is_distant(shape))
        before_solid(state, light, where, from);
    face_light(state, light, horizon, from, normal);

    random_motion(state, from, &m);
    rotate(&m, normal, v);
    scale3(v, random_log(state, 1e-3, 1e3), light->normal);
    move_geometry(&m, random_log(state, 1e-3, 1e3), light);
    if (is_distant(shape)) {
        rotate(&m, up, light->middle);
        return; /* from wherever */
    }
    rotate(&m, from, v);
    for (i = 0; i < 3; i++)
        light->position[i] = m.shift[i] + m.scale * v[i];
    memcpy(light->middle, m.shift, sizeof light->middle);
    light->reach = m.scale;
}

void place_light(uint64_t *state, const struct shape *shape, const struct test_technique *what,
                 int where, int horizon, int facing, struct light *light)
{
    place(state, shape, what, 0, where, horizon, facing, light);
}

static int random_facing(uint64_t *state, const struct test_technique *what)
{
    int facing;

    do
        facing = random_below(state, FACINGS);
    while (!is_offered(what, facing));
    return facing;
}

void random_light(uint64_t *state, const struct shape *shape, const struct test_technique *what,
                  struct light *light)
{
    const int inside = !shape->flat && random_below(state, 5) == 0;
    const int horizon = random_below(state, 3) == 0 ? HORIZON_CUT : HORIZON_ANY;

    place(state, shape, what, 0, inside ? PLACE_INSIDE : PLACE_ORDINARY, horizon,
          random_facing(state, what), light);
}

void random_hard_light(uint64_t *state, const struct shape *shape,
                       const struct test_technique *what, struct light *light)
{
    const int where = random_below(state, PLACES), horizon = random_below(state, HORIZONS);

    place(state, shape, what, random_below(state, 2), where, horizon, random_facing(state, what),
          light);
    if (random_below(state, 3) == 0)
        light->technique_flags = PSC_TECHNIQUE_ONE_SIDED;
}

void exact_light(uint64_t *state, const struct shape *shape, const struct test_technique *what,
                 struct light *light)
{
    memset(light, 0, sizeof *light);
    light->shape = shape;
    light->what = what;
    if (shape->exact)
        shape->exact(state, light);
    else
        place_exactly(state, light, shape->make);
    set_facing(light, random_below(state, FACINGS));
}

void shrink_to_nothing(struct light *light)
{
    double *g = light->geometry;
    const char *part;
    int i;

    for (part = light->shape->parts; *part; g += part_size(*part), part++)
        for (i = 0; i < part_size(*part); i++)
            if (*part == 'p')
                g[i] = light->geometry[i];
            else if (*part != 'd')
                g[i] = 0.0;
}

/* ---- Calls ---- */

psc_technique light_technique(const struct light *light)
{
    psc_technique technique = make_technique(light->what->measure, light->what->map);

    technique.flags = light->technique_flags;
    return technique;
}

psc_receiver light_receiver(const struct light *light)
{
    return make_receiver(light->position, light->has_normal ? light->normal : NULL, light->flags);
}

psc_result build_light(psc_sampler *sampler, const struct light *light)
{
    const psc_technique technique = light_technique(light);
    const psc_receiver receiver = light_receiver(light);

    return light->shape->build(sampler, &technique, &receiver, light->geometry);
}

const char *describe_light(const struct light *light)
{
    static char text[2048];
    const double *g = light->geometry;
    const char *part;
    int n;

    n = snprintf(text, sizeof text, "%s, %s%s%s%s: position %a %a %a normal %a %a %a geometry",
                 light->shape->name, light->what->name, light->flags ? ", two-sided" : "",
                 light->technique_flags ? ", one-sided light" : "",
                 light->has_normal ? "" : ", no normal", light->position[0], light->position[1],
                 light->position[2], light->normal[0], light->normal[1], light->normal[2]);
    for (part = light->shape->parts; *part; g += part_size(*part), part++)
        n += part_size(*part) == 3
                 ? snprintf(text + n, sizeof text - (size_t)n, " %c %a %a %a", *part, g[0], g[1],
                            g[2])
                 : snprintf(text + n, sizeof text - (size_t)n, " %c %a", *part, g[0]);
    return text;
}
