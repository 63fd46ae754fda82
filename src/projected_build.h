/* SPDX-License-Identifier: Apache-2.0 */
/* Totals of the projected cap (equations 27 to 29 of [UG18]) and the common part of a lobe. */
#ifndef PSC_SRC_PROJECTED_BUILD_H
#define PSC_SRC_PROJECTED_BUILD_H

#include "cap_maps.h"
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
    double q, ellipse, theta_l, psi2, sector, per_total;

    c.sin_b = MAX(c.sin_b, 0.0);
    projected_base(l, &c, h0);
    l->rise = unit_scale(MAX(l->high, c.sin_b));
    q = SQRT(l->q2);
    ellipse = l->sin_a * l->sin_a * l->sin_b;
    theta_l = twice_atan(q / (l->sin_a * l->cos_b + l->cos_a * l->sin_b));
    l->v0 = l->q2 / (l->cos_a + l->cos_b);
    l->psi_l = twice_atan(q / (l->cos_a + l->cos_b));
    psi2 = l->psi_l * l->psi_l;
    sector = l->del * l->psi_l + l->x_e * (l->psi_l * psi2 * sine_polynomial_f64(psi2));
    l->total = sector + ellipse * (PSC_PI - theta_l);
    per_total = 1.0 / l->total;
    l->circle = sector * per_total;
    l->arc = ellipse * (PSC_PI - theta_l) * per_total;
    return q;
}

/* Lune: at its tip the chord and v are 0, which leaves of both maps' areas the same
   2/3 sin^3 psi_l (N(psi_l) (1 - |sin beta| / sin alpha) - ...). Returns sqrt(q2). */
PSC_LANE double lune_build(struct psc_lobe_f64 *l, const struct psc_cap *cap, double h0)
{
    const double q = SQRT(cap->q2), per_b = 1.0 / cap->cos_b, sine = q * per_b;
    struct chord tip;

    projected_base(l, cap, h0);
    l->high = l->q2 / (l->zc - cap->cos_a * cap->sin_b);
    l->rise = unit_scale(l->high);
    l->v0 = l->q2 / (l->cos_a + l->cos_b);
    l->psi_l = twice_atan(q / (l->cos_a + l->cos_b));
    l->k = -l->sin_a * l->sin_b;
    l->thickness = l->q2 / (l->sin_a * (l->sin_a - l->sin_b));
    tip.sine = sine * l->per_a;
    tip.cosine = -l->sin_b * l->cos_a * (l->per_a * per_b);
    tip.y = sine;
    tip.cos_psi = l->cos_a * per_b;
    tip.length = 0.0;
    l->total = chord_area(l, &tip);
    return q;
}

/* Completes a lobe of the case "ellipse and lune" for radial_both(): the start value of Kepler's
   equation, a rational function fitted at 0.45 psi_l and 0.8 psi_l. */
PSC_LANE void radial_both_build(struct psc_lobe_f64 *l)
{
    const double psi_l = l->psi_l, psi2 = psi_l * psi_l;
    const double p_l = psi_l * psi2 * sine_polynomial_f64(psi2);
    const double linear = l->del * psi_l, ellipse = l->sin_a * l->sin_a * l->sin_b;
    const double sector = linear + l->x_e * p_l;
    static const double nodes[2] = {0.45, 0.8};
    double q[2], g[2], per_sector;
    int i;

    per_sector = sector > 0.0 ? 1.0 / sector : 0.0;
    l->per_ellipse = ellipse > 0.0 ? l->total / ellipse : 0.0;
    l->per_circle = l->total * per_sector;
    l->m = linear > 0.0 ? l->x_e * p_l / linear : 0.0;
    l->b1 = 0.0;
    l->c1 = 0.0;
    if (!(l->m >= 1e-12))
        return;
    PSC_UNROLL
    for (i = 0; i < 2; i++) {
        const double y = nodes[i], psi = y * psi_l;
        const double p = psi * psi * psi * sine_polynomial_f64(psi * psi);
        const double sum = l->del * psi + l->x_e * p, share = sum * per_sector;

        q[i] = share * share;
        g[i] = l->x_e * (y * p_l - p) / (sum * (1.0 - q[i]) * l->m);
    }
    l->b1 = ((g[0] - 1.0) * q[1] - (g[1] - 1.0) * q[0]) / (q[0] * q[1] * (g[1] - g[0]));
    l->b1 = MIN(MAX(l->b1, 0.0), 3.0);
    l->c1 = (g[0] * (1.0 + l->b1 * q[0]) - 1.0) / q[0];
}

#endif
