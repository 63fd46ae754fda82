/* SPDX-License-Identifier: Apache-2.0 */
/* The parallel map of fibres, and its inverse. */
#ifndef PSC_SRC_FIBRE_SOLVE_H
#define PSC_SRC_FIBRE_SOLVE_H

#include "disk_side.h"
#include "ellipse_chord.h"
#include "fibre_series.h"
#include "segment.h"

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
    const double part = rough ? rough_integral(&f->sheaf, lower, from, x) : fibre_integral(&f->sheaf, lower, from, x);
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

/* The same by the series: without bounds, in a number of steps that is that of the build. */
PSC_LANE double series_find(int n, const struct psc_fibres *f, double share, double rest,
                            int *lower)
{
    double sign, target, x = series_start(&f->sheaf, &f->series, share, rest, &sign, &target);
    int i;

    for (i = 0; i < f->series.steps; i++)
        x = series_step(n, &f->series, sign, f->sheaf.end, target, x);
    *lower = sign < 0.0;
    return x;
}

static inline double find_fibre(const struct psc_fibres *f, double share, double rest, int *lower)
{
    switch (f->series.rule) {
#define FIND_CASE(i, m, most) \
    case i: return series_find(m, f, share, rest, lower);
        PSC_FIBRE_RULES(FIND_CASE)
#undef FIND_CASE
    default: return panel_find(f, share, rest, lower);
    }
}

/* The share above a place. */
static inline double fibre_share(const struct psc_fibres *f, int lower, double x)
{
    double upper, under, from, below, part;
    int i = 0;

    switch (f->series.rule) {
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

/* Where on a fibre: chi, and the distances from both ends in the coordinates U, V. */
struct psc_fibre_place {
    double sine, cosine; /* of chi */
    double low, high;
};

/*
 * y in [0, angle] with (y - sin y) + 2 sin y sin^2(w + y / 2) = goal, the integral of
 * 2 sin^2 over the angles from w to w + y, for a short way: y is at most half of w, or comes down
 * to that. Sine and cosine are those of w; `stop` is the squared sine at the other end.
 */
PSC_LANE double short_arc(double sine, double cosine, double angle, double share, double goal,
                          double stop, double sign)
{
    const double start = sine * sine, mean = 0.5 * (start + stop) * share;
    double y = angle * 2.0 * mean / (start + SQRT(start * start + 2.0 * (stop - start) * mean));
    int i;

    for (i = 0; i < 3; i++) {
        double defect, versine, s, c, half_s, half_c, at, slope, bend, error;

        sine_cosine_defects_f64(0.5 * y, &defect, &versine);
        half_s = 0.5 * y - defect;
        half_c = 1.0 - versine;
        s = sine * half_c + sign * (cosine * half_s);
        c = cosine * half_c - sign * (sine * half_s);
        at = s * half_c + sign * (c * half_s);
        error = angle_excess(y, 0.0) + 4.0 * half_s * half_c * (s * s) - goal;
        slope = 2.0 * (at * at);
        bend = sign * (c * half_c - sign * (s * half_s)) / at; /* half of slope' / slope */
        error /= slope;
        y -= error / (1.0 - error * bend);
        y = MIN(MAX(y, 0.0), angle);
    }
    return y;
}

/* Where the fibre has the share v before it, rest = 1 - v. */
PSC_LANE void along_fibre(int brief, const struct psc_fibre *o, double width, double v, double rest,
                          struct psc_fibre_place *p)
{
    /* By w = pi/2 -+ chi, the angle from E or against it, of whichever the fibre is nearer: near and
       far are the sines of w at the ends, near_c and far_c the cosines. */
    const int turned = o->middle < 0.0;
    const double share = turned ? v : rest, other = turned ? rest : v;
    const double near = 1.0 / (turned ? o->first : o->second);
    const double far = 1.0 / (turned ? o->second : o->first);
    const double near_c = near * (ABS(o->middle) + o->half);
    const double far_c = far * (ABS(o->middle) - o->half);
    const double per = 1.0 / (o->k * width), chord = o->half * per;
    double sine, cosine, y, distance, to_near, to_far;
    int from_near;

    if (brief) {
        const double goal = MIN(share, other) * o->weight;
        double defect, versine, s, c;

        from_near = share <= other;
        s = from_near ? near : far;
        c = from_near ? near_c : far_c;
        y = short_arc(s, c, o->angle, MIN(share, other), goal,
                      from_near ? far * far : near * near, from_near ? 1.0 : -1.0);
        sine_cosine_defects_f64(y, &defect, &versine);
        y -= defect;
        sine = s * (1.0 - versine) + (from_near ? c : -c) * y;
        cosine = c * (1.0 - versine) - (from_near ? s : -s) * y;
        distance = y / (sine * s) * per;
    } else {
        const double scale = 2.0 / PSC_PI, whole = scale * o->weight;
        const double before = segment_share(near_c, near, near * near) + share * whole;
        double dn, df;

        /* used beyond the middle, where far_c is negative */
        const double behind = segment_share(ABS(far_c), far, far * far) + other * whole;
        const int beyond = before > 1.0;
        const double from_end = MIN(behind, 1.0);

        solve_chord_f64(beyond ? from_end : before, &sine, &cosine);
        cosine = beyond ? -cosine : cosine;
        dn = MAX((sine * near_c - cosine * near) / (sine * near), 0.0);
        df = MAX((cosine * far - sine * far_c) / (sine * far), 0.0);
        from_near = dn <= df;
        distance = (from_near ? dn : df) * per;
    }
    p->sine = turned ? -cosine : cosine;
    p->cosine = sine;
    distance = MIN(distance, 2.0 * chord);
    to_near = from_near ? distance : 2.0 * chord - distance;
    to_far = from_near ? 2.0 * chord - distance : distance;
    p->low = turned ? to_near : to_far;
    p->high = turned ? to_far : to_near;
}

/* The share of the fibre before the place at tan chi, which is `step` beyond the tangent at its
   start. */
static inline double fibre_before(const struct psc_fibre *o, double tangent, double step)
{
    const double start = o->middle - o->half, secant = SQRT(1.0 + tangent * tangent);
    const double d = o->first * secant, product = tangent * start, other = 1.0 - product;
    const double sine = step / d, angle = angle_of(1.0 + product, step);
    const double sum = tangent + start;
    const double part = angle_excess(angle, sine) +
                        sine * (other >= 0.0 ? 1.0 + other / d : sum * sum / (d * (d - other)));

    return o->weight > 0.0 ? MIN(part / o->weight, 1.0) : 0.5;
}

/* A direction of the cone: x, y and depth = 1 + z; U depth, V depth, depth^2 (1 - U^2 - V^2), and
   its height over the horizon. */
struct psc_fibre_direction {
    double x, y, z, depth, uz, vz, margin, height;
};

PSC_LANE void fibre_direction(const struct psc_sheaf *f, const struct psc_fibre *o,
                                   const struct psc_fibre_place *p, const double per[2], double bt,
                                   struct psc_fibre_direction *d)
{
    const double xi = p->low < p->high ? p->low - o->sine / o->k : o->sine / o->k - p->high;
    const double eta = o->cosine * (f->cos_m / o->k), z = p->cosine * o->k;
    const double forward = p->cosine * (f->sin_m * o->cosine);

    d->x = forward * f->f[0] - p->sine * f->f[1];
    d->y = forward * f->f[1] + p->sine * f->f[0];
    d->uz = d->x * per[0];
    /* across a needle, from the place on it */
    d->vz = bt <= 1.0 ? (eta * f->turn[1] + xi * f->turn[0]) * z : d->y * per[1];
    d->y = bt <= 1.0 ? d->vz * bt : d->y;
    d->z = -(d->x * d->x + d->y * d->y) / (1.0 + z);
    d->depth = z;
    d->margin = z * z * (p->low * p->high);
    d->height = p->cosine * o->height;
}

/* The map of a side: u from the top to the horizon, v along a fibre. */
PSC_LANE void place_on_fibre(const struct psc_sheaf *f, int clipped, int brief,
                             const double per[2], double bt, int lower, double x, double v,
                             struct psc_fibre_direction *d)
{
    struct psc_fibre_place p;
    struct psc_fibre o;

    fibre_at(f, clipped, lower, x, &o);
    along_fibre(brief, &o, f->width, v, 1.0 - v, &p);
    fibre_direction(f, &o, &p, per, bt, d);
}

static inline void fibre_point(const struct psc_disk_light *l, int side, double u, double v,
                               struct psc_fibre_direction *d)
{
    const struct psc_fibres *f = l->fibres + side;
    const double per[2] = {l->seen.ca / l->seen.a, l->seen.cb / l->seen.b};
    int lower;
    const double x = find_fibre(f, u, 1.0 - u, &lower);

    if (f->sheaf.brief)
        place_on_fibre(&f->sheaf, f->sheaf.clipped, 1, per, l->seen.bt, lower, x, v, d);
    else
        place_on_fibre(&f->sheaf, f->sheaf.clipped, 0, per, l->seen.bt, lower, x, v, d);
}

/* The point of the square of a side that goes to a direction, given as fibre_direction() has it;
   out of the cone by rounding, it is the nearest. */
static inline void fibre_invert(const struct psc_disk_light *l, int side,
                                const struct psc_fibre_direction *d, double uv[2])
{
    const struct psc_fibres *fibres = l->fibres + side;
    const struct psc_sheaf *f = &fibres->sheaf;
    const double z = d->depth, margin = d->margin / (z * z);
    const double u = d->uz / z, v = d->vz / z;
    const double eta = u * f->turn[0] + v * f->turn[1], xi = v * f->turn[0] - u * f->turn[1];
    const double chord = SQRT(margin + xi * xi);
    const double forward = d->x * f->f[0] + d->y * f->f[1];
    const double across = d->y * f->f[0] - d->x * f->f[1];
    const int wide = l->seen.bt > 1.0; /* see fibre_direction() */
    double back, s, x, tangent, step;
    struct psc_fibre o;
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
