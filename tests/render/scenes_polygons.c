/* SPDX-License-Identifier: Apache-2.0 */
#include "parts.h"

static const vec3 white = {0.75f, 0.73f, 0.70f};

static void make_room(scene *s)
{
    const vec3 clay = {0.62f, 0.30f, 0.18f};
    const vec3 x = {2, 0, 0}, y = {0, 2, 0}, z = {0, 0, 2}, corner = {-1, -1, 0};

    look_at(s, (vec3){0, -4.75f, 1}, (vec3){0, 0, 1}, 0.2715f, 1);
    add_quad(s, corner, x, y, white);
    add_quad(s, add(corner, z), x, y, white);
    add_quad(s, add(corner, y), x, z, white);
    add_quad(s, corner, y, z, clay);
    add_quad(s, add(corner, x), y, z, white);
    add_block(s, -0.42f, 0.42f, (vec3){0.50f, 0.50f, 1.05f}, 0.35f, white);
    add_block(s, 0.10f, -0.35f, (vec3){0.34f, 0.34f, 0.34f}, -0.3f, white);
    add_ball(s, (vec3){0.10f, -0.35f, 0.50f}, 0.16f, white);
    for (int i = 0; i < 4; ++i) /* bars before the rectangle */
        add_block(s, -0.90f, -0.45f + 0.25f * (float)i, (vec3){0.03f, 0.03f, 1.6f}, 0, white);
    s->crops[0] = (cutout){0.56f, 0.66f, 0.28f};
    s->crops[1] = (cutout){0.10f, 0.58f, 0.28f};
}

/* Walls would come between each other and what is below the floor. */
static void make_floor(scene *s)
{
    look_at(s, (vec3){0.3f, -4.2f, 2.6f}, (vec3){0.1f, -0.1f, 0.35f}, 0.36f, 4.0f / 3);
    add_quad(s, (vec3){-20, -20, 0}, (vec3){40, 0, 0}, (vec3){0, 40, 0}, white)->checkered = 1;
    s->fill = (vec3){0.015f, 0.018f, 0.022f};
    s->crops[0] = (cutout){0.56f, 0.50f, 0.225f};
    s->crops[1] = (cutout){0.16f, 0.44f, 0.225f};
}

/* A rectangular and a pointed window, and a triangular lamp that the floor cuts. */
void make_windows(scene *s)
{
    (s->open ? make_floor : make_room)(s);
    ADD_LIGHT(s, &light_rectangle, ((vec3){5.0f, 6.0f, 7.5f}), -0.995f, -0.55f, 0.75f, 0, 0.95f, 0,
              0, 0, 0.75f);
    ADD_LIGHT(s, &light_polygon, ((vec3){6.0f, 5.4f, 4.5f}), 0.15f, 0.995f, 0.85f, 0.65f, 0.995f,
              0.85f, 0.65f, 0.995f, 1.35f, 0.55f, 0.995f, 1.56f, 0.40f, 0.995f, 1.70f, 0.25f,
              0.995f, 1.56f, 0.15f, 0.995f, 1.35f);
    ADD_LIGHT(s, &light_triangle, ((vec3){9.0f, 6.5f, 3.5f}), 0.45f, -0.30f, -0.12f, 0.80f, -0.05f,
              0.10f, 0.55f, -0.22f, 0.42f);
}
