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
    /* Of a sphere, in units of the power of two `unit`, which is 1 / scale: */
    double scale, unit, radius, distance;
    double power; /* distance^2 - radius^2, exact to rounding: 0 on the surface */
};

/* What scale (to - from) loses when it is rounded. */
PSC_LANE void rounded_off(const double from[3], const double to[3], double scale, double low[3])
{
    double sum;
    int i;

    for (i = 0; i < 3; i++) {
        two_sum(to[i], -from[i], &sum, &low[i]);
        low[i] *= scale;
    }
}

/*
 * The frame and the elevation, from a normal and the vector to the light: scale (to - from),
 * rounded. inverse = 1 / its length, square its square. Returns the height of its end above the
 * receiver's plane; where that is within `close` of 0 or of the lengths -radius and radius, plain
 * products would cancel, and all are exact. Then the height has two words. So are the products of
 * the frame when the light is nearly straight above or below. plain: none of this is the case, see
 * sphere_is_plain().
 */
PSC_LANE void see_elevation(int plain, const double normal[3], const double from[3],
                            const double to[3], double scale, const double vector[3],
                            double inverse, double square, double radius, double close,
                            struct psc_cap_view *o, double *height, double *height_low)
{
    double n[3] = {normal[0], normal[1], normal[2]}, n2 = dot(n, n);
    double length, shrink, reach2, reach, widen, across[3];
    int i, overhead = 0;

    if (!plain && !is_fair(n2)) {
        scale_to_one(normal, n);
        n2 = dot(n, n);
    }
    length = SQRT(n2);
    shrink = 1.0 / length;
    *height = dot(n, vector) * shrink;
    *height_low = 0.0;
    if (!plain && (ABS(ABS(*height) - radius) < close || ABS(*height) < close)) {
        double sum = 0.0, sum_low = 0.0, exact = 0.0, exact_low = 0.0, p, e, length_low;
        double low[3];

        rounded_off(from, to, scale, low);
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
    if (!plain && 16.0 * reach2 <= n2 * square) { /* 0 where there is no distance */
        double low[3], along[3], other[3];

        rounded_off(from, to, scale, low);
        cross(n, vector, across);
        cross_rounded(n, low, along);
        for (i = 0; i < 3; i++)
            across[i] += along[i];
        overhead = !(dot(across, across) > 0.0);
        any_across(n, other);
        for (i = 0; i < 3; i++)
            across[i] = overhead ? other[i] : across[i];
        reach2 = dot(across, across);
    }
    reach = SQRT(reach2);
    widen = 1.0 / reach;
    scale3(shrink, n, o->normal);
    scale3(widen, across, o->sideways);
    o->cap.sin_b = *height * inverse;
    o->cap.cos_b = overhead ? 0.0 : reach * shrink * inverse;
}

/* Without a normal: any frame around the axis. */
PSC_LANE void see_around(struct psc_cap_view *o)
{
    perpendicular(o->axis, o->sideways);
    copy3(o->axis, o->normal);
    o->cap.sin_b = 1.0;
    o->cap.cos_b = 0.0;
    o->cap.q2 = 0.0;
}

/* Where the plain products of a sphere's view come within this share of its distance of
   cancelling, they are exact. */
#define PSC_CLOSE 0.25

/*
 * Whether all is in range and plain products suffice for a sphere outside which the receiver is,
 * as is so for most: then see_sphere() has no branch left. False for whatever is not finite. The
 * compiler finds the common terms.
 */
PSC_LANE int sphere_is_plain(const double position[3], const double normal[3],
                             const double center[3], double radius)
{
    const double offset[3] = {center[0] - position[0], center[1] - position[1],
                              center[2] - position[2]};
    const double square = dot(offset, offset), n2 = dot(normal, normal);
    double across[3], height, close;

    if (!(radius > 0.0 && is_fair(square) && is_fair(n2) &&
          square - radius * radius >= PSC_CLOSE * square))
        return 0;
    cross_rounded(normal, offset, across);
    height = ABS(dot(normal, offset) * (1.0 / SQRT(n2)));
    close = PSC_CLOSE * SQRT(square);
    return ABS(height - radius) >= close && height >= close &&
           16.0 * dot(across, across) > n2 * square;
}

/* A sphere of positive radius; normal is NULL or not zero. Unit lengths overflow to NaN. */
PSC_LANE void see_sphere_as(int plain, const double position[3], const double *normal,
                            const double center[3], double radius, struct psc_cap_view *o)
{
    double offset[3], square, square_r, inverse;
    int i, at_center;

    offset[0] = center[0] - position[0];
    offset[1] = center[1] - position[1];
    offset[2] = center[2] - position[2];
    o->scale = o->unit = 1.0;
    o->radius = radius;
    square = dot(offset, offset);
    square_r = radius * radius;
    if (!plain && !is_fair(MAX(square, square_r))) {
        const double size = largest(offset);

        o->scale = unit_scale(MAX(size, radius));
        o->unit = unit_inverse(o->scale);
        scale3(o->scale, offset, offset);
        o->radius = radius * o->scale;
        square = dot(offset, offset);
        square_r = o->radius * o->radius;
    }

    o->distance = SQRT(square);
    o->power = square - square_r;
    if (!plain && o->power < PSC_CLOSE * square) {
        /* Close to the surface, and from inside: every product with its rounding. */
        double high = 0.0, error = 0.0, low[3];

        rounded_off(position, center, o->scale, low);
        for (i = 0; i < 3; i++)
            add_product(offset[i], offset[i], &high, &error);
        add_product(o->radius, -o->radius, &high, &error);
        o->power = high + (error + 2.0 * dot(offset, low));
    }

    at_center = !plain && !(o->distance > 0.0);
    inverse = 1.0 / (at_center ? 1.0 : o->distance);
    o->cap.sin_a = plain ? o->radius * inverse : MIN(o->radius * inverse, 1.0);
    o->cap.cos_a = SQRT(plain ? o->power : MAX(o->power, 0.0)) * inverse;
    o->h0 = plain            ? o->cap.sin_a * o->cap.sin_a / (1.0 + o->cap.cos_a)
            : o->power < 0.0 ? 2.0
                             : psc_cap_versine(&o->cap);
    scale3(inverse, offset, o->axis);

    if (normal) {
        double height, height_low, sign, upright;

        see_elevation(plain, normal, position, center, o->scale, offset, inverse, square, o->radius,
                      PSC_CLOSE * o->distance, o, &height, &height_low);
        /* How far the horizon is inside the sphere decides what is left of a thin lune. */
        sign = COPYSIGN(1.0, height);
        o->cap.q2 = ((o->radius - sign * height) - sign * height_low) *
                    (o->radius + sign * height) * (inverse * inverse);
        /* Straight above or below, where that is below the two words: cos^2 beta - cos^2 alpha. */
        upright = (o->cap.cos_b - o->cap.cos_a) * (o->cap.cos_b + o->cap.cos_a);
        o->cap.q2 = !plain && o->cap.cos_b < 1e-8 ? upright : o->cap.q2;
        if (at_center) {
            copy3(o->normal, o->axis);
            o->cap.sin_b = 1.0;
        }
    } else {
        o->axis[2] = at_center ? 1.0 : o->axis[2];
        see_around(o);
    }
}

PSC_LANE void see_sphere(const double position[3], const double *normal, const double center[3],
                         double radius, struct psc_cap_view *o)
{
    see_sphere_as(0, position, normal, center, radius, o);
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
    static const double origin[3] = {0.0, 0.0, 0.0};
    double a[3], square, length, inverse;

    scale_to_one(axis, a);
    square = dot(a, a);
    length = SQRT(square);
    inverse = 1.0 / length;
    scale3(inverse, a, o->axis);
    sine_cosine(half_angle, &o->cap.sin_a, &o->cap.cos_a, &o->h0);
    o->scale = o->unit = 1.0;
    o->radius = 0.0;
    o->distance = o->power = 1.0;
    if (normal) {
        double height, low, sb;

        see_elevation(0, normal, origin, a, 1.0, a, inverse, square, o->cap.sin_a * length,
                      PSC_CLOSE * length, o, &height, &low);
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
