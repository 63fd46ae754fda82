/* SPDX-License-Identifier: Apache-2.0 */
#include "scene.h"

/* Whether the ray meets the rectangle between low and high; if so, high becomes where. NaN, from
   a ray within the plane, fails the comparisons. */
static inline int meet_quad(const quad *q, vec3 origin, vec3 direction, float low, float *high)
{
    const vec3 to_corner = sub(q->corner, origin);
    const float t = dot(q->normal, to_corner) / dot(q->normal, direction);
    if (!(t > low && t < *high))
        return 0;
    const vec3 p = sub(scale(direction, t), to_corner);
    const float a = dot(p, q->u), b = dot(p, q->v);
    if (!(a >= 0 && a <= 1 && b >= 0 && b <= 1))
        return 0;
    *high = t;
    return 1;
}

static void sky(const scene *s, vec3 direction, hit *h)
{
    const float t = direction.z < 0 ? 0 : 1 - expf(-7 * direction.z);
    h->albedo = add(scale(s->horizon, 1 - t), scale(s->zenith, t));
}

/* The first thing on a ray of the camera; returns whether it is a surface. */
static int look(const scene *s, vec3 d, hit *h, float *distance)
{
    float nearest = INFINITY;
    int surface = 0;

    sky(s, d, h);
    for (size_t i = 0; i < s->light_count; ++i) {
        const float t = light_meet(&s->lights[i], s->eye, d);
        if (t < nearest) {
            nearest = t;
            h->albedo = s->lights[i].radiance;
        }
    }
    for (size_t i = 0; i < s->quad_count; ++i) {
        const quad *q = &s->quads[i];
        if (meet_quad(q, s->eye, d, 0, &nearest)) {
            surface = 1;
            h->position = add(s->eye, scale(d, nearest));
            h->normal = dot(q->normal, d) < 0 ? q->normal : scale(q->normal, -1);
            h->albedo = q->albedo;
            if (q->checkered && ((int)floorf(h->position.x) + (int)floorf(h->position.y)) % 2)
                h->albedo = scale(q->albedo, 0.45f);
        }
    }
    for (size_t i = 0; i < s->ball_count; ++i) {
        const ball *b = &s->balls[i];
        const float t = meet_ball(b->center, b->radius, s->eye, d);
        if (t < nearest) {
            nearest = t;
            surface = 1;
            h->normal = unit(sub(add(s->eye, scale(d, t)), b->center));
            h->position = add(b->center, scale(h->normal, b->radius));
            h->albedo = b->albedo;
        }
    }
    *distance = nearest;
    return surface;
}

/* Replaces what a ray ends at by a point of the fog before it: nearer to the light more of them, by
   the angle under which the light sees them [C. Kulla, M. Fajardo, Importance Sampling Techniques
   for Path Tracing in Participating Media, EGSR 2012, section 4.1]. */
static void look_into_fog(const scene *s, vec3 d, float u, float distance, hit *h)
{
    const float *n = s->lights[0].number;
    const vec3 to_light = sub((vec3){n[0], n[1], n[2]}, s->eye);
    const float nearest = dot(to_light, d), end = fminf(distance, s->depth);
    const vec3 aside = sub(to_light, scale(d, nearest));
    const float height = sqrtf(dot(aside, aside));
    const float first = atan2f(-nearest, height), last = atan2f(end - nearest, height);
    const float t = nearest + height * tanf(first + u * (last - first));
    const float spread = (last - first) * (height + (t - nearest) * (t - nearest) / height);
    const float share = s->fog * expf(-s->fog * t) / 4 * spread; /* pi * phase is 1 / 4 */

    h->position = add(s->eye, scale(d, t));
    h->normal = (vec3){0, 0, 0};
    h->albedo = (vec3){share, share, share};
}

int scene_look(const scene *s, float x, float y, float u, hit *h, vec3 *backdrop)
{
    const vec3 d = unit(add(s->forward, add(scale(s->right, x), scale(s->up, y))));
    float distance;
    const int surface = look(s, d, h, &distance);

    *backdrop = surface ? mul(h->albedo, s->fill) : h->albedo;
    if (s->fog == 0)
        return surface;
    *backdrop = scale(*backdrop, expf(-s->fog * fminf(distance, s->depth)));
    look_into_fog(s, d, u, distance, h);
    return 1;
}

int scene_blocked(const scene *s, const hit *from, vec3 direction, float distance)
{
    const float start = 1e-4f; /* well above the rounding of a position */
    const vec3 position = add(from->position, scale(from->normal, start));
    for (size_t i = 0; i < s->quad_count; ++i)
        if (meet_quad(&s->quads[i], position, direction, start, &distance))
            return 1;
    for (size_t i = 0; i < s->ball_count; ++i)
        if (meet_ball(s->balls[i].center, s->balls[i].radius, position, direction) < distance)
            return 1;
    return 0;
}
