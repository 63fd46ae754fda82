/* SPDX-License-Identifier: Apache-2.0 */
#include "light_geometry.h"
#include "contour.h"

#define TURN 6.28318530717958647692

static vec3 vector(const float *number, size_t i)
{
    return (vec3){number[3 * i], number[3 * i + 1], number[3 * i + 2]};
}

/* The nearer meeting point, or the farther one from inside. The discriminant is formed from the
   vector across the ray, which keeps its digits for the big balls [Haines 2019]. */
float meet_ball(vec3 center, float radius, vec3 origin, vec3 direction)
{
    const vec3 to_center = sub(center, origin);
    const float along = dot(to_center, direction);
    const vec3 across = sub(to_center, scale(direction, along));
    const float half = radius * radius - dot(across, across);
    if (half < 0)
        return INFINITY;
    const float chord = sqrtf(half);
    return along - chord > 0 ? along - chord : along + chord > 0 ? along + chord : INFINITY;
}

float sphere_meet(const float *number, size_t vectors, vec3 origin, vec3 direction)
{
    (void)vectors;
    return meet_ball(vector(number, 0), number[3], origin, direction);
}

/* Far away, but nearer than where there is nothing at all. */
float cap_meet(const float *number, size_t vectors, vec3 origin, vec3 direction)
{
    (void)vectors;
    (void)origin;
    return dot(vector(number, 0), direction) > cosf(number[3]) ? 1e30f : INFINITY;
}

/* ---- Flat lights ---- */

/* Where a ray meets the plane through a point along u and v, as p = point + s u + t v; infinite if
   nowhere. */
static float meet_plane(vec3 point, vec3 u, vec3 v, vec3 origin, vec3 direction, float *s, float *t)
{
    const vec3 n = cross(u, v), to = sub(point, origin);
    const float distance = dot(n, to) / dot(n, direction);
    const vec3 p = sub(scale(direction, distance), to);
    *s = dot(cross(p, v), n) / dot(n, n);
    *t = dot(cross(u, p), n) / dot(n, n);
    return distance > 0 ? distance : INFINITY;
}

float ellipse_meet(const float *number, size_t vectors, vec3 origin, vec3 direction)
{
    float s, t;
    const float distance = meet_plane(vector(number, 0), vector(number, 1), vector(number, 2),
                                      origin, direction, &s, &t);
    (void)vectors;
    return s * s + t * t <= 1 ? distance : INFINITY;
}

float disk_meet(const float *number, size_t vectors, vec3 origin, vec3 direction)
{
    const vec3 n = unit(vector(number, 1));
    const vec3 u = unit(fabsf(n.x) > 0.6f ? cross(n, (vec3){0, 1, 0}) : cross(n, (vec3){1, 0, 0}));
    float s, t;
    const float distance =
        meet_plane(vector(number, 0), u, cross(n, u), origin, direction, &s, &t);
    (void)vectors;
    return s * s + t * t <= number[6] * number[6] ? distance : INFINITY;
}

float triangle_meet(const float *number, size_t vectors, vec3 origin, vec3 direction)
{
    const vec3 first = vector(number, 0);
    float s, t;
    const float distance = meet_plane(first, sub(vector(number, 1), first),
                                      sub(vector(number, 2), first), origin, direction, &s, &t);
    (void)vectors;
    return s >= 0 && t >= 0 && s + t <= 1 ? distance : INFINITY;
}

float rectangle_meet(const float *number, size_t vectors, vec3 origin, vec3 direction)
{
    float s, t;
    const float distance = meet_plane(vector(number, 0), vector(number, 1), vector(number, 2),
                                      origin, direction, &s, &t);
    (void)vectors;
    return s >= 0 && s <= 1 && t >= 0 && t <= 1 ? distance : INFINITY;
}

float polygon_meet(const float *number, size_t vectors, vec3 origin, vec3 direction)
{
    for (size_t i = 2; i < vectors; ++i) {
        const vec3 fan[3] = {vector(number, 0), vector(number, i - 1), vector(number, i)};
        const float distance = triangle_meet(&fan[0].x, 3, origin, direction);
        if (distance < INFINITY)
            return distance;
    }
    return INFINITY;
}

/* ---- Ellipsoids ---- */

/* In the space where it is the unit ball at the origin. */
float ellipsoid_meet(const float *number, size_t vectors, vec3 origin, vec3 direction)
{
    const vec3 u = vector(number, 1), v = vector(number, 2), w = vector(number, 3);
    const vec3 r = cross(v, w), s = cross(w, u), t = cross(u, v), to = sub(origin, vector(number, 0));
    const float volume = dot(u, r);
    const vec3 from = scale((vec3){dot(r, to), dot(s, to), dot(t, to)}, 1 / volume);
    const vec3 along = scale((vec3){dot(r, direction), dot(s, direction), dot(t, direction)},
                             1 / volume);
    const float length = sqrtf(dot(along, along));
    (void)vectors;
    return meet_ball((vec3){0, 0, 0}, 1, from, scale(along, 1 / length)) / length;
}

/* ---- Outlines, seen from the origin ---- */

/* In the frame of the axis and, across it, of the meridian through z and of the horizontal. */
void cap_outline(const double *number, size_t vectors, double t, double p[3])
{
    const double *axis = number, level = hypot(axis[0], axis[1]);
    const double side[3] = {level > 0 ? -axis[1] / level : 0, level > 0 ? axis[0] / level : 1, 0};
    const double up[3] = {-axis[2] * side[1], axis[2] * side[0], level};
    (void)vectors;
    for (int c = 0; c < 3; ++c)
        p[c] = cos(number[3]) * axis[c] + sin(number[3]) * (cos(TURN * t) * up[c] +
                                                            sin(TURN * t) * side[c]);
}

static void outline(const contour *c, double t, double p[3])
{
    const size_t n = c->count;
    if (n > 0) {
        const size_t i = (size_t)(t * (double)n) % n;
        const double part = t * (double)n - floor(t * (double)n);
        for (int k = 0; k < 3; ++k)
            p[k] = (1 - part) * c->vertex[i][k] + part * c->vertex[(i + 1) % n][k];
        return;
    }
    for (int k = 0; k < 3; ++k)
        p[k] = c->center[k] + cos(TURN * t) * c->u[k] + sin(TURN * t) * c->v[k];
}

#define OUTLINE(shape)                                                                          \
    void shape##_outline(const double *number, size_t vectors, double t, double p[3])          \
    {                                                                                           \
        static const double origin[3] = {0, 0, 0};                                              \
        contour c;                                                                              \
        shape##_contour(number, vectors, origin, &c);                                           \
        outline(&c, t, p);                                                                      \
    }
OUTLINE(disk)
OUTLINE(ellipse)
OUTLINE(ellipsoid)
OUTLINE(triangle)
OUTLINE(rectangle)
OUTLINE(polygon)
