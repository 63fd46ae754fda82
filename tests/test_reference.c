/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Is the reference right? It has to agree with the stored values, which were made with 110
 * digits, and with the equations of [UG18] as printed wherever these do not cancel.
 */
#include <string.h>

#include "csv.h"
#include "random.h"
#include "reference.h"
#include "worst.h"

static double difference(quad a, quad b)
{
    return (double)quad_abs(a - b);
}

/* s and t of a point, and by how much they move when its coordinates do by what 30 digits leave
   open. The azimuth of a radial point has no end but in a lune: there t is taken modulo 1. */
static void point_error(const struct csv *csv, int parallel, double error[2])
{
    void (*map)(const struct reference *, quad, quad, quad *) =
        parallel ? reference_parallel : reference_radial;
    struct reference r;
    quad dx, y = csv->exact[5], st[2], moved_x[2], moved_y[2];
    int i;

    reference_from_angles(&r, csv->number[0], csv->number[1]);
    dx = csv->exact[4] - r.cb;
    map(&r, dx, y, st);
    map(&r, dx + 1e-29, y, moved_x);
    map(&r, dx, y + 1e-29, moved_y);
    for (i = 0; i < 2; i++) {
        double off = difference(st[i], csv->number[2 + i]);
        double open = difference(moved_x[i], st[i]) + difference(moved_y[i], st[i]);
        if (i == 1 && !parallel && r.visible != REFERENCE_LUNE)
            off = fmin(off, 1.0 - off);
        error[i] = fmax(off - open, 0.0);
    }
}

/* The stored point itself, in units of what 30 digits and the half-angle allow. */
static double sample_error(const struct csv *csv, int parallel)
{
    struct reference r;
    quad offset[3];

    reference_from_angles(&r, csv->number[0], csv->number[1]);
    (parallel ? reference_parallel_sample : reference_radial_sample)(&r, csv->number[2],
                                                                     csv->number[3], offset);
    return (difference(offset[0] + r.cb, csv->exact[4]) + difference(offset[1], csv->exact[5]) +
            difference(offset[2] + r.sb, csv->exact[6])) /
           (1e-29 + csv->number[7] * 1e-23 * (double)r.sa);
}

static void compare_points(const char *path, int parallel, int columns)
{
    struct csv csv;
    struct worst s_error = {0}, t_error = {0}, sample = {0};
    const char *problem = csv_open(&csv, path);
    int read = -1;

    while (!problem && (read = csv_read(&csv, columns)) == 1) {
        double error[2];

        if (columns < 8)
            csv.number[7] = 100.0; /* kappa of rows that are not stiff, at most */
        worst_add(&sample, sample_error(&csv, parallel), "%s:%ld", path, csv.line);

        /* left out: the position at a tip and the azimuth of the centre */
        point_error(&csv, parallel, error);
        if (csv.number[3] > 0.0 && csv.number[3] < 1.0)
            worst_add(&s_error, error[0], "%s:%ld", path, csv.line);
        if (parallel || csv.number[2] > 0.0)
            worst_add(&t_error, error[1], "%s:%ld", path, csv.line);
    }
    tap_ok(!problem && read == 0, "%s %s", path, problem ? problem : "was read to its end");
    worst_report(&t_error, 1e-20, "t of %s", path);
    worst_report(&s_error, 1e-20, "s of %s", path);
    worst_report(&sample, 1.0, "points of %s, in units of the digits", path);
    if (!problem)
        csv_close(&csv);
}

static void compare_areas(const char *path)
{
    struct csv csv;
    struct worst error = {0};
    const char *problem = csv_open(&csv, path);
    int read = -1;

    while (!problem && (read = csv_read(&csv, 3)) == 1) {
        struct reference r;
        reference_from_angles(&r, csv.number[0], csv.number[1]);
        worst_add(&error,
                  difference(reference_total(&r), csv.exact[2]) /
                      (csv.number[2] > 0.0 ? csv.number[2] : 1.0),
                  "%s:%ld", path, csv.line);
    }
    tap_ok(!problem && read == 0, "%s %s", path, problem ? problem : "was read to its end");
    worst_report(&error, 1e-20, "%s", path);
    if (!problem)
        csv_close(&csv);
}

/* Equations 13 and 14: the ends of the chord at y. */
static void printed_chord(const struct reference *r, quad y, quad *x_min, quad *x_max)
{
    quad x_e = r->ca * r->cb, a_x = r->sa * r->sb;
    quad root = quad_sqrt(1 - quad_square(y / r->sa));
    quad y_l = quad_sqrt(1 - quad_square(r->ca / r->cb));

    *x_min = x_e - a_x * root;
    *x_max = r->visible == REFERENCE_ELLIPSE || y > y_l ? x_e + a_x * root
                                                        : quad_sqrt(1 - y * y);
}

/* Equations 21 and 22: the ends of the ray at phi. */
static void printed_ray(const struct reference *r, quad phi, quad *r_min, quad *r_max)
{
    quad x_e = r->ca * r->cb, a_x = quad_abs(r->sa * r->sb);
    quad sine = quad_sin(phi), cosine = quad_cos(phi);
    quad ellipse = a_x / quad_sqrt(1 - quad_square(r->cb * sine));
    quad x_l = r->ca / r->cb, y_l = quad_sqrt(1 - x_l * x_l);

    *r_min = r->sb < 0 ? ellipse : 0;
    *r_max = r->visible == REFERENCE_ELLIPSE || phi > quad_atan2(y_l, x_l - x_e)
                 ? ellipse
                 : quad_sqrt(1 - quad_square(x_e * sine)) - x_e * cosine;
}

/* The midpoint rule on the printed equations, for the share of the area before y or phi. Coarse,
   but it knows nothing of the reference: halving the step quarters the error. */
static double printed_share(const struct reference *r, int parallel, double end, double x)
{
    const int steps = 1000;
    double part = 0.0, whole = 0.0;
    int i;

    for (i = 0; i < 2 * steps; i++) {
        double from = i < steps ? 0.0 : x, to = i < steps ? x : end;
        double at = from + (to - from) * (i % steps + 0.5) / steps, low, high;
        quad inner, outer;

        (parallel ? printed_chord : printed_ray)(r, at, &inner, &outer);
        low = (double)inner;
        high = (double)outer;
        if (high > low)
            whole += (to - from) * (parallel ? high - low : high * high - low * low);
        if (i == steps - 1)
            part = whole;
    }
    return part / whole;
}

static void compare_with_equations(void)
{
    struct worst s_error[2], t_error[2];
    uint64_t seed = 1;
    int i, j;

    memset(s_error, 0, sizeof s_error);
    memset(t_error, 0, sizeof t_error);
    for (i = 0; i < 60; i++) {
        double alpha = random_between(&seed, 0.3, 1.3);
        double beta = alpha * random_between(&seed, -0.7, 1.1);
        struct reference r;

        reference_from_angles(&r, alpha, beta);
        for (j = 0; j < 2; j++) {
            double end, x, s = random_uniform(&seed), y_l = 0.0;
            quad low, high, st[2], px, py;

            if (r.visible == REFERENCE_LUNE)
                y_l = (double)quad_sqrt(1 - quad_square(r.ca / r.cb));
            if (j == 1)
                end = y_l > 0.0 ? y_l : (double)r.sa;
            else
                end = y_l > 0.0 ? atan2(y_l, (double)(r.ca / r.cb - r.ca * r.cb)) : acos(-1.0);
            x = end * random_between(&seed, 0.1, 0.9);
            (j ? printed_chord : printed_ray)(&r, x, &low, &high);
            if (j == 1) {
                px = low + (high - low) * s;
                py = x;
            } else {
                quad length = quad_sqrt(low * low + s * (high * high - low * low));
                px = r.ca * r.cb + length * quad_cos(x);
                py = length * quad_sin(x);
            }
            (j ? reference_parallel : reference_radial)(&r, px - r.cb, py, st);
            worst_add(&s_error[j], difference(st[0], s), "alpha %a beta %a", alpha, beta);
            worst_add(&t_error[j],
                      fabs(2.0 * (double)st[1] - 1.0 - printed_share(&r, j, end, x)),
                      "alpha %a beta %a end %a at %a", alpha, beta, end, x);
        }
    }
    for (j = 0; j < 2; j++) {
        worst_report(&s_error[j], 1e-28, "equation 19 or 27, %s", j ? "parallel" : "radial");
        worst_report(&t_error[j], 3e-5, "equation 12 or 20 summed up, %s",
                     j ? "parallel" : "radial");
    }
}

int main(int count, char **path)
{
    int i;

    for (i = 1; i < count; i++) {
        int columns = strstr(path[i], "stiff") ? 8 : 7;
        if (strstr(path[i], "psc_area"))
            compare_areas(path[i]);
        else
            compare_points(path[i], strstr(path[i], "parallel") != NULL, columns);
    }
    compare_with_equations();
    return tap_done();
}
