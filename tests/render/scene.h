/* SPDX-License-Identifier: Apache-2.0 */
/* The scenes: rectangles and balls, lit by spheres or by a distant sun. */
#ifndef SCENE_H
#define SCENE_H

#include <math.h>
#include <stddef.h>
#include <stdint.h>

typedef struct vec3 {
    float x, y, z;
} vec3;

static inline vec3 add(vec3 a, vec3 b) { return (vec3){a.x + b.x, a.y + b.y, a.z + b.z}; }
static inline vec3 sub(vec3 a, vec3 b) { return (vec3){a.x - b.x, a.y - b.y, a.z - b.z}; }
static inline vec3 mul(vec3 a, vec3 b) { return (vec3){a.x * b.x, a.y * b.y, a.z * b.z}; }
static inline vec3 scale(vec3 a, float s) { return (vec3){a.x * s, a.y * s, a.z * s}; }
static inline float dot(vec3 a, vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
static inline vec3 unit(vec3 a) { return scale(a, 1 / sqrtf(dot(a, a))); }
static inline vec3 cross(vec3 a, vec3 b)
{
    return (vec3){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/* A rectangle; u and v are its edges divided by their squared lengths. */
typedef struct quad {
    vec3 corner, u, v, normal, albedo;
    int checkered;
} quad;

typedef struct ball {
    vec3 center;
    float radius;
    vec3 albedo;
} ball;

/* A diffuse emitter: a sphere, or a cap of directions at infinity. Lights do not occlude. */
typedef struct emitter {
    int distant;
    vec3 center;  /* axis, if distant */
    float radius; /* half-angle, if distant */
    vec3 radiance;
} emitter;

/* A square cut-out, as fractions of the picture's width and height. */
typedef struct cutout {
    float x, y, width;
} cutout;

typedef struct scene {
    const char *name, *title;
    int open;              /* nothing comes between any point and any light */
    float aspect;          /* width / height */
    vec3 eye, forward, right, up;
    vec3 horizon, zenith;  /* what is seen where there is nothing */
    vec3 fill;             /* irradiance / pi that is there besides the lights */
    cutout crops[2];
    quad quads[160];
    ball balls[40];
    emitter lights[4];
    size_t quad_count, ball_count, light_count;
} scene;

/* What a camera ray hits: a surface point, or else a colour alone (in albedo). */
typedef struct hit {
    vec3 position, normal, albedo;
    uint32_t pixel;
} hit;

enum { SCENE_COUNT = 5 };

/* Makes scene number 0 to SCENE_COUNT - 1. */
void scene_make(scene *s, int number);

/* Follows a ray of the camera through (x, y), each from -1 to 1; returns whether it ends on a
   surface rather than on a light or in the sky. */
int scene_look(const scene *s, float x, float y, hit *h);

/* Whether anything is between a hit and a light in this direction at this distance. */
int scene_blocked(const scene *s, const hit *from, vec3 direction, float distance);

#endif
