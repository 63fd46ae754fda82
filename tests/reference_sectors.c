/* SPDX-License-Identifier: Apache-2.0 */
#include "reference_sectors.h"

#include <math.h>
#include <string.h>

#include "reference_polygons.h"

typedef quad vector[3];

/* The part of a polygon with plane.p >= 0. */
static int cut(int n, vector *p, const quad *plane)
{
    vector q[REFERENCE_ROOM];
    int i, c, m = 0;

    for (i = 0; i < n; i++) {
        const int next = (i + 1) % n;
        const quad a = reference_dot(plane, p[i]), b = reference_dot(plane, p[next]);

        if (a >= 0)
            memcpy(q[m++], p[i], sizeof q[0]);
        if ((a > 0 && b < 0) || (a < 0 && b > 0)) {
            for (c = 0; c < 3; c++)
                q[m][c] = (p[i][c] * b - p[next][c] * a) / (b - a);
            m++;
        }
    }
    memcpy(p, q, (size_t)m * sizeof q[0]);
    return m;
}

/* theta / sin theta - 1 of sine and cosine: by its series in the square of the sine where the
   quotient would cancel. */
static quad arc_excess(quad sine, quad cosine)
{
    quad square = sine * sine, term = 1, sum = 0;
    int i;

    if (cosine < 0.9)
        return sine > 0 ? quad_atan2(sine, cosine) / sine - 1 : 0;
    for (i = 1; i < 60; i++) {
        term *= square * (2 * i - 1) / (2 * i);
        sum += term / (2 * i + 1);
    }
    return sum;
}

/* Projected solid angle for a normal of length 1; the order of vertices does not matter. Of the
   integral, sum of theta (a x b).n / sin theta for directions a and b, what small polygons cancel
   is taken off: a and b are a first direction and a small vector each. */
static quad lambert(int n, vector *p, const quad *normal)
{
    quad sum = 0, length[REFERENCE_ROOM];
    vector u[REFERENCE_ROOM], e[REFERENCE_ROOM];
    int i, c;

    for (i = 0; i < n; i++)
        length[i] = quad_sqrt(reference_dot(p[i], p[i]));
    for (i = 0; i < n; i++) {
        quad longer = 0;

        for (c = 0; c < 3; c++)
            longer += (p[i][c] - p[0][c]) * (p[i][c] + p[0][c]) / (length[i] + length[0]);
        for (c = 0; c < 3; c++) {
            u[i][c] = p[i][c] / length[i];
            e[i][c] = ((p[i][c] - p[0][c]) - u[0][c] * longer) / length[i];
        }
    }
    for (i = 0; i < n; i++) {
        const int next = (i + 1) % n;
        vector step, across;

        reference_cross(e[i], e[next], across);
        sum += reference_dot(across, normal);
        for (c = 0; c < 3; c++)
            step[c] = e[next][c] - e[i][c];
        reference_cross(u[i], step, across);
        sum += arc_excess(quad_sqrt(reference_dot(across, across)), reference_dot(u[i], u[next])) *
               reference_dot(across, normal);
    }
    return quad_abs(sum) / 2;
}

/* In the plane across the normal. */
static quad azimuth_dot(const struct reference_sectors *s, const quad *a, const quad *b)
{
    return reference_dot(a, s->x) * reference_dot(b, s->x) +
           reference_dot(a, s->y) * reference_dot(b, s->y);
}

static quad azimuth_cross(const struct reference_sectors *s, const quad *a, const quad *b)
{
    return reference_dot(a, s->x) * reference_dot(b, s->y) -
           reference_dot(a, s->y) * reference_dot(b, s->x);
}

void reference_sectors(const struct reference_polygon *light, int flip,
                       struct reference_sectors *s)
{
    vector e1, e2, across;
    quad length = 0, turn;
    int i, c, left = 1;

    for (c = 0; c < 3; c++)
        length += quad_square(light->normal[c]);
    for (c = 0; c < 3; c++)
        s->normal[c] = (flip ? -1 : 1) * light->normal[c] / quad_sqrt(length);
    s->n = light->n;
    for (i = 0; i < light->n; i++)
        for (c = 0; c < 3; c++)
            s->p[i][c] = light->v[i][c];
    /* Any frame, its y counterclockwise from x seen from above; from below, mirrored. */
    for (c = 0; c < 3; c++)
        e1[c] = c == (quad_abs(s->normal[0]) > 0.5);
    reference_cross(s->normal, e1, s->x);
    length = quad_sqrt(reference_dot(s->x, s->x));
    for (c = 0; c < 3; c++)
        s->x[c] /= length;
    reference_cross(s->normal, s->x, s->y);
    for (c = 0; flip && c < 3; c++)
        s->y[c] = -s->y[c];
    /* Counterclockwise around the zenith, the first vertex staying where it is. */
    for (c = 0; c < 3; c++) {
        e1[c] = s->p[1][c] - s->p[0][c];
        e2[c] = s->p[light->n - 1][c] - s->p[0][c];
    }
    reference_cross(e1, e2, across);
    turn = reference_dot(across, s->p[0]);
    if ((turn < 0) != flip)
        for (i = 1; i < s->n - i; i++) {
            vector swap;

            memcpy(swap, s->p[i], sizeof swap);
            memcpy(s->p[i], s->p[s->n - i], sizeof swap);
            memcpy(s->p[s->n - i], swap, sizeof swap);
        }
    s->n = cut(s->n, s->p, s->normal);
    s->total = lambert(s->n, s->p, s->normal);
    for (i = 0; i < s->n; i++)
        left &= azimuth_cross(s, s->p[i], s->p[(i + 1) % s->n]) >= 0;
    s->around = left;
}

/* Projected solid angle at azimuths from that of a to that of b, at most half a turn. */
static quad wedge(const struct reference_sectors *s, const quad *a, const quad *b, int open)
{
    vector p[REFERENCE_ROOM], plane;
    int n = s->n, c;

    memcpy(p, s->p, sizeof p);
    for (c = 0; c < 3; c++)
        plane[c] = reference_dot(b, s->y) * s->x[c] - reference_dot(b, s->x) * s->y[c];
    n = cut(n, p, plane);
    if (!open) {
        for (c = 0; c < 3; c++)
            plane[c] = reference_dot(a, s->x) * s->y[c] - reference_dot(a, s->y) * s->x[c];
        n = cut(n, p, plane);
    }
    return lambert(n, p, s->normal);
}

void reference_in_sectors(const struct reference_sectors *s, const quad d[3], quad uv[2])
{
    const quad rho2 = azimuth_dot(s, d, d) / reference_dot(d, d);
    quad low = 2, high = 0;
    int i, c;

    if (!s->around)
        uv[0] = wedge(s, d, d, 1) / s->total;
    else if (azimuth_cross(s, s->p[0], d) >= 0)
        uv[0] = wedge(s, s->p[0], d, 0) / s->total;
    else
        uv[0] = 1 - wedge(s, d, s->p[0], 0) / s->total;
    for (i = 0; i < s->n; i++) {
        const int next = (i + 1) % s->n;
        const quad a = azimuth_cross(s, d, s->p[i]), b = azimuth_cross(s, d, s->p[next]);
        quad along, r2;
        vector q;

        if (a == b || (a > 0) == (b > 0))
            continue;
        for (c = 0; c < 3; c++)
            q[c] = (s->p[i][c] * b - s->p[next][c] * a) / (b - a);
        along = azimuth_dot(s, q, d);
        if (along < 0)
            continue;
        r2 = azimuth_dot(s, q, q) / reference_dot(q, q);
        low = r2 < low ? r2 : low;
        high = r2 > high ? r2 : high;
    }
    low = s->around ? 0 : low;
    uv[1] = high > low ? (rho2 - low) / (high - low) : NAN;
}
