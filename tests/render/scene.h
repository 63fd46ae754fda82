/* SPDX-License-Identifier: Apache-2.0 */
/* The scenes: rectangles and balls, lit by lights of any shape. */
#ifndef SCENE_H
#define SCENE_H

#include "light.h"

#include <stddef.h>
#include <stdint.h>

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

/* A square cut-out, as fractions of the picture's width and height. */
typedef struct cutout {
    float x, y, width;
} cutout;

/* What a scene compares: all others with the first. References are made by one of them. */
enum { TECHNIQUES = 8 };
typedef struct comparison {
    unsigned count, reference;
    technique_row row[TECHNIQUES];
} comparison;

typedef struct scene {
    const char *name, *title;
    const comparison *comparison;
    int open;              /* nothing comes between any point and any light */
    float aspect;          /* width / height */
    vec3 eye, forward, right, up;
    vec3 horizon, zenith;  /* what is seen where there is nothing */
    vec3 fill;             /* irradiance / pi that is there besides the lights */
    float fog;             /* scattering per length, which takes as much light away; 0 for none */
    float depth;           /* how far the fog is looked into where no surface ends it */
    cutout crops[2];
    quad quads[160];
    ball balls[40];
    emitter lights[4];     /* they do not occlude */
    size_t quad_count, ball_count, light_count;
} scene;

/* What a camera ray hits: a surface point, or else a colour alone (in albedo). In fog, a point
   without normal (zero) and, in albedo, pi times the share of the light there that is seen. */
typedef struct hit {
    vec3 position, normal, albedo;
    uint32_t pixel;
} hit;

enum { SCENE_COUNT = 13 };

/* Makes scene number 0 to SCENE_COUNT - 1. */
void scene_make(scene *s, int number);

/* Follows a ray of the camera through (x, y), each from -1 to 1; returns whether it ends at a
   point to be lit rather than on a light or in the sky. In fog the points of a ray are chosen by
   u, from 0 to 1. Sets backdrop to what is seen besides the light to be sampled. */
int scene_look(const scene *s, float x, float y, float u, hit *h, vec3 *backdrop);

/* Whether anything is between a hit and a light in this direction at this distance. */
int scene_blocked(const scene *s, const hit *from, vec3 direction, float distance);

#endif
