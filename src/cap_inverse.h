/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Inverses of the maps of a cap: from the offset of a direction in the frame of its lobe to the
 * unit square. depth is h0 - (1 - cos) of the angle to the axis, height the cosine to the normal.
 */
#ifndef PSC_SRC_CAP_INVERSE_H
#define PSC_SRC_CAP_INVERSE_H

#include "projected_build.h"

struct seen {
    double x, y; /* offset across */
    double h;    /* 1 - cos of the angle to the axis */
    double depth, height;
};

/* The inverse of turn(): v of the direction (c, s). */
static double unturn(double c, double s)
{
    const double u = angle_of(c, ABS(s)) * (1.0 / PSC_PI);

    return 0.5 * (s < 0.0 ? 1.0 - u : 1.0 + u);
}

/* The inverse of square_to_disk(). */
static void disk_to_square(double p, double q, double *u, double *v)
{
    const int along_u = ABS(p) > ABS(q);
    const double radius = SQRT(p * p + q * q);
    const double far = COPYSIGN(radius, along_u ? p : q);
    const double tangent = along_u ? q / p : q != 0.0 ? p / q : 0.0;
    const double angle = angle_of(1.0, ABS(tangent));
    const double near = far * COPYSIGN(angle, tangent) * (4.0 / PSC_PI);

    *u = 0.5 + 0.5 * (along_u ? far : near);
    *v = 0.5 + 0.5 * (along_u ? near : far);
}

/* Polar coordinates of the disk, the squared radius being u, in either map of the square. */
static void polar_to_square(int concentric, double u, double c, double s, double uv[2])
{
    if (concentric) {
        const double r = SQRT(c * c + s * s);
        const double scale = r > 0.0 ? SQRT(u) / r : 0.0;

        disk_to_square(c * scale, s * scale, uv, uv + 1);
    } else {
        uv[0] = u;
        uv[1] = unturn(c, s);
    }
}

static void invert_cone(const struct psc_lobe_f64 *l, int concentric, const struct seen *d,
                        double uv[2])
{
    polar_to_square(concentric, d->h / l->h0, d->x, d->y, uv);
}

/* The share of the ellipse's squared radius at X = x - x_e, from the side that does not cancel. */
static double ellipse_radius2(const struct psc_lobe_f64 *l, double x, const struct seen *d)
{
    const double px = x / (l->sin_a * l->sin_b), py = d->y / l->sin_a;
    const double s = px * px + py * py, a = l->sin_a * l->sin_b;

    return s <= 0.5 ? s : 1.0 - d->depth * (2.0 * l->sin_b * d->height - d->depth) / (a * a);
}

static void invert_ellipse(const struct psc_lobe_f64 *l, int concentric, const struct seen *d,
                           double uv[2])
{
    const double x = d->x + l->cos_b * l->h0;

    polar_to_square(concentric, ellipse_radius2(l, x, d), x / l->sin_b, d->y, uv);
}

/* rho of radial_point() for a boundary point of squared radius k and squared height bz2: close
   to the horizon the height tells better than the place how far it is. */
static double by_height(const struct psc_lobe_f64 *l, double rho, double k, double bz2,
                        const struct seen *d)
{
    const double slope = l->ome2 + rho * k - bz2;

    return 4.0 * d->height * SQRT(k) < slope
               ? 1.0 - (d->height * d->height - bz2) / slope
               : rho;
}

/* Radial map of a cap that the horizon cuts; lune: its centre is below. */
static void invert_radial(const struct psc_lobe_f64 *l, int lune, const struct seen *d,
                          double uv[2])
{
    const double x = d->x + l->cos_b * l->h0, y = ABS(d->y);
    double u;

    if (!lune && x * SQRT(l->q2) < y * (l->cos_a * l->sin_b * l->sin_b)) {
        const double px = x / l->sin_b, inverse = 1.0 / SQRT(px * px + y * y);
        const double bx = l->sin_a * l->sin_b * px * inverse, by = l->sin_a * y * inverse;
        const double bz = l->cos_a * l->sin_b - l->zc * px * inverse;

        u = 1.0 - (PSC_PI - angle_of(px, y)) / l->per_ellipse;
        uv[0] = by_height(l, SQRT(ellipse_radius2(l, x, d)), bx * bx + by * by, bz * bz, d);
        uv[0] *= uv[0];
    } else {
        const double r = SQRT(x * x + y * y), inverse = r > 0.0 ? 1.0 / r : 0.0;
        const double c = r > 0.0 ? x * inverse : 1.0, s = y * inverse;
        const double root = SQRT(l->ome2 + l->x_e * c * (l->x_e * c));
        const double rim = c > 0.0 ? l->ome2 / (l->x_e * c + root) : root - l->x_e * c;
        const double sine = rim * s, versine = l->del - rim * c;

        if (lune) {
            const double v = l->v0 - l->cos_b * versine, rho = r / rim;
            const double k2 = l->k * l->k, m2 = k2 + v * v;
            const double middle = d->depth - l->sin_b * d->height;
            const double by_depth = d->depth * (middle - l->sin_b * d->height);
            const double by_place = rho * rho * m2 - k2;

            u = lune_area(l, sine, MAX(versine, 0.0)) / l->total;
            /* From what a rounding of the direction changes less. */
            uv[0] = (rho * m2 < rim * l->sin_a * middle ? by_place : by_depth) / (v * v);
        } else {
            const double psi = angle_of(1.0 - versine, sine);
            const double rho = by_height(l, r / rim, rim * rim, 0.0, d);

            u = (l->del * psi + l->x_e * (psi * psi * psi * sine_polynomial_f64(psi * psi))) /
                l->total;
            uv[0] = rho * rho;
        }
    }
    u = MIN(u, 1.0);
    uv[1] = 0.5 * (d->y < 0.0 ? 1.0 - u : 1.0 + u);
}

/* Parallel map of any cap, and the concentric one where it goes through chords. */
static void invert_chord(const struct psc_lobe_f64 *l, enum psc_region region, int concentric,
                         const struct seen *d, double uv[2])
{
    const double x = d->x + l->cos_b * l->h0, sine0 = ABS(d->y) / l->sin_a;
    const double sine = MIN(sine0, 1.0), cosine = SQRT((1.0 - sine) * (1.0 + sine));
    const double half = l->sin_a * l->sin_b * cosine;
    const int lune = region == PSC_REGION_LUNE;
    /* of an ellipse beyond this chord */
    const double share = segment_share(sine, cosine, (1.0 - sine) * (1.0 + sine));
    double u;

    if (region == PSC_REGION_ELLIPSE ||
        (region == PSC_REGION_BOTH && share < l->whole * l->whole_scale)) {
        u = 1.0 - (region == PSC_REGION_ELLIPSE ? share : share / l->whole_scale);
        uv[0] = half > 0.0 ? 0.5 + 0.5 * x / half : 0.5;
    } else {
        const struct chord c = chord_at(l, lune, sine, cosine);
        const double zl = l->high - l->zc * (sine * sine / (1.0 + cosine));

        u = chord_area(l, &c) / l->total;
        uv[0] = lune ? d->depth * (d->depth - 2.0 * l->sin_b * d->height) /
                           ((x - half) * c.length)
                     : (x + half) / c.length;
        /* As by_height(), at the horizon's end of the chord. */
        if (4.0 * d->height * c.length < uv[0] * (c.length * c.length) + zl * zl)
            uv[0] = 1.0 - d->height * d->height / (uv[0] * (c.length * c.length) + zl * zl);
    }
    u = MIN(MAX(u, 0.0), 1.0);
    if (concentric) {
        double sine_h, cosine_h, along = 2.0 * uv[0] - 1.0;

        solve_chord_f64(1.0 - u, &sine_h, &cosine_h);
        disk_to_square(along * sine_h, COPYSIGN(cosine_h, d->y), uv, uv + 1);
    } else {
        uv[1] = 0.5 * (d->y < 0.0 ? 1.0 - u : 1.0 + u);
    }
}

#endif
