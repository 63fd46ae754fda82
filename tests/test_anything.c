/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Whatever is built from numbers of any size, signs and zeros included, gives samples that are
 * samples: unit directions and normals, densities and weights that are numbers, inverses inside
 * the square; in both precisions.
 */
#include "shapes.h"
#include "tap.h"
#include "vectors.h"

enum { BUILDS = 150000 };

static double anything(uint64_t *seed)
{
    double x = 2.0 * random_uniform(seed) - 1.0;

    switch (random_below(seed, 5)) {
    case 0: return 0.0;
    case 1: return ldexp(x, random_below(seed, 80) - 40);
    case 2: return x;
    case 3: return (double)random_below(seed, 5) - 2.0;
    default: return ldexp(x, random_below(seed, 60) - 30);
    }
}

static int is_sample(const psc_sampler *sampler, double u, double v)
{
    double pdf = NAN, uv[2] = {0.5, 0.5}, narrow[3];
    psc_light_sample_f64 wide;
    psc_light_sample_f32 sample;
    int i;

    memset(&wide, 0xff, sizeof wide);
    memset(&sample, 0xff, sizeof sample);
    psc_sample_f64(sampler, u, v, &wide);
    psc_sample_f32(sampler, (float)u, (float)v, &sample);
    psc_pdf_f64(sampler, wide.direction, &pdf);
    psc_invert_f64(sampler, wide.direction, uv);
    for (i = 0; i < 3; i++)
        narrow[i] = (double)sample.direction[i];
    return fabs(dot(wide.direction, wide.direction) - 1.0) < 1e-13 && fabs(dot(narrow, narrow) - 1.0) < 2e-6 &&
           fabs(dot(wide.normal, wide.normal) - 1.0) < 1e-9 && wide.weight >= 0.0 && wide.pdf >= 0.0 &&
           pdf >= 0.0 && uv[0] >= 0.0 && uv[0] <= 1.0 && uv[1] >= 0.0 && uv[1] <= 1.0;
}

/* Numbers of any kind in every place that may have them. */
static void any_numbers(uint64_t *seed, struct light *light)
{
    double *g = light->geometry;
    const char *part;
    int i;

    for (i = 0; i < 3; i++) {
        light->position[i] = random_below(seed, 3) ? anything(seed) : 0.0;
        light->normal[i] = anything(seed);
    }
    for (part = light->shape->parts; *part && !light->shape->bound; g += part_size(*part), part++)
        for (i = 0; i < part_size(*part); i++)
            g[i] = *part == 'a'   ? ldexp(1.57 * random_uniform(seed), -random_below(seed, 40))
                   : *part == 'r' ? fabs(anything(seed))
                                  : anything(seed);
    light->has_normal = random_below(seed, 8) > 0;
    light->flags = light->has_normal && random_below(seed, 2) ? PSC_RECEIVER_TWO_SIDED : 0;
}

/* The receiver comes as close to the surface as numbers can. */
static void approach(uint64_t *seed, struct light *light)
{
    const double near = 1.0 + ldexp(random_uniform(seed) - 0.5, -random_below(seed, 60));
    double to[3], along;
    int i;

    subtract3(light->geometry, light->position, to);
    along = light->shape->hit(light->geometry, light->position, to);
    for (i = 0; i < 3 && along > 0.0 && isfinite(along); i++)
        light->position[i] += near * along * to[i];
}

static void any_light(uint64_t *seed, const struct shape *shape, struct light *light)
{
    const struct test_technique *what = shape->techniques;

    while (what[1].name && random_below(seed, 3))
        what++;
    random_hard_light(seed, shape, what, light);
    if (random_below(seed, 4))
        any_numbers(seed, light);
    if (!is_distant(shape) && random_below(seed, 4) == 0)
        approach(seed, light);
}

static void builds(const struct shape *shape)
{
    struct test_sampler s;
    long built = 0, odd = 0;
    uint64_t seed = 120;
    int i;

    make_sampler(&s);
    for (i = 0; i < BUILDS; i++) {
        struct light light;
        double u, v;

        any_light(&seed, shape, &light);
        u = random_below(&seed, 4) ? random_uniform(&seed) : (double)random_below(&seed, 2);
        v = random_below(&seed, 4) ? random_uniform(&seed) : 0.5 * (double)random_below(&seed, 3);
        if (build_light(s.sampler, &light) != PSC_SUCCESS)
            continue;
        built++;
        if (!is_sample(s.sampler, u, v) && odd++ == 0)
            tap_note("    build %d: %s u %a v %a", i, describe_light(&light), u, v);
    }
    tap_ok(odd == 0 && built > BUILDS / 4, "%s: %ld of %ld samples are none", shape->name, odd,
           built);
}

int main(void)
{
    int i;

    for (i = 0; shapes[i]; i++)
        builds(shapes[i]);
    return tap_done();
}
