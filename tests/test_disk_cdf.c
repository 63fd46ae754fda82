/* SPDX-License-Identifier: Apache-2.0 */
/*
 * CDF errors of the maps of elliptic cones by solid angle, from samples as offsets from the axis:
 * semi-arcs from 1e-8 to within 1e-8 of a right angle, quotients of the two down to 1e-8.
 *
 * The shares are integrals of the outline in polar coordinates, 1 - cosine over the azimuth, and
 * of the chords over the angle of their planes. Both are taken in a variable in which they are
 * smooth but for layers at both ends, to which panels get smaller by four.
 */
#include "arcs.h"
#include "gauss.h"
#include "shapes.h"
#include "worst.h"

enum { CONES = 100, SAMPLES = 4, PANELS = 17 };

/* Each number of an offset may be three units in its last place off. */
#define ROUNDINGS 6.0

static const double cdf_bound[2] = {3e-7, 1e-14};

/* A cone: tangents and their inverse squares, sines, in quad from the semi-arcs. */
struct cone {
    quad sine_a, sine_b, tangent_b, p, q;
    quad sectors, chords; /* the integrals of all */
};

/* A density of solid angle. */
typedef quad rate(const struct cone *k, quad t);

/* Per unit of t, tan azimuth = (sin b / sin a) tan t: 1 - cosine of the outline there. */
static quad sector_rate(const struct cone *k, quad t)
{
    const quad x = k->sine_a * quad_cos(t), y = k->sine_b * quad_sin(t);
    const quad square = x * x + y * y; /* cos and sin of the azimuth are x, y by its root */
    const quad tangent2 = square / (k->p * x * x + k->q * y * y), root = quad_sqrt(1 + tangent2);

    return tangent2 / (root * (1 + root)) * (k->sine_a * k->sine_b / square);
}

/* Per unit of t, tan angle = tan beta sin t: half the chord of that plane. */
static quad chord_rate(const struct cone *k, quad t)
{
    const quad height = k->tangent_b * quad_sin(t), square = 1 / (1 + height * height);
    const quad c = quad_cos(t), tangent2 = square * c * c / k->p;

    return quad_sqrt(tangent2 / (1 + tangent2)) * k->tangent_b * c * square;
}

static quad panel(rate *f, const struct cone *k, quad from, quad to)
{
    quad sum = 0;
    int i;

    for (i = 0; i < GAUSS_NODES; i++)
        sum += gauss_weight(i) * f(k, from + (to - from) * gauss_node(i));
    return (to - from) * sum;
}

/* From 0 to high <= pi/2. */
static quad integral(rate *f, const struct cone *k, quad high)
{
    const quad right = quad_pi() / 2, middle = high < right / 2 ? high : right / 2;
    quad sum = 0, step = middle;
    int i;

    for (i = 1; i < PANELS; i++, step /= 4)
        sum += panel(f, k, step / 4, step);
    sum += panel(f, k, 0, step);
    for (i = 1, step = right - middle; i <= PANELS && right - step < high; i++, step /= 4) {
        const quad to = i < PANELS ? right - step / 4 : right;

        sum += panel(f, k, right - step, to < high ? to : high);
    }
    return sum;
}

static struct cone cone_of(double alpha, double beta)
{
    const quad ca = quad_cos(alpha), cb = quad_cos(beta);
    struct cone c;

    c.sine_a = quad_sin(alpha);
    c.sine_b = quad_sin(beta);
    c.tangent_b = c.sine_b / cb;
    c.p = quad_square(ca / c.sine_a);
    c.q = quad_square(cb / c.sine_b);
    c.sectors = integral(sector_rate, &c, quad_pi() / 2);
    c.chords = integral(chord_rate, &c, quad_pi() / 2);
    return c;
}

/* ---- From a sample to its place in the square */

/* Inverse of the map of [SC97]: where the square's point is in polar coordinates. */
static void square_to_polar(double u, double v, quad *square, quad *turn)
{
    const quad a = 2 * (quad)u - 1, b = 2 * (quad)v - 1;
    const int along = quad_abs(a) > quad_abs(b);
    const quad r = along ? a : b;
    const quad angle = along ? b / a / 8 : b != 0 ? (quad)0.25 - a / b / 8 : 0;

    *square = r * r;
    *turn = r < 0 ? angle + (quad)0.5 : angle;
}

static double around(quad a, quad b)
{
    quad d = quad_abs(a - b);

    while (d > 0.5)
        d = quad_abs(d - 1);
    return (double)d;
}

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
    const quad p = offset[0] / k->sine_a, q = offset[1] / k->sine_b;
    const quad t = quad_atan2(quad_abs(q), quad_abs(p));
    const quad square = quad_square(quad_sin(t) * k->sine_b) + quad_square(quad_cos(t) * k->sine_a);
    const quad c2 = quad_square(quad_cos(t) * k->sine_a) / square;
    const quad tangent2 = 1 / (k->p * c2 + k->q * (1 - c2)), root = quad_sqrt(1 + tangent2);
    const quad inner = versine_of(offset) / (tangent2 / (root * (1 + root)));
    quad turn = integral(sector_rate, k, t) / k->sectors / 4;
    quad wanted = u, outwards = 1 - (quad)v;

    turn = p < 0 ? (quad)0.5 - turn : turn;
    turn = q < 0 ? 1 - turn : turn;
    if (map == PSC_MAP_CONCENTRIC)
        square_to_polar(u, v, &outwards, &wanted);
    error[0] = p == 0 && q == 0 ? 0.0 : around(turn, wanted) * (double)outwards;
    error[1] = (double)quad_abs(inner - outwards) - 2.0 * ROUNDINGS * unit * (double)outwards;
}

/* The share of the cone between the middle and the chord of an offset, and where the sample with
   the coordinate v is on that chord less where it should be, in sines of alpha. */
static void chord_place(const struct cone *k, double v, const quad offset[3], quad place[2])
{
    const quad pi = quad_pi(), z = 1 + offset[2];
    const quad sine = quad_abs(offset[1]) / (z * k->tangent_b);
    const quad t = sine < 1 ? quad_asin(sine) : pi / 2;
    const quad square = 1 / (1 + quad_square(k->tangent_b * quad_sin(t)));
    const quad tangent2 = square * quad_square(quad_cos(t)) / k->p;
    const quad part = integral(chord_rate, k, t) / k->chords / 2;

    place[0] = (offset[1] < 0 ? -part : part) + (quad)0.5;
    place[1] = (offset[0] - (2 * (quad)v - 1) * quad_sqrt(tangent2 / (1 + tangent2))) / k->sine_a;
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
        cone = cone_of(alpha, beta);
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
