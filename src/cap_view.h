/* SPDX-License-Identifier: Apache-2.0 */
/*
 * What a receiver sees of a light that fills a spherical cap: lane functions from geometry to
 * the cap and its frame, for one build and for loops over many. Nothing here needs more than
 * + - * / and sqrt, but for the half-angle of a distant light.
 */
#ifndef PSC_SRC_CAP_VIEW_H
#define PSC_SRC_CAP_VIEW_H

#include "cap.h"
#include "vector.h"

struct psc_cap_view {
    struct psc_cap cap; /* sin_b = 1, cos_b = q2 = 0 without a normal */
    double h0;          /* 1 - cos alpha, also beyond a right angle */
    double axis[3], sideways[3], normal[3]; /* unit vectors; sideways is normal x axis */
    /* Of a sphere, in units of 1 / scale, a power of two: */
    double scale, radius, distance;
    double power; /* distance^2 - radius^2, exact to rounding: 0 on the surface */
};

/*
 * The frame and the elevation, from a normal of any length near 1 and the vector to the light as
 * the sum vector + low. inverse = 1 / its length, square its square. Returns the height of its
 * end above the receiver's plane, in two words where it is below `close` or cancels.
 *
 * Products are exact where plain ones would cancel: a light near the horizon, or straight above.
 */
PSC_LANE void see_elevation(const double n[3], const double vector[3], const double low[3],
                            double inverse, double square, double close,
                            struct psc_cap_view *o, double *height, double *height_low)
{
    double n2 = dot(n, n), up = dot(n, vector), length, shrink, reach2, reach, widen;
    double across[3], other[3];
    int i, overhead;

    length = SQRT(n2);
    shrink = 1.0 / length;
    *height = (up + dot(n, low)) * shrink;
    *height_low = 0.0;
    if (4.0 * up * up < n2 * square || ABS(*height) < close) {
        double sum = 0.0, sum_low = 0.0, exact = 0.0, exact_low = 0.0, p, e, length_low;

        for (i = 0; i < 3; i++) {
            add_product(n[i], vector[i], &sum, &sum_low);
            add_product(n[i], n[i], &exact, &exact_low);
        }
        sum_low += dot(n, low);
        /* (sum + sum_low) / sqrt(exact + exact_low) */
        two_product(length, length, &p, &e);
        length_low = ((exact - p) - e + exact_low) * (0.5 * shrink);
        *height = (sum + sum_low) * shrink;
        two_product(*height, length, &p, &e);
        *height_low = ((sum - p) - e + sum_low - *height * length_low) * shrink;
    }

    cross_rounded(n, vector, across);
    reach2 = dot(across, across);
    if (16.0 * reach2 < n2 * square) {
        double along[3];

        cross(n, vector, across);
        cross_rounded(n, low, along);
        for (i = 0; i < 3; i++)
            across[i] += along[i];
        reach2 = dot(across, across);
    }
    overhead = !(reach2 > 0.0);
    any_across(n, other);
    for (i = 0; i < 3; i++)
        across[i] = overhead ? other[i] : across[i];
    reach = SQRT(dot(across, across));
    widen = 1.0 / reach;
    for (i = 0; i < 3; i++) {
        o->normal[i] = n[i] * shrink;
        o->sideways[i] = across[i] * widen;
    }
    o->cap.sin_b = *height * inverse;
    o->cap.cos_b = overhead ? 0.0 : reach * shrink * inverse;
}

/* Without a normal: any frame around the axis. */
PSC_LANE void see_around(struct psc_cap_view *o)
{
    int i;

    perpendicular(o->axis, o->sideways);
    for (i = 0; i < 3; i++)
        o->normal[i] = o->axis[i];
    o->cap.sin_b = 1.0;
    o->cap.cos_b = 0.0;
    o->cap.q2 = 0.0;
}

/* A sphere of positive radius; normal is NULL or not zero. Unit lengths overflow to NaN. */
PSC_LANE void see_sphere(const double position[3], const double *normal, const double center[3],
                         double radius, struct psc_cap_view *o)
{
    double offset[3], low[3], n[3], size, square, inverse;
    int i, at_center;

    for (i = 0; i < 3; i++)
        two_sum(center[i], -position[i], &offset[i], &low[i]);
    size = largest(offset);
    o->scale = unit_scale(MAX(size, radius));
    for (i = 0; i < 3; i++) {
        offset[i] *= o->scale;
        low[i] *= o->scale;
    }
    o->radius = radius * o->scale;

    square = dot(offset, offset);
    o->distance = SQRT(square);
    o->power = square - o->radius * o->radius;
    if (4.0 * o->radius * o->radius > square) {
        /* Close to the surface, and from inside: every product with its rounding. */
        double high = 0.0, error = 0.0;

        for (i = 0; i < 3; i++)
            add_product(offset[i], offset[i], &high, &error);
        add_product(o->radius, -o->radius, &high, &error);
        o->power = high + (error + 2.0 * dot(offset, low));
    }

    at_center = !(o->distance > 0.0);
    inverse = 1.0 / (at_center ? 1.0 : o->distance);
    o->cap.sin_a = MIN(o->radius * inverse, 1.0);
    o->cap.cos_a = SQRT(MAX(o->power, 0.0)) * inverse;
    o->h0 = o->power < 0.0 ? 2.0 : psc_cap_versine(&o->cap);
    for (i = 0; i < 3; i++)
        o->axis[i] = offset[i] * inverse;

    if (normal) {
        double height, height_low, sign, upright;

        scale_to_one(normal, n);
        see_elevation(n, offset, low, inverse, square, 2.0 * o->radius, o, &height, &height_low);
        /* How far the horizon is inside the sphere decides what is left of a thin lune. */
        sign = COPYSIGN(1.0, height);
        o->cap.q2 = ((o->radius - sign * height) - sign * height_low) *
                    (o->radius + sign * height) * (inverse * inverse);
        /* Straight above or below, where that is below the two words: cos^2 beta - cos^2 alpha. */
        upright = (o->cap.cos_b - o->cap.cos_a) * (o->cap.cos_b + o->cap.cos_a);
        o->cap.q2 = o->cap.cos_b < 1e-8 ? upright : o->cap.q2;
        for (i = 0; i < 3; i++)
            o->axis[i] = at_center ? o->normal[i] : o->axis[i];
        o->cap.sin_b = at_center ? 1.0 : o->cap.sin_b;
    } else {
        o->axis[2] = at_center ? 1.0 : o->axis[2];
        see_around(o);
    }
}

#define PSC_PI_LOW 1.2246467991473532e-16 /* pi - PSC_PI */

/* Sine, cosine and 1 - cosine of an angle in [0, pi], each accurate relative to itself: the
   polynomials at the distance from 0, pi/2 or pi. */
PSC_LANE void sine_cosine(double a, double *sine, double *cosine, double *versine)
{
    const double right = 0.5 * PSC_PI;
    const int small = a < 1.0, large = a > PSC_PI - 1.0;
    const double x = small   ? a
                     : large ? (PSC_PI - a) + PSC_PI_LOW
                             : (right - a) + 0.5 * PSC_PI_LOW;
    double defect, v, s, c;

    sine_cosine_defects_f64(x, &defect, &v);
    s = x - defect;
    c = 1.0 - v;
    *sine = small || large ? s : c;
    *cosine = small ? c : large ? -c : s;
    *versine = small ? v : large ? 2.0 - v : 1.0 - s;
}

/* A distant cap; the axis is not zero, half_angle in [0, pi]; normal as above. */
PSC_LANE void see_cap(const double *normal, const double axis[3], double half_angle,
                      struct psc_cap_view *o)
{
    static const double exact[3] = {0.0, 0.0, 0.0};
    double a[3], n[3], square, inverse;
    int i;

    scale_to_one(axis, a);
    square = dot(a, a);
    inverse = 1.0 / SQRT(square);
    for (i = 0; i < 3; i++)
        o->axis[i] = a[i] * inverse;
    sine_cosine(half_angle, &o->cap.sin_a, &o->cap.cos_a, &o->h0);
    o->scale = 1.0;
    o->radius = 0.0;
    o->distance = o->power = 1.0;
    if (normal) {
        double height, low, sb;

        scale_to_one(normal, n);
        see_elevation(n, a, exact, inverse, square, 0.0, o, &height, &low);
        sb = ABS(o->cap.sin_b);
        /* sin^2 alpha - sin^2 beta, from whichever pair is smaller. */
        o->cap.q2 = sb <= o->cap.cos_b
                        ? (o->cap.sin_a - sb) * (o->cap.sin_a + sb)
                        : (o->cap.cos_b - ABS(o->cap.cos_a)) * (o->cap.cos_b + ABS(o->cap.cos_a));
    } else {
        see_around(o);
    }
}

#endif
