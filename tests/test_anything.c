/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Whatever is built from numbers of any size, signs and zeros included, gives samples that are
 * samples: unit directions and normals, densities and weights that are numbers, inverses inside
 * the square; in both precisions.
 */
#include <math.h>
#include <string.h>

#include <psc/psc.h>

#include "random.h"
#include "tap.h"

enum { BUILDS = 400000 };

static double anything(uint64_t *seed)
{
    double x = 2.0 * random_uniform(seed) - 1.0;

    switch (random_below(seed, 5)) {
    case 0: return 0.0;
    case 1: return ldexp(x, (int)random_below(seed, 80) - 40);
    case 2: return x;
    case 3: return (double)random_below(seed, 5) - 2.0;
    default: return ldexp(x, (int)random_below(seed, 60) - 30);
    }
}

static double length2(const double v[3])
{
    return v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
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
    return fabs(length2(wide.direction) - 1.0) < 1e-13 && fabs(length2(narrow) - 1.0) < 2e-6 &&
           fabs(length2(wide.normal) - 1.0) < 1e-9 && wide.weight >= 0.0 && wide.pdf >= 0.0 &&
           pdf >= 0.0 && uv[0] >= 0.0 && uv[0] <= 1.0 && uv[1] >= 0.0 && uv[1] <= 1.0;
}

int main(void)
{
    long built = 0, odd = 0;
    psc_sampler_storage storage;
    psc_sampler *sampler;
    uint64_t seed = 120;
    int i, k;

    psc_sampler_init(&storage, sizeof storage, &sampler);
    for (i = 0; i < BUILDS; i++) {
        double position[3], normal[3], vector[3], size, u, v;
        const int distant = random_below(&seed, 3) == 0;
        const psc_receiver receiver = {sizeof receiver, (uint32_t)random_below(&seed, 2), position,
                                       random_below(&seed, 8) ? normal : NULL};
        const psc_technique technique = {sizeof technique, (uint32_t)random_below(&seed, 4),
                                         (uint32_t)random_below(&seed, 3), 0};

        for (k = 0; k < 3; k++) {
            position[k] = random_below(&seed, 3) ? anything(&seed) : 0.0;
            normal[k] = anything(&seed);
            vector[k] = anything(&seed);
        }
        size = distant ? ldexp(1.57 * random_uniform(&seed), -(int)random_below(&seed, 40))
                       : fabs(anything(&seed));
        if (!distant && random_below(&seed, 4) == 0) { /* close to the surface */
            for (k = 0; k < 3; k++)
                vector[k] = position[k];
            vector[random_below(&seed, 3)] +=
                size * (1.0 + ldexp(random_uniform(&seed) - 0.5, -(int)random_below(&seed, 60)));
        }
        u = random_below(&seed, 4) ? random_uniform(&seed) : (double)random_below(&seed, 2);
        v = random_below(&seed, 4) ? random_uniform(&seed) : 0.5 * (double)random_below(&seed, 3);
        if ((distant ? psc_build_cap : psc_build_sphere)(sampler, &technique, &receiver, vector,
                                                         size) != PSC_SUCCESS)
            continue;
        built++;
        if (!is_sample(sampler, u, v) && odd++ == 0)
            tap_note("    build %d: position %a %a %a normal %a %a %a vector %a %a %a size %a "
                     "u %a v %a", i, position[0], position[1], position[2], normal[0], normal[1],
                     normal[2], vector[0], vector[1], vector[2], size, u, v);
    }
    tap_ok(odd == 0 && built > BUILDS / 4, "%ld of %ld samples are none", odd, built);
    return tap_done();
}
