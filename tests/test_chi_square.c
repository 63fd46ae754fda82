/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Random samples of spheres counted in cells whose probabilities are exact: the chi-square
 * statistic. test_directions.c does so for all shapes, with cells that are only measured.
 *
 * The cells are no images of a grid on the square. For projected solid angle they are strips of
 * the projection, cut across, with the area between chords of equations 13 and 14 of [UG18]
 * (those below the horizon of a two-sided receiver apart). For solid angle and area they are
 * rings about the light's axis, cut into sectors. Also counted: that nothing falls outside.
 */
#include "chi_square.h"
#include "shapes.h"
#include "vectors.h"
#include "tap.h"

enum { ROWS = 11, COLUMNS = 13, SIDES = 2, SAMPLES = 200000, CUTS = 4000 };

struct grid {
    double expected[SIDES][ROWS][COLUMNS];
    long counted[SIDES][ROWS][COLUMNS], outside;
};

/* A light over the origin with normal (0,0,1) and axis (cos b, 0, sin b). */
struct setting {
    const struct test_technique *what;
    uint32_t flags;
    double alpha, beta;
};

/* The chord of the upper side at y, empty if low >= high. */
static void chord(double alpha, double beta, double y, double *low, double *high)
{
    double sa = sin(alpha), x_e = cos(alpha) * cos(beta), a_x = sa * sin(beta);
    double root = sqrt(fmax(1.0 - y * y / (sa * sa), 0.0)), x_l = cos(alpha) / cos(beta);

    *low = x_e - a_x * root;
    *high = alpha > fabs(beta) && y * y <= 1.0 - x_l * x_l ? sqrt(1.0 - y * y) : x_e + a_x * root;
}

static double overlap(double low, double high, double from, double to)
{
    return fmax(fmin(high, to) - fmax(low, from), 0.0);
}

/* Cells of the projection: between -sin a and sin a in y, and the bounds of x in x. */
static void strip(const struct setting *s, double *x0, double *x1, double *y1)
{
    double low, high;

    *y1 = sin(s->alpha);
    *x0 = cos(s->alpha + fabs(s->beta));
    chord(s->alpha, fabs(s->beta), 0.0, &low, &high);
    *x1 = high;
}

static void expect_projected(const struct setting *s, struct grid *g)
{
    double x0, x1, y1, total = 0.0;
    int side, row, column, i;

    strip(s, &x0, &x1, &y1);
    for (side = 0; side < (s->flags ? SIDES : 1); side++)
        for (row = 0; row < ROWS; row++)
            for (i = 0; i < CUTS; i++) {
                double y = y1 * (2.0 * (row + (i + 0.5) / CUTS) / ROWS - 1.0), low, high;
                double sign = side ? -1.0 : 1.0;

                chord(s->alpha, sign * s->beta, y, &low, &high);
                for (column = 0; column < COLUMNS; column++) {
                    double from = x0 + (x1 - x0) * column / COLUMNS;
                    double part = overlap(low, high, from, from + (x1 - x0) / COLUMNS);
                    g->expected[side][row][column] += part;
                    total += part;
                }
            }
    for (side = 0; side < SIDES; side++)
        for (row = 0; row < ROWS; row++)
            for (column = 0; column < COLUMNS; column++)
                g->expected[side][row][column] *= SAMPLES / total;
}

static void count(struct grid *g, int side, double row, double column)
{
    const double slack = 1e-5; /* rounding of floats at the rim */

    if (!(row > -slack && row < ROWS + slack && column > -slack && column < COLUMNS + slack)) {
        g->outside++;
        return;
    }
    g->counted[side][(int)fmin(fmax(row, 0.0), ROWS - 1.0)]
              [(int)fmin(fmax(column, 0.0), COLUMNS - 1.0)]++;
}

static void count_projected(const struct setting *s, const psc_light_sample_f64 *sample,
                            struct grid *g)
{
    const double *d = sample->direction;
    double x0, x1, y1, low, high;

    strip(s, &x0, &x1, &y1);
    chord(s->alpha, d[2] < 0.0 ? -s->beta : s->beta, d[1], &low, &high);
    if (d[0] < low - 1e-5 || d[0] > high + 1e-5)
        g->outside++;
    else
        count(g, d[2] < 0.0, (d[1] / y1 + 1.0) / 2.0 * ROWS, (d[0] - x0) / (x1 - x0) * COLUMNS);
}

/* Rings of 1 - cosine of the angle from the axis, or at the centre from the near point. */
static void count_ring(const struct setting *s, const psc_light_sample_f64 *sample,
                       struct grid *g)
{
    int area = s->what->measure >= PSC_MEASURE_AREA;
    double axis[3] = {cos(s->beta), 0.0, sin(s->beta)}, side[3] = {0.0, 1.0, 0.0}, up[3];
    double versine = 0.0, width, w[3];
    int i;

    for (i = 0; i < 3; i++) {
        w[i] = area ? -sample->normal[i] : sample->direction[i];
        versine += (w[i] - axis[i]) * (w[i] - axis[i]) / 2.0;
    }
    width = s->what->measure == PSC_MEASURE_SOLID_ANGLE ? 1.0 - cos(s->alpha)
            : s->what->measure == PSC_MEASURE_AREA      ? 2.0
                                                        : 1.0 - sin(s->alpha);
    cross(axis, side, up);
    count(g, 0, versine / width * ROWS,
          (atan2(dot(w, up), dot(w, side)) / (2.0 * acos(-1.0)) + 0.5) * COLUMNS);
}

static void test(int bits, const struct setting *s)
{
    const double origin[3] = {0.0, 0.0, 0.0}, normal[3] = {0.0, 0.0, 1.0};
    const double center[3] = {cos(s->beta), 0.0, sin(s->beta)};
    static struct grid g;
    struct test_sampler sampler;
    uint64_t seed = 80;
    int projected = s->what->measure == PSC_MEASURE_PROJECTED_SOLID_ANGLE, freedom, i;
    double x2;

    memset(&g, 0, sizeof g);
    if (projected)
        expect_projected(s, &g);
    else
        for (i = 0; i < ROWS * COLUMNS; i++)
            g.expected[0][i / COLUMNS][i % COLUMNS] = (double)SAMPLES / (ROWS * COLUMNS);
    build_sphere(make_sampler(&sampler), s->what, s->flags, origin, normal, center,
                 sin(s->alpha));
    for (i = 0; i < SAMPLES; i++) {
        psc_light_sample_f64 sample;
        double u = random_uniform(&seed), v = random_uniform(&seed);

        memset(&sample, 0xff, sizeof sample);
        sample_any(bits, sampler.sampler, u, v, &sample);
        (projected ? count_projected : count_ring)(s, &sample, &g);
    }
    x2 = chi_square(&g.counted[0][0][0], &g.expected[0][0][0], SIDES * ROWS * COLUMNS, &freedom);
    tap_ok(x2 <= chi_square_limit(freedom) && g.outside == 0,
           "%s, f%d, a %g, b %g%s: %.0f of at most %.0f with %d degrees of freedom, %ld outside",
           s->what->name, bits, s->alpha, s->beta, s->flags ? ", two-sided" : "", x2,
           chi_square_limit(freedom), freedom, g.outside);
}

int main(void)
{
    static const double angles[][2] = {{0.5, 1.2}, {0.8, 0.4}, {0.8, 0.02}, {0.8, -0.3},
                                       {0.8, -0.7}, {1.4, -0.2}};
    const struct test_technique *what;
    size_t j;
    int two;

    for (FOR_TECHNIQUES(&shape_sphere, what))
        for (j = 0; j < sizeof angles / sizeof angles[0]; j++)
            for (two = 0; two < 2; two++) {
                struct setting s = {what, 0, 0.0, 0.0};
                int projected = s.what->measure == PSC_MEASURE_PROJECTED_SOLID_ANGLE;
                if (!projected && j % 3)
                    continue; /* the elevation makes no difference */
                s.flags = projected && two ? PSC_RECEIVER_TWO_SIDED : 0;
                s.alpha = angles[j][0];
                s.beta = angles[j][1];
                test(two ? 32 : 64, &s);
            }
    return tap_done();
}
