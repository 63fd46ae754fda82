/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Lights that shine on one side only: a receiver before the light, or outside it, sees the same to
 * the bit as if it shone on both; one behind or inside sees nothing. The side of a flat light is
 * where its normal points, whichever way the receiver looks.
 *
 * Receivers that are lit on both sides: of the square, each side takes the share that it has of
 * the projected solid angle, the side of the normal first.
 */
#include "rays.h"
#include "worst.h"

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

/* The projected solid angle of a one-sided receiver that looks this way; 0 if it sees nothing. */
static double seen_from(const struct light *light, double sign)
{
    struct light one = *light;
    struct test_sampler s;
    double value = 0.0;

    one.flags = 0;
    scale3(light->normal, sign, one.normal);
    return build_light(make_sampler(&s), &one) == PSC_SUCCESS &&
                   psc_sampler_projected_solid_angle(s.sampler, &value) == PSC_SUCCESS
               ? value
               : 0.0;
}

/* Where u goes from one side to the other. */
static double find_split(const struct light *light, const psc_sampler *sampler)
{
    double low = 0.0, high = 1.0;
    int i;

    for (i = 0; i < 60; i++) {
        const double middle = 0.5 * (low + high);
        psc_light_sample_f64 s;

        psc_sample_f64(sampler, middle, 0.5, &s);
        *(dot(s.direction, light->normal) > 0.0 ? &low : &high) = middle;
    }
    return low;
}

static void shares(const struct shape *shape, const struct test_technique *what)
{
    struct worst worst = {0};
    uint64_t seed = 171;
    int i;

    for (i = 0; i < LIGHTS; i++) {
        struct test_sampler s;
        struct light light;
        double above, below;

        place_light(&seed, shape, what, PLACE_ORDINARY, HORIZON_CUT, FACING_BOTH, &light);
        if (build_light(make_sampler(&s), &light) != PSC_SUCCESS)
            continue;
        above = seen_from(&light, 1.0);
        below = seen_from(&light, -1.0);
        if (above > 0.0 && below > 0.0)
            worst_add(&worst, fabs(find_split(&light, s.sampler) - above / (above + below)), "%s",
                      describe_light(&light));
    }
    worst_report(&worst, 1e-14, "%s, %s: share of the first side", shape->name, what->name);
}

int main(void)
{
    const struct test_technique *what;
    int i;

    for (i = 0; shapes[i]; i++)
        for (FOR_TECHNIQUES(shapes[i], what)) {
            sides(shapes[i], what);
            if (what->measure == PSC_MEASURE_PROJECTED_SOLID_ANGLE)
                shares(shapes[i], what);
        }
    return tap_done();
}
