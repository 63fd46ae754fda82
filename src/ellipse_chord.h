/* SPDX-License-Identifier: Apache-2.0 */
/*
 * The parallel map of [GUK17]: planes through the x axis cut the cone in chords; phi is the angle
 * of a plane to the z axis, tan phi = b sin eta / z at its end. The solid angle of the part with
 * 0 <= phi' <= phi (equation 11, two elliptic integrals there) is that of two sectors and two
 * spherical triangles:
 *     2 Omega_r(eta) + 2 atan2(a b sin eta cos eta, z + ca^2 cos^2 eta + sin^2 eta).
 *
 * tau, tan eta = sqrt(ca) tan tau, balances the layers at both ends. With c, s = cos, sin tau and
 *     q = ca c^2 + s^2,  Y = c^2 + ca s^2,  D = ca c^2 + cb^2 s^2,
 * the share of both halves has the density 4 a b ca c^2 / (q sqrt(Y D)) in tau, and the point at
 * v of the chord is
 *     x = (2 v - 1) a c / sqrt Y,  k^2 = (1 - x^2) / q,  (y, z) = k (b s, sqrt D),
 * where 1 - x^2 = 4 v (1 - v) + (2 v - 1)^2 ca q / Y loses nothing.
 */
#ifndef PSC_SRC_ELLIPSE_CHORD_H
#define PSC_SRC_ELLIPSE_CHORD_H

#include "ellipse_cdf.h"

#include "chord_tmpl.h"

/* The share of the cone with |phi| at most that of eta, given by its cosine and sine in [0,1]. */
static inline double chord_share(const struct psc_ellipse *e, const struct psc_cdf *f, double total,
                                 double c, double s)
{
    const double cc = e->ca * c, cs = e->cb * s, z = SQRT(cc * cc + cs * cs);
    const double sectors = cdf_theta(f, angle_of(c, s), c, s) * (2.0 / PSC_PI);
    const double triangles = small_angle(z + cc * cc + s * s, e->a * e->b * s * c);

    return sectors + 4.0 * triangles / total;
}

/* Cosine and sine of tau in [0, pi/2] at the end of the given share: Newton's steps between
   bounds, from the chord of a plane ellipse, in the angle to the nearer of 0 and pi/2, so that
   both keep their digits. */
static inline void chord_solve(const struct psc_ellipse *e, const struct psc_cdf *f, double total,
                               double share, double *cosine, double *sine)
{
    const double root = SQRT(e->ca);
    const double middle = 1.0 / SQRT(1.0 + e->ca);
    const int other = share > chord_share(e, f, total, middle, root * middle);
    double low = 0.0, high = 0.25 * PSC_PI, x, c, s, defect, versine;
    int i;

    solve_chord_f64(1.0 - share, &c, &s);
    x = MIN(other ? angle_of(s, c) : angle_of(c, s), high);
    for (i = 0; i < 80; i++) {
        double ec, es, length, error, density, q, y, d, step, next;

        sine_cosine_defects_f64(x, &defect, &versine);
        c = other ? x - defect : 1.0 - versine;
        s = other ? 1.0 - versine : x - defect;
        length = 1.0 / SQRT(c * c + e->ca * (s * s));
        ec = c * length;
        es = root * s * length;
        error = chord_share(e, f, total, ec, es) - share;
        error = other ? -error : error;
        if (error < 0.0)
            low = x;
        else
            high = x;
        q = e->ca * (c * c) + s * s;
        y = c * c + e->ca * (s * s);
        d = e->ca * (c * c) + (e->cb * s) * (e->cb * s);
        density = 4.0 * e->a * e->b * e->ca * (c * c) / (q * SQRT(y * d));
        step = -error * total / density;
        next = x + step;
        if (!(next >= low && next <= high)) {
            next = 0.5 * (low + high);
            step = next - x;
        }
        x = next;
        if (ABS(step) <= 1e-9 * x || error == 0.0)
            break;
    }
    sine_cosine_defects_f64(x, &defect, &versine);
    *cosine = other ? x - defect : 1.0 - versine;
    *sine = other ? 1.0 - versine : x - defect;
}

#endif
