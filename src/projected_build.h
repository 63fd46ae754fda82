/* SPDX-License-Identifier: Apache-2.0 */
/* Totals of the projected cap (equations 27 to 29 of [UG18]) and the common part of a lobe. */
#ifndef PSC_SRC_PROJECTED_BUILD_H
#define PSC_SRC_PROJECTED_BUILD_H

#include "cap_maps.h"
#include "starts.h"
#include "vector.h"

/* What every map by projected solid angle needs: nothing in it cancels. */
PSC_LANE void projected_base(struct psc_lobe_f64 *l, const struct psc_cap *cap, double h0)
{
    const double cb_ca = cap->cos_a * cap->sin_b;

    l->sin_a = cap->sin_a;
    l->cos_a = cap->cos_a;
    l->sin_b = cap->sin_b;
    l->cos_b = cap->cos_b;
    l->per_a = 1.0 / cap->sin_a;
    l->q2 = cap->q2;
    l->h0 = h0;
    l->x_e = cap->cos_a * cap->cos_b;
    l->ome2 = cap->sin_a * cap->sin_a + cb_ca * cb_ca;
    l->del = l->ome2 / (1.0 + l->x_e);
    l->zc = cap->cos_b * cap->sin_a;
    l->high = l->zc + cb_ca;
}

/* The case that single calls meet most: no more than it needs. */
PSC_LANE void ellipse_build(struct psc_lobe_f64 *l, const struct psc_cap *cap, double h0)
{
    const double cb_ca = cap->cos_a * cap->sin_b, zc = cap->cos_b * cap->sin_a;

    l->sin_a = cap->sin_a;
    l->cos_a = cap->cos_a;
    l->sin_b = cap->sin_b;
    l->cos_b = cap->cos_b;
    l->h0 = h0;
    l->zc = zc;
    /* The guard serves the whole hemisphere, where the ends of 0/0 are all 0. */
    l->low = -cap->q2 / (cb_ca + zc + 1e-300);
    l->rise = unit_scale(MAX(zc + cb_ca, cap->sin_b));
    l->total = PSC_PI * (cap->sin_a * cap->sin_a) * cap->sin_b;
}

/* Ellipse and lune: the circle's sector up to psi_l, then the ellipse's. Sums of positive
   terms. A flat lune (see PSC_FLAT_LUNE) counts as beta = 0. Returns sqrt(q2). */
PSC_LANE double both_build(struct psc_lobe_f64 *l, const struct psc_cap *cap, double h0)
{
    struct psc_cap c = *cap;
    double q, ellipse, theta_l, psi2, sector, per_total, cosines, inverse;

    c.sin_b = MAX(c.sin_b, 0.0);
    projected_base(l, &c, h0);
    l->rise = unit_scale(MAX(l->high, c.sin_b));
    q = SQRT(l->q2);
    ellipse = l->sin_a * l->sin_a * l->sin_b;
    cosines = l->cos_a + l->cos_b;
    inverse = q / (l->high * cosines);
    theta_l = twice_atan(cosines * inverse);
    l->v0 = q * (l->high * inverse);
    l->psi_l = twice_atan(l->high * inverse);
    psi2 = l->psi_l * l->psi_l;
    sector = l->del * l->psi_l + l->x_e * (l->psi_l * psi2 * sine_polynomial_f64(psi2));
    l->total = sector + ellipse * (PSC_PI - theta_l);
    per_total = 1.0 / l->total;
    l->circle = sector * per_total;
    l->arc = ellipse * (PSC_PI - theta_l) * per_total;
    return q;
}

/*
 * Lune: at its tip the chord and v are 0, which leaves of both maps' areas the same
 *     2/3 sin^3 psi_l ((1 - b) N(psi_l) - b (N(theta_l) - N(psi_l))),  b = |sin beta| / sin alpha,
 * with cos psi_l = cos alpha / cos beta and cos theta_l = b cos psi_l, and their complements
 * v0 / cos beta and sin(alpha - |beta|) / (sin alpha cos beta). Returns sqrt(q2).
 */
PSC_LANE double lune_build(struct psc_lobe_f64 *l, const struct psc_cap *cap, double h0)
{
    const double q = SQRT(cap->q2);
    double steep, inverse, per_b, share, sine, sine2, cos_psi, cos_theta, v_psi, v_theta;
    double d_psi, d_theta, thickness, rise, n, dn;

    projected_base(l, cap, h0);
    steep = l->zc - cap->cos_a * cap->sin_b; /* sin(alpha + |beta|) */
    inverse = 1.0 / (steep * cap->cos_b);
    per_b = steep * inverse;
    l->high = l->q2 * (cap->cos_b * inverse);
    l->rise = unit_scale(l->high);
    share = q / (l->cos_a + l->cos_b);
    l->v0 = q * share;
    l->psi_l = twice_atan(share);
    l->k = -l->sin_a * l->sin_b;
    thickness = l->q2 / (l->sin_a * (l->sin_a - l->sin_b)); /* 1 - b */

    sine = q * per_b;
    sine2 = sine * sine;
    cos_psi = l->cos_a * per_b;
    v_psi = l->v0 * per_b;
    cos_theta = -l->sin_b * cos_psi * l->per_a;
    v_theta = l->high * (l->per_a * per_b);
    d_psi = (1.0 + cos_psi) + PSC_KAPPA * v_psi;
    d_theta = (1.0 + cos_theta) + PSC_KAPPA * v_theta;
    share = 1.0 / (d_psi * d_theta);
    n = segment_difference_f64(v_psi * (d_theta * share), v_theta * (d_psi * share), 0, &dn);
    /* The difference of its arguments, from that of the cosines. */
    rise = 2.0 * (cos_psi * thickness) * share;
    l->total = 2.0 / 3.0 * (sine * sine2) *
               (thickness * n + l->sin_b * l->per_a * (dn * rise));
    return q;
}

/* Completes a lobe of the case "ellipse and lune" for radial_both(): the start value of Kepler's
   equation. */
PSC_LANE void radial_both_build(struct psc_lobe_f64 *l)
{
    const double psi_l = l->psi_l, psi2 = psi_l * psi_l;
    const double p_l = psi_l * psi2 * sine_polynomial_f64(psi2);
    const double linear = l->del * psi_l, ellipse = l->sin_a * l->sin_a * l->sin_b;
    const double sector = linear + l->x_e * p_l;

    l->per_ellipse = ellipse > 0.0 ? l->total / ellipse : 0.0;
    l->per_circle = sector > 0.0 ? l->total / sector : 0.0;
    l->m = linear > 0.0 ? l->x_e * p_l / linear : 0.0;
    l->m1 = l->m * PSC_KEPLER_0(l->m, psi2);
    l->m2 = l->m * PSC_KEPLER_1(l->m, psi2);
    l->m3 = l->m * PSC_KEPLER_2(l->m, psi2);
}

#endif
