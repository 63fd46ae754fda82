/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Random samples counted in cells of directions, against how many rays of an even lattice hit the
 * light there by plain geometry, each weighted with the density that the measure has: the
 * chi-square statistic; and that no sample lies outside all cells that were hit.
 */
#include "chi_square.h"
#include "rays.h"
#include "tap.h"

enum { LIGHTS = 5, RINGS = 9, SECTORS = 16, CELLS = RINGS * SECTORS, SAMPLES = 40000,
       RAYS = 300000 };

/* The cell of a direction: rings of equal solid angle about the cone's axis, cut into sectors. */
static int cell_of(const struct cone *cone, const double w[3])
{
    const double turn = 6.283185307179586;
    double off[3], h, ring, sector;

    subtract3(w, cone->axis, off);
    h = 0.5 * dot(off, off);
    ring = h / cone->versine * RINGS;
    sector = (atan2(dot(w, cone->y), dot(w, cone->x)) / turn + 0.5) * SECTORS;
    return (int)fmin(ring, RINGS - 1.0) * SECTORS + (int)fmin(sector, SECTORS - 1.0);
}

/* The density of a direction that hits the light, but for a factor. */
static double density(const struct light *light, const psc_sampler *sampler, const double w[3],
                      double distance)
{
    double point[3], normal[3], pdf = NAN;
    int i;

    if (is_uneven(light->what)) {
        psc_pdf_f64(sampler, w, &pdf);
        return pdf;
    }
    switch (light->what->measure) {
    case PSC_MEASURE_SOLID_ANGLE: return 1.0;
    case PSC_MEASURE_PROJECTED_SOLID_ANGLE: return cosine_at(light, w);
    default:
        for (i = 0; i < 3; i++)
            point[i] = light->position[i] + distance * w[i];
        light->shape->surface(light->geometry, point, normal);
        return distance * distance / fabs(dot(normal, w));
    }
}

/* Whether rays tell how much there is in a cell: not where a flat light has parts that are seen
   edge-on, with most of its area in a few rays. */
static int is_even(const struct light *light, const psc_sampler *sampler)
{
    double sum = 0.0, most = 0.0;
    struct cone cone;
    int i;

    make_cone(light, &cone);
    for (i = 0; i < 2000; i++) {
        double w[3], distance, d;

        cone_direction(&cone, i, w);
        distance = light->shape->hit(light->geometry, light->position, w);
        d = distance < 0.0 ? 0.0 : density(light, sampler, w, distance);
        most = fmax(most, d);
        sum += d;
    }
    return most < 0.03 * sum;
}

/* Returns the integral of the density over all directions that hit. */
static double expect(const struct light *light, const psc_sampler *sampler,
                     const struct cone *cone, double expected[CELLS], double touched[CELLS])
{
    double total = 0.0;
    int i;

    memset(expected, 0, CELLS * sizeof *expected);
    memset(touched, 0, CELLS * sizeof *touched);
    for (i = 0; i < RAYS; i++) {
        double w[3], distance, d;
        int cell;

        cone_direction(cone, i, w);
        distance = light->shape->hit(light->geometry, light->position, w);
        if (distance < 0.0)
            continue;
        cell = cell_of(cone, w);
        d = density(light, sampler, w, distance);
        expected[cell] += d;
        touched[cell] += 1.0;
        total += d;
    }
    for (i = 0; i < CELLS; i++)
        expected[i] /= total;
    return total * cone->solid_angle / RAYS;
}

/* Samples of the near side. */
static long count(int bits, const struct light *light, const psc_sampler *sampler,
                  const struct cone *cone, long counted[CELLS])
{
    psc_description d = {sizeof d, 0, 0, 0, 0, 0};
    uint64_t seed = 161;
    long all = 0;
    int i, far;

    psc_sampler_describe(sampler, &d);
    far = !light->shape->flat && d.visibility != PSC_CASE_INSIDE &&
          light->what->measure == PSC_MEASURE_AREA;
    memset(counted, 0, CELLS * sizeof *counted);
    for (i = 0; i < SAMPLES; i++) {
        const double u = random_uniform(&seed), v = random_uniform(&seed);
        psc_light_sample_f64 s;

        memset(&s, 0xff, sizeof s);
        sample_any(bits, sampler, u, v, &s);
        if ((far && dot(s.direction, s.normal) > 0.0) || is_rejected(light->what, s.pdf))
            continue;
        counted[cell_of(cone, s.direction)]++;
        all++;
    }
    return all;
}

static void test(int bits, int number, const struct light *light, const psc_sampler *sampler)
{
    static double expected[CELLS], touched[CELLS];
    static long counted[CELLS];
    struct cone cone;
    double x2, limit, integral;
    long all, stray = 0;
    int freedom, i;

    make_cone(light, &cone);
    integral = expect(light, sampler, &cone, expected, touched);
    all = count(bits, light, sampler, &cone, counted);
    if (is_uneven(light->what))
        tap_ok(fabs(integral - (double)all / SAMPLES) < (is_tabulated(light->what) ? 8e-3 : 2e-3),
               "%s, %s, light %d: integral of the pdf %.4f, %.4f of samples are kept",
               light->shape->name, light->what->name, number, integral, (double)all / SAMPLES);
    for (i = 0; i < CELLS; i++) {
        /* a cell whose corner the light just reaches may have been missed by all rays */
        if (touched[i] == 0.0 && counted[i] > 2 + all / 5000)
            stray += counted[i];
        expected[i] *= (double)all;
    }
    x2 = chi_square(counted, expected, CELLS, &freedom);
    limit = chi_square_limit(freedom);
    if (!tap_ok(x2 <= limit && stray == 0 && all > 100 && freedom > 3,
                "%s, %s, f%d, light %d: %.0f of at most %.0f with %d degrees of freedom, %ld stray",
                light->shape->name, light->what->name, bits, number, x2, limit, freedom, stray))
        tap_note("    %s", describe_light(light));
}

static void directions(const struct shape *shape, const struct test_technique *what)
{
    uint64_t seed = 160;
    int i;

    for (i = 0; i < LIGHTS; i++) {
        const int far = !shape->flat && what->measure >= PSC_MEASURE_AREA;
        struct test_sampler s;
        struct light light;
        int facing;

        do {
            facing = (int)random_below(&seed, FACINGS);
        } while (!is_offered(what, facing));
        do
            place_light(&seed, shape, what, far ? PLACE_FAR : PLACE_ORDINARY,
                        i % 2 ? HORIZON_ABOVE : HORIZON_CUT, facing, &light);
        while (build_light(make_sampler(&s), &light) != PSC_SUCCESS || !fills_cone(&light) ||
               !is_even(&light, s.sampler));
        test(i % 2 ? 32 : 64, i, &light, s.sampler);
    }
}

int main(void)
{
    const struct test_technique *what;
    int i;

    for (i = 0; shapes[i]; i++)
        for (FOR_TECHNIQUES(shapes[i], what))
            directions(shapes[i], what);
    return tap_done();
}
