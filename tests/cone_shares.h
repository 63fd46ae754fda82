/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Shares of an elliptic cone in 113 bits: integrals of the outline in polar coordinates, 1 - cosine
 * over the azimuth, and of the chords over the angle of their planes. Both are taken in a variable
 * in which they are smooth but for layers at both ends, to which panels get smaller by four.
 */
#ifndef PSC_TESTS_CONE_SHARES_H
#define PSC_TESTS_CONE_SHARES_H

#include "gauss.h"

enum { PANELS = 17 };

/* A cone: tangents and their inverse squares, sines, in quad from the semi-arcs. */
struct cone {
    quad sine_a, sine_b, tangent_b, p, q;
    quad sectors, chords; /* the integrals of all */
};

/* A density of solid angle. */
typedef quad rate(const struct cone *k, quad t);

/* Per unit of t, tan azimuth = (sin b / sin a) tan t: 1 - cosine of the outline there. */
static inline quad sector_rate(const struct cone *k, quad t)
{
    const quad x = k->sine_a * quad_cos(t), y = k->sine_b * quad_sin(t);
    const quad square = x * x + y * y; /* cos and sin of the azimuth are x, y by its root */
    const quad tangent2 = square / (k->p * x * x + k->q * y * y), root = quad_sqrt(1 + tangent2);

    return tangent2 / (root * (1 + root)) * (k->sine_a * k->sine_b / square);
}

/* Per unit of t, tan angle = tan beta sin t: half the chord of that plane. */
static inline quad chord_rate(const struct cone *k, quad t)
{
    const quad height = k->tangent_b * quad_sin(t), square = 1 / (1 + height * height);
    const quad c = quad_cos(t), tangent2 = square * c * c / k->p;

    return quad_sqrt(tangent2 / (1 + tangent2)) * k->tangent_b * c * square;
}

static inline quad panel(rate *f, const struct cone *k, quad from, quad to)
{
    quad sum = 0;
    int i;

    for (i = 0; i < GAUSS_NODES; i++)
        sum += gauss_weight(i) * f(k, from + (to - from) * gauss_node(i));
    return (to - from) * sum;
}

/* From 0 to high <= pi/2. */
static inline quad integral(rate *f, const struct cone *k, quad high)
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

/* From the semi-arcs' sines and cosines. */
static inline struct cone cone_of(quad sine_a, quad cosine_a, quad sine_b, quad cosine_b)
{
    struct cone c;

    c.sine_a = sine_a;
    c.sine_b = sine_b;
    c.tangent_b = sine_b / cosine_b;
    c.p = quad_square(cosine_a / sine_a);
    c.q = quad_square(cosine_b / sine_b);
    c.sectors = integral(sector_rate, &c, quad_pi() / 2);
    c.chords = integral(chord_rate, &c, quad_pi() / 2);
    return c;
}

/* ---- Places of directions in the square */

/* Inverse of the map of [SC97]: where the square's point is in polar coordinates. */
static inline void square_to_polar(double u, double v, quad *square, quad *turn)
{
    const quad a = 2 * (quad)u - 1, b = 2 * (quad)v - 1;
    const int along = quad_abs(a) > quad_abs(b);
    const quad r = along ? a : b;
    const quad angle = along ? b / a / 8 : b != 0 ? (quad)0.25 - a / b / 8 : 0;

    *square = r * r;
    *turn = r < 0 ? angle + (quad)0.5 : angle;
}

static inline double around(quad a, quad b)
{
    quad d = quad_abs(a - b);

    while (d > 0.5)
        d = quad_abs(d - 1);
    return (double)d;
}

/* Of a direction with the offset (x, y, z - 1) from the axis: the share of a full turn from the x
   axis, and what is inside. */
static inline void polar_place(const struct cone *k, const quad offset[3], quad versine,
                               quad place[2])
{
    const quad p = offset[0] / k->sine_a, q = offset[1] / k->sine_b;
    const quad t = quad_atan2(quad_abs(q), quad_abs(p));
    const quad square = quad_square(quad_sin(t) * k->sine_b) + quad_square(quad_cos(t) * k->sine_a);
    const quad c2 = quad_square(quad_cos(t) * k->sine_a) / square;
    const quad tangent2 = 1 / (k->p * c2 + k->q * (1 - c2)), root = quad_sqrt(1 + tangent2);
    quad turn = integral(sector_rate, k, t) / k->sectors / 4;

    turn = p < 0 ? (quad)0.5 - turn : turn;
    place[0] = q < 0 ? 1 - turn : turn;
    place[1] = versine / (tangent2 / (root * (1 + root)));
}

/* The share of the cone between the middle and the chord of an offset, and where the sample with
   the coordinate v is on that chord less where it should be, in sines of alpha. */
static inline void chord_place(const struct cone *k, double v, const quad offset[3], quad place[2])
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

#endif
