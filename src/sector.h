/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Sectors: the light between two azimuths around the receiver's normal, where one edge bounds it
 * outwards and one inwards. Polygons by projected solid angle are sampled sector by sector, in
 * double behind both precisions.
 *
 * Coordinates are those of the receiver, z upwards. U is a point of the outer edge's plane, W the
 * one of the inner edge's with the same x and y; with m = 1 - l both are linear in l,
 *     U = m U_a + l U_b,   W_z = U_z + d,   d = m d_a + l d_b,   |U_a| = |U_b| = 1,
 * and twice the projected solid angle between the azimuths at 0 and l has the density
 *     f(l) = k (1 / |U|^2 - 1 / |W|^2) = k Q / (|U|^2 |W|^2),   Q = d (2 U_z + d),
 * k being the z component of U_a x U_b. A zenith inside the light is an inner edge that is a
 * point: W is then so high that 1 / |W|^2 vanishes.
 */
#ifndef PSC_SRC_SECTOR_H
#define PSC_SRC_SECTOR_H

#include "vector.h"

/* Shares are of the integral of f over all sectors of a side. */
#define PSC_SECTOR_FIELDS(X)                                                           \
    X(ax) X(ay) X(az) X(bx) X(by) X(bz) /* U_a and U_b */                              \
    X(da) X(db)                                                                        \
    X(k) /* in units of that integral */                                               \
    X(sine) X(sine_w) X(sine_more) /* |U_a x U_b|, |W_a x W_b|, the second less the    \
       first, not cancelled */                                                         \
    X(versine) /* 1 - U_a.U_b */                                                       \
    X(start) X(quarter) X(middle) X(last) X(end) /* shares of all before, and up to    \
       l = 1/4, 1/2, 3/4 and 1 */                                                      \
    X(rise_a) X(bend_a) X(rise_b) X(bend_b) /* density at both ends, and half its      \
       derivative inwards */

#define PSC_SECTOR_NUMBER(name) double name;
struct psc_sector { PSC_SECTOR_FIELDS(PSC_SECTOR_NUMBER) };
#undef PSC_SECTOR_NUMBER

/* U_a, U_b and the W above them from the corners of the light: weights of both ends of the edge
   that each is on, [a or b][from or to]. */
struct psc_sector_hit {
    double outer[2][2], inner[2][2];
    unsigned char corner[4]; /* of the outer edge, from and to, and of the inner edge */
};

/* U, W and the density at l. */
struct psc_sector_place {
    double uu, uz, d, q, ww; /* |U|^2, U_z, d, Q, |W|^2 */
    double u1, q1, w1;       /* derivatives along U, and of Q and W: U.U(l + h) = uu + h u1, */
                             /* W.W(l + h) = ww + h w1, and their difference Q + h q1 */
};

PSC_LANE void sector_place(const struct psc_sector *s, double l, struct psc_sector_place *p)
{
    const double m = 1.0 - l;
    const double slope = s->bz - s->az, gain = s->db - s->da;

    p->uu = 1.0 - 2.0 * l * m * s->versine;
    p->uz = m * s->az + l * s->bz;
    p->d = m * s->da + l * s->db;
    p->q = p->d * (2.0 * p->uz + p->d);
    p->ww = p->uu + p->q;
    p->u1 = (l - m) * s->versine;
    p->q1 = p->d * (slope + gain) + p->uz * gain;
    p->w1 = p->u1 + p->q1;
}

/* Angles from a node, and up to half a sector's: tangents are at most this. */
#define PSC_SECTOR_REACH 0.42

/* atan(t) / t of t^2 = x, and its divided difference (f(y) - f(x)) / (y - x), x and y at most
   0.18: 3e-17 and 1e-15. */
PSC_LANE double atan_quotient(double x, double y, double *difference)
{
    static const double c[] = {PSC_ATAN_NEAR_F64};
    const double x2 = x * x, y2 = y * y;
    double even = c[10], odd = c[9], even_change = 0.0, odd_change = 0.0, value, change;
    int i;

    /* f = 1 - x p(x), p = even(x^2) + x odd(x^2): two short chains of steps, not a long one. */
    PSC_UNROLL
    for (i = 8; i > 0; i -= 2) {
        even_change = even_change * y2 + even;
        odd_change = odd_change * y2 + odd;
        even = even * x2 + c[i];
        odd = odd * x2 + c[i - 1];
    }
    even_change = even_change * y2 + even;
    even = even * x2 + c[0];
    value = even + x * odd;
    change = odd + (x + y) * (even_change + y * odd_change);
    *difference = -(change * y + value);
    return 1.0 - x * value;
}

/*
 * The integral of f from l to l + h. With A and B the angles of U and W between the two, it is
 *     (k / sine) A - (k / sine_w) B,   tan A = h sine / (uu + h u1) and so on,
 * of which thin sectors leave nothing. With atan t = t p(t^2) it is
 *     h k / (X Y) ((Y - X) p(y^2) + X (y - w) (y + w) (p(y^2) - p(w^2)) / (y^2 - w^2))
 * for X = uu + h u1, Y = ww + h w1, y = tan A, w = tan B; every difference in it is known.
 */
PSC_LANE double sector_mass(const struct psc_sector *s, const struct psc_sector_place *p, double h)
{
    const double x = p->uu + h * p->u1, gap = p->q + h * p->q1, y = x + gap;
    const double inverse = 1.0 / (x * y);
    const double tangent = h * s->sine * y * inverse, tangent_w = h * s->sine_w * x * inverse;
    const double apart = h * (s->sine * gap - s->sine_more * x) * inverse;
    double change;
    const double p_u = atan_quotient(tangent * tangent, tangent_w * tangent_w, &change);

    return h * s->k * inverse * (gap * p_u + x * (apart * (tangent + tangent_w)) * change);
}

/*
 * The step from l to where the integral is larger by `mass`, with angles for tangents: a quadratic
 * equation, whose error is of third order in the angle.
 */
PSC_LANE double sector_step(const struct psc_sector *s, const struct psc_sector_place *p,
                            double mass)
{
    const double a = s->k * p->q1 - mass * (p->u1 * p->w1);
    const double b = s->k * p->q - mass * (p->uu * p->w1 + p->u1 * p->ww);
    const double c = mass * (p->uu * p->ww);
    const double square = b * b + 4.0 * (a * c);
    const double root = b + __builtin_sqrt(MAX(square, 0.0));

    return 2.0 * c / MAX(root, DBL_MIN);
}

/*
 * A start: how far from the nearer end of the sector the mass from there to the middle has the
 * share that it should. Near the end the density may vanish as a square does, so that powers up to
 * the third matter: of a x + b x^2 + c x^3 the first two are those of the end, the third meets the
 * mass to the middle. Were one of them all, it would give x; sums of their inverses are at most
 * 1.6 times too large, of which a step of Halley's leaves so little that what the cubic is off by
 * is more.
 */
PSC_LANE double sector_start(double a, double b, double half, double mass)
{
    const double c = 8.0 * half - (4.0 * a + 2.0 * b);
    const double square = MAX(b, 0.0) * mass, cube = MAX(c, 0.0) * mass * mass;
    const double slope = a + (__builtin_sqrt(square) + rough_cbrt(cube));
    const double far = mass / MAX(slope, DBL_MIN), x = MIN(far, 0.5);
    const double value = ((c * x + b) * x + a) * x - mass;
    const double first = (3.0 * c * x + 2.0 * b) * x + a, half_second = 3.0 * c * x + b;
    const double denominator = first * first - value * half_second;
    const double near = x - value * first / MAX(denominator, DBL_MIN);

    return MIN(MAX(near, 0.0), 0.5);
}

/* What shares of a side are off by in any case. */
#define PSC_SECTOR_ROUNDING 0x1p-51

/* l of the share u of all sectors, which is in this one. Each step leaves the cube of what the one
   before left. */
PSC_LANE double sector_solve(const struct psc_sector *s, int steps, double u)
{
    const int upper = u >= s->middle;
    const double half = upper ? s->end - s->middle : s->middle - s->start;
    const double from_end = upper ? s->end - u : u - s->start;
    const double x = sector_start(upper ? s->rise_b : s->rise_a, upper ? s->bend_b : s->bend_a,
                                  half, MAX(from_end, 0.0));
    const double node = upper ? 0.75 : 0.25, least = upper ? 0.5 : 0.0;
    const double mass = u - (upper ? s->last : s->quarter);
    struct psc_sector_place at, here;
    double l = upper ? 1.0 - x : x;
    int i;

    sector_place(s, node, &at);
    PSC_UNROLL
    for (i = 0; i < steps; i++) {
        const double missing = mass - sector_mass(s, &at, l - node);
        double step;

        sector_place(s, l, &here);
        step = sector_step(s, &here, missing);
        /* At an end without density, rounding would send it anywhere. */
        l += ABS(missing) > PSC_SECTOR_ROUNDING ? step : 0.0;
        l = MIN(MAX(l, least), least + 0.5);
    }
    return l;
}

/* A sampled direction: coordinates, and shares of U and W, of which it is the sum. */
struct psc_sector_point {
    double l, x, y, z, u, w;
};

/* v is the share of the squared distance from the receiver's normal between W, 0, and U, 1. z^2 is
   a sum of positive terms. The share of U is (r W_z - z) / d, and that is positive terms too. */
PSC_LANE void sector_point(const struct psc_sector *s, double l, double v,
                           struct psc_sector_point *to)
{
    struct psc_sector_place p;
    double high, inner, outer, r, x, y, z, uz, wz, twice, unit;

    sector_place(s, l, &p);
    high = p.uz + p.d;
    inner = (1.0 - v) / p.ww;
    outer = v / p.uu;
    r = __builtin_sqrt(inner + outer);
    x = ((1.0 - l) * s->ax + l * s->bx) * r;
    y = ((1.0 - l) * s->ay + l * s->by) * r;
    z = __builtin_sqrt(inner * (high * high) + outer * (p.uz * p.uz));
    /* On the horizon itself all heights are 0. */
    uz = p.uz + 0x1p-900;
    wz = uz + p.d;
    twice = 2.0 * uz + p.d;
    /* Of length 1 but where points of the light are all but antipodal, or beyond the receiver. */
    unit = 1.0 / __builtin_sqrt((x * x + y * y) + z * z);
    to->l = l;
    to->x = x * unit;
    to->y = y * unit;
    to->z = z * unit;
    to->u = unit * (outer * twice / (r * wz + (z + r * 0x1p-900)));
    to->w = unit * (inner * twice / (r * uz + (z + r * 0x1p-900)));
}

/* Shares of the corners that a sampled point is made of: of both ends of the outer edge, then of
   the inner one. Their sum is the inverse of the distance, in units of the view. */
PSC_LANE double sector_shares(const struct psc_sector_hit *hit, const struct psc_sector_point *p,
                              double share[4])
{
    const double m = 1.0 - p->l;
    int i;

    for (i = 0; i < 2; i++) {
        share[i] = p->u * (m * hit->outer[0][i] + p->l * hit->outer[1][i]);
        share[2 + i] = p->w * (m * hit->inner[0][i] + p->l * hit->inner[1][i]);
    }
    return (share[0] + share[1]) + (share[2] + share[3]);
}

#endif
