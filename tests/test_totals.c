/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Estimates are right: over a fine lattice on the square the mean of 1 / pdf is the solid angle of
 * what is sampled, and the mean weight is the projected solid angle, whichever the technique.
 *
 * Both are compared with the library's answers, and these with rays: how far from its middle the light
 * reaches in every direction around it, by plain geometry.
 */
#include "rays.h"
#include "worst.h"

enum { LIGHTS = 24, AZIMUTHS = 1024, HALVINGS = 40 };

/* Points of a lattice on each side: more where the density changes by much, or jumps. */
static int lattice(const struct test_technique *what)
{
    return is_tabulated(what) ? 576 : what->measure >= PSC_MEASURE_AREA ? 288 : 144;
}

static double bound(const struct test_technique *what)
{
    return is_tabulated(what) ? 2e-3 : 1e-3;
}

/* Whether the direction of the sample is one that no other has: the far side of a closed light
   shares its directions with the near one. */
static int is_near(const struct light *light, const psc_sampler *sampler,
                   const psc_light_sample_f64 *s)
{
    psc_description d = {sizeof d, 0, 0, 0, 0, 0};

    if (is_rejected(light->what, s->pdf))
        return 0;
    if (light->shape->flat || light->what->measure != PSC_MEASURE_AREA)
        return 1;
    psc_sampler_describe(sampler, &d);
    return d.visibility == PSC_CASE_INSIDE || dot(s->direction, s->normal) < 0.0;
}

struct sums {
    double solid, projected;
};

/* Runs from 0 to 1 and lingers at both, where the maps have roots. */
static double graded(double t)
{
    return t * t * (3.0 - 2.0 * t);
}

/* Means of 1 / pdf and of the weight. */
static struct sums take_samples(const struct light *light, const psc_sampler *sampler)
{
    struct sums sums = {0.0, 0.0};
    const int n = lattice(light->what);
    int i, j;

    for (i = 0; i < n; i++)
        for (j = 0; j < n; j++) {
            const double u = graded((i + 0.5) / n), v = graded((j + 0.5) / n);
            const double share = (graded((i + 1.0) / n) - graded((double)i / n)) *
                                 (graded((j + 1.0) / n) - graded((double)j / n));
            psc_light_sample_f64 s;

            memset(&s, 0xff, sizeof s);
            psc_sample_f64(sampler, u, v, &s);
            sums.projected += share * s.weight;
            if (is_near(light, sampler, &s))
                sums.solid += share / s.pdf;
        }
    return sums;
}

/* A direction at an angle from the middle of the light. */
static void ray(const struct cone *cone, double angle, double azimuth, double w[3])
{
    int k;

    for (k = 0; k < 3; k++)
        w[k] = cos(angle) * cone->axis[k] +
               sin(angle) * (cos(azimuth) * cone->x[k] + sin(azimuth) * cone->y[k]);
}

/* The angle from the middle up to which rays hit the light: it is convex. */
static double reach_of(const struct light *light, const struct cone *cone, double azimuth)
{
    double low = 0.0, high = 3.14159265358979323846, w[3];
    int i;

    ray(cone, high, azimuth, w);
    if (light->shape->hit(light->geometry, light->position, w) >= 0.0)
        return high; /* from inside */
    for (i = 0; i < HALVINGS; i++) {
        const double middle = 0.5 * (low + high);

        ray(cone, middle, azimuth, w);
        if (light->shape->hit(light->geometry, light->position, w) >= 0.0)
            low = middle;
        else
            high = middle;
    }
    return low;
}

/* The integral of (up cos t + out sin t) sin t up to an angle. */
static double cosines(double up, double out, double angle)
{
    return 0.5 * (up * sin(angle) * sin(angle) + out * (angle - sin(angle) * cos(angle)));
}

/* The same of what counts of that cosine, which changes its sign at one angle. */
static double counted_cosines(const struct light *light, double up, double out, double angle)
{
    const double turn = up > 0.0 ? atan2(up, -out) : atan2(-up, out);
    const double near = cosines(up, out, fmin(turn, angle));
    const double rest = angle > turn ? cosines(up, out, angle) - near : 0.0;

    return light->flags ? fabs(near) + fabs(rest) : fmax(near, 0.0) + fmax(rest, 0.0);
}

/* The light without and with the cosine of the receiver: sectors about its middle. */
static struct sums trace_outline(const struct light *light)
{
    struct sums sums = {0.0, 0.0};
    const double pi = 3.14159265358979323846, length = sqrt(dot(light->normal, light->normal));
    struct cone cone;
    int i;

    make_cone(light, &cone);
    for (i = 0; i < AZIMUTHS; i++) {
        const double azimuth = 2.0 * pi * i / AZIMUTHS;
        const double angle = reach_of(light, &cone, azimuth), half = sin(0.5 * angle);
        double out[3];

        sums.solid += 2.0 * half * half * 2.0 * pi / AZIMUTHS;
        ray(&cone, 0.5 * pi, azimuth, out);
        sums.projected += 2.0 * pi / AZIMUTHS *
                          (light->has_normal
                               ? counted_cosines(light, dot(cone.axis, light->normal) / length,
                                                 dot(out, light->normal) / length, angle)
                               : 2.0 * half * half);
    }
    return sums;
}

/* As errors are given: relative, but to no less than an eighth of the solid angle, since a light
   that is almost below the horizon needs a finer lattice than any here. */
static double apart(double found, double expected, double solid)
{
    return fabs(found - expected) / fmax(expected, solid / 8.0);
}

/* Light i: above the horizon or across it, seen by receivers of every kind. From close by, most of
   a closed light is its far side, and the near side between the points of a lattice; a flat one that
   is seen edge-on is sampled by area between them too. */
static psc_result make_light(uint64_t *seed, const struct shape *shape,
                             const struct test_technique *what, int i, psc_sampler *sampler,
                             struct light *light)
{
    const int far = !shape->flat && what->measure >= PSC_MEASURE_AREA;
    const int place = far ? PLACE_FAR : !shape->flat && i % 6 == 5 ? PLACE_INSIDE : PLACE_ORDINARY;
    const int facing = i % FACINGS == FACING_NONE && !is_offered(what, FACING_NONE) ? FACING_ONE
                                                                                    : i % FACINGS;

    do
        place_light(seed, shape, what, place, i % 2 ? HORIZON_CUT : HORIZON_ABOVE, facing, light);
    while (!fills_cone(light));
    return build_light(sampler, light);
}

/* The library's answers. */
static struct sums ask(const struct light *light, const psc_sampler *sampler)
{
    struct sums answers = {NAN, NAN};

    psc_sampler_solid_angle(sampler, &answers.solid);
    if (light->has_normal)
        psc_sampler_projected_solid_angle(sampler, &answers.projected);
    return answers;
}

/* By projected solid angle only what is above the horizon is sampled. */
static void samples(const struct shape *shape, const struct test_technique *what)
{
    const int whole = what->measure != PSC_MEASURE_PROJECTED_SOLID_ANGLE;
    struct worst solid = {0}, projected = {0};
    uint64_t seed = 150;
    int i;

    for (i = 0; i < LIGHTS; i++) {
        struct test_sampler s;
        struct light light;
        struct sums mean, answers;

        if (make_light(&seed, shape, what, i, make_sampler(&s), &light) != PSC_SUCCESS)
            continue;
        mean = take_samples(&light, s.sampler);
        answers = ask(&light, s.sampler);
        if (whole)
            worst_add(&solid, apart(mean.solid, answers.solid, 0.0), "%s", describe_light(&light));
        if (answers.projected == answers.projected) /* of caps up to a right angle */
            worst_add(&projected, apart(mean.projected, answers.projected, answers.solid), "%s",
                      describe_light(&light));
    }
    if (whole)
        worst_report(&solid, bound(what), "%s, %s: mean of 1 / pdf", shape->name, what->name);
    if (shape->form_factor)
        worst_report(&projected, bound(what), "%s, %s: mean weight", shape->name, what->name);
}

static void rays(const struct shape *shape)
{
    struct worst solid = {0}, projected = {0};
    uint64_t seed = 151;
    int i;

    for (i = 0; i < 4 * LIGHTS; i++) {
        struct test_sampler s;
        struct light light;
        struct sums found, answers;

        if (make_light(&seed, shape, shape->techniques, i, make_sampler(&s), &light) !=
            PSC_SUCCESS)
            continue;
        found = trace_outline(&light);
        answers = ask(&light, s.sampler);
        worst_add(&solid, apart(found.solid, answers.solid, 0.0), "%s", describe_light(&light));
        if (answers.projected == answers.projected)
            worst_add(&projected, apart(found.projected, answers.projected, answers.solid), "%s",
                      describe_light(&light));
    }
    worst_report(&solid, 1e-4, "%s: solid angle by rays", shape->name);
    if (shape->form_factor)
        worst_report(&projected, 1e-4, "%s: projected solid angle by rays", shape->name);
}

int main(void)
{
    const struct test_technique *what;
    int i;

    for (i = 0; shapes[i]; i++) {
        rays(shapes[i]);
        for (FOR_TECHNIQUES(shapes[i], what))
            samples(shapes[i], what);
    }
    return tap_done();
}
