/* SPDX-License-Identifier: Apache-2.0 */
/*
 * The inverse undoes the map, both ways round, and the pdf of a direction is the one it was
 * sampled with.
 *
 * A direction is rounded, and so is a point of the square: how far the map, or the pdf, carries
 * that rounding is measured next to each sample and is no error.
 */
#include "shapes.h"
#include "vectors.h"
#include "worst.h"

enum { LIGHTS = 500, SAMPLES = 20 };

#define ROUNDINGS 32.0

static double unit_of(int bits)
{
    return bits == 64 ? 0x1p-53 : 0x1p-24;
}

static double distance(const double a[3], const double b[3])
{
    double d[3] = {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
    return sqrt(dot(d, d));
}

static double clamp(double x)
{
    return x < 0.0 ? 0.0 : x > 1.0 ? 1.0 : x;
}

/* Both ends of the square's v may be one line in the middle of the light. */
static double around(double a, double b)
{
    double d = fabs(a - b);
    return d > 0.5 ? fabs(1.0 - d) : d;
}

/* How far the direction moves when a point of the square does by some roundings, or by what some
   roundings of a direction move it. */
static double motion(int bits, const psc_sampler *sampler, const double uv[2],
                     const double open[2], const double direction[3])
{
    double most = 0.0;
    int i, sign;

    for (i = 0; i < 2; i++)
        for (sign = -1; sign <= 1; sign += 2) {
            double step = (ROUNDINGS + 8.0 * open[i]) * unit_of(bits);
            double u = clamp(uv[0] + (i == 0) * sign * step);
            double v = clamp(uv[1] + (i == 1) * sign * step);
            psc_light_sample_f64 there;

            sample_any(bits, sampler, u, v, &there);
            most = fmax(most, distance(there.direction, direction));
        }
    return most;
}

/* How far a point of the square moves when the direction does by one rounding: from the
   derivatives of the map; of its projection where that is what the map is uniform in, since a
   place near the horizon is known from there. */
static void sensitivity(const psc_sampler *sampler, const struct light *light, double u, double v,
                        double open[2])
{
    const int projected = light->what->measure == PSC_MEASURE_PROJECTED_SOLID_ANGLE;
    const double *normal = light->normal;
    const double step = 1e-7;
    psc_light_sample_f64 a, b;
    double along[2][3], area[3], size;
    int i, k;

    for (k = 0; k < 2; k++) {
        double du = (k == 0) * step, dv = (k == 1) * step;
        psc_sample_f64(sampler, u - du, v - dv, &a);
        psc_sample_f64(sampler, u + du, v + dv, &b);
        for (i = 0; i < 3; i++)
            along[k][i] = (b.direction[i] - a.direction[i]) / (2.0 * step);
        if (projected) {
            double up = dot(along[k], normal) / dot(normal, normal);

            for (i = 0; i < 3; i++)
                along[k][i] -= up * normal[i];
        }
    }
    cross(along[0], along[1], area);
    size = sqrt(dot(area, area));
    open[0] = sqrt(dot(along[1], along[1])) / size;
    open[1] = sqrt(dot(along[0], along[0])) / size;
}

/* How far the pdf of a direction moves when that does by some roundings. */
static double pdf_motion(int bits, const psc_sampler *sampler, const double direction[3],
                         double pdf)
{
    double sum = 0.0;
    int i, sign;

    for (i = 0; i < 3; i++) {
        double most = 0.0;
        for (sign = -1; sign <= 1; sign += 2) {
            double moved[3] = {direction[0], direction[1], direction[2]}, there;
            moved[i] += sign * 8.0 * unit_of(bits); /* of the sample and of the density */
            pdf_any(bits, sampler, moved, &there);
            most = fmax(most, fabs(there - pdf)); /* all of it, at the edge */
        }
        sum += most;
    }
    return sum;
}

/* Whether roundings reach the limb, where the density of a closed light sampled by area has no
   bound. */
static int on_limb(int bits, const psc_light_sample_f64 *s)
{
    const double cosine = dot(s->direction, s->normal);

    return cosine * cosine < 256.0 * unit_of(bits);
}

struct errors {
    struct worst direction, square, pdf;
};

static void one_sample(int bits, psc_sampler *sampler, const struct light *light, double u,
                       double v, struct errors *e)
{
    psc_light_sample_f64 here, there;
    double uv[2] = {NAN, NAN}, pdf = NAN, unit = unit_of(bits), off, open[2];
    const char *text = "%s f%d u %a v %a", *name = describe_light(light);
    const int closed = light->what->measure >= PSC_MEASURE_AREA && !light->shape->flat;

    if (sample_any(bits, sampler, u, v, &here) == PSC_CULLED && closed)
        return; /* a direction belongs to the near side, whose sample it is not */
    if (is_rejected(light->what, here.pdf))
        return;
    sensitivity(sampler, light, u, v, open);
    invert_any(bits, sampler, here.direction, uv);
    memset(&there, 0xff, sizeof there);
    sample_any(bits, sampler, uv[0], uv[1], &there);
    off = distance(here.direction, there.direction);
    if (!(off <= ROUNDINGS * unit))
        off -= motion(bits, sampler, uv, open, there.direction);
    worst_add(&e->direction, off / unit, text, name, bits, u, v);

    off = fmax(fabs(uv[0] - u) / (1.0 + open[0]), around(uv[1], v) / (1.0 + open[1]));
    worst_add(&e->square, uv[0] == uv[0] ? off / unit : NAN, text, name, bits, u, v);

    if (closed && on_limb(bits, &here))
        return;
    pdf_any(bits, sampler, here.direction, &pdf);
    off = pdf == here.pdf ? 0.0 : fabs(pdf - here.pdf);
    if (!(off <= ROUNDINGS * unit * pdf))
        off -= pdf_motion(bits, sampler, here.direction, pdf);
    worst_add(&e->pdf, off / (pdf * unit), text, name, bits, u, v);
}

static void round_trips(const struct shape *shape, const struct test_technique *what)
{
    struct errors e[2];
    uint64_t seed = 40;
    int i, j, wide;

    memset(e, 0, sizeof e);
    for (i = 0; i < LIGHTS; i++) {
        struct test_sampler s;
        struct light light;

        random_light(&seed, shape, what, &light);
        if (build_light(make_sampler(&s), &light) != PSC_SUCCESS)
            continue;
        for (j = 0; j < SAMPLES; j++) {
            double u = (float)random_between(&seed, 1e-3, 0.999);
            double v = (float)random_between(&seed, 1e-3, 0.999);
            for (wide = 0; wide < 2; wide++)
                one_sample(wide ? 64 : 32, s.sampler, &light, u, v, &e[wide]);
        }
    }
    for (wide = 0; wide < 2; wide++) {
        const int bits = wide ? 64 : 32;

        worst_report(&e[wide].direction, ROUNDINGS,
                     "%s, %s, f%d: direction there and back, roundings", shape->name, what->name,
                     bits);
        worst_report(&e[wide].square, 2.0 * ROUNDINGS,
                     "%s, %s, f%d: square there and back, roundings of the direction",
                     shape->name, what->name, bits);
        worst_report(&e[wide].pdf, ROUNDINGS, "%s, %s, f%d: pdf of a sample, roundings",
                     shape->name, what->name, bits);
    }
}

int main(void)
{
    const struct test_technique *what;
    int i;

    for (i = 0; shapes[i]; i++)
        for (FOR_TECHNIQUES(shapes[i], what))
            round_trips(shapes[i], what);
    return tap_done();
}
