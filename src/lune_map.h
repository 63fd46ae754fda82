/* SPDX-License-Identifier: Apache-2.0 */
/*
 * The radial map of a cap whose centre is below the horizon: its projection is a lune between
 * the ellipse and the horizon circle (section 4.2 of [UG18], the case x_e - r_min). In double
 * also behind the float interface.
 *
 * On the ray from the ellipse's centre to the point psi of the circle, with
 * v = cos beta cos psi - cos alpha (the depth of that point inside the cap) and k = |a_x|,
 *     r_ellipse^2 / r_circle^2 = k^2 / (k^2 + v^2),
 * because two conics that touch twice differ by a squared line. Twice the area up to psi,
 *     F(psi) = integral of (1 - x_e cos psi) v^2 / (k^2 + v^2) = psi - x_e sin psi - k sin alpha theta,
 * has a form without cancellation. With C = cos psi - x_e, m^2 = k^2 + v^2 = C^2 + sin^2 beta
 * sin^2 psi, cos theta = C / m, sin theta = |sin beta| sin psi / m and N of segment.h,
 *     F = sin psi C v^2 / m^2 + 2/3 sin^3 psi (N(psi) - sin^2 beta k^2 / m^3 N(theta)),
 *     m^3 - sin^2 beta k^2 = v^2 m + k^2 (sin^2 beta q^2 + v^2) / (m + sin^2 beta),
 *     cos psi - cos theta = sin^2 psi (|sin beta| cos psi - C) (|sin beta| cos psi + C)
 *                           / (m (cos psi m + C)),
 *     |sin beta| cos psi - C = cos beta (cos alpha |sin beta| - v0 + cos beta (1 - cos psi))
 *                              / (1 + |sin beta|).
 */
#ifndef PSC_SRC_LUNE_MAP_H
#define PSC_SRC_LUNE_MAP_H

#include "lobe.h"
#include "segment.h"
#include "starts.h"

/* F(psi), from sin psi and 1 - cos psi; per_m2 = 1 / (k^2 + v^2). */
PSC_LANE double lune_area(const struct psc_lobe_f64 *l, double sine, double versine,
                          double *per_m2)
{
    const double sb = -l->sin_b, sb2 = sb * sb, k2 = l->k * l->k, s2 = sine * sine;
    const double cosine = 1.0 - versine;
    const double v = l->v0 - l->cos_b * versine, v2 = v * v;
    const double c = l->del - versine, m2 = k2 + v2, m = SQRT(m2);
    const double gap = l->cos_b * (l->cos_a * sb - l->v0 + l->cos_b * versine) / (1.0 + sb);
    const double up = m + sb2, mc = m + c, meet = cosine * m + c + 1e-300;
    const double d_psi = (1.0 + cosine) + PSC_KAPPA * versine;
    const double d_theta = mc * mc + PSC_KAPPA * (sb2 * s2);
    const double inverse_m = 1.0 / (m2 * m * up);
    const double inverse_d = 1.0 / (d_psi * d_theta * meet);
    const double w_psi = versine * (d_theta * meet * inverse_d);
    const double w_theta = sb2 * s2 * (d_psi * meet * inverse_d);
    /* w_theta - w_psi = 2 (cos psi - cos theta) / (d_psi d_theta / (m (m + C))) */
    const double rise = 2.0 * s2 * gap * (sb * cosine + c) * mc * inverse_d;
    double n, dn;

    n = segment_difference_f64(w_psi, w_theta, 0, &dn);
    *per_m2 = m * up * inverse_m;
    return sine * c * v2 * *per_m2 +
           (2.0 / 3.0) * sine * s2 *
               ((n * (v2 * m * up + k2 * (sb2 * l->q2 + v2)) -
                 k2 * sb2 * up * (dn * rise)) * inverse_m);
}

/* The tip layer: within v ~ k of a tip of the lune the remaining area is cubic, outside linear.
   An approximation to 9e-4 of the inverse of w - atan w, x^3 / 3 + h(x); only its smoothness
   matters. share is h(x) / x, which falls from 1 to 0. */
#define PSC_TIP_A 0.18669119
#define PSC_TIP_B 0.05217386

PSC_LANE double tip_layer(double x, double *share)
{
    const double a = PSC_TIP_A, b = PSC_TIP_B;

    *share = (1.0 + x * (a + b * x)) /
             (1.0 + x * (a + x * ((b + 2.0 / 15.0) + x * (2.0 * b / PSC_PI))));
    return x * (x * x * (1.0 / 3.0) + *share);
}

/* The variable in which the distance from the tip is smooth, for r of the area remaining. */
PSC_LANE double lune_variable(const struct psc_lobe_f64 *l, double r)
{
    double share;

    return tip_layer(l->layer * rough_cbrt(r), &share) * l->layer_width;
}

/* psi where the share u = 1 - r of F is reached: start within 1.5e-3 of the distance from the
   tip, then one step of fourth order. */
PSC_LANE void lune_solve(const struct psc_lobe_f64 *l, double u, double r, double *sine,
                         double *versine)
{
    const double w = lune_variable(l, r);
    const double d = w * (l->a1 + w * (l->a2 + w * (l->a3 + w * (l->a4 + w * l->a5))));
    const double psi = l->psi_l * (1.0 - d);
    const double k2 = l->k * l->k;
    double sine_defect, v, v2, r2, weight, g, gv, gvv, gvvv, dv, ddv, w_1, w_2, w_3, f;

    sine_cosine_defects_f64(psi, &sine_defect, versine);
    *sine = psi - sine_defect;
    f = lune_area(l, *sine, *versine, &r2) - u * l->total;

    v = l->v0 - l->cos_b * *versine;
    v2 = v * v;
    weight = l->del + l->x_e * *versine;
    g = v2 * r2;
    gv = 2.0 * k2 * v * (r2 * r2);
    gvv = 2.0 * k2 * (k2 - 3.0 * v2) * (r2 * r2 * r2);
    gvvv = 24.0 * k2 * v * (v2 - k2) * (r2 * r2 * (r2 * r2));
    dv = -l->cos_b * *sine;
    ddv = -l->cos_b * (1.0 - *versine);
    w_1 = l->x_e * *sine;
    w_2 = l->x_e * (1.0 - *versine);
    w_3 = -w_1;
    turn_by(quintic_step(f, weight * g,
                         w_1 * g + weight * (gv * dv),
                         w_2 * g + 2.0 * w_1 * (gv * dv) +
                             weight * (gvv * dv * dv + gv * ddv),
                         w_3 * g + 3.0 * w_2 * (gv * dv) +
                             3.0 * w_1 * (gvv * dv * dv + gv * ddv) +
                             weight * (gvvv * dv * dv * dv + 3.0 * gvv * dv * ddv - gv * dv),
                         MIN(0.05 * d * l->psi_l, 0.01)),
            sine, versine);
}

PSC_LANE void radial_lune_f64(const struct psc_lobe_f64 *l, double s, double t,
                              struct psc_point_f64 *p)
{
    const double k2 = l->k * l->k;
    double u, r, side, sine, versine, v2, inverse, lam, margin;

    fold_f64(t, &u, &r, &side);
    lune_solve(l, u, r, &sine, &versine);
    v2 = l->v0 - l->cos_b * versine;
    v2 *= v2;
    inverse = 1.0 / (k2 + v2);
    lam = SQRT((k2 + s * v2) * inverse);
    margin = (1.0 - s) * v2 * inverse / (1.0 + lam);
    radial_point_f64(l, 0, l->del - versine, side * sine, 0.0, lam, margin, p);
    p->power = -s * v2 * (l->per_a * l->per_a);
    p->across = SQRT(l->sin_b * p->height * (l->sin_b * p->height) + s * v2);
}

/*
 * Completes a lobe for radial_lune_f64(): the start values. Needs psi_l and the total; q =
 * sqrt(q2). The distance from the tip, d = 1 - psi / psi_l, is a smooth function of
 * W(r) = w(layer cbrt r) / w(layer). Its value, slope and curvature at the tip are known, the rest
 * is a fit over all lunes (starts.py).
 */
PSC_LANE void radial_lune_build(struct psc_lobe_f64 *l, double q)
{
    /* In units of sin alpha, so that nothing gets too small. */
    const double per_a = l->per_a, across = q * per_a, b = -l->sin_b * per_a;
    const double arc = l->psi_l * per_a;
    const double inverse = 1.0 / (across * b * arc);
    const double x = l->total * per_a * per_a * per_a * (across * across * arc * inverse);
    const double layer = rough_cbrt(3.0 * x);
    double share, e, g0, g1;
    const double width = tip_layer(layer, &share);
    const double per_across = b * arc * inverse;

    l->layer = layer;
    l->layer_width = 1.0 / width;
    l->a1 = width * b * (b * inverse);
    l->a2 = 0.25 * l->cos_a * (width * b) * (per_across * per_across + 1.0) * l->a1;
    e = 1.0 - l->a1;
    g0 = PSC_LUNE_0(share * share, e);
    g1 = PSC_LUNE_1(share * share, e);
    l->a3 = (e - l->a2) + g0;
    l->a4 = g1 - g0;
    l->a5 = -g1;
}

#endif
