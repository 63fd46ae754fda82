/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Polygons by projected solid angle against 113-bit arithmetic: totals, and the place in the unit
 * square of samples, over sizes from 1e-8 to 2 and needles to 1e-8, with the zenith inside, next to
 * an edge and outside, the horizon cutting and touching.
 *
 * The reference is compared in turn with quadrature of cosine times cosine over squared distance on
 * the light.
 *
 * Lights are made of integers times powers of two, flat without rounding. A sample is taken at its
 * word by its texture coordinates where the light is small, each of which may be some units in its
 * last place off, by its direction where it is large, which may be that of the whole vector; where
 * this carries its place far, nothing is compared.
 */
#include "calls.h"
#include "random.h"
#include "reference_sectors.h"
#include "worst.h"

enum { LIGHTS = 2400, SAMPLES = 6 };

struct flat_light {
    struct reference_polygon p;
    double size, thin;
    int exactly; /* at an edge, or touching, to rounding: on which side is not said */
    const char *kind;
};

/* ---- Lights ---- */

/* x rounded to a multiple of step. */
static double to_grid(double x, double step)
{
    return floor(x / step + 0.5) * step;
}

static double power_below(double x)
{
    int e;

    frexp(x, &e);
    return ldexp(1.0, e - 1);
}

enum { ABOVE, ZENITH_INSIDE, ZENITH_AT_EDGE, HORIZON_CUTS, HORIZON_TOUCHES, CLOSE, KINDS };
static const char *const kinds[KINDS] = {"above",        "zenith inside",   "zenith at an edge",
                                         "horizon cuts", "horizon touches", "close"};

/* Weights of the vertices that add up to a point inside. */
static void point_inside(uint64_t *state, const struct flat_light *light, double q[3])
{
    double sum = 0.0, weight;
    int i, c;

    q[0] = q[1] = q[2] = 0.0;
    for (i = 0; i < light->p.n; i++) {
        weight = random_between(state, 0.1, 1.0);
        sum += weight;
        for (c = 0; c < 3; c++)
            q[c] += weight * light->p.v[i][c];
    }
    for (c = 0; c < 3; c++)
        q[c] /= sum;
}

/* A normal to q, but for `off`. */
static void normal_across(uint64_t *state, const double q[3], double off, double normal[3])
{
    double length = q[0] * q[0] + q[1] * q[1] + q[2] * q[2], along;
    int c;

    random_unit(state, normal);
    along = (normal[0] * q[0] + normal[1] * q[1] + normal[2] * q[2]) / length;
    for (c = 0; c < 3; c++)
        normal[c] += (off - along) * q[c];
}

static void choose_normal(uint64_t *state, int kind, double size, struct flat_light *light)
{
    const int i = random_below(state, light->p.n), next = (i + 1) % light->p.n;
    const double least = kind == ZENITH_AT_EDGE ? 1e-12 : 1e-16;
    const double tiny = light->exactly ? 0.0
                        : (random_below(state, 2) ? -1.0 : 1.0) * random_log(state, least, 0.1);
    double q[3], t;
    int c;

    point_inside(state, light, q);
    switch (kind) {
    case ABOVE:
        random_unit(state, light->p.normal);
        t = random_between(state, 0.0, 2.0);
        for (c = 0; c < 3; c++)
            light->p.normal[c] = q[c] + t * light->p.normal[c];
        break;
    case ZENITH_INSIDE: memcpy(light->p.normal, q, sizeof q); break;
    case ZENITH_AT_EDGE:
        t = random_uniform(state);
        for (c = 0; c < 3; c++) {
            light->p.normal[c] = light->p.v[i][c] + t * (light->p.v[next][c] - light->p.v[i][c]);
            light->p.normal[c] += tiny * (q[c] - light->p.normal[c]);
        }
        break;
    case HORIZON_CUTS: normal_across(state, q, 0.0, light->p.normal); break;
    case HORIZON_TOUCHES:
        normal_across(state, light->p.v[i], tiny * size, light->p.normal);
        break;
    default: random_unit(state, light->p.normal); break;
    }
}

/* A polygon of vertices around an ellipse, `size` long and some share of that wide. */
static void make_light(uint64_t *state, struct flat_light *light)
{
    static const int counts[] = {3, 3, 4, 5, 8, 16};
    const int n = counts[random_below(state, 6)], kind = random_below(state, KINDS);
    const int needle = random_below(state, 3) == 0;
    /* Half of them about where builds in plain arithmetic end. */
    const int ordinary = random_below(state, 2);
    const double size = kind == CLOSE ? random_log(state, 1.0, 100.0)
                        : ordinary    ? random_log(state, 1e-4, 3.0)
                        : n == 3 || !needle ? random_log(state, 1e-8, 2.0)
                                            : random_log(state, 1e-4, 2.0);
    const double least = ordinary ? 0.02 : n == 3 ? 1e-8 : 1e-3;
    const double thin = needle ? random_log(state, least, 1.0) : 1.0, step = power_below(size);
    double center[3], e[2][3];
    int i, c;

    light->p.n = n;
    light->kind = kinds[kind];
    light->size = size;
    light->thin = thin;
    light->exactly = random_below(state, 4) == 0;
    random_unit(state, center);
    random_unit(state, e[0]);
    random_unit(state, e[1]);
    /* Few bits each, so that all products and sums are exact. */
    for (c = 0; c < 3; c++) {
        center[c] = to_grid(center[c], 0x1p-12);
        e[0][c] = to_grid(e[0][c], 0x1p-9) * step;
        e[1][c] = to_grid(e[1][c], 0x1p-9) * step * power_below(thin);
    }
    for (i = 0; i < n; i++) {
        const double angle = 6.283185307179586 * (i + 0.6 * random_uniform(state)) / n;
        const double x = to_grid(cos(angle), 0x1p-12), y = to_grid(sin(angle), 0x1p-12);

        for (c = 0; c < 3; c++)
            light->p.v[i][c] = center[c] + (x * e[0][c] + y * e[1][c]);
    }
    choose_normal(state, kind, size, light);
}

static const char *describe(const struct flat_light *light, double u, double v)
{
    static char text[400];
    int n, i;

    n = snprintf(text, sizeof text, "%s, n %d, u %a v %a normal %a %a %a:", light->kind, light->p.n,
                 u, v, light->p.normal[0], light->p.normal[1], light->p.normal[2]);
    for (i = 0; i < light->p.n && n < (int)sizeof text - 80; i++)
        n += snprintf(text + n, sizeof text - (size_t)n, " %a %a %a", light->p.v[i][0],
                      light->p.v[i][1], light->p.v[i][2]);
    return text;
}

/* ---- The sweep ---- */

/* The direction of a sample: its own, or that of the point of its texture coordinates; the
   `moved`-th number, when that is not negative, moved by `shift`, of coordinates as a share of
   itself. */
static void take_direction(const struct flat_light *light, const psc_light_sample_f64 *sample,
                           int moved, quad shift, quad *d)
{
    const int by_surface = light->size < 0.05, last = light->p.n - 1;
    const double(*v)[3] = light->p.v;
    quad number[3];
    int c;

    for (c = 0; c < 3; c++)
        number[c] = by_surface ? (c < 2 ? sample->surface[c] : 0.0) : sample->direction[c];
    if (moved >= 0)
        number[moved] += by_surface ? number[moved] * shift : shift;
    for (c = 0; c < 3; c++)
        d[c] = by_surface ? v[0][c] + number[0] * ((quad)v[1][c] - v[0][c]) +
                                number[1] * ((quad)v[last][c] - v[0][c])
                          : number[c];
}

/* The point of the square on one of the sides, joined as the library does; *turn is what u may be
   more or less where it counts around the zenith, else 0. */
static void place_on(const struct reference_sectors side[2], quad split, int below, const quad *d,
                     quad uv[2], quad *turn)
{
    reference_in_sectors(side + below, d, uv);
    if (split > 0)
        uv[0] = below ? 1 - uv[0] * (1 - split) : uv[0] * split;
    *turn = side[below].around ? (below ? 1 - split : split) : 0;
}

static quad distance(quad a, quad b, quad turn)
{
    const quad straight = quad_abs(a - b);

    return turn > 0 && turn - straight < straight ? quad_abs(turn - straight) : straight;
}

/* Error of a sample beyond what rounding its numbers explains; returns 0 where that is so much that
   there is nothing to compare. v is not defined where the direction is beside the light by less
   than its rounding. */
static int sample_error(const struct flat_light *light, const struct reference_sectors side[2],
                        int sides, int bits, const psc_light_sample_f64 *sample, double u,
                        double v, double error[2])
{
    const quad rounding = bits == 64 ? 4 * 0x1p-53 : 1.5 * 0x1p-24;
    const quad split = sides == 2 ? side[0].total / (side[0].total + side[1].total) : 1;
    const int below = sides == 2 && (u > split || split == 0);
    quad at[2], turn, allowed[2] = {0, 0};
    quad d[3];
    int i, k;

    take_direction(light, sample, -1, 0, d);
    place_on(side, split, below, d, at, &turn);
    for (i = 0; i < 3; i++) {
        quad moved[2][2], unused;

        take_direction(light, sample, i, rounding, d);
        place_on(side, split, below, d, moved[0], &unused);
        take_direction(light, sample, i, -rounding, d);
        place_on(side, split, below, d, moved[1], &unused);
        for (k = 0; k < 2; k++) {
            const quad up = distance(moved[0][k], at[k], k ? 0 : turn);
            const quad down = distance(moved[1][k], at[k], k ? 0 : turn);

            allowed[k] += up > down ? up : down;
        }
    }
    for (k = 0; k < 2; k++)
        error[k] = 0.0;
    if (allowed[0] > 1.0 / 16 || allowed[1] > 1.0 / 16)
        return 0;
    for (k = 0; k < 2; k++) {
        const quad miss = distance(at[k], k ? v : u, k ? 0 : turn) - allowed[k];

        error[k] = miss > 0 ? (double)miss : 0.0;
    }
    /* At the zenith there is no azimuth, and where the azimuths begin and end the light may have
       no width. */
    if ((turn > 0 || light->kind == kinds[ZENITH_AT_EDGE]) && v < 1e-4)
        error[0] = 0.0;
    if ((below ? 1 - u < 1e-4 * (1 - split) || u - split < 1e-4 * (1 - split)
                            : u < 1e-4 * split || split - u < 1e-4 * split))
        error[1] = 0.0;
    if (!(at[0] == at[0]))
        error[0] = NAN;
    return 1;
}

/* Where next to nothing is above the horizon, 113 bits do not tell how much: the differences of its
   points are rounded too. */
static int told_by_reference(const struct reference_sectors *side)
{
    quad most = 0;
    int i, c;

    for (i = 0; i < side->n; i++)
        for (c = 0; c < 3; c++) {
            const quad off = quad_abs(side->p[i][c] - side->p[0][c]);

            most = off > most ? off : most;
        }
    return !(side->total > 0) || most * 1e-33 < 1e-15 * side->total;
}

static void sweep(void)
{
    struct worst total, place_error[2][2];
    const psc_technique technique =
        make_technique(PSC_MEASURE_PROJECTED_SOLID_ANGLE, PSC_MAP_RADIAL);
    static const double origin[3] = {0.0, 0.0, 0.0};
    uint64_t seed = 5;
    long empty = 0, untold = 0, samples = 0, carried = 0;
    int i, j, bits;

    memset(&total, 0, sizeof total);
    memset(place_error, 0, sizeof place_error);
    for (i = 0; i < LIGHTS; i++) {
        const int sides = 1 + random_below(&seed, 2);
        struct flat_light light;
        struct reference_sectors side[2];
        struct test_sampler s;
        psc_receiver receiver;
        psc_result result;
        quad expected;
        double found;

        make_light(&seed, &light);
        receiver = make_receiver(origin, light.p.normal, sides == 2 ? PSC_RECEIVER_TWO_SIDED : 0);
        reference_sectors(&light.p, 0, side);
        reference_sectors(&light.p, 1, side + 1);
        expected = side[0].total + (sides == 2 ? side[1].total : 0);
        result = psc_build_polygon(make_sampler(&s), &technique, &receiver, (size_t)light.p.n,
                                   light.p.v[0], sizeof light.p.v[0]);
        psc_sampler_total(s.sampler, &found);
        if (!(expected > 0)) {
            empty++;
            tap_ok(result == PSC_EMPTY, "nothing is seen: %s", describe(&light, 0.0, 0.0));
            continue;
        }
        if (!told_by_reference(side) || (sides == 2 && !told_by_reference(side + 1))) {
            untold++;
            continue;
        }
        worst_add(&total, result == PSC_SUCCESS ? (double)quad_abs(found / expected - 1) : NAN,
                  "%s", describe(&light, 0.0, 0.0));
        /* Where the zenith is on an edge, rounding says where azimuths begin. */
        if (light.kind == kinds[ZENITH_AT_EDGE] && (light.exactly || light.thin < 1.0))
            continue;
        for (j = 0; j < SAMPLES && result == PSC_SUCCESS; j++) {
            double u = random_coordinate(&seed), v = random_coordinate(&seed);

            for (bits = 64; bits >= 32; bits -= 32) {
                psc_light_sample_f64 sample;
                double error[2];
                int k;

                if (bits == 32) {
                    u = (float)u;
                    v = (float)v;
                }
                sample.direction[0] = NAN;
                sample_any(bits, s.sampler, u, v, &sample);
                samples++;
                carried += !sample_error(&light, side, sides, bits, &sample, u, v, error);
                for (k = 0; k < 2; k++)
                    worst_add(&place_error[bits == 64][k], error[k], "%s",
                              describe(&light, u, v));
            }
        }
    }
    tap_note("%ld lights of which nothing is seen", empty);
    tap_ok(untold < LIGHTS / 20, "%ld of %d lights are too faint to be compared", untold, LIGHTS);
    tap_ok(carried < samples / 10, "%ld of %ld samples are carried too far by rounding", carried,
           samples);
    worst_report(&total, 3e-14, "total, relative");
    for (bits = 32; bits <= 64; bits += 32) {
        const double bound = bits == 64 ? 3e-14 : 3e-7;

        worst_report(&place_error[bits == 64][0], bound, "f%d: CDF in u", bits);
        worst_report(&place_error[bits == 64][1], bound, "f%d: CDF in v", bits);
    }
}

/* Cosine times cosine over squared distance, over the triangles of a fan, by Simpson's rule along
   and across each. */
static double by_quadrature(const struct flat_light *light)
{
    enum { STEPS = 64 };
    const double *const normal = light->p.normal;
    double sum = 0.0;
    int i, j, k, c;

    for (i = 1; i + 1 < light->p.n; i++) {
        const double *const a = light->p.v[0], *const b = light->p.v[i];
        const double *const d = light->p.v[i + 1];
        double e[2][3], across[3];

        for (c = 0; c < 3; c++) {
            e[0][c] = b[c] - a[c];
            e[1][c] = d[c] - b[c];
        }
        across[0] = e[0][1] * e[1][2] - e[0][2] * e[1][1];
        across[1] = e[0][2] * e[1][0] - e[0][0] * e[1][2];
        across[2] = e[0][0] * e[1][1] - e[0][1] * e[1][0];
        for (j = 0; j <= STEPS; j++)
            for (k = 0; k <= STEPS; k++) {
                const double s = (double)j / STEPS, t = (double)k / STEPS;
                const double weight = (j == 0 || j == STEPS ? 1 : 2 + 2 * (j & 1)) *
                                      (k == 0 || k == STEPS ? 1 : 2 + 2 * (k & 1)) /
                                      (9.0 * STEPS * STEPS);
                double square = 0.0, height = 0.0, facing = 0.0;

                for (c = 0; c < 3; c++) {
                    const double p = a[c] + s * (e[0][c] + t * e[1][c]);

                    square += p * p;
                    height += p * normal[c];
                    facing += p * across[c];
                }
                sum += weight * s * fabs(facing) * height / (square * square);
            }
    }
    return sum / sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
}

static void compare_reference(void)
{
    struct worst worst = {0.0, 0, ""};
    uint64_t seed = 6;
    int i, c;

    while (worst.count < 20) {
        struct flat_light light;
        double least = INFINITY;
        struct reference_sectors side;

        make_light(&seed, &light);
        for (i = 0; i < light.p.n; i++) {
            double height = 0.0;

            for (c = 0; c < 3; c++)
                height += light.p.normal[c] * light.p.v[i][c];
            least = fmin(least, height);
        }
        if (least <= 0.0 || light.size < 0.1 || light.size > 0.5)
            continue;
        reference_sectors(&light.p, 0, &side);
        worst_add(&worst, fabs(by_quadrature(&light) / (double)side.total - 1.0), "%s",
                  describe(&light, 0.0, 0.0));
    }
    worst_report(&worst, 1e-6, "the reference against quadrature on the light");
}

int main(void)
{
    compare_reference();
    sweep();
    return tap_done();
}
