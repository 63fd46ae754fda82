/* SPDX-License-Identifier: Apache-2.0 */
/*
 * CDF errors over random caps built from angles, from samples as offsets from the axis: half
 * angles from 1e-8 to a right angle, elevations to within 1e-12 of every boundary of the cases.
 */
#include "angles.h"
#include "caps.h"
#include "place.h"
#include "shapes.h"
#include "worst.h"

enum { CAPS = 1000, SAMPLES = 6 };

static const double cdf_bound[2] = {3e-7, 1e-14}, sphere_bound[2] = {5e-7, 1e-15};

static void as_it_is(const void *context, const quad number[3], quad offset[3])
{
    (void)context;
    memcpy(offset, number, 3 * sizeof *offset);
}

/* An offset, each number of which may be three units in its last place off. That along x is
   computed from the centre of the projection, and rounded with respect to that. */
static struct place_sample observe(const struct reference *r, int bits, const double offset[3])
{
    double unit = bits == 64 ? 0x1p-53 : 0x1p-24;
    struct place_sample sample = {{0}, {0}, as_it_is, NULL, 1};
    int i;

    for (i = 0; i < 3; i++) {
        sample.number[i] = offset[i];
        sample.rounding[i] = 6.0 * unit * fabs(offset[i]);
    }
    sample.rounding[0] += 6.0 * unit * (double)(r->cb * r->height);
    return sample;
}

/* Distance of axis + offset from the unit sphere, in units of the light's size. */
static double sphere_error(const struct reference *r, const double offset[3])
{
    quad x = offset[0], y = offset[1], z = offset[2];
    quad power = 2 * (r->cb * x + r->sb * z) + (x * x + y * y + z * z);
    return (double)(quad_abs(power) / (2 * r->sa));
}

static void sample_offset(int bits, const psc_sampler *sampler, double u, double v,
                          double offset[3])
{
    float f[3];
    int i;

    if (bits == 64) {
        psc_sample_offset_f64(sampler, u, v, offset);
        return;
    }
    psc_sample_offset_f32(sampler, (float)u, (float)v, f);
    for (i = 0; i < 3; i++)
        offset[i] = f[i];
}

static void sweep(const struct test_technique *what)
{
    struct worst s_error[2], t_error[2], off_sphere[2];
    uint64_t seed = 20;
    int i, j, wide;

    memset(s_error, 0, sizeof s_error);
    memset(t_error, 0, sizeof t_error);
    memset(off_sphere, 0, sizeof off_sphere);
    for (i = 0; i < CAPS; i++) {
        psc_technique technique = make_technique(what->measure, what->map);
        struct test_sampler s;
        struct reference r;
        double alpha, beta;
        psc_result result;

        random_cap(&seed, &alpha, &beta);
        reference_from_angles(&r, alpha, beta);
        result = psc_build_cap_angles(make_sampler(&s), &technique, alpha, beta);
        if (r.visible == REFERENCE_EMPTY)
            continue;
        for (j = 0; j < SAMPLES; j++) {
            double u = random_coordinate(&seed), v = random_coordinate(&seed);

            for (wide = 1; wide >= 0; wide--) {
                double offset[3] = {NAN, NAN, NAN}, error[2];
                const char *text = "cap %d sample %d: alpha %a beta %a u %a v %a";
                struct place_sample sample;

                if (!wide) {
                    u = (float)u;
                    v = (float)v;
                }
                if (result == PSC_SUCCESS)
                    sample_offset(wide ? 64 : 32, s.sampler, u, v, offset);
                sample = observe(&r, wide ? 64 : 32, offset);
                place_error(what, &r, u, v, &sample, error);
                worst_add(&s_error[wide], error[0], text, i, j, alpha, beta, u, v);
                worst_add(&t_error[wide], error[1], text, i, j, alpha, beta, u, v);
                worst_add(&off_sphere[wide], sphere_error(&r, offset), text, i, j, alpha, beta,
                          u, v);
            }
        }
    }
    for (wide = 0; wide < 2; wide++) {
        const char *bits = wide ? "f64" : "f32";
        worst_report(&s_error[wide], cdf_bound[wide], "%s, %s: CDF in s", what->name, bits);
        worst_report(&t_error[wide], cdf_bound[wide], "%s, %s: CDF in t", what->name, bits);
        worst_report(&off_sphere[wide], sphere_bound[wide], "%s, %s: unit length", what->name,
                     bits);
    }
}

int main(void)
{
    const struct test_technique *what;

    for (FOR_TECHNIQUES(&shape_cap, what))
        sweep(what);
    return tap_done();
}
