/* SPDX-License-Identifier: Apache-2.0 */
/* Directions in the frame of a light that is seen as an elliptic cone, or laid out by its area, and
   the inverses of its maps. */
#ifndef PSC_SRC_DISK_INVERSE_H
#define PSC_SRC_DISK_INVERSE_H

#include "disk_solve.h"
#include "fibre_solve.h"
#include "segment.h"
#include "square.h"
#include "vector.h"

/* A direction in the frame of the cone. */
struct seen {
    double x, y, z;
    double u, v;   /* x / tan alpha, y / tan beta */
    double margin; /* z^2 - u^2 - v^2 */
};

/* Whether the direction, rounded by epsilon or a few, is in the cone. */
static inline int look(const struct psc_ellipse *e, const double direction[3], double epsilon,
                struct seen *d)
{
    const double per_at = e->ca / e->a, per_bt = e->cb / e->b, error = 32.0 * epsilon;
    double gradient;

    d->x = dot(direction, e->x);
    d->y = dot(direction, e->y);
    d->z = dot(direction, e->z);
    d->u = d->x * per_at;
    d->v = d->y * per_bt;
    d->margin = (d->z - ABS(d->u)) * (d->z + ABS(d->u)) - d->v * d->v;
    gradient = SQRT(d->u * per_at * (d->u * per_at) + d->v * per_bt * (d->v * per_bt) +
                    d->z * d->z);
    if (!(d->z > -error) || !(d->margin >= -error * (2.0 * gradient + error * per_bt * per_bt)))
        return 0;
    d->margin = MAX(d->margin, 0.0);
    d->z = MAX(d->z, 0.0);
    return 1;
}

/* The same of a light by area, which has no cone: u / z and v / z are its point, and the margin is
   z^2 - u^2 - v^2, linear and quadratic in the direction. */
static inline int look_laid(const struct psc_disk_light *l, const double direction[3],
                            double epsilon, struct seen *d)
{
    const struct psc_laid *f = &l->laid;
    const double error = 32.0 * epsilon, per_a = 1.0 / f->a, per_b = 1.0 / f->b;
    /* the coefficients of v and u */
    const double vy = f->height * per_b, vz = -f->y * per_b;
    const double ux = f->height * per_a, uy = -f->skew * per_a * vy;
    const double uz = (-f->x - f->skew * vz) * per_a;
    const double curve = (vy * vy + vz * vz) + (ux * ux + (uy * uy + uz * uz));
    double gx, gy, gz;

    d->x = dot(direction, l->seen.x);
    d->y = dot(direction, l->seen.y);
    d->z = dot(direction, l->seen.z);
    d->v = d->y * vy + d->z * vz;
    d->u = (d->x * f->height - d->z * f->x - f->skew * d->v) * per_a;
    d->margin = (d->z - ABS(d->u)) * (d->z + ABS(d->u)) - d->v * d->v;
    gx = d->u * ux;
    gy = d->u * uy + d->v * vy;
    gz = d->z - d->u * uz - d->v * vz;
    if (!(d->z > -error) ||
        !(d->margin >= -error * (2.0 * SQRT(gx * gx + gy * gy + gz * gz) + error * curve)))
        return 0;
    d->margin = MAX(d->margin, 0.0);
    d->z = MAX(d->z, DBL_MIN);
    return 1;
}

/* The cosine and sine of eta, see ellipse_cdf.h; returns how far out the direction is, (x / a)^2 +
   (y / b)^2. */
static inline double eccentric(const struct psc_ellipse *e, const struct seen *d, double *c,
                               double *s)
{
    const double p = d->x / e->a, q = d->y / e->b, square = p * p + q * q, r = SQRT(square);

    *c = r > 0.0 ? p / r : 1.0;
    *s = r > 0.0 ? q / r : 0.0;
    return square;
}

/* The height over the horizon that counts of a direction of the light; negative if it is none of
   what is above. */
static inline double look_above(const psc_sampler *s, const double direction[3], double epsilon,
                                struct seen *d)
{
    const double height = dot(direction, s->disk.receiver);

    if (s->disk.inside) {
        d->u = d->v = 0.0;
        d->margin = 1.0;
    } else if (!look(&s->disk.seen, direction, epsilon, d)) {
        return -1.0;
    }
    return s->facing == PSC_FACING_BOTH ? ABS(height) : height;
}

/* By projected solid angle. */
static inline psc_result invert_fibres(const psc_sampler *s, const double direction[3],
                                       double epsilon, double uv[2])
{
    const struct psc_disk_light *l = &s->disk;
    const int side = s->sides == 2 && dot(direction, l->receiver) < 0.0;
    const double sign = l->inside && side == 1 ? -1.0 : 1.0;
    struct psc_fibre_direction_f64 at;
    struct seen d;

    if (look_above(s, direction, epsilon, &d) < -32.0 * epsilon)
        return PSC_OUTSIDE;
    at.x = dot(direction, l->seen.x);
    at.y = dot(direction, l->seen.y);
    at.depth = MAX(sign * dot(direction, l->seen.z), DBL_MIN);
    at.uz = d.u;
    at.vz = d.v;
    at.margin = l->inside ? at.depth * at.depth : d.margin;
    fibre_invert(l, side, &at, uv);
    if (s->sides == 2)
        uv[0] = side == 0 ? uv[0] * s->split : 1.0 - uv[0] * (1.0 - s->split);
    uv[0] = MIN(MAX(uv[0], 0.0), 1.0);
    uv[1] = MIN(MAX(uv[1], 0.0), 1.0);
    return PSC_SUCCESS;
}

/* v of the parallel map and u of the share of both halves with the sign of y. */
static inline void invert_chord(const psc_sampler *s, const struct seen *d, double uv[2])
{
    const struct psc_ellipse *e = &s->disk.seen;
    double sine, cosine, c, s1, length, half;

    if (!(e->ca > 0.0)) { /* a half space */
        const double angle = angle_of(MAX(d->z, 0.0), ABS(d->y));

        uv[0] = 0.5 + COPYSIGN(angle / PSC_PI, d->y);
        uv[1] = 0.5 * (1.0 + d->x);
        return;
    }
    sine = MIN(ABS(d->v) / d->z, 1.0);
    cosine = SQRT((1.0 - sine) * (1.0 + sine));
    /* tan eta = (ca / cb) tan t */
    c = e->cb * cosine;
    s1 = e->ca * sine;
    length = 1.0 / SQRT(c * c + s1 * s1);
    c *= length;
    s1 *= length;
    half = e->a * c;
    uv[0] = 0.5 + 0.5 * COPYSIGN(chord_share(e, &s->disk.cdf, s->total, c, s1), d->y);
    uv[1] = half > 0.0 ? 0.5 * (1.0 + d->x / half) : 0.5;
}

static inline void invert_radial(const psc_sampler *s, const struct seen *d, double uv[2])
{
    const struct psc_ellipse *e = &s->disk.seen;
    double defect, versine, c, s1;
    const double square = eccentric(e, d, &c, &s1);
    const double cc = e->ca * c, cs = e->cb * s1, z = SQRT(cc * cc + cs * cs);
    const double inner = MIN(square * (1.0 + z) / (1.0 + d->z), 1.0);
    const double theta =
        s->disk.map == PSC_DISK_QUASI_UNIFORM
            ? angle_of((1.0 + ellipse_mu1(e->ca, e->cb)) * ABS(c), ABS(s1))
            : cdf_theta(&s->disk.cdf, angle_of(ABS(c), ABS(s1)), ABS(c), ABS(s1));

    if (s->disk.map == PSC_DISK_CONCENTRIC) {
        sine_cosine_defects_f64(MIN(theta, 0.5 * PSC_PI), &defect, &versine);
        disk_to_square(COPYSIGN(SQRT(inner) * (1.0 - versine), c),
                       COPYSIGN(SQRT(inner) * (theta - defect), s1), uv, uv + 1);
    } else {
        const double turn = theta * (0.5 / PSC_PI), half = c < 0.0 ? 0.5 - turn : turn;

        uv[0] = s1 < 0.0 ? 1.0 - half : half;
        uv[1] = 1.0 - inner;
    }
}

static inline void invert_area(const struct psc_disk_light *l, const struct seen *d, double uv[2])
{
    const double s = d->u / d->z, t = d->v / d->z;

    if (l->map == PSC_DISK_AREA_CONCENTRIC) {
        disk_to_square(s, t, uv, uv + 1);
    } else if (l->map == PSC_DISK_AREA_RADIAL) {
        uv[0] = unturn(-s, -t);
        uv[1] = d->margin / (d->z * d->z);
    } else {
        const double sine = MIN(ABS(t), 1.0), square = MAX((1.0 - sine) * (1.0 + sine), 0.0);
        const double half = SQRT(square);
        const double share = segment_share_f64(sine, half, square);

        uv[0] = 0.5 + COPYSIGN(0.5 * (1.0 - share), t);
        uv[1] = half > 0.0 ? 0.5 * (1.0 + s / half) : 0.5;
    }
}

/* All directions. */
static inline void invert_around(enum psc_disk_map map, const double d[3], double uv[2])
{
    const double inner = d[2] > 0.0 ? 0.5 * (d[0] * d[0] + d[1] * d[1]) / (1.0 + d[2])
                                    : 0.5 * (1.0 - d[2]);

    if (map == PSC_DISK_AROUND_PARALLEL) {
        uv[0] = unturn(d[2], d[1]);
        uv[1] = 0.5 * (1.0 + d[0]);
    } else if (map == PSC_DISK_AROUND_CONCENTRIC) {
        polar_to_square(1, inner, d[0], d[1], uv);
    } else {
        uv[0] = unturn(-d[0], -d[1]);
        uv[1] = d[2] > 0.0 ? 1.0 - inner : 0.5 * (d[0] * d[0] + d[1] * d[1]) / (1.0 - d[2]);
    }
}

#endif
