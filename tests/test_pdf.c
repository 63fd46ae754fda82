/* SPDX-License-Identifier: Apache-2.0 */
/*
 * The pdf as a function of direction: its integral is 1, it is positive just inside the edge of
 * the light and exactly 0 just outside, and no sample comes with a direction that it denies.
 */
#include "shapes.h"
#include "vectors.h"
#include "worst.h"

enum { LIGHTS = 12, RINGS = 500, SECTORS = 600 };

static const double pi = 3.14159265358979323846;

static double unit_of(int bits)
{
    return bits == 64 ? 0x1p-53 : 0x1p-24;
}

/* Directions about the middle of the light. */
struct polar {
    double axis[3], x[3], y[3];
    double half_angle; /* of the light, pi from inside */
    double horizon[3]; /* unit normal of the receiver */
};

static void make_polar(const struct light *light, struct polar *p)
{
    const double *g = light->geometry;
    uint64_t seed = 1;
    double length, normal;
    int i;

    for (i = 0; i < 3; i++)
        p->axis[i] = g[i] - (is_distant(light->shape) ? 0.0 : light->position[i]);
    length = sqrt(dot(p->axis, p->axis));
    normal = sqrt(dot(light->normal, light->normal));
    for (i = 0; i < 3; i++) {
        p->axis[i] /= length;
        p->horizon[i] = light->normal[i] / normal;
    }
    p->half_angle = is_distant(light->shape) ? g[3] : g[3] > length ? pi : asin(g[3] / length);
    random_across(&seed, p->axis, p->x);
    cross(p->axis, p->x, p->y);
}

/* An angle beyond the edge that no rounding explains: of the direction's, or of 1 - cosine. */
static double beyond_edge(int bits, const struct polar *p)
{
    return 64.0 * unit_of(bits) * fmax(1.0, tan(p->half_angle / 2.0));
}

static void polar_direction(const struct polar *p, double theta, double phi, double w[3])
{
    int i;

    for (i = 0; i < 3; i++)
        w[i] = cos(theta) * p->axis[i] +
               sin(theta) * (cos(phi) * p->x[i] + sin(phi) * p->y[i]);
}

/* Midpoints, close to each other towards the edge, where the pdf of the area measures has an
   inverse root; and the part outside, which must be exactly 0. */
static void integrate(int bits, const struct polar *p, const psc_sampler *sampler, double *inside,
                      double *outside)
{
    int i, j;

    *inside = *outside = 0.0;
    for (i = 0; i < 2 * RINGS; i++) {
        double x = (i % RINGS + 0.5) / RINGS, theta, step, w[3], pdf;

        if (i < RINGS) {
            theta = p->half_angle * (1.0 - (1.0 - x) * (1.0 - x));
            step = p->half_angle * 2.0 * (1.0 - x) / RINGS;
        } else {
            theta = p->half_angle + beyond_edge(bits, p) + (pi - p->half_angle) * (x * x + 1e-5);
            step = 1.0;
            if (theta >= pi)
                break;
        }
        for (j = 0; j < SECTORS; j++) {
            polar_direction(p, theta, 2.0 * pi * (j + 0.5) / SECTORS, w);
            pdf_any(bits, sampler, w, &pdf);
            *(i < RINGS ? inside : outside) += pdf * sin(theta) * step * 2.0 * pi / SECTORS;
        }
    }
}

static void integrals(const struct shape *shape, const struct test_technique *what)
{
    struct worst one = {0}, none = {0};
    uint64_t seed = 90;
    int i;

    for (i = 0; i < LIGHTS; i++) {
        struct test_sampler s;
        struct light light;
        struct polar p;
        double inside, outside, expected = 1.0, total, area;

        random_light(&seed, shape, what, &light);
        if (build_light(make_sampler(&s), &light) != PSC_SUCCESS)
            continue;
        make_polar(&light, &p);
        integrate(i % 2 ? 32 : 64, &p, s.sampler, &inside, &outside);
        if (what->measure == PSC_MEASURE_AREA && p.half_angle < pi) {
            /* the far side takes its share of samples, and no directions */
            area = 0.5 * (1.0 - sin(p.half_angle));
            psc_sampler_total(s.sampler, &total);
            expected = area;
        }
        worst_add(&one, fabs(inside / expected - 1.0), "f%d %s", i % 2 ? 32 : 64,
                  describe_light(&light));
        worst_add(&none, outside, "f%d %s", i % 2 ? 32 : 64, describe_light(&light));
    }
    worst_report(&one, 1e-3, "%s, %s: integral of the pdf less 1", shape->name, what->name);
    worst_report(&none, 0.0, "%s, %s: pdf outside", shape->name, what->name);
}

/* Directions some roundings outside the edge, or below the horizon, and as many inside. */
static void edges(int bits, const struct shape *shape, const struct test_technique *what)
{
    double step = 64.0 * unit_of(bits);
    long outside = 0, inside = 0, lit = 0, dark = 0;
    uint64_t seed = 91;
    char first[2200] = "none";
    int i, j;

    for (i = 0; i < 400; i++) {
        struct test_sampler s;
        struct light light;
        struct polar p;

        random_light(&seed, shape, what, &light);
        if (build_light(make_sampler(&s), &light) != PSC_SUCCESS)
            continue;
        make_polar(&light, &p);
        if (p.half_angle > 3.0)
            continue;
        for (j = 0; j < 20; j++) {
            double phi = random_between(&seed, 0.0, 2.0 * pi), w[3], pdf;
            int projected = what->measure == PSC_MEASURE_PROJECTED_SOLID_ANGLE;

            polar_direction(&p, p.half_angle + beyond_edge(bits, &p), phi, w);
            pdf_any(bits, s.sampler, w, &pdf);
            outside++;
            if (pdf != 0.0) {
                lit++;
                snprintf(first, sizeof first, "%s phi %a", describe_light(&light), phi);
            }
            polar_direction(&p, p.half_angle - step, phi, w);
            if (projected && !light.flags && dot(w, p.horizon) < step)
                continue;
            if (projected && fabs(dot(w, p.horizon)) < step)
                continue;
            pdf_any(bits, s.sampler, w, &pdf);
            inside++;
            if (!(pdf > 0.0)) {
                dark++;
                snprintf(first, sizeof first, "%s phi %a", describe_light(&light), phi);
            }
        }
    }
    tap_ok(lit == 0 && outside > 1000, "%s, %s, f%d: pdf just outside is 0 (%ld of %ld are not)",
           shape->name, what->name, bits, lit, outside);
    tap_ok(dark == 0 && inside > 1000, "%s, %s, f%d: pdf just inside is not (%ld of %ld are)",
           shape->name, what->name, bits, dark, inside);
    if (lit || dark)
        tap_note("    at %s", first);
}

static void horizon(int bits, const struct shape *shape, const struct test_technique *what)
{
    double step = 64.0 * unit_of(bits);
    long wrong = 0, tried = 0;
    uint64_t seed = 92;
    int i, j, k;

    for (i = 0; i < 400; i++) {
        struct test_sampler s;
        struct light light;
        struct polar p;

        random_light(&seed, shape, what, &light);
        light.flags = 0;
        if (build_light(make_sampler(&s), &light) != PSC_SUCCESS)
            continue;
        make_polar(&light, &p);
        for (j = 0; j < 20; j++) {
            double across[3], w[3], pdf;

            random_across(&seed, p.horizon, across);
            for (k = 0; k < 3; k++)
                w[k] = across[k] - step * p.horizon[k];
            pdf_any(bits, s.sampler, w, &pdf);
            tried++;
            wrong += pdf != 0.0;
        }
    }
    tap_ok(wrong == 0 && tried > 1000, "%s, %s, f%d: pdf below the horizon is 0 (%ld of %ld are not)",
           shape->name, what->name, bits, wrong, tried);
}

/* Every sample that counts has a direction that the pdf knows. */
static void samples(int bits, const struct shape *shape, const struct test_technique *what)
{
    long wrong = 0, tried = 0;
    uint64_t seed = 93;
    char first[2200] = "none";
    int i, j;

    for (i = 0; i < 400; i++) {
        struct test_sampler s;
        struct light light;

        random_light(&seed, shape, what, &light);
        if (build_light(make_sampler(&s), &light) != PSC_SUCCESS)
            continue;
        for (j = 0; j < 40; j++) {
            double u = random_coordinate(&seed), v = random_coordinate(&seed), pdf;
            psc_light_sample_f64 sample;
            psc_result result = sample_any(bits, s.sampler, u, v, &sample);

            /* rounding may take a direction on the horizon below it */
            if (result != PSC_SUCCESS ||
                (light.has_normal && sample.pdf * sample.weight < 8.0 * unit_of(bits)))
                continue;
            pdf_any(bits, s.sampler, sample.direction, &pdf);
            tried++;
            if (!(pdf > 0.0)) {
                wrong++;
                snprintf(first, sizeof first, "%s u %a v %a", describe_light(&light), u, v);
            }
        }
    }
    tap_ok(wrong == 0 && tried > 1000, "%s, %s, f%d: directions of samples have a pdf (%ld of %ld not)",
           shape->name, what->name, bits, wrong, tried);
    if (wrong)
        tap_note("    at %s", first);
}

/* What is known of caps and spheres alone: where exactly they end. */
static void caps(const struct shape *shape)
{
    const struct test_technique *what;
    int bits;

    for (FOR_TECHNIQUES(shape, what)) {
        integrals(shape, what);
        for (bits = 32; bits <= 64; bits += 32)
            edges(bits, shape, what);
    }
}

int main(void)
{
    const struct test_technique *what;
    int i, bits;

    caps(&shape_sphere);
    caps(&shape_cap);
    for (i = 0; shapes[i]; i++)
        for (FOR_TECHNIQUES(shapes[i], what))
            for (bits = 32; bits <= 64; bits += 32) {
                samples(bits, shapes[i], what);
                if (what->measure == PSC_MEASURE_PROJECTED_SOLID_ANGLE)
                    horizon(bits, shapes[i], what);
            }
    return tap_done();
}
