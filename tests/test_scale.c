/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Scaling every length by a power of two, up to 1e30 and down to 1e-30, changes nothing but the
 * lengths that are returned, and these exactly; the lengths of normals never matter.
 */
#include <float.h>
#include <math.h>

#include "shapes.h"
#include "tap.h"

enum { LIGHTS = 60, SAMPLES = 8 };

static void scale_light(const struct light *light, double lengths, double normal,
                        struct light *scaled)
{
    double *g = scaled->geometry;
    const char *part;
    int i;

    *scaled = *light;
    for (i = 0; i < 3; i++) {
        scaled->position[i] *= lengths;
        scaled->normal[i] *= normal;
    }
    for (part = light->shape->parts; *part; g += part_size(*part), part++)
        for (i = 0; i < part_size(*part); i++)
            g[i] *= *part == 'a' ? 1.0 : *part == 'd' ? normal : lengths;
}

/* The sample with lengths divided again; points of distant lights are directions. */
static void unscale(const struct light *light, double lengths, psc_light_sample_f64 *sample)
{
    int i;

    if (is_distant(light->shape))
        return;
    for (i = 0; i < 3; i++)
        sample->point[i] /= lengths;
    sample->distance /= lengths;
}

/* Bit for bit; but a float too small for its full precision after scaling is rounded coarser. */
static int same_sample(int bits, double lengths, const psc_light_sample_f64 *x,
                       const psc_light_sample_f64 *y)
{
    double a[sizeof *x / sizeof(double)], b[sizeof *x / sizeof(double)];
    size_t i;
    int same = 1;

    memcpy(a, x, sizeof *x);
    memcpy(b, y, sizeof *y);
    for (i = 0; i < sizeof a / sizeof *a; i++)
        same &= a[i] == b[i] || (bits == 32 && fabs(a[i] * lengths) < FLT_MIN &&
                                 fabs(a[i] - b[i]) * lengths < 0x1p-149);
    return same;
}

static int same_samples(int bits, const psc_sampler *a, const psc_sampler *b,
                        const struct light *light, double lengths, uint64_t *seed)
{
    int i, same = 1;

    for (i = 0; i < SAMPLES; i++) {
        double u = random_coordinate(seed), v = random_coordinate(seed), uv_a[2], uv_b[2], p, q;
        psc_light_sample_f64 x, y;

        memset(&x, 0, sizeof x);
        memset(&y, 0, sizeof y);
        same &= sample_any(bits, a, u, v, &x) == sample_any(bits, b, u, v, &y);
        unscale(light, lengths, &y);
        same &= same_sample(bits, lengths, &x, &y);
        uv_a[0] = uv_a[1] = uv_b[0] = uv_b[1] = p = q = 0.0;
        same &= pdf_any(bits, a, x.direction, &p) == pdf_any(bits, b, x.direction, &q);
        same &= invert_any(bits, a, x.direction, uv_a) == invert_any(bits, b, x.direction, uv_b);
        same &= p == q && uv_a[0] == uv_b[0] && uv_a[1] == uv_b[1];
    }
    return same;
}

static void scales(const struct shape *shape, const struct test_technique *what, double lengths,
                   double normal)
{
    uint64_t seed = 110;
    int i, bits, failed = -1, built = 0;
    struct light light, scaled;

    for (i = 0; i < LIGHTS && failed < 0; i++) {
        struct test_sampler a, b;
        double total[2] = {0.0, 0.0};
        int area = what->measure >= PSC_MEASURE_AREA;

        random_light(&seed, shape, what, &light);
        scale_light(&light, lengths, normal, &scaled);
        if (build_light(make_sampler(&a), &light) != build_light(make_sampler(&b), &scaled))
            failed = i;
        psc_sampler_total(a.sampler, &total[0]);
        built += psc_sampler_total(b.sampler, &total[1]) == PSC_SUCCESS;
        if (total[0] != total[1] / (area ? lengths * lengths : 1.0))
            failed = i;
        for (bits = 32; bits <= 64; bits += 32)
            if (!same_samples(bits, a.sampler, b.sampler, &light, lengths, &seed))
                failed = i;
    }
    if (!tap_ok(failed < 0 && built > 0, "%s, %s: lengths by %a, normal by %a", shape->name,
                what->name, lengths, normal))
        tap_note("    light %d: %s", failed, describe_light(&light));
}

int main(void)
{
    static const double factors[] = {0x1p-100, 0x1p-52, 0x1p-1, 0x1p+1, 0x1p+60, 0x1p+100};
    const struct test_technique *what;
    size_t j;
    int i;

    for (i = 0; shapes[i]; i++)
        for (FOR_TECHNIQUES(shapes[i], what))
            for (j = 0; j < sizeof factors / sizeof factors[0]; j++) {
                scales(shapes[i], what, factors[j], 1.0);
                scales(shapes[i], what, 1.0, factors[j]);
                scales(shapes[i], what, factors[j], 1.0 / factors[j]);
            }
    return tap_done();
}
