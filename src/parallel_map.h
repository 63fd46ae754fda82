/* SPDX-License-Identifier: Apache-2.0 */
/* What the parallel map of a cap that the horizon cuts needs to know, computed once, in double; see
   clipped_map_tmpl.h for the map itself and its units. */
#ifndef PSC_SRC_PARALLEL_MAP_H
#define PSC_SRC_PARALLEL_MAP_H

#include "lobe.h"
#include "segment.h"

/* The units of a lobe. */
PSC_LANE void chord_units(struct psc_lobe_f64 *l, double sigma, double c)
{
    l->slant = ABS(l->sin_b) * l->per_a;
    l->half_slant = 0.5 * l->slant;
    l->base = l->cos_a * (l->slant * l->slant) / (1.0 + l->cos_b);
    l->tip_sine = sigma;
    l->tip_y = l->sin_a * sigma;
    l->tip_cos_psi = l->cos_a / c;
    l->chord_unit = l->tip_y * l->tip_y * (sigma * sigma) * (c * c);
}

/* Those of a lune, whose tip is at theta_l. q = sqrt(q2). */
PSC_LANE void lune_units(struct psc_lobe_f64 *l, double q)
{
    const double per_sc = 1.0 / (l->sin_a * l->cos_b), sb = ABS(l->sin_b);
    /* tan theta_l = q / (|sin beta| cos alpha); the larger one makes a unit vector of both. */
    const double s = q * per_sc, c = sb * l->cos_a * per_sc;
    const double s1 = SQRT(1.0 - c * c), c1 = SQRT(1.0 - s * s), sigma = s < c ? s : s1;

    chord_units(l, sigma, l->cos_b);
    l->per_tip_sine = 1.0 / sigma;
    l->tip_cosine = s < c ? c1 : c;
    l->thickness = 1.0 / (1.0 + l->slant);
    l->area = 0.5 * l->total * l->per_a / (l->chord_unit * l->tip_y * l->per_a);
}

/* Completes a lobe for the maps. Needs the total; q = sqrt(q2). */
PSC_LANE void parallel_build(struct psc_lobe_f64 *l, int lune, double q)
{
    const double sb = ABS(l->sin_b), total = l->total, per_sc = 1.0 / (l->sin_a * l->cos_b);
    /* cos theta_l = tan beta / tan alpha, from products. */
    const double eta = sb * l->cos_a * per_sc;
    double first, shape, bend, p0;

    if (lune) {
        lune_units(l, q);
    } else {
        chord_units(l, 1.0, 1.0);
        l->area = 0.5 * total * (l->per_a * l->per_a * l->per_a);
    }
    l->x_m = lune ? twice_atan(q / (l->sin_a * l->cos_b + l->cos_a * sb)) : 0.5 * PSC_PI;
    l->lam = (lune ? 4.0 / 3.0 : 10.0) * eta;
    l->mu = 4.0 * l->cos_a * l->per_a + l->lam;
    l->n = (l->lam + l->x_m) / (l->mu + l->x_m);
    shape = lune ? 3.0 * total / ((sb + 2.0 * l->cos_b) * l->q2 * l->n)
                 : 3.0 * total / (4.0 * l->sin_a * l->sin_a * (sb + 0.4 * l->cos_b) * l->n);
    p0 = rough_cbrt(shape);
    first = 2.0 * l->sin_a * (l->chord_unit * chord_at_f64(l, lune, 0.0, 1.0, 1.0).length);
    bend = 0.25 * l->x_m * (1.0 / (l->mu + l->x_m) - 1.0 / (l->lam + l->x_m));
    l->p0 = p0;
    l->p2 = 3.0 * total / (first * (1.0 + bend)) - 2.0 * l->x_m + p0;
    l->p1 = l->x_m - p0 - l->p2;

    l->whole = 0.0;
    l->whole_scale = 0.0;
    if (!lune) {
        const double ellipse = PSC_PI * l->sin_a * l->sin_a * sb;
        /* H_l = pi/2 - theta_l: sin H_l = eta, cos H_l = q / (sin alpha cos beta). */
        const double cosine = q * per_sc;

        l->whole = 2.0 * l->sin_a * l->sin_a * sb * (angle_of(cosine, eta) - eta * cosine) / total;
        l->whole_scale = ellipse > 0.0 ? total / ellipse : 0.0;
    }
}

#endif
