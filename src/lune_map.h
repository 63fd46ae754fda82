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

/* F(psi), from sin psi and 1 - cos psi. */
PSC_LANE double lune_area(const struct psc_lobe_f64 *l, double sine, double versine)
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

    n = segment(w_psi, w_theta, &dn);
    return sine * c * v2 * (m * up * inverse_m) +
           (2.0 / 3.0) * sine * s2 *
               ((n * (v2 * m * up + k2 * (sb2 * l->q2 + v2)) -
                 k2 * sb2 * up * (dn * rise)) * inverse_m);
}

/* The tip layer: within v ~ k of a tip of the lune the remaining area is cubic, outside linear.
   An approximation to 9e-4 of the inverse of w - atan w, x^3 / 3 + h(x); only its smoothness
   matters. */
#define PSC_TIP_A 0.18669119
#define PSC_TIP_B 0.05217386

PSC_LANE double tip_layer(double x)
{
    const double a = PSC_TIP_A, b = PSC_TIP_B;

    return x * (x * x * (1.0 / 3.0) +
                (1.0 + x * (a + b * x)) /
                    (1.0 + x * (a + x * ((b + 2.0 / 15.0) + x * (2.0 * b / PSC_PI)))));
}

/* h'(x) and h''(x). */
PSC_LANE void tip_slopes(double x, double *h1, double *h2)
{
    const double a = PSC_TIP_A, b = PSC_TIP_B, c = b + 2.0 / 15.0, d = 2.0 * b / PSC_PI;
    const double inverse = 1.0 / (1.0 + x * (a + x * (c + x * d)));
    const double slope = a + x * (2.0 * c + x * (3.0 * d));
    const double h = x * (1.0 + x * (a + b * x)) * inverse;

    *h1 = ((1.0 + x * (2.0 * a + x * (3.0 * b))) - h * slope) * inverse;
    *h2 = ((2.0 * a + 6.0 * b * x) - 2.0 * *h1 * slope - h * (2.0 * c + 6.0 * d * x)) * inverse;
}

/* The variable in which the distance from the tip is smooth, for r of the area remaining. */
PSC_LANE double lune_variable(const struct psc_lobe_f64 *l, double r)
{
    const double c = rough_cbrt(r), w = tip_layer(l->layer * c) * l->layer_width;

    return l->layer > 0.0 ? w : c;
}

/* psi where the share u = 1 - r of F is reached: start within 1.4e-3 of the distance from the
   tip, then one step of fourth order. */
PSC_LANE void lune_solve(const struct psc_lobe_f64 *l, double u, double r, double *sine,
                         double *versine)
{
    const double w = lune_variable(l, r), w1 = 1.0 - w;
    const double d = w * (l->a1 + w * (l->a2 + w * (l->e0 - w1 * (l->q1 - w1 * (l->q2_fit +
                     w1 * (l->f0 + l->f1 * w))))));
    const double psi = l->psi_l * (1.0 - d);
    const double k2 = l->k * l->k;
    double sine_defect, v, v2, r2, weight, g, gv, gvv, gvvv, dv, ddv, w_1, w_2, w_3, f;

    sine_cosine_defects_f64(psi, &sine_defect, versine);
    *sine = psi - sine_defect;
    f = lune_area(l, *sine, *versine) - u * l->total;

    v = l->v0 - l->cos_b * *versine;
    v2 = v * v;
    r2 = 1.0 / (k2 + v2);
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

/* What the last factor of the start value has to be for it to be exact at psi = share psi_l. */
PSC_LANE double lune_fit(const struct psc_lobe_f64 *l, double share, double per_total, double *w)
{
    const double psi = share * l->psi_l, d = 1.0 - share;
    double sine_defect, versine, w1, per_w;

    sine_cosine_defects_f64(psi, &sine_defect, &versine);
    *w = lune_variable(l, 1.0 - lune_area(l, psi - sine_defect, versine) * per_total);
    w1 = 1.0 - *w;
    per_w = 1.0 / *w;
    return (((d * per_w - l->a1) * per_w - l->a2) * per_w - l->e0 +
            w1 * (l->q1 - w1 * l->q2_fit)) /
           (w1 * w1 * w1);
}

/*
 * Completes a lobe for radial_lune_f64(): the start values. Needs psi_l and the total; q =
 * sqrt(q2). The distance from the tip, d = 1 - psi / psi_l, is a smooth function of
 * W(r) = w(layer cbrt r) / w(layer), where w(x) = x for lunes thin enough to have no layer:
 * value, slope and curvature at the tip and at u = 0, and two points between, fix it.
 */
PSC_LANE void radial_lune_build(struct psc_lobe_f64 *l, double q)
{
    const double sb = -l->sin_b, k = l->k;
    const double per_a2 = l->per_a * l->per_a, per_total = 1.0 / l->total, per_q = 1.0 / q;
    const double per_psi = 1.0 / l->psi_l, x = l->total * q * per_a2 / k;
    const int thick = q >= l->cos_a * sb;
    const double layer = rough_cbrt(3.0 * x), width_thick = tip_layer(layer);
    const double width = thick ? width_thick : layer, z = width * k * per_q;
    double h1, h2, slope, bend, g, m0, d1, d2, fit0, fit1, w0, w1;

    tip_slopes(layer, &h1, &h2);
    l->layer = thick ? layer : 0.0;
    l->layer_width = 1.0 / width;
    slope = (x + h1 * layer * (1.0 / 3.0)) * l->layer_width;
    bend = (h2 * layer - 2.0 * h1) * layer * (1.0 / 9.0) * l->layer_width;
    slope = thick ? slope : 1.0 / 3.0;
    bend = thick ? bend : -2.0 / 9.0;

    /* With x_l = cos alpha / cos beta and y_l = q / cos beta, the place of the tip. */
    g = -0.75 * (l->cos_a * per_q + l->x_e * (q * per_a2) / l->cos_b);
    l->a1 = z * per_psi;
    l->a2 = -g * z * l->a1 * (1.0 / 3.0);
    m0 = l->del * l->v0 * l->v0 / (k * k + l->v0 * l->v0) * l->psi_l * per_total;
    d1 = 1.0 / (m0 * slope);
    d2 = -bend * d1 * (m0 * d1 * (m0 * d1));
    l->e0 = 1.0 - l->a1 - l->a2;
    l->q1 = d1 - l->a1 - 2.0 * l->a2 - 3.0 * l->e0;
    l->q2_fit = 0.5 * (d2 - 2.0 * l->a2 - 6.0 * l->e0 - 6.0 * l->q1);

    fit0 = lune_fit(l, 0.38, per_total, &w0);
    fit1 = lune_fit(l, 0.73, per_total, &w1);
    l->f1 = (fit1 - fit0) / (w1 - w0);
    l->f0 = fit0 - l->f1 * w0;
}

#endif
