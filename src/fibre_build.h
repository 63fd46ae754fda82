/* SPDX-License-Identifier: Apache-2.0 */
/*
 * From a horizon to fibres that are ready: the range of s and panels of quadrature.
 *
 * The density is analytic in s but for k = 0, at 0 and pi +- i arsinh(cos m / sin m), and where an
 * end of a fibre has 1 + tan^2 chi = 0, at arctan(shear / width), or pi less that, +-
 * i arsinh(1 / tan c), c being the largest chi. A panel of 16 nodes gives all digits where the
 * nearest of these is at least 1 / PSC_NEARNESS of its half-width from its middle.
 */
#ifndef PSC_SRC_FIBRE_BUILD_H
#define PSC_SRC_FIBRE_BUILD_H

#include "ellipse.h"
#include "fibre_fit.h"

#define PSC_NEARNESS 0.505
/* A panel from a place with a singularity beside it at the distance 1. */
#define PSC_FIRST_PANEL 1.17
/* How much farther from it the next panel ends: (1 + nearness) / (1 - nearness). */
#define PSC_NEXT_PANEL 3.04

/* arsinh x for x >= 0 from below, by 2 % up to x = 2; no more than 3. */
static inline double arsinh_below(double x)
{
    return 3.0 * x / (2.0 + SQRT(1.0 + x * x));
}

/* Places beside which there is a singularity, and how far. */
struct psc_sharp {
    double at[6], off[6];
};

/* The distance from s to the nearest singularity. */
static inline double sharpness(const struct psc_sharp *p, double s)
{
    double least = 9.0;
    int i;

    for (i = 0; i < 6; i++) {
        const double d = (s - p->at[i]) * (s - p->at[i]) + p->off[i] * p->off[i];

        least = MIN(least, d);
    }
    return MAX(SQRT(least), 0.5 * DBL_EPSILON);
}

/* A half space (flat) has none: what would be sharp at its edge is at the edge. */
static inline void find_sharp(const struct psc_sheaf_f64 *f, int flat, struct psc_sharp *p)
{
    const double tangent = SQRT(f->shear * f->shear + f->width * f->width);
    const double k = flat ? 3.0 : arsinh_below(f->cos_m / f->sin_m);
    const double t = flat ? 3.0 : arsinh_below(1.0 / tangent);
    const double where = angle_of(f->width, ABS(f->shear));
    const double at[6] = {0.0, PSC_PI, where, PSC_PI - where, -where, PSC_PI + where};
    int i;

    for (i = 0; i < 6; i++) {
        p->at[i] = at[i];
        p->off[i] = i < 2 ? k : t;
    }
}

static inline void add_panel(struct psc_fibres *f, int lower, double edge)
{
    const int n = f->panels[lower];
    const double from = n > 0 ? f->edge[lower][n - 1] : 0.0;
    const double below = n > 0 ? f->below[lower][n - 1] : 0.0;

    if (n == PSC_FIBRE_PANELS || !(edge > from))
        return;
    f->edge[lower][n] = edge;
    f->below[lower][n] = below + fibre_integral(&f->sheaf, lower, from, edge);
    f->panels[lower] = n + 1;
}

/* Panels from a to b, ever longer from either end, where the nearest singularities are at the
   distances p and q. */
static inline void graded_panels(struct psc_fibres *f, int lower, double a, double b, double p,
                                 double q)
{
    const double middle = 0.5 * (a + b), half = 0.5 * (b - a);
    double step;
    int n = 0;

    if (b - a > PSC_FIRST_PANEL * MIN(p, q)) {
        for (step = PSC_FIRST_PANEL * p; step < half; step *= PSC_NEXT_PANEL)
            add_panel(f, lower, a + step);
        add_panel(f, lower, middle);
        for (step = PSC_FIRST_PANEL * q; step < half; step *= PSC_NEXT_PANEL)
            n++;
        for (; n > 0; n--) {
            step /= PSC_NEXT_PANEL;
            add_panel(f, lower, b - step);
        }
    }
    add_panel(f, lower, b);
}

/* The panels of one half, and the integral over it. */
static inline double half_panels(struct psc_fibres *f, int lower, const struct psc_sharp *p)
{
    const double middle = 0.5 * f->sheaf.end;
    double from = 0.0, near = sharpness(p, lower ? f->sheaf.end : 0.0);
    int i;

    f->panels[lower] = 0;
    /* the places inside, in order from the end of the range in question */
    for (i = 0; i < 2; i++) {
        const double s = p->at[2 + (lower ? 1 - i : i)], x = lower ? f->sheaf.end - s : s;

        if (x > from && x < middle && p->off[2] < 0.5) {
            const double next = sharpness(p, s);

            graded_panels(f, lower, from, x, near, next);
            from = x;
            near = next;
        }
    }
    graded_panels(f, lower, from, middle, near, sharpness(p, middle));
    return f->below[lower][f->panels[lower] - 1];
}

/* The side of the horizon given; 0 when nothing is above it. */
static inline int sheaf_build(struct psc_sheaf_f64 *f, const struct psc_ellipse *e,
                              const struct psc_horizon *h)
{
    const double at = MIN(e->at, PSC_WIDEST_TANGENT), bt = MIN(e->bt, PSC_WIDEST_TANGENT);
    const double nx = h->x / at, ny = h->y / bt;
    double stretch, length, widest;

    f->clipped = h->margin > 0.0;
    if (!f->clipped && !(h->z > 0.0))
        return 0;
    f->nz = h->z;
    f->nf = SQRT(nx * nx + ny * ny);
    f->f[0] = f->nf > 0.0 ? nx / f->nf : 0.0;
    f->f[1] = f->nf > 0.0 ? ny / f->nf : -1.0;
    f->turn[0] = at * f->f[0];
    f->turn[1] = bt * f->f[1];
    stretch = SQRT(f->turn[0] * f->turn[0] + f->turn[1] * f->turn[1]); /* tan m */
    f->turn[0] /= stretch;
    f->turn[1] /= stretch;
    length = SQRT(1.0 + stretch * stretch);
    f->sin_m = stretch / length;
    f->cos_m = 1.0 / length;
    f->shear = (bt / stretch - at / stretch) * ((bt + at) / stretch) * (f->f[0] * f->f[1]) *
               f->sin_m;
    f->width = at * (bt / stretch);
    f->end = PSC_PI;
    f->rest = 0.0;
    f->cos_end = -1.0;
    if (f->clipped) {
        const double sine = f->cos_m * SQRT(h->margin);

        f->end = angle_and_rest(-h->z, sine, &f->rest);
        f->cos_end = -h->z / SQRT(h->z * h->z + sine * sine);
    }
    widest = f->end < 0.5 * PSC_PI ? f->width * f->cos_m * SQRT(h->margin) / f->sin_m : f->width;
    /* the sine of the angle of a fibre is 2 half / (first second) of struct psc_fibre_f64 */
    f->brief = 4.25 * widest <= 1.0;
    f->brief_f32 = 2.0 * widest <= 1.0;
    return 1;
}

static inline int fibres_build(struct psc_fibres *f, const struct psc_ellipse *e,
                               const struct psc_horizon *h)
{
    struct psc_sharp sharp;
    double sum;

    if (!sheaf_build(&f->sheaf, e, h))
        return 0;
    f->total = PSC_PI * (e->a * e->b) * h->z; /* unless the horizon cuts it */
    f->steps = series_steps(&f->sheaf, e->at);
    f->rule = f->steps > 0 ? fibre_rule(e->at) : -1;
    switch (f->rule) {
#define BUILD_CASE(i, m, most)                                                                  \
    case i:                                                                                     \
        series_of_one(m, psc_rule_f64_##m.c, psc_rule_f64_##m.s, psc_rule_f64_##m.per_s,        \
                      psc_rule_f64_##m.column, psc_rule_f64_##m.power, f);                      \
        return f->total > 0.0;
        PSC_FIBRE_RULES(BUILD_CASE)
#undef BUILD_CASE
    default: break;
    }
    find_sharp(&f->sheaf, !(e->bt < PSC_WIDEST_TANGENT), &sharp);
    sum = half_panels(f, 0, &sharp) + half_panels(f, 1, &sharp);
    if (f->sheaf.clipped)
        f->total = sum;
    return f->total > 0.0;
}

#endif
