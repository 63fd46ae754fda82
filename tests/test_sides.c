/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Lights that shine on one side only: a receiver before the light, or outside it, sees the same to
 * the bit as if it shone on both; one behind or inside sees nothing. The side of a flat light is
 * where its normal points, whichever way the receiver looks.
 */
#include "rays.h"
#include "tap.h"

enum { LIGHTS = 300, SAMPLES = 4 };

/* Whether the receiver is where the light shines: from hits of plain geometry for closed lights,
   whose inside sees the surface all around. */
static int is_lit(const struct light *light)
{
    const struct shape *shape = light->shape;
    double to[3], normal[3], back[3];

    if (is_distant(shape))
        return 1;
    subtract3(light->middle, light->position, to);
    shape->surface(light->geometry, light->position, normal);
    if (shape->flat)
        return dot(to, normal) < 0.0;
    scale3(to, -1.0, back);
    return shape->hit(light->geometry, light->position, to) < 0.0 ||
           shape->hit(light->geometry, light->position, back) < 0.0;
}

static int same_samples(uint64_t *seed, const psc_sampler *a, const psc_sampler *b)
{
    int i, bits, same = 1;

    for (i = 0; i < SAMPLES; i++)
        for (bits = 32; bits <= 64; bits += 32) {
            const double u = random_coordinate(seed), v = random_coordinate(seed);
            psc_light_sample_f64 x, y;

            memset(&x, 0, sizeof x);
            memset(&y, 0, sizeof y);
            same &= sample_any(bits, a, u, v, &x) == sample_any(bits, b, u, v, &y);
            same &= memcmp(&x, &y, sizeof x) == 0;
        }
    return same;
}

static void sides(const struct shape *shape, const struct test_technique *what)
{
    long lit = 0, dark = 0, wrong = 0;
    uint64_t seed = 170;
    int i;

    for (i = 0; i < LIGHTS; i++) {
        struct test_sampler both, one;
        struct light light;
        psc_result result;

        random_light(&seed, shape, what, &light);
        result = build_light(make_sampler(&both), &light);
        light.technique_flags = PSC_TECHNIQUE_ONE_SIDED;
        if (!is_lit(&light)) {
            dark++;
            result = PSC_EMPTY;
        } else
            lit++;
        if (build_light(make_sampler(&one), &light) != result ||
            (result == PSC_SUCCESS && !same_samples(&seed, both.sampler, one.sampler)))
            if (wrong++ == 0)
                tap_note("    first: %s", describe_light(&light));
    }
    tap_ok(wrong == 0 && lit > LIGHTS / 4 && (is_distant(shape) || dark > LIGHTS / 10),
           "%s, %s: %ld receivers that are lit, %ld that are not (%ld wrong)", shape->name,
           what->name, lit, dark, wrong);
}

int main(void)
{
    const struct test_technique *what;
    int i;

    for (i = 0; shapes[i]; i++)
        for (FOR_TECHNIQUES(shapes[i], what))
            sides(shapes[i], what);
    return tap_done();
}
