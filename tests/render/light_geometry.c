/* SPDX-License-Identifier: Apache-2.0 */
#include "light_geometry.h"

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
