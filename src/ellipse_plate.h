/* SPDX-License-Identifier: Apache-2.0 */
/* An elliptical disk in coordinates of its plane, and the axis of the cone in which it is seen. */
#ifndef PSC_SRC_ELLIPSE_PLATE_H
#define PSC_SRC_ELLIPSE_PLATE_H

#include "vector.h"

/* Cosine >= 0 and sine of half the angle of (x, y), whose length is returned; of 0 for the zero
   vector. */
PSC_LANE double half_angle(double x, double y, double *cosine, double *sine)
{
    const double length = SQRT(x * x + y * y), sum = length + ABS(x);
    const double square = 2.0 * length * sum, per = 1.0 / SQRT(square > 0.0 ? square : 1.0);
    const double longer = square > 0.0 ? sum * per : 1.0, shorter = ABS(y) * per;

    *cosine = x >= 0.0 ? longer : shorter;
    *sine = COPYSIGN(x >= 0.0 ? shorter : longer, y);
    return length;
}

/* The root x > 0 of a x^2 + b x = c, a > 0, c >= 0. */
PSC_LANE double positive_root(double a, double b, double c)
{
    const double root = SQRT(b * b + 4.0 * a * c);

    return (b > 0.0 ? 2.0 * c : root - b) / (b > 0.0 ? b + root : 2.0 * a);
}

/*
 * The offset of the centre is c = f i + h n with the unit normal n away from the receiver, f >= 0
 * and h > 0: i points from the receiver's foot to the centre. A i and p i + q j are conjugate
 * semi-axes, j = n x i, and f^2 = A^2 + kappa.
 */
struct psc_plate {
    double a, p, q, f, h, kappa;
    double axis[2][3];  /* i and j */
    double light[2][2]; /* the conjugate semi-axes in terms of those that were given */
    double per_foot;    /* 1 / f, or any number if that is 0 */
};

/* With the conjugate semi-axes g1, g2, side (g1 x g2) = area normal, at a height below the centre.
   `foot` has the place of the foot in the unit disk, turned round, and f^2 / A^2 - 1, all from
   products in two words; if NULL, one word has to do. */
PSC_LANE void set_plate(const double g1[3], const double g2[3], const double normal[3], double area,
                        double side, const double offset[3], double height, const double *foot,
                        struct psc_plate *k)
{
    /* so that the squares of squares of a small light are numbers */
    const double unit = unit_scale(MAX(largest(g1), largest(g2))), square = unit * unit;
    double c, s, major, minor, per, per_out, per_a, u, v, x, y, out, length;
    int i;

    /* the semi-axes that are perpendicular, and their places in the unit disk */
    (void)half_angle((dot(g1, g1) - dot(g2, g2)) * square, 2.0 * dot(g1, g2) * square, &c, &s);
    for (i = 0; i < 3; i++)
        k->axis[0][i] = c * g1[i] + s * g2[i];
    major = SQRT(dot(k->axis[0], k->axis[0]));
    per = 1.0 / major;
    minor = area * per;
    for (i = 0; i < 3; i++)
        k->axis[0][i] *= per;
    cross_rounded(normal, k->axis[0], k->axis[1]);
    k->light[0][0] = c;
    k->light[0][1] = s;
    k->light[1][0] = -side * s;
    k->light[1][1] = side * c;

    /* turned towards the foot, which is at (x, y), and at (u, v) in the unit disk; from a foot in
       the centre, towards any point of the rim */
    x = dot(offset, k->axis[0]);
    u = x * per;
    v = foot ? side * (c * foot[1] - s * foot[0]) : dot(offset, k->axis[1]) / minor;
    y = v * minor;
    k->f = SQRT(x * x + y * y);
    out = SQRT(u * u + v * v);
    k->kappa = foot ? foot[2] : (out - 1.0) * (out + 1.0);
    x = k->f > 0.0 ? x : major;
    u = k->f > 0.0 ? u : 1.0;
    length = k->f > 0.0 ? k->f : major;
    out = k->f > 0.0 ? out : 1.0;
    k->per_foot = 1.0 / length;
    per_out = 1.0 / out;
    c = x * k->per_foot;
    s = y * k->per_foot;
    k->a = length * per_out;
    per_a = out * k->per_foot;
    k->p = (minor - major) * (minor + major) * ((u * per_out) * (v * per_out)) * per_a;
    k->q = area * per_a;
    k->h = height;
    k->kappa *= k->a * k->a;
    for (i = 0; i < 3; i++) {
        const double p = k->axis[0][i], q = k->axis[1][i];

        k->axis[0][i] = c * p + s * q;
        k->axis[1][i] = c * q - s * p;
    }
    for (i = 0; i < 2; i++) {
        const double p = k->light[0][i], q = k->light[1][i];

        k->light[0][i] = (u * p + v * q) * per_out;
        k->light[1][i] = (u * q - v * p) * per_out;
    }
}

#define PSC_PLATE_STEPS 5

/*
 * What the square of the smallest semi-axis of the dual cone, g1 g1' + g2 g2' - c c' with the
 * eigenvalue -lambda, has beyond h^2: x = lambda - h^2 with
 *     x^2 + (h^2 - kappa + phi) x = (h f)^2,   phi = p^2 (x + h^2) / (x + h^2 + q^2),
 * lambda being an ellipsoidal coordinate of the receiver. It is the only positive root of a cubic
 * whose roots are all real, so that Laguerre's steps find it from anywhere: 5 from where phi is
 * replaced by its tangent at a lower bound, 2 for most lights. The last is one from within 4e-6
 * and leaves nothing. If `many`, elements of a loop stay where they are found.
 */
PSC_LANE double plate_root(const struct psc_plate *k, int many)
{
    const double h2 = k->h * k->h, q2 = k->q * k->q, p2 = k->p * k->p;
    const double hf = k->h * k->f, square = hf * hf, middle = h2 - k->kappa, all = h2 + q2;
    const double c2 = all + (middle + p2), c1 = (all * middle - square) + p2 * h2;
    const double c0 = square * all, low = positive_root(1.0, middle + p2, square);
    const double per = 1.0 / (low + all), slope = p2 * q2 * per * per;
    double x = positive_root(1.0 + slope, middle + p2 * (low + h2) * per - slope * low, square);
    double open = 1.0;
    int i;

    PSC_UNROLL
    for (i = 0; i < PSC_PLATE_STEPS; i++) {
        const double value = ((x + c2) * x + c1) * x - c0;
        const double first = (3.0 * x + 2.0 * c2) * x + c1, second = 6.0 * x + 2.0 * c2;
        const double inner = 4.0 * first * first - 6.0 * value * second;
        const double step = 3.0 * value / (first + SQRT(MAX(inner, 0.0)));

        x = open > 0.0 ? x - step : x;
        open = ABS(step) > 0x1p-18 * x ? open : 0.0;
        if (!many && !(open > 0.0))
            break;
    }
    return x;
}

#endif
