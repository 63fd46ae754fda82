/* SPDX-License-Identifier: Apache-2.0 */
/* The parallel map of fibres, and its inverse. */
#ifndef PSC_SRC_FIBRE_SOLVE_H
#define PSC_SRC_FIBRE_SOLVE_H

#include "disk_side.h"
#include "fibre_series.h"

/* The end of what lies before panel i of a half. */
static inline void panel_start(const struct psc_fibres *f, int lower, int i, double *from,
                               double *below)
{
    *from = i > 0 ? f->edge[lower][i - 1] : 0.0;
    *below = i > 0 ? f->below[lower][i - 1] : 0.0;
}

/* A step of Newton's towards the place with the given integral from the start of its panel,
   between bounds that it tightens. */
static inline double panel_step(const struct psc_fibres *f, int lower, int rough, double from,
                                double goal, double *low, double *high, double x)
{
    const double part = rough ? rough_integral(&f->sheaf, lower, from, x)
                              : fibre_integral(&f->sheaf, lower, from, x);
    const double error = part - goal, next = x - error / fibre_density(&f->sheaf, lower, x);

    if (error < 0.0)
        *low = x;
    else
        *high = x;
    return error == 0.0 ? x : next >= *low && next <= *high ? next : 0.5 * (*low + *high);
}

/* The place that has the given share of the whole above it, and the rest below: with few nodes at
   first, then with all. */
static inline double panel_find(const struct psc_fibres *f, double share, double rest, int *lower)
{
    const double upper = f->below[0][f->panels[0] - 1], under = f->below[1][f->panels[1] - 1];
    double target = share * (upper + under), from, below, fraction, x;
    int i = 0, rough, step;

    *lower = target > upper;
    if (*lower)
        target = MIN(rest * (upper + under), under);
    while (i < f->panels[*lower] - 1 && target > f->below[*lower][i])
        i++;
    panel_start(f, *lower, i, &from, &below);
    fraction = MIN((target - below) / (f->below[*lower][i] - below), 1.0);
    if (i == 0)
        fraction = *lower && f->sheaf.clipped ? SQRT(fraction) : rough_cbrt(fraction);
    x = from + fraction * (f->edge[*lower][i] - from);
    for (rough = 1; rough >= 0; rough--) {
        double low = from, high = f->edge[*lower][i], change = 1.0;
        const double close = (rough ? 1e-3 : 1e-8) * (high - from);

        for (step = 0; step < 40 && ABS(change) > close; step++) {
            const double next =
                panel_step(f, *lower, rough, from, target - below, &low, &high, x);

            change = next - x;
            x = next;
        }
    }
    return x;
}

static inline void panel_site(const struct psc_fibres *f, double share, double rest,
                              struct psc_fibre_site_f64 *o)
{
    int lower;
    const double x = panel_find(f, share, rest, &lower);

    fibre_place_at(&f->sheaf, f->sheaf.clipped, lower, x, o);
}

static inline void find_fibre(const struct psc_fibres *f, double share, double rest,
                              struct psc_fibre_site_f64 *o)
{
    const struct series_view_f64 q = view_of_f64(&f->series);

    switch (f->rule) {
#define FIND_CASE(i, m, most) \
    case i: series_find_f64(m, &q, &f->sheaf, f->steps, share, rest, o); break;
        PSC_FIBRE_RULES(FIND_CASE)
#undef FIND_CASE
    default: panel_site(f, share, rest, o); break;
    }
}

PSC_LANE double series_share(int n, const struct psc_fibre_series_f64 *series, double sign,
                             double x)
{
    const struct series_view_f64 q = view_of_f64(series);
    struct fibre_arc_f64 at;

    arc_of_f64(x, &at);
    return series_integral_f64(n, &q, sign, &at);
}

/* The share above a place. */
static inline double fibre_share(const struct psc_fibres *f, int lower, double x)
{
    double upper, under, from, below, part;
    int i = 0;

    switch (f->rule) {
#define SHARE_CASE(i, m, most)                                                                  \
    case i:                                                                                     \
        if (f->sheaf.clipped)                                                                   \
            return series_share(m, &f->series, 1.0, lower ? f->sheaf.end - x : x);              \
        part = series_share(m, &f->series, lower ? -1.0 : 1.0, x);                              \
        return lower ? 1.0 - part : part;
        PSC_FIBRE_RULES(SHARE_CASE)
#undef SHARE_CASE
    default: break;
    }
    upper = f->below[0][f->panels[0] - 1];
    under = f->below[1][f->panels[1] - 1];
    x = MIN(MAX(x, 0.0), f->edge[lower][f->panels[lower] - 1]);
    while (i < f->panels[lower] - 1 && x > f->edge[lower][i])
        i++;
    panel_start(f, lower, i, &from, &below);
    part = (below + fibre_integral(&f->sheaf, lower, from, x)) / (upper + under);
    return lower ? 1.0 - part : part;
}

/* The share of the fibre before the place at tan chi, which is `step` beyond the tangent at its
   start. */
static inline double fibre_before(const struct psc_fibre_f64 *o, double tangent, double step)
{
    const double start = o->middle - o->half, secant = SQRT(1.0 + tangent * tangent);
    const double d = o->first * secant, product = tangent * start, other = 1.0 - product;
    const double sine = step / d, angle = angle_of(1.0 + product, step);
    const double sum = tangent + start;
    const double part = angle_excess_f64(angle, sine) +
                        sine * (other >= 0.0 ? 1.0 + other / d : sum * sum / (d * (d - other)));

    return o->weight > 0.0 ? MIN(part / o->weight, 1.0) : 0.5;
}

/* u from the top to the horizon. */
static inline void fibre_point(const struct psc_disk_light *l, int side, double u, double v,
                               struct psc_fibre_direction_f64 *d)
{
    const struct psc_fibres *f = l->fibres + side;
    const double per[2] = {l->seen.ca / l->seen.a, l->seen.cb / l->seen.b};
    struct psc_fibre_site_f64 site;

    find_fibre(f, u, 1.0 - u, &site);
    if (f->sheaf.brief)
        place_on_fibre_f64(&f->sheaf, f->sheaf.clipped, 1, per, l->seen.bt, &site, v, d);
    else
        place_on_fibre_f64(&f->sheaf, f->sheaf.clipped, 0, per, l->seen.bt, &site, v, d);
}

/* The point of the square of a side that goes to a direction, given as fibre_direction() has it;
   out of the cone by rounding, it is the nearest. */
static inline void fibre_invert(const struct psc_disk_light *l, int side,
                                const struct psc_fibre_direction_f64 *d, double uv[2])
{
    const struct psc_fibres *fibres = l->fibres + side;
    const struct psc_sheaf_f64 *f = &fibres->sheaf;
    const double z = d->depth, margin = d->margin / (z * z);
    const double u = d->uz / z, v = d->vz / z;
    const double eta = u * f->turn[0] + v * f->turn[1], xi = v * f->turn[0] - u * f->turn[1];
    const double chord = SQRT(margin + xi * xi);
    const double forward = d->x * f->f[0] + d->y * f->f[1];
    const double across = d->y * f->f[0] - d->x * f->f[1];
    const int wide = l->seen.bt > 1.0; /* see fibre_direction_f64() */
    double back, s, x, tangent, step;
    struct psc_fibre_f64 o;
    int lower;

    s = wide ? angle_and_rest(forward / f->sin_m, chord * z, &back)
             : angle_and_rest(eta, f->cos_m * chord, &back);
    lower = s > 0.5 * f->end;
    x = !lower ? s : f->clipped ? MAX(f->end - s, 0.0) : back;
    fibre_at(f, f->clipped, lower, x, &o);
    if (wide) {
        tangent = across / SQRT(forward * forward + z * z);
        step = MAX(tangent - o.middle + o.half, 0.0);
    } else {
        step = f->width * o.k * (xi < 0.0 ? margin / (chord - xi) : chord + xi);
        tangent = o.middle - o.half + step;
    }
    uv[0] = fibre_share(fibres, lower, x);
    uv[1] = fibre_before(&o, tangent, step);
}

#endif
