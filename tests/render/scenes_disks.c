/* SPDX-License-Identifier: Apache-2.0 */
#include "parts.h"

static const vec3 white = {0.75f, 0.73f, 0.70f}, stone = {0.62f, 0.60f, 0.57f};

static void add_ground(scene *s)
{
    add_quad(s, (vec3){-30, -30, 0}, (vec3){60, 0, 0}, (vec3){0, 60, 0}, white)->checkered = 1;
}

/* A disk that stands on the ground and shines to both sides; an elliptical lamp beside it. */
void make_disk(scene *s)
{
    look_at(s, (vec3){0.6f, -6.2f, 3.3f}, (vec3){0, -0.1f, 0.35f}, 0.40f, 4.0f / 3);
    add_ground(s);
    ADD_LIGHT(s, &light_disk, ((vec3){16, 12, 7.5f}), 0, 0, 0.85f, 1, 0.30f, 0, 0.80f);
    ADD_LIGHT(s, &light_ellipse, ((vec3){5, 8, 14}), 1.55f, -1.45f, 0.32f, 0.10f, 0.22f, 0.20f,
              -0.12f, 0, 0.06f);
    s->fill = (vec3){0.020f, 0.024f, 0.032f};
    s->crops[0] = (cutout){0.20f, 0.52f, 0.225f};
    s->crops[1] = (cutout){0.60f, 0.60f, 0.225f};
    if (s->open)
        return;
    for (int i = 0; i < 9; ++i) {
        const float angle = 6.2831853f * ((float)i + 0.4f) / 9;
        const float r = 1.55f + 0.30f * (float)(i % 3), height = 0.25f + 0.22f * (float)(i * 5 % 4);
        add_block(s, r * cosf(angle), r * sinf(angle), (vec3){0.18f, 0.34f, height}, angle, stone);
    }
    add_ball(s, (vec3){-0.75f, -1.15f, 0.22f}, 0.22f, white);
}

/* A disk in fog, among pillars that throw shadows through it. */
void make_fog(scene *s)
{
    look_at(s, (vec3){0, -7, 1.9f}, (vec3){0, 0, 1.25f}, 0.36f, 4.0f / 3);
    add_ground(s);
    ADD_LIGHT(s, &light_disk, ((vec3){24, 19, 12}), 0, 0, 1.35f, 1, -0.35f, 0.20f, 0.55f);
    s->fog = 0.12f;
    s->depth = 16;
    s->fill = (vec3){0.010f, 0.014f, 0.020f};
    s->crops[0] = (cutout){0.20f, 0.25f, 0.225f};
    s->crops[1] = (cutout){0.56f, 0.42f, 0.225f};
    if (s->open)
        return;
    for (int i = 0; i < 7; ++i) {
        const float angle = 6.2831853f * ((float)i + 0.15f) / 7;
        add_block(s, 1.5f * cosf(angle), 1.2f * sinf(angle), (vec3){0.16f, 0.16f, 2.6f}, angle,
                  stone);
    }
}

/* A flying ellipsoid, one half sunk into the ground, and an elliptical lamp on the ground. */
void make_ellipsoids(scene *s)
{
    look_at(s, (vec3){0, -6.2f, 3.0f}, (vec3){0, 0, 0.55f}, 0.40f, 4.0f / 3);
    add_ground(s);
    ADD_LIGHT(s, &light_ellipsoid, ((vec3){10, 8, 5}), -1.0f, 0.3f, 1.25f, 0.80f, 0.20f, 0.25f,
              -0.06f, 0.22f, 0.02f, -0.08f, 0.02f, 0.26f);
    ADD_LIGHT(s, &light_ellipsoid, ((vec3){6, 8, 11}), 1.1f, -0.2f, -0.05f, 0.55f, 0.15f, 0,
              -0.20f, 0.60f, 0.10f, 0, 0, 0.30f);
    ADD_LIGHT(s, &light_ellipse, ((vec3){11, 6, 5}), -0.6f, -1.3f, 0.40f, 0.12f, 0, 0.30f, 0.02f,
              0.10f, 0.10f);
    s->fill = (vec3){0.018f, 0.022f, 0.030f};
    s->crops[0] = (cutout){0.24f, 0.50f, 0.225f};
    s->crops[1] = (cutout){0.62f, 0.56f, 0.225f};
    if (s->open)
        return;
    for (int i = 0; i < 6; ++i)
        add_block(s, -1.9f + 0.75f * (float)i, 0.9f - 0.5f * (float)(i % 3),
                  (vec3){0.16f, 0.16f, 0.5f + 0.2f * (float)(i * 5 % 3)}, 0.5f * (float)i, stone);
    add_ball(s, (vec3){0.25f, -1.1f, 0.2f}, 0.2f, white);
}
