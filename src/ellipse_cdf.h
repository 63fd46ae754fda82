/* SPDX-License-Identifier: Apache-2.0 */
/*
 * The solid angle of an elliptic cone and of its sectors.
 *
 * On the boundary (a cos eta, b sin eta, z), z^2 = ca^2 cos^2 eta + cb^2 sin^2 eta, the sector
 * between the centre and d eta has the solid angle a b / (1 + z) d eta: the zone theorem for
 * 1 - z, and d phi = a b / (1 - z^2) d eta for the azimuth. All of equation 19 of [GUK17]
 * follows, without its difference of two elliptic integrals: nothing cancels at any size.
 *
 * Steps of Gauss and Landen, tan(eta' - eta) = (B / A) tan eta, turn
 *     (p + q z) / (r + v z) d eta / z,   z^2 = A^2 cos^2 eta + B^2 sin^2 eta,
 * into half an integral of the same kind over eta', with A' = (A + B) / 2 and B' = sqrt(A B),
 * plus an arc tangent, and make A and B equal quadratically. r is kept at 1.
 */
#ifndef PSC_SRC_ELLIPSE_CDF_H
#define PSC_SRC_ELLIPSE_CDF_H

#include "elementary.h"
#include "ellipse.h"
#include "ellipse_rules.h"

/* From here on a few nodes serve without a Landen step: cos alpha / cos beta. */
#define PSC_ELLIPSE_REGULAR 0.5

PSC_LANE void landen(double *p, double *q, double *v, double *x, double *y)
{
    const double g2 = *x * *y;
    const double r1 = 1.0 / (1.0 + *v * *v * g2);
    const double p1 = (*p + *q * *v * g2) * r1, q1 = (*p * *v + *q) * r1;

    *v = 2.0 * *v * r1;
    *p = p1;
    *q = q1;
    *x = 0.5 * (*x + *y);
    *y = SQRT(g2);
}

/* Quadratic convergence: 3 steps in the regular range, 7 at a quotient of 1e-8 and 9 at 1e-30
   leave A and B equal to 1e-8, and their mean has the square of that for its error. */
PSC_LANE double ellipse_solid_angle(double a, double ca, double b, double cb, int steps)
{
    double p = 0.0, q = 1.0, v = 1.0, x = ca, y = cb, m;
    int i;

    for (i = 0; i < steps; i++)
        landen(&p, &q, &v, &x, &y);
    m = 0.5 * (x + y);
    return 2.0 * PSC_PI * a * b * (p + q * m) / ((1.0 + v * m) * m);
}

#define PSC_REGULAR_STEPS 3

static inline double ellipse_total(const struct psc_ellipse *e)
{
    if (!(e->ca > 0.0)) /* a half space: no steps, and no quotient of zeros */
        return 2.0 * PSC_PI * e->a * e->b;
    return ellipse_solid_angle(e->a, e->ca, e->b, e->cb,
                               e->ca >= PSC_ELLIPSE_REGULAR * e->cb ? PSC_REGULAR_STEPS : 12);
}

/* mu^2 = (1 + ca) / (1 + cb): tan eta is about mu tan theta, theta being 2 pi times the share of the
   sectors up to eta. */
PSC_LANE double ellipse_mu2(double ca, double cb)
{
    return (1.0 + ca) / (1.0 + cb);
}

/* mu - 1 */
PSC_LANE double ellipse_mu1(double ca, double cb)
{
    return (ca - cb) / ((1.0 + cb) * (1.0 + SQRT(ellipse_mu2(ca, cb))));
}

/* See quasi_share() in disk_map_tmpl.h. */
PSC_LANE double ellipse_quasi_scale(const struct psc_ellipse *e)
{
    return 2.0 * PSC_PI * e->a * e->b / SQRT(ellipse_mu2(e->ca, e->cb));
}

#define PSC_LANDEN_LEVELS 10
#define PSC_CDF_TERMS 24

/*
 * Theta(eta), 2 pi times the share of the sectors up to eta:
 *     2^-J (eta_J + sum of series[k] sin 2 k eta_J) + arc tangents of J Landen steps,
 * J = 0 in the regular range. Error 2e-16.
 */
struct psc_cdf {
    double ca, cb;
    double mean; /* of 1 / (1 + z) */
    double mu;   /* see ellipse_mu2() */
    int levels, terms;
    struct psc_level {
        double x, y, half, x1, y1, factor, root;
    } level[PSC_LANDEN_LEVELS];
    double series[PSC_CDF_TERMS];
};

/* Fills in all but a series that is already there (terms > 0). */
static inline void cdf_build(struct psc_cdf *f, const struct psc_ellipse *e)
{
    double p = 0.0, q = 1.0, v = 1.0, x = e->ca, y = e->cb, weight = 1.0, sum = 0.0;
    double rest_x = e->a * e->a / (1.0 + e->ca), rest_y = e->b * e->b / (1.0 + e->cb);
    double g[PSC_CDF_TERMS];
    int i, j, k;

    f->ca = e->ca;
    f->cb = e->cb;
    f->mu = SQRT(ellipse_mu2(e->ca, e->cb));
    f->levels = 0;
    if (f->terms > 0)
        return;
    while (MIN(x, y) < PSC_ELLIPSE_REGULAR * MAX(x, y) && f->levels < PSC_LANDEN_LEVELS) {
        struct psc_level *l = f->level + f->levels++;
        const double g2 = x * y, root = SQRT(g2);
        const double up = (1.0 + v * x) * (1.0 + v * y), down = rest_x * rest_y;
        const double s = (rest_x + v * x * rest_y) / (1.0 + v * root);
        const double r1 = 1.0 / (1.0 + v * v * g2);

        l->x = x;
        l->y = y;
        l->half = 0.5 * (x - y);
        l->factor = weight * (q - p * v) / up;
        l->root = SQRT(down / up);
        rest_x = down * r1;
        rest_y = s * s * r1;
        landen(&p, &q, &v, &x, &y);
        l->x1 = x;
        l->y1 = y;
        weight *= 0.5;
    }
    f->terms = PSC_CDF_TERMS;
    for (j = 0; j < PSC_CDF_TERMS; j++) {
        const double c = psc_rule_f64_24.c[j], s = psc_rule_f64_24.s[j];
        const double z = SQRT((x * c) * (x * c) + (y * s) * (y * s));

        g[j] = (p + q * z) / ((1.0 + v * z) * z);
        sum += g[j];
    }
    f->mean = sum / PSC_CDF_TERMS;
    for (k = 1; k < PSC_CDF_TERMS; k++) {
        sum = 0.0;
        for (j = 0; j < PSC_CDF_TERMS; j++)
            sum += g[j] * psc_rule_f64_24.wave[k * PSC_CDF_TERMS + j];
        f->series[k] = weight * sum / (f->mean * PSC_CDF_TERMS * k);
    }
    for (i = 0; i < f->levels; i++)
        f->level[i].factor /= f->mean;
}

/* The angle in (-pi/2, pi/2) whose tangent is s / c, c > 0. */
static inline double small_angle(double c, double s)
{
    return COPYSIGN(angle_of(c, ABS(s)), s);
}

/* Theta of eta with the cosine c and the sine s. */
static inline double cdf_theta(const struct psc_cdf *f, double eta, double c, double s)
{
    double theta = 0.0, scale = 1.0, x, b0, b1 = 0.0, b2 = 0.0;
    int i, k;

    for (i = 0; i < f->levels; i++) {
        const struct psc_level *l = f->level + i;
        const double xc = l->x * c, ys = l->y * s;
        const double z = SQRT(xc * xc + ys * ys), inverse = 1.0 / z;
        const double c1 = (xc * c - ys * s) * inverse, s1 = (l->x + l->y) * s * c * inverse;
        const double xc1 = l->x1 * c1, ys1 = l->y1 * s1;
        const double z1 = SQRT(xc1 * xc1 + ys1 * ys1);
        const double odd = l->half * s1 / (l->x1 + z1);
        const double t = MIN(ABS(odd) * l->root, 1.0);

        eta = 2.0 * eta + small_angle(xc * c + ys * s, (l->y - l->x) * s * c);
        theta += l->factor * odd * (1.0 - t * t * atan_polynomial(t * t));
        scale *= 0.5;
        c = c1;
        s = s1;
    }
    x = 2.0 * (c - s) * (c + s);
    for (k = f->terms - 1; k > 0; k--) {
        b0 = f->series[k] + x * b1 - b2;
        b2 = b1;
        b1 = b0;
    }
    return theta + (scale * eta + b1 * (2.0 * s * c));
}

/*
 * Cosine and sine of the eta in [0, pi/2] with Theta(eta) = theta: Chebyshev's third-order steps
 * between bounds. Only where an interpolation (ellipse_fit_tmpl.h) does not serve.
 */
static inline void cdf_solve(const struct psc_cdf *f, double theta, double *cosine, double *sine)
{
    double low = 0.0, high = 0.5 * PSC_PI, eta, c, s, defect, versine, step;
    int i;

    sine_cosine_defects_f64(MIN(theta, high), &defect, &versine);
    eta = angle_of(1.0 - versine, f->mu * (theta - defect));
    for (i = 0; i < 80; i++) {
        double z, error, slope, bend, next;

        sine_cosine_defects_f64(eta, &defect, &versine);
        s = eta - defect;
        c = 1.0 - versine;
        error = cdf_theta(f, eta, c, s) - theta;
        if (error < 0.0)
            low = eta;
        else
            high = eta;
        z = SQRT((f->ca * c) * (f->ca * c) + (f->cb * s) * (f->cb * s));
        slope = f->mean * (1.0 + z);
        bend = z > 0.0 ? (f->cb - f->ca) * (f->cb + f->ca) * s * c / (z * (1.0 + z)) : 0.0;
        step = -error * slope;
        step *= 1.0 + 0.5 * bend * step;
        next = eta + step;
        if (!(next >= low && next <= high)) {
            next = 0.5 * (low + high);
            step = next - eta;
        }
        eta = next;
        if (ABS(step) <= 1e-6 * eta)
            break;
    }
    sine_cosine_defects_f64(eta, &defect, &versine);
    *sine = eta - defect;
    *cosine = 1.0 - versine;
}

#endif
