/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Inverses of the maps of a cap: from the offset of a direction in the frame of its lobe to the
 * unit square.
 */
#ifndef PSC_SRC_CAP_INVERSE_H
#define PSC_SRC_CAP_INVERSE_H

#include "cap_seen.h"
#include "projected_build.h"
#include "square.h"

PSC_LANE void invert_cone(const struct psc_lobe_f64 *l, int concentric, const struct seen *d,
                        double uv[2])
{
    polar_to_square(concentric, d->h / l->h0, d->x, d->y, uv);
}

/* The share of the ellipse's squared radius at X = x - x_e, from the side that does not cancel. */
PSC_LANE double ellipse_radius2(const struct psc_lobe_f64 *l, double x, const struct seen *d)
{
    const double px = x / (l->sin_a * l->sin_b), py = d->y / l->sin_a;
    const double s = px * px + py * py, a = l->sin_a * l->sin_b;

    return s <= 0.5 ? s : 1.0 - d->depth * (2.0 * l->sin_b * d->height - d->depth) / (a * a);
}

PSC_LANE void invert_ellipse(const struct psc_lobe_f64 *l, int concentric, const struct seen *d,
                           double uv[2])
{
    const double x = d->x + l->cos_b * l->h0;

    polar_to_square(concentric, ellipse_radius2(l, x, d), x / l->sin_b, d->y, uv);
}

/* rho of radial_point() for a boundary point of squared radius k and squared height bz2: close
   to the horizon the height tells better than the place how far it is. */
PSC_LANE double by_height(const struct psc_lobe_f64 *l, double rho, double k, double bz2,
                        const struct seen *d)
{
    const double slope = l->ome2 + rho * k - bz2;

    return 4.0 * d->height * SQRT(k) < slope
               ? 1.0 - (d->height * d->height - bz2) / slope
               : rho;
}

/* Of the radial map of a cap that the horizon cuts, a direction that lies towards the ellipse:
   1 - u, and the squared share of the radius. */
PSC_LANE void invert_to_ellipse(const struct psc_lobe_f64 *l, double x, const struct seen *d,
                                double *rest, double *share)
{
    const double y = ABS(d->y), px = x / l->sin_b, length = SQRT(px * px + y * y);
    const double inverse = 1.0 / length;
    const double bx = l->sin_a * l->sin_b * px * inverse, by = l->sin_a * y * inverse;
    const double bz = l->cos_a * l->sin_b - l->zc * px * inverse;
    const double rho =
        by_height(l, SQRT(ellipse_radius2(l, x, d)), bx * bx + by * by, bz * bz, d);

    *rest = (PSC_PI - angle_of(px, y)) / l->per_ellipse;
    *share = rho * rho;
}

/* Of one that lies towards the horizon's circle: u and the share. lune: the centre of the cap is
   below the horizon. */
PSC_LANE void invert_to_circle(const struct psc_lobe_f64 *l, int lune, double x,
                               const struct seen *d, double *u, double *share)
{
    const double y = ABS(d->y), r = SQRT(x * x + y * y);
    const double inverse = 1.0 / (r > 0.0 ? r : 1.0);
    const double c = r > 0.0 ? x * inverse : 1.0, s = y * inverse;
    const double root = SQRT(l->ome2 + l->x_e * c * (l->x_e * c));
    const double forwards = l->ome2 / (l->x_e * c + root), backwards = root - l->x_e * c;
    const double rim = c > 0.0 ? forwards : backwards;
    const double sine = rim * s, versine = l->del - rim * c;

    if (lune) {
        const double v = l->v0 - l->cos_b * versine, rho = r / rim;
        const double k2 = l->k * l->k, m2 = k2 + v * v;
        const double middle = d->depth - l->sin_b * d->height;
        const double by_depth = d->depth * (middle - l->sin_b * d->height);
        const double by_place = rho * rho * m2 - k2;
        double per_m2;

        *u = lune_area(l, sine, MAX(versine, 0.0), &per_m2) / l->total;
        /* From what a rounding of the direction changes less. */
        *share = (rho * m2 < rim * l->sin_a * middle ? by_place : by_depth) / (v * v);
    } else {
        const double psi = angle_of(1.0 - versine, sine);
        const double rho = by_height(l, r / rim, rim * rim, 0.0, d);

        *u = (l->del * psi + l->x_e * (psi * psi * psi * sine_polynomial_f64(psi * psi))) /
             l->total;
        *share = rho * rho;
    }
}

/* Radial map of a cap that the horizon cuts; lune: its centre is below. */
PSC_LANE void invert_radial(const struct psc_lobe_f64 *l, int lune, const struct seen *d,
                            double uv[2])
{
    const double x = d->x + l->cos_b * l->h0, y = ABS(d->y);
    double u, share;

    invert_to_circle(l, lune, x, d, &u, &share);
    if (!lune) {
        const int ellipse = x * SQRT(l->q2) < y * (l->cos_a * l->sin_b * l->sin_b);
        double rest, share_e;

        invert_to_ellipse(l, x, d, &rest, &share_e);
        u = ellipse ? 1.0 - rest : u;
        share = ellipse ? share_e : share;
    }
    u = MIN(u, 1.0);
    uv[0] = share;
    uv[1] = 0.5 * (d->y < 0.0 ? 1.0 - u : 1.0 + u);
}

/* Parallel map of any cap, and the concentric one where it goes through chords. */
PSC_LANE void invert_chord(const struct psc_lobe_f64 *l, enum psc_region region, int concentric,
                           const struct seen *d, double uv[2])
{
    const double x = d->x + l->cos_b * l->h0, sine0 = ABS(d->y) / l->sin_a;
    const double sine = MIN(sine0, 1.0), square0 = (1.0 - sine0) * (1.0 + sine0);
    const double square = MAX(square0, 0.0), cosine = SQRT(square);
    const double half = l->sin_a * l->sin_b * cosine;
    const int lune = region == PSC_REGION_LUNE;
    /* of an ellipse beyond this chord */
    const double beyond = segment_share_f64(sine, cosine, square);
    /* The chord that is a point has its share 1/2 there. */
    double u = 1.0 - beyond, share = 0.5 + 0.5 * x / (half > 0.0 ? half : DBL_MAX);

    if (region != PSC_REGION_ELLIPSE) {
        const int whole = region == PSC_REGION_BOTH && beyond < l->whole * l->whole_scale;
        const double sn0 = lune ? sine * l->per_tip_sine : sine, sn = MIN(sn0, 1.0);
        const struct chord_f64 c = chord_at_f64(l, lune, sn, cosine, (1.0 - sn) * (1.0 + sn));
        const double length = l->chord_unit * c.length;
        const double vt = sine * sine / (1.0 + cosine), zl = l->high - l->zc * vt;
        const double along = lune ? d->depth * (d->depth - 2.0 * l->sin_b * d->height) /
                                        ((x - half) * length)
                                  : (x + half) / length;
        /* As by_height(), at the horizon's end of the chord. */
        const double slope = along * (length * length) + zl * zl;
        const double by_height = 1.0 - d->height * d->height / slope;
        /* (theta - sin theta cos theta) / 2 */
        const double sector = sine * sine * sine * (1.0 / 3.0) *
                              segment_f64(vt / ((1.0 + cosine) + PSC_KAPPA * vt));
        const double area = chord_area_f64(l, lune, &c) + (lune ? 0.0 : l->slant * sector);
        const double u_whole = 1.0 - beyond / l->whole_scale, u_cut = area / l->area;

        u = whole ? u_whole : u_cut;
        share = whole ? share : 4.0 * d->height * length < slope ? by_height : along;
    }
    u = MIN(MAX(u, 0.0), 1.0);
    if (concentric) {
        double sine_h, cosine_h, along = 2.0 * share - 1.0;

        solve_chord_f64(1.0 - u, &sine_h, &cosine_h);
        disk_to_square(along * sine_h, COPYSIGN(cosine_h, d->y), uv, uv + 1);
    } else {
        uv[0] = share;
        uv[1] = 0.5 * (d->y < 0.0 ? 1.0 - u : 1.0 + u);
    }
}

/* The point of the square that side i maps to the direction. */
PSC_LANE void seen_invert(const struct psc_cap_light *light, int i, enum psc_cap_map map,
                          int concentric, int inside, const double direction[3],
                          const struct seen *d, double uv[2])
{
    const struct psc_lobe_f64 *l = &light->side[i].lobe;

    switch (map) {
    case PSC_CAP_RADIAL_CONE:
    case PSC_CAP_CONCENTRIC_CONE: invert_cone(l, concentric, d, uv); break;
    case PSC_CAP_RADIAL_ELLIPSE:
    case PSC_CAP_CONCENTRIC_ELLIPSE: invert_ellipse(l, concentric, d, uv); break;
    case PSC_CAP_RADIAL_BOTH: invert_radial(l, 0, d, uv); break;
    case PSC_CAP_RADIAL_LUNE: invert_radial(l, 1, d, uv); break;
    case PSC_CAP_PARALLEL_ELLIPSE: invert_chord(l, PSC_REGION_ELLIPSE, 0, d, uv); break;
    case PSC_CAP_PARALLEL_BOTH:
    case PSC_CAP_CONCENTRIC_BOTH: invert_chord(l, PSC_REGION_BOTH, concentric, d, uv); break;
    case PSC_CAP_PARALLEL_LUNE:
    case PSC_CAP_CONCENTRIC_LUNE: invert_chord(l, PSC_REGION_LUNE, concentric, d, uv); break;
    case PSC_CAP_RADIAL_AREA:
    case PSC_CAP_CONCENTRIC_AREA:
        polar_to_square(concentric, seen_w(light, inside, direction, d) / l->width, d->x, d->y,
                        uv);
        break;
    }
    uv[0] = MIN(MAX(uv[0], 0.0), 1.0);
    uv[1] = MIN(MAX(uv[1], 0.0), 1.0);
}

/* u of all sides from u of one: the inverse of pick_side(). */
PSC_LANE void share_sides(int sides, int i, double split, double uv[2])
{
    if (sides == 2)
        uv[0] = i == 0 ? uv[0] * split : 1.0 - uv[0] * (1.0 - split);
}

#endif
