/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Continuity of the maps in the geometry: across every boundary between the cases, the sample of
 * a point of the square moves no farther than in proportion to the change, relative to the size
 * of the light, however small both are.
 *
 * Through beta = 0 the radial map is continuous, but not uniformly so: close to both ends of t a
 * region of the size of beta moves by as much as the light is large, since the part beyond the
 * lune's tip degenerates to a line. There the mean is what is bounded.
 */
#include "angles.h"
#include "caps.h"
#include "shapes.h"
#include "vectors.h"
#include "worst.h"

enum { POINTS = 400 };

/* Change of the direction from one elevation to another, in sines of the half-angle. */
static double change(const psc_sampler *a, double beta_a, const psc_sampler *b, double beta_b,
                     double u, double v, double sine)
{
    double p[3], q[3], half = (beta_b - beta_a) / 2.0, mean = (beta_a + beta_b) / 2.0, d[3];

    psc_sample_offset_f64(a, u, v, p);
    psc_sample_offset_f64(b, u, v, q);
    d[0] = q[0] - p[0] - 2.0 * sin(half) * sin(mean); /* the axis moves too */
    d[1] = q[1] - p[1];
    d[2] = q[2] - p[2] + 2.0 * sin(half) * cos(mean);
    return sqrt(dot(d, d)) / sine;
}

struct scan {
    double most, mean;
};

static struct scan compare(const struct test_technique *what, double alpha, double beta_a,
                           double beta_b)
{
    psc_technique technique = make_technique(what->measure, what->map);
    struct scan scan = {0.0, 0.0};
    struct test_sampler a, b;
    uint64_t seed = 100;
    int i;

    if (psc_build_cap_angles(make_sampler(&a), &technique, alpha, beta_a) != PSC_SUCCESS ||
        psc_build_cap_angles(make_sampler(&b), &technique, alpha, beta_b) != PSC_SUCCESS) {
        scan.most = scan.mean = NAN;
        return scan;
    }
    for (i = 0; i < POINTS; i++) {
        double u = random_uniform(&seed), v = random_uniform(&seed);
        double d = change(a.sampler, beta_a, b.sampler, beta_b, u, v, sin(alpha));

        if (!(d <= scan.most))
            scan.most = d;
        scan.mean += d / POINTS;
    }
    return scan;
}

/* At a boundary, and at 0 and 1 half-angles from it for comparison. */
static void boundary(const struct test_technique *what, const char *name, double place,
                     int in_mean)
{
    static const double alphas[] = {1e-6, 1e-3, 0.1, 0.8, 1.5};
    struct worst worst = {0};
    double step;
    size_t i;

    for (i = 0; i < sizeof alphas / sizeof alphas[0]; i++)
        for (step = 1e-2; step > 1e-13; step /= 10.0) {
            double alpha = alphas[i], at = place * alpha;
            double above = fmin(at + step * alpha, RIGHT_ANGLE), below = at - step * alpha;
            struct scan scan = compare(what, alpha, below, above);

            /* 1e-14 is left for rounding */
            worst_add(&worst, ((in_mean ? scan.mean : scan.most) - 1e-14) / step,
                      "alpha %g, change of elevation %g", alpha, 2.0 * step * alpha);
        }
    worst_report(&worst, 8.0, "%s, %s: motion by change of elevation", what->name, name);
}

/* A lune that vanishes: its thickness changes by a factor. */
static void vanishing(const struct test_technique *what)
{
    static const double alphas[] = {1e-6, 1e-3, 0.1, 0.8, 1.5};
    struct worst worst = {0};
    double margin;
    size_t i;

    for (i = 0; i < sizeof alphas / sizeof alphas[0]; i++)
        for (margin = 1e-2; margin > 1e-11; margin /= 10.0) {
            double a = alphas[i];
            struct scan scan = compare(what, a, -a * (1.0 - margin), -a * (1.0 - 1.1 * margin));
            double length = sqrt(margin); /* of the lune: what moves at its tips */

            worst_add(&worst, scan.most / length, "alpha %g, margin %g", a, margin);
        }
    worst_report(&worst, 0.5, "%s: vanishing lune, motion by its length", what->name);
}

/* A receiver that comes to the surface of the sphere. */
static void surface(const struct test_technique *what)
{
    const double normal[3] = {0.3, -0.2, 0.5}, center[3] = {0.0, 0.0, 1.0};
    struct worst worst = {0};
    double gap;
    int i;

    for (gap = 1e-2; gap > 1e-13; gap /= 10.0) {
        struct test_sampler on, near;
        double touching[3] = {0.0, 0.0, 0.0}, position[3] = {0.0, 0.0, -gap};
        uint64_t seed = 101;

        build_sphere(make_sampler(&on), what, 0, touching, normal, center, 1.0);
        build_sphere(make_sampler(&near), what, 0, position, normal, center, 1.0);
        for (i = 0; i < POINTS; i++) {
            double u = random_uniform(&seed), v = random_uniform(&seed), d[3];
            psc_light_sample_f64 a, b;
            int k;

            memset(&a, 0xff, sizeof a);
            psc_sample_f64(on.sampler, u, v, &a);
            psc_sample_f64(near.sampler, u, v, &b);
            for (k = 0; k < 3; k++)
                d[k] = a.direction[k] - b.direction[k];
            worst_add(&worst, sqrt(dot(d, d) / gap), "gap %g u %a v %a", gap, u, v);
        }
    }
    worst_report(&worst, 4.0, "%s: receiver close to the surface, motion by root of the gap",
                 what->name);
}

int main(void)
{
    const struct test_technique *what;

    for (FOR_TECHNIQUES(&shape_sphere, what)) {
        if (what->measure <= PSC_MEASURE_PROJECTED_SOLID_ANGLE)
            surface(what);
        if (what->measure != PSC_MEASURE_PROJECTED_SOLID_ANGLE)
            continue;
        boundary(what, "beta = alpha", 1.0, 0);
        boundary(what, "beta = 0", 0.0, what->map == PSC_MAP_RADIAL);
        vanishing(what);
    }
    return tap_done();
}
