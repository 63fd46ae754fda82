/* SPDX-License-Identifier: Apache-2.0 */
/*
 * The parallel map of a cap that the horizon cuts (section 4.1 of [UG18]): chords parallel to
 * the x axis from the outline of the cap to the horizon circle, at heights up to y_l = sin psi_l,
 * and, if the centre is above the horizon, whole chords of the ellipse beyond. In double also
 * behind the float interface.
 *
 * At the height y = sin alpha sin theta = sin psi the chord is cos psi - x_e + a_x cos theta
 * long, with a_x = sin alpha sin beta negative for a lune. The area between -y and y,
 *     F(theta) = psi + sin psi cos psi - 2 x_e y + a_x (theta + sin theta cos theta) sin alpha,
 * is, with N of segment.h and b = sin beta / sin alpha,
 *     F = 2 y chord + 2/3 y^3 ((1 + b) N(psi) + b (N(theta) - N(psi))),
 * one expression for both signs of beta; the two steps of the solver vary theta.
 */
#ifndef PSC_SRC_PARALLEL_MAP_H
#define PSC_SRC_PARALLEL_MAP_H

#include "lobe.h"
#include "segment.h"

struct chord {
    double sine, cosine; /* of theta */
    double y, cos_psi;
    double length;
};

/* The chord at theta; lune: the same length without its cancellation. */
PSC_LANE struct chord chord_at(const struct psc_lobe_f64 *l, int lune, double sine,
                               double cosine)
{
    struct chord c;
    const double sc = l->sin_a * cosine;
    double sagitta;

    c.sine = sine;
    c.cosine = cosine;
    c.y = l->sin_a * sine;
    c.cos_psi = SQRT(l->cos_a * l->cos_a + sc * sc);
    sagitta = c.y * c.y / (1.0 + c.cos_psi);
    if (lune) {
        double v = l->v0 - l->cos_b * sagitta;

        v = MAX(v, 0.0);
        c.length = v * v / ((v + l->cos_a * l->sin_b * l->sin_b) / l->cos_b -
                            l->sin_a * l->sin_b * cosine + 1e-300);
    } else {
        c.length = (c.cos_psi < 0.5 ? c.cos_psi - l->x_e : l->del - sagitta) +
                   l->sin_a * l->sin_b * cosine;
    }
    return c;
}

/* F(theta). */
PSC_LANE double chord_area(const struct psc_lobe_f64 *l, const struct chord *c)
{
    const double b = l->sin_b * l->per_a, s2 = c->sine * c->sine;
    const double s1 = c->y * c->y / (1.0 + c->cos_psi), vt = s2 / (1.0 + c->cosine);
    const double d_psi = (1.0 + c->cos_psi) + PSC_KAPPA * s1;
    const double d_theta = (1.0 + c->cosine) + PSC_KAPPA * vt;
    const double meet = c->cos_psi + c->cosine + 1e-300;
    const double inverse = 1.0 / (d_psi * d_theta * meet);
    /* w_theta - w_psi = 2 (cos psi - cos theta) / (d_psi d_theta) */
    const double rise = 2.0 * (l->cos_a * l->cos_a) * s2 * inverse;
    const double w_psi = s1 * (d_theta * meet * inverse);
    const double w_theta = vt * (d_psi * meet * inverse);
    double n, dn;

    n = segment(w_psi, w_theta, &dn);
    return 2.0 * c->y * (c->length + (1.0 / 3.0) * (c->y * c->y) *
                                         (l->thickness * n + b * (dn * rise)));
}

/* dF/dtheta and its first two derivatives. */
PSC_LANE void chord_slopes(const struct psc_lobe_f64 *l, int lune, const struct chord *c,
                           double *d, double *d1, double *d2)
{
    const double sc = l->sin_a * c->cosine, cp = c->cos_psi + 1e-300, sb = ABS(l->sin_b);
    const double per_cp = 1.0 / cp, steep = c->y * per_cp;
    double e, f, ch1, ch2;

    if (lune) {
        double v = l->v0 - l->cos_b * (c->y * c->y / (1.0 + c->cos_psi));

        v = MAX(v, 0.0);
        e = v * (l->cos_b * cp + l->cos_a) / (sc + sb * cp);
        f = (l->cos_a * l->cos_a + l->cos_b * l->cos_b * (sc * sc)) / (cp + sb * sc);
    } else {
        e = sc + sb * cp;
        f = cp + sb * sc;
    }
    ch1 = -steep * e;
    ch2 = steep * steep * f - sc * (per_cp * per_cp * per_cp) * e;
    *d = 2.0 * sc * c->length;
    *d1 = 2.0 * l->sin_a * (c->cosine * ch1 - c->sine * c->length);
    *d2 = 2.0 * l->sin_a * (c->cosine * (ch2 - c->length) - 2.0 * c->sine * ch1);
}

/* Sine and cosine of the theta at the distance x from where theta ends. */
PSC_LANE struct chord chord_from_end(const struct psc_lobe_f64 *l, int lune, double x)
{
    double sine_defect, versine, s, c;

    sine_cosine_defects_f64(lune ? l->x_m - x : x, &sine_defect, &versine);
    s = (lune ? l->x_m - x : x) - sine_defect;
    c = 1.0 - versine;
    return lune ? chord_at(l, 1, s, c) : chord_at(l, 0, c, s);
}

/*
 * The theta at which the share u = 1 - r of the total is reached. The unknown is the distance x
 * from the end of theta (pi/2, or theta_l for a lune); the remaining area goes like x^4 or x^3
 * there, which the start puts into one power (within 20 %, mostly a few). A rational step of
 * third order and a step of third order follow.
 */
PSC_LANE struct chord chord_solve(const struct psc_lobe_f64 *l, int lune, double u, double r)
{
    const double x0 = l->x_m * SQRT(SQRT(r));
    const double root = rough_cbrt(r * l->n * (l->mu + x0) / (l->lam + x0 + 1e-300));
    double x = root * (l->p0 + root * (l->p1 + root * l->p2));
    const double goal = u * l->total;
    double f, d, d1, d2, h, a2, a3, per_d, limit;
    struct chord c;

    c = chord_from_end(l, lune, x);
    f = chord_area(l, &c) - goal;
    chord_slopes(l, lune, &c, &d, &d1, &d2);
    h = -f * (6.0 * d * d - 3.0 * f * d1) /
        (6.0 * d * (d * d - f * d1) + f * f * d2);
    limit = 0.3 * x;
    h = MIN(MAX(h, -limit), limit);
    x -= h;

    c = chord_from_end(l, lune, x);
    f = chord_area(l, &c) - goal;
    chord_slopes(l, lune, &c, &d, &d1, &d2);
    per_d = 1.0 / d;
    a2 = 0.5 * d1 * per_d;
    a3 = (1.0 / 6.0) * d2 * per_d;
    h = -f * per_d;
    limit = 0.1 * x;
    h = MIN(MAX(h, -limit), limit);
    h = h * (1.0 + h * (-a2 + h * (2.0 * a2 * a2 - a3)));
    h = MIN(MAX(h, -limit), limit);
    x -= h;
    if (!lune)
        x = MAX(x, l->h_l);
    return chord_from_end(l, lune, x);
}

/* The point at the share u of a chord that ends on the horizon. */
PSC_LANE void clipped_chord_point(const struct psc_lobe_f64 *l, int lune, const struct chord *c,
                                  double u, double rest, double side,
                                  struct psc_point_f64 *p)
{
    const double half = l->sin_a * l->sin_b * c->cosine, step = u * c->length;
    const double zl = l->high - l->zc * (c->sine * c->sine / (1.0 + c->cosine));
    const double power = step * (2.0 * half - step);
    double up;

    chord_point_f64(l, 0, -half, side * c->y, c->length, MAX(zl, 0.0), 0.0, u, rest, p);
    up = l->sin_b * p->height;
    p->power = power * (l->per_a * l->per_a);
    p->across = lune ? SQRT(up * up - power) : l->cos_b * step - l->sin_b * zl;
}

/* The point at the share u (rest = 1 - u) of the chord with the share r of the area beyond. */
PSC_LANE void lune_chord_point(const struct psc_lobe_f64 *l, double u, double rest, double r,
                               double side, struct psc_point_f64 *p)
{
    const struct chord c = chord_solve(l, 1, 1.0 - r, r);

    clipped_chord_point(l, 1, &c, u, rest, side, p);
}

PSC_LANE void whole_chord_point(const struct psc_lobe_f64 *l, double u, double rest, double r,
                                double side, struct psc_point_f64 *p)
{
    const double scaled = r * l->whole_scale;
    double sine, cosine, half, zl, zr;

    solve_chord_f64(MIN(scaled, 1.0), &sine, &cosine);
    half = l->sin_a * l->sin_b * sine;
    zl = l->cos_a * l->sin_b + l->zc * sine;
    zr = l->cos_a * l->sin_b - l->zc * sine;
    chord_point_f64(l, 0, -half, side * l->sin_a * cosine, 2.0 * half, zl, zr, u, rest, p);
    whole_chord_power_f64(l, u, rest, sine, zl, zr, p);
}

PSC_LANE void both_chord_point(const struct psc_lobe_f64 *l, double u, double rest, double r,
                               double side, struct psc_point_f64 *p)
{
    if (r < l->whole) {
        whole_chord_point(l, u, rest, r, side, p);
    } else {
        const struct chord c = chord_solve(l, 0, 1.0 - r, r);

        clipped_chord_point(l, 0, &c, u, rest, side, p);
    }
}

PSC_LANE void parallel_lune_f64(const struct psc_lobe_f64 *l, double u, double v,
                                struct psc_point_f64 *p)
{
    lune_chord_point(l, u, 1.0 - u, 2.0 * MIN(v, 1.0 - v), COPYSIGN(1.0, v - 0.5), p);
}

PSC_LANE void parallel_both_f64(const struct psc_lobe_f64 *l, double u, double v,
                                struct psc_point_f64 *p)
{
    both_chord_point(l, u, 1.0 - u, 2.0 * MIN(v, 1.0 - v), COPYSIGN(1.0, v - 0.5), p);
}

/*
 * Low distortion: the square is laid over the disk [SC97], and a point of the disk is read as
 * the place on a chord: the chord that cuts off the same share of the disk, the same share of
 * the chord.
 */
PSC_LANE void disk_to_chord(double u, double v, double *share, double *rest, double *r,
                            double *side)
{
    double cosine, sine, versine, radius, margin, p, q, sine_h;
    double outside, square, along, less, more;

    square_to_disk_f64(u, v, &cosine, &sine, &versine, &radius, &margin);
    p = radius * cosine;
    q = radius * sine;
    outside = margin * (1.0 + radius);
    square = outside + p * p;
    sine_h = SQRT(square);
    *r = segment_share(ABS(q), sine_h, square);
    *r = MIN(*r, 1.0);
    /* (sine_h +- |p|) / (2 sine_h) without cancellation; the tips of the disk have no chord. */
    along = square > 0.0 ? ABS(p) / sine_h : 0.0;
    less = 0.5 * (square > 0.0 ? outside / square : 1.0) / (1.0 + along);
    more = 0.5 + 0.5 * along;
    *share = p < 0.0 ? less : more;
    *rest = p < 0.0 ? more : less;
    *side = COPYSIGN(1.0, q);
}

PSC_LANE void concentric_lune_f64(const struct psc_lobe_f64 *l, double u, double v,
                                  struct psc_point_f64 *p)
{
    double share, rest, r, side;

    disk_to_chord(u, v, &share, &rest, &r, &side);
    lune_chord_point(l, share, rest, r, side, p);
}

PSC_LANE void concentric_both_f64(const struct psc_lobe_f64 *l, double u, double v,
                                  struct psc_point_f64 *p)
{
    double share, rest, r, side;

    disk_to_chord(u, v, &share, &rest, &r, &side);
    both_chord_point(l, share, rest, r, side, p);
}

/* Completes a lobe for the maps above. Needs the total; q = sqrt(q2). */
PSC_LANE void parallel_build(struct psc_lobe_f64 *l, int lune, double q)
{
    const double sb = ABS(l->sin_b), total = l->total;
    /* cos theta_l = tan beta / tan alpha, from products. */
    const double eta = sb * l->cos_a / (l->sin_a * l->cos_b);
    double first, shape, bend, p0;

    l->thickness = lune ? l->q2 / (l->sin_a * (l->sin_a + sb)) : 1.0 + sb / l->sin_a;
    l->x_m = lune ? twice_atan(q / (l->sin_a * l->cos_b + l->cos_a * sb)) : 0.5 * PSC_PI;
    l->lam = (lune ? 4.0 / 3.0 : 10.0) * eta;
    l->mu = 4.0 * l->cos_a / l->sin_a + l->lam;
    l->n = (l->lam + l->x_m) / (l->mu + l->x_m);
    shape = lune ? 3.0 * total / ((sb + 2.0 * l->cos_b) * l->q2 * l->n)
                 : 3.0 * total / (4.0 * l->sin_a * l->sin_a * (sb + 0.4 * l->cos_b) * l->n);
    p0 = rough_cbrt(shape);
    first = 2.0 * l->sin_a * chord_at(l, lune, 0.0, 1.0).length;
    bend = 0.25 * l->x_m * (1.0 / (l->mu + l->x_m) - 1.0 / (l->lam + l->x_m));
    l->p0 = p0;
    l->p2 = 3.0 * total / (first * (1.0 + bend)) - 2.0 * l->x_m + p0;
    l->p1 = l->x_m - p0 - l->p2;

    l->whole = 0.0;
    l->h_l = 0.0;
    if (!lune) {
        const double ellipse = PSC_PI * l->sin_a * l->sin_a * sb;
        /* H_l = pi/2 - theta_l: sin H_l = eta, cos H_l = q / (sin alpha cos beta). */
        const double cosine = q / (l->sin_a * l->cos_b);

        l->h_l = angle_of(cosine, eta);
        l->whole = 2.0 * l->sin_a * l->sin_a * sb * (l->h_l - eta * cosine) / total;
        l->whole_scale = ellipse > 0.0 ? total / ellipse : 0.0;
    }
}

#endif
