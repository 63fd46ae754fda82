/* SPDX-License-Identifier: Apache-2.0 */
/* Samples that are solved for one at a time, in double behind both precisions. */
#ifndef PSC_SRC_DISK_SOLVE_H
#define PSC_SRC_DISK_SOLVE_H

#include "disk_table.h"

/* All directions: 1 - z = 2 inner, or by the angle around the x axis. */
static inline void around_point(enum psc_disk_map map, double u, double v,
                                struct psc_disk_point_f64 *p)
{
    double c, s, versine, radius, margin, inner, rest, r;

    if (map == PSC_DISK_AROUND_PARALLEL) {
        turn_f64(u, &s, &c, &versine);
        r = 2.0 * SQRT(v * (1.0 - v));
        p->x = 2.0 * v - 1.0;
        p->y = r * s;
        p->z = r * c - 1.0;
        return;
    }
    if (map == PSC_DISK_AROUND_CONCENTRIC) {
        square_to_disk_f64(u, v, &c, &s, &versine, &radius, &margin);
        inner = radius * radius;
        rest = margin * (1.0 + radius);
    } else {
        full_turn_f64(u, &c, &s);
        inner = 1.0 - v;
        rest = v;
    }
    r = 2.0 * SQRT(inner * rest);
    p->x = r * c;
    p->y = r * s;
    p->z = -2.0 * inner;
}

static inline void solve_radial(const struct psc_disk_light *d, double u, double v,
                                struct psc_disk_point_f64 *p)
{
    const struct psc_ellipse *e = &d->seen;
    double c0, s0, c, s, versine, radius, margin, inner, rest, z;

    if (d->map == PSC_DISK_CONCENTRIC) {
        square_to_disk_f64(u, v, &c0, &s0, &versine, &radius, &margin);
        inner = radius * radius;
        rest = margin * (1.0 + radius);
    } else {
        full_turn_f64(u, &c0, &s0);
        inner = 1.0 - v;
        rest = v;
    }
    cdf_solve(&d->cdf, angle_of(ABS(c0), ABS(s0)), &c, &s);
    z = SQRT((e->ca * c) * (e->ca * c) + (e->cb * s) * (e->cb * s));
    cone_point_f64(e->a, e->b, inner, rest, COPYSIGN(c, c0), COPYSIGN(s, s0), 1.0 / (1.0 + z), p);
}

static inline void solve_parallel(const struct psc_disk_light *d, double total, double u, double v,
                                  struct psc_disk_point_f64 *p)
{
    const struct psc_ellipse *e = &d->seen;
    const double share = ABS(2.0 * u - 1.0), f = 2.0 * v - 1.0;
    double c, s, y, q, k, z;

    p->rest = 4.0 * v * (1.0 - v);
    if (!(e->ca > 0.0)) { /* a half space */
        const double angle = 0.5 * PSC_PI * share;
        double defect, versine;

        sine_cosine_defects_f64(angle, &defect, &versine);
        k = SQRT(p->rest);
        p->x = f;
        p->y = COPYSIGN(k * (angle - defect), u - 0.5);
        p->z = k * (1.0 - versine) - 1.0;
        p->c = 1.0;
        p->s = 0.0;
        return;
    }
    chord_solve(e, &d->cdf, total, share, &c, &s);
    s = COPYSIGN(s, u - 0.5);
    y = 1.0 / (c * c + e->ca * (s * s));
    q = 1.0 / (e->ca * (c * c) + s * s);
    k = SQRT(p->rest * q + f * f * e->ca * y);
    z = k * SQRT(e->ca * (c * c) + (e->cb * s) * (e->cb * s));
    p->x = f * e->a * c * SQRT(y);
    p->y = k * e->b * s;
    p->z = -(p->x * p->x + p->y * p->y) / (1.0 + z);
    p->c = c;
    p->s = s;
}

static inline void solve_point(const psc_sampler *s, double u, double v,
                               struct psc_disk_point_f64 *p)
{
    p->c = 1.0;
    p->s = p->rest = 0.0;
    if (s->disk.inside) {
        around_point(s->disk.map, u, v, p);
    } else if (s->disk.map == PSC_DISK_PARALLEL) {
        solve_parallel(&s->disk, s->total, u, v, p);
    } else if (s->disk.map < PSC_DISK_AREA_RADIAL) {
        solve_radial(&s->disk, u, v, p);
    } else {
        struct psc_disk_world_f64 w;

        flat_world_f64(s, &w);
        area_lane_f64(s->disk.map, &w, u, v, p);
    }
}

#endif
