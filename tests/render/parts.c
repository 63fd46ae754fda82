/* SPDX-License-Identifier: Apache-2.0 */
#include "parts.h"

#include <string.h>

quad *add_quad(scene *s, vec3 corner, vec3 edge_u, vec3 edge_v, vec3 albedo)
{
    quad *q = &s->quads[s->quad_count++];
    *q = (quad){corner, scale(edge_u, 1 / dot(edge_u, edge_u)),
                scale(edge_v, 1 / dot(edge_v, edge_v)), unit(cross(edge_u, edge_v)), albedo, 0};
    return q;
}

void add_ball(scene *s, vec3 center, float radius, vec3 albedo)
{
    s->balls[s->ball_count++] = (ball){center, radius, albedo};
}

void add_block(scene *s, float x, float y, vec3 size, float turn, vec3 albedo)
{
    const vec3 u = {size.x * cosf(turn), size.x * sinf(turn), 0};
    const vec3 v = {-size.y * sinf(turn), size.y * cosf(turn), 0};
    const vec3 w = {0, 0, size.z};
    const vec3 corner = sub((vec3){x, y, 0}, scale(add(u, v), 0.5f));
    add_quad(s, corner, u, w, albedo);
    add_quad(s, corner, v, w, albedo);
    add_quad(s, add(corner, u), v, w, albedo);
    add_quad(s, add(corner, v), u, w, albedo);
    add_quad(s, add(corner, w), u, v, albedo);
}

void add_light(scene *s, const light_shape *shape, vec3 radiance, unsigned count,
               const float *number)
{
    emitter *l = &s->lights[s->light_count++];
    *l = (emitter){.shape = shape, .count = count, .radiance = radiance};
    memcpy(l->number, number, count * sizeof *number);
}

void look_at(scene *s, vec3 eye, vec3 target, float tangent, float aspect)
{
    s->eye = eye;
    s->aspect = aspect;
    s->forward = unit(sub(target, eye));
    s->right = unit(cross(s->forward, (vec3){0, 0, 1}));
    s->up = scale(cross(s->right, s->forward), tangent / aspect);
    s->right = scale(s->right, tangent);
}
