/* SPDX-License-Identifier: Apache-2.0 */
/*
 * CDF errors of the maps of elliptic cones by solid angle, from samples as offsets from the axis:
 * semi-arcs from 1e-8 to within 1e-8 of a right angle, quotients of the two down to 1e-8.
 */
#include "arcs.h"
#include "cone_shares.h"
#include "shapes.h"
#include "worst.h"

enum { CONES = 100, SAMPLES = 4 };

/* Each number of an offset may be three units in its last place off. */
#define ROUNDINGS 6.0

static const double cdf_bound[2] = {3e-7, 1e-14};

/* 1 - z of an offset: from whichever of x, y and z has more digits. */
static quad versine_of(const double offset[3])
{
    const quad square = quad_square(offset[0]) + quad_square(offset[1]);

    return square < 0.5 ? square / (1 + quad_sqrt(1 - square)) : -(quad)offset[2];
}

/* Around the axis, and outwards; in the middle there is no azimuth. */
static void polar_error(psc_map map, const struct cone *k, double unit, double u, double v,
                        const double offset[3], double error[2])
{
    const quad at[3] = {offset[0], offset[1], offset[2]};
    quad wanted = u, outwards = 1 - (quad)v, place[2];

    polar_place(k, at, versine_of(offset), place);
    if (map == PSC_MAP_CONCENTRIC)
        square_to_polar(u, v, &outwards, &wanted);
    error[0] = at[0] == 0 && at[1] == 0 ? 0.0 : around(place[0], wanted) * (double)outwards;
    error[1] = (double)quad_abs(place[1] - outwards) - 2.0 * ROUNDINGS * unit * (double)outwards;
}

/* Less what the rounding of the offset explains: at the ends of the map, and where z is small, it
   moves the place of a direction. */
static void chord_error(const struct cone *k, double unit, double u, double v,
                        const double offset[3], double error[2])
{
    quad at[3], here[2], there[2];
    int i;

    for (i = 0; i < 3; i++)
        at[i] = offset[i];
    if (at[0] * at[0] + at[1] * at[1] < 0.5)
        at[2] = -versine_of(offset);
    chord_place(k, v, at, here);
    error[0] = (double)quad_abs(here[0] - u);
    error[1] = (double)quad_abs(here[1]);
    for (i = 0; i < 3; i++) {
        const quad step = ROUNDINGS * unit * quad_abs(at[i]);
        double most[2] = {0.0, 0.0};
        int sign, m;

        for (sign = -1; sign <= 1; sign += 2) {
            quad moved[3] = {at[0], at[1], at[2]};

            moved[i] += sign * step;
            chord_place(k, v, moved, there);
            for (m = 0; m < 2; m++)
                most[m] = fmax(most[m], (double)quad_abs(there[m] - here[m]));
        }
        for (m = 0; m < 2; m++)
            error[m] -= most[m];
    }
}

/* ---- The sweep */

static void random_arcs(uint64_t *seed, double *alpha, double *beta)
{
    const double right = 1.5707963267948966;

    switch (random_below(seed, 3)) {
    case 0: *alpha = random_log(seed, 1e-8, 1.5); break;
    case 1: *alpha = right - random_log(seed, 1e-8, 0.5); break;
    default: *alpha = random_between(seed, 0.01, 1.5); break;
    }
    switch (random_below(seed, 4)) {
    case 0: *beta = *alpha * random_log(seed, 1e-8, 1.0); break;
    case 1: *beta = *alpha * (1.0 - random_log(seed, 1e-12, 0.5)); break;
    case 2: *beta = *alpha; break;
    default: *beta = *alpha * random_between(seed, 0.01, 1.0); break;
    }
}

static void sample_offset(int bits, const psc_sampler *sampler, double u, double v,
                          double offset[3])
{
    float f[3];
    int i;

    if (bits == 64) {
        psc_sample_cone_offset_f64(sampler, u, v, offset);
        return;
    }
    psc_sample_cone_offset_f32(sampler, (float)u, (float)v, f);
    for (i = 0; i < 3; i++)
        offset[i] = f[i];
}

static void sweep(const struct test_technique *what)
{
    struct worst first[2], second[2];
    uint64_t seed = 200;
    int i, j, wide;

    memset(first, 0, sizeof first);
    memset(second, 0, sizeof second);
    for (i = 0; i < CONES; i++) {
        const psc_technique technique = make_technique(what->measure, what->map);
        struct test_sampler s;
        double alpha, beta;
        struct cone cone;

        random_arcs(&seed, &alpha, &beta);
        cone = cone_of(quad_sin(alpha), quad_cos(alpha), quad_sin(beta), quad_cos(beta));
        psc_build_ellipse_arcs(make_sampler(&s), &technique, alpha, beta);
        for (j = 0; j < SAMPLES; j++) {
            double u = random_coordinate(&seed), v = random_coordinate(&seed);

            for (wide = 1; wide >= 0; wide--) {
                const char *text = "alpha %a beta %a u %a v %a";
                const double unit = wide ? 0x1p-53 : 0x1p-24;
                double offset[3] = {NAN, NAN, NAN}, error[2];

                if (!wide) {
                    u = (float)u;
                    v = (float)v;
                }
                if (!wide && what->map == PSC_MAP_PARALLEL && alpha > 1.57)
                    continue; /* floats hold no z that tells one chord from another: golden.c */
                sample_offset(wide ? 64 : 32, s.sampler, u, v, offset);
                if (what->map == PSC_MAP_PARALLEL)
                    chord_error(&cone, unit, u, v, offset, error);
                else
                    polar_error(what->map, &cone, unit, u, v, offset, error);
                worst_add(&first[wide], error[0], text, alpha, beta, u, v);
                worst_add(&second[wide], error[1], text, alpha, beta, u, v);
            }
        }
    }
    for (wide = 0; wide < 2; wide++) {
        const char *bits = wide ? "f64" : "f32";

        worst_report(&first[wide], cdf_bound[wide], "%s, %s: CDF of the sector or chord",
                     what->name, bits);
        worst_report(&second[wide], cdf_bound[wide], "%s, %s: CDF in it", what->name, bits);
    }
}

int main(void)
{
    const struct test_technique *what;

    for (FOR_TECHNIQUES(&shape_ellipse, what))
        if (what->measure == PSC_MEASURE_SOLID_ANGLE && what->map <= PSC_MAP_CONCENTRIC)
            sweep(what);
    return tap_done();
}
