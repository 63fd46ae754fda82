/* SPDX-License-Identifier: Apache-2.0 */
/* What scenes are made of, and the functions that make them. */
#ifndef PARTS_H
#define PARTS_H

#include "scene.h"

quad *add_quad(scene *s, vec3 corner, vec3 edge_u, vec3 edge_v, vec3 albedo);
void add_ball(scene *s, vec3 center, float radius, vec3 albedo);

/* A block that stands on the ground z = 0, turned about its vertical axis. */
void add_block(scene *s, float x, float y, vec3 size, float turn, vec3 albedo);

/* A light of this shape; the numbers are those of its build call, in their order. */
void add_light(scene *s, const light_shape *shape, vec3 radiance, unsigned count,
               const float *number);
#define ADD_LIGHT(s, shape, radiance, ...)                                                      \
    add_light(s, shape, radiance, sizeof(float[]){__VA_ARGS__} / sizeof(float),                 \
              (float[]){__VA_ARGS__})

/* A camera; tangent is that of half its horizontal angle, aspect its width / height. */
void look_at(scene *s, vec3 eye, vec3 target, float tangent, float aspect);

/* scenes_spheres.c */
void make_cornell(scene *s);
void make_dome(scene *s);
void make_sun(scene *s);

/* scenes_disks.c */
void make_disk(scene *s);
void make_fog(scene *s);
void make_ellipsoids(scene *s);

/* scenes_polygons.c */
void make_windows(scene *s);

#endif
