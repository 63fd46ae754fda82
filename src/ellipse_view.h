/* SPDX-License-Identifier: Apache-2.0 */
/*
 * What a receiver sees of a light whose outline is an elliptic cone, and how the cone's directions
 * meet the light.
 *
 * In gnomonic coordinates scaled by the tangents of the semi-arcs, U = x / (at z) and
 * V = y / (bt z), the cone is the unit disk. An elliptical disk c + s g1 + t g2 is a unit disk in
 * (s,t), and the projection between the two unit disks is a motion of the Klein model of the
 * hyperbolic plane: a turn, a translation along y', and a turn,
 *     x' + i y' = (turn0 - i turn1) (U + i V),
 *     q_x = 2 x' / D,  q_y = (near (1 + y') - far (1 - y')) / D,  D = near (1 + y') + far (1 - y'),
 *     (s,t) = q_x side[0] + q_y side[1],   near far = 1.
 */
#ifndef PSC_SRC_ELLIPSE_VIEW_H
#define PSC_SRC_ELLIPSE_VIEW_H

#include "ellipse.h"
#include "wide.h"

struct psc_outline {
    struct psc_ellipse seen;
    double near, far, turn[2];
    double side[2][2];
    double turned[3]; /* z reach as a sum of the semi-axes and the offset; not of a circular disk */
    double reach; /* of the light along z: the receiver is at distance 2 reach / D of the light in
                     the direction whose gnomonic coordinates are divided by their z */
};

/* The vector from the receiver to the light in two words, in units of 1 / scale. */
PSC_LANE void see_offset(const double position[3], const double center[3], double scale,
                         struct psc_wide to[3])
{
    int i;

    for (i = 0; i < 3; i++) {
        two_sum(center[i], -position[i], &to[i].high, &to[i].low);
        to[i].high *= scale;
        to[i].low *= scale;
    }
}

/* One-sided Jacobi: turns the first two columns of w, and of the record v of all that is done,
   until they are perpendicular; whether they were not before. */
static inline int jacobi_turn(double w[3][3], double v[3][3])
{
    const double g = dot(w[0], w[1]), n0 = dot(w[0], w[0]), n1 = dot(w[1], w[1]);
    double z, t, c, s;
    int i;

    if (!(ABS(g) > DBL_EPSILON * SQRT(n0) * SQRT(n1)))
        return 0;
    z = (n1 - n0) / (2.0 * g);
    t = COPYSIGN(1.0, z) / (ABS(z) + SQRT(1.0 + z * z));
    c = 1.0 / SQRT(1.0 + t * t);
    s = c * t;
    for (i = 0; i < 3; i++) {
        const double a = w[0][i], b = w[1][i], p = v[0][i], q = v[1][i];

        w[0][i] = c * a - s * b;
        w[1][i] = s * a + c * b;
        v[0][i] = c * p - s * q;
        v[1][i] = s * p + c * q;
    }
    return 1;
}

/* The same for column k and the last by a hyperbolic turn by artanh t. Where the two are nearly
   equal, t is nearly -sign, and e = 1 - |t| with w_k - sign w_2 keeps the digits; that difference
   is `gap` if it is known. */
static inline int jacobi_boost(double w[3][3], double v[3][3], int k, const double *gap)
{
    const double g = dot(w[k], w[2]), n0 = dot(w[k], w[k]), n1 = dot(w[2], w[2]);
    const double sign = COPYSIGN(1.0, g), z = 2.0 * g / (n0 + n1);
    double off[3], below, q, e, c;
    int i, equal;

    if (!(ABS(g) > DBL_EPSILON * SQRT(n0) * SQRT(n1)))
        return 0;
    for (i = 0; i < 3; i++)
        off[i] = gap ? gap[i] : w[k][i] - sign * w[2][i];
    equal = ABS(z) > 0.5;
    below = equal ? dot(off, off) / (n0 + n1) : 1.0 - ABS(z);
    q = SQRT(below * (2.0 - below));
    e = equal ? (q + below) / (1.0 + q) : 1.0 - ABS(z) / (1.0 + q);
    c = 1.0 / SQRT(e * (2.0 - e));
    for (i = 0; i < 3; i++) {
        const double t = -z / (1.0 + q), a = w[k][i], b = w[2][i], p = v[k][i], r = v[2][i];
        const double d = p - sign * r;

        w[k][i] = c * (equal ? off[i] + sign * e * b : a + t * b);
        w[2][i] = c * (equal ? sign * (e * a - off[i]) : b + t * a);
        v[k][i] = c * (equal ? d + sign * e * r : p + t * r);
        v[2][i] = c * (equal ? sign * (e * p - d) : r + t * p);
    }
    return 1;
}

/* Unit vectors x along a, y along what of b is perpendicular to it, and z = x cross y. */
static inline void frame(const double a[3], const double b[3], double x[3], double y[3],
                         double z[3])
{
    double length = 1.0 / SQRT(dot(a, a)), along;
    int i;

    for (i = 0; i < 3; i++)
        x[i] = a[i] * length;
    along = dot(b, x);
    for (i = 0; i < 3; i++)
        y[i] = b[i] - along * x[i];
    length = 1.0 / SQRT(dot(y, y));
    for (i = 0; i < 3; i++)
        y[i] *= length;
    cross_rounded(x, y, z);
}

/*
 * Where the receiver is above the plane of an elliptical disk: the offset is
 *     c = (1 + beyond) (s g1 + t g2) + rise,   s^2 + t^2 = 1,
 * with rise along the normal. `beyond` is small next to the rim, where it needs products in two
 * words.
 */
struct psc_foot {
    double s, t, beyond, rise[3];
};

static inline void see_foot(const struct psc_wide g[2][3], const struct psc_wide normal[3],
                            const struct psc_wide offset[3], struct psc_foot *foot)
{
    const double high[3] = {normal[0].high, normal[1].high, normal[2].high};
    const double scale = unit_scale(largest(high));
    struct psc_wide n[3], across[2][3], nn, s, t, square;
    double height, length;
    int i, k;

    for (i = 0; i < 3; i++) {
        n[i].high = normal[i].high * scale;
        n[i].low = normal[i].low * scale;
    }
    wide_cross(offset, g[1], across[0]);
    wide_cross(g[0], offset, across[1]);
    for (k = 0; k < 2; k++)
        for (i = 0; i < 3; i++) {
            across[k][i].high *= scale;
            across[k][i].low *= scale;
        }
    nn = wide_dot(n, n);
    s = wide_dot(across[0], n);
    t = wide_dot(across[1], n);
    square = wide_sum(wide_square(s), wide_square(t));
    length = SQRT(square.high);
    foot->s = length > 0.0 ? s.high / length : 1.0;
    foot->t = length > 0.0 ? t.high / length : 0.0;
    foot->beyond = wide_sum(square, wide_negative(wide_square(nn))).high /
                   (nn.high * (length + nn.high));
    height = wide_dot(n, offset).high / nn.high;
    for (i = 0; i < 3; i++)
        foot->rise[i] = height * n[i].high;
}

/*
 * An elliptical disk with the conjugate semi-axes g1, g2, whose determinant with the offset is
 * det. Its cone has the dual matrix g1 g1' + g2 g2' - c c' = W J W', W = (g1 g2 c),
 * J = diag(1, 1, -1); W V with V in SO(2,1) gives the same. Rotations that make the columns of W
 * perpendicular give the axes of the cone, the tangents as quotients of their lengths, and V the
 * projection. The shortest column follows from the determinant, which does not change. With the
 * receiver's foot, the first of W is turned towards that, so that what it is off the last is known.
 */
static inline int see_elliptical(const double g1[3], const double g2[3], const double offset[3],
                                 double det, const struct psc_foot *foot, struct psc_outline *o)
{
    const double s = foot ? foot->s : 1.0, t = foot ? foot->t : 0.0;
    double w[3][3], v[3][3] = {{s, t, 0.0}, {-t, s, 0.0}, {0.0, 0.0, 1.0}}, n[3], gap[3];
    struct psc_ellipse *e = &o->seen;
    double sinh_rho, turn, hypotenuse;
    int i, sweep, changed, first, second, low;

    memcpy(w[2], offset, sizeof w[2]);
    for (i = 0; i < 3; i++) {
        w[0][i] = s * g1[i] + t * g2[i];
        w[1][i] = s * g2[i] - t * g1[i];
        gap[i] = foot ? -foot->beyond * w[0][i] - foot->rise[i] : w[0][i] - offset[i];
    }
    for (sweep = 0, changed = 1; changed && sweep < 12; sweep++) {
        changed = jacobi_boost(w, v, 0, sweep == 0 && dot(w[0], w[2]) > 0.0 ? gap : NULL);
        changed |= jacobi_boost(w, v, 1, NULL);
        changed |= jacobi_turn(w, v);
    }
    for (i = 0; i < 3; i++)
        n[i] = SQRT(dot(w[i], w[i]));
    first = n[0] >= n[1] ? 0 : 1;
    second = 1 - first;
    low = n[second] <= n[2];
    /* the x axis has no sign of its own: s + t grows along it */
    turn = v[first][0] + v[first][1] < 0.0 ? -1.0 : 1.0;
    for (i = 0; i < 3; i++) {
        w[first][i] *= turn;
        v[first][i] *= turn;
    }
    frame(w[first], low ? w[2] : w[second], e->x, low ? e->z : e->y, low ? e->y : e->z);
    /* the columns are turned round where the frame is */
    turn = dot(e->z, offset) < 0.0 ? -1.0 : 1.0;
    for (i = 0; i < 3; i++)
        e->z[i] *= turn;
    cross_rounded(e->z, e->x, e->y);
    turn = dot(w[second], e->y) < 0.0 ? -1.0 : 1.0;
    for (i = 0; i < 3; i++)
        v[second][i] *= turn;
    if (low)
        n[second] = ABS(det) / (n[first] * n[2]);
    else
        n[2] = ABS(det) / (n[first] * n[second]);
    if (!(n[0] > 0.0 && n[1] > 0.0 && n[2] > 0.0))
        return 0;
    e->at = n[first] / n[2];
    e->bt = n[second] / n[2];
    hypotenuse = SQRT(n[first] * n[first] + n[2] * n[2]);
    e->a = n[first] / hypotenuse;
    e->ca = n[2] / hypotenuse;
    hypotenuse = SQRT(n[second] * n[second] + n[2] * n[2]);
    e->b = n[second] / hypotenuse;
    e->cb = n[2] / hypotenuse;
    o->reach = n[2];

    /* V = turn (side) boost turn: y' is where the last row points, x' is not boosted. */
    memcpy(o->turned, v[2], sizeof o->turned);
    sinh_rho = SQRT(v[first][2] * v[first][2] + v[second][2] * v[second][2]);
    o->far = SQRT(1.0 + sinh_rho * sinh_rho) + sinh_rho;
    o->near = 1.0 / o->far;
    o->turn[0] = sinh_rho > 0.0 ? -v[second][2] / sinh_rho : 1.0;
    o->turn[1] = sinh_rho > 0.0 ? v[first][2] / sinh_rho : 0.0;
    for (i = 0; i < 2; i++)
        o->side[0][i] = o->turn[0] * v[first][i] + o->turn[1] * v[second][i];
    turn = 1.0 / SQRT(o->side[0][0] * o->side[0][0] + o->side[0][1] * o->side[0][1]);
    o->side[0][0] *= turn;
    o->side[0][1] *= turn;
    turn = v[first][0] * v[second][1] - v[first][1] * v[second][0] < 0.0 ? -1.0 : 1.0;
    o->side[1][0] = -turn * o->side[0][1];
    o->side[1][1] = turn * o->side[0][0];
    return 1;
}

#endif
