/* SPDX-License-Identifier: Apache-2.0 */
#include "parts.h"

static const vec3 white = {0.75f, 0.73f, 0.70f};

void make_cornell(scene *s)
{
    const vec3 red = {0.63f, 0.09f, 0.07f}, green = {0.14f, 0.45f, 0.12f};
    const vec3 x = {2, 0, 0}, y = {0, 2, 0}, z = {0, 0, 2}, corner = {-1, -1, 0};

    look_at(s, (vec3){0, -4.75f, 1}, (vec3){0, 0, 1}, 0.2715f, 1);
    add_quad(s, corner, x, y, white);
    add_quad(s, add(corner, z), x, y, white);
    add_quad(s, add(corner, y), x, z, white);
    add_quad(s, corner, y, z, red);
    add_quad(s, add(corner, x), y, z, green);
    ADD_LIGHT(s, &light_sphere, ((vec3){9.0f, 7.6f, 5.8f}), -0.68f, 0.35f, 1.60f, 0.24f);
    ADD_LIGHT(s, &light_sphere, ((vec3){9.0f, 8.4f, 7.8f}), 0.76f, 0.45f, 1.36f, 0.17f);
    ADD_LIGHT(s, &light_sphere, ((vec3){11.0f, 9.5f, 7.5f}), 0.06f, -0.55f, 0.15f, 0.12f);
    ADD_LIGHT(s, &light_sphere, ((vec3){8.0f, 8.4f, 9.0f}), -0.78f, -0.30f, 0.30f, 0.14f);
    s->crops[0] = (cutout){0.02f, 0.20f, 0.28f};
    s->crops[1] = (cutout){0.22f, 0.70f, 0.28f};
    if (s->open)
        return;
    add_block(s, -0.36f, 0.38f, (vec3){0.56f, 0.56f, 1.15f}, 0.30f, white);
    add_block(s, 0.44f, -0.10f, (vec3){0.52f, 0.52f, 0.55f}, -0.32f, white);
    add_ball(s, (vec3){0.46f, -0.10f, 0.77f}, 0.22f, white);
    for (int i = 0; i < 4; ++i)
        add_block(s, -0.52f + 0.11f * (float)i, -0.62f + 0.03f * (float)i,
                  (vec3){0.05f, 0.05f, 0.42f}, 0.4f, white);
}

void make_dome(scene *s)
{
    const vec3 stone = {0.62f, 0.60f, 0.57f};

    look_at(s, (vec3){0, -6.4f, 4.1f}, (vec3){0, -0.2f, 0.1f}, 0.42f, 4.0f / 3);
    add_quad(s, (vec3){-30, -30, 0}, (vec3){60, 0, 0}, (vec3){0, 60, 0}, white)->checkered = 1;
    ADD_LIGHT(s, &light_sphere, ((vec3){20, 14, 8.5f}), 0, 0, -0.45f, 1.0f);
    s->fill = (vec3){0.020f, 0.030f, 0.050f};
    s->crops[0] = (cutout){0.10f, 0.42f, 0.225f};
    s->crops[1] = (cutout){0.52f, 0.66f, 0.225f};
    if (s->open)
        return;
    for (int i = 0; i < 11; ++i) {
        const float angle = 6.2831853f * ((float)i + 0.37f) / 11;
        const float r = 1.95f + 0.22f * (float)(i % 3), height = 0.35f + 0.20f * (float)(i * 5 % 4);
        add_block(s, r * cosf(angle), r * sinf(angle), (vec3){0.20f, 0.42f, height}, angle, stone);
    }
}

void make_sun(scene *s)
{
    const vec3 sand = {0.72f, 0.60f, 0.46f}, rock = {0.50f, 0.45f, 0.42f};
    const float azimuth = -0.13f, elevation = -0.04f;
    static const float dune[][4] = {{-14, 24, 30, 1.0f}, {19, 40, 50, 1.5f}};

    look_at(s, (vec3){0, -13, 3.6f}, (vec3){0, 0, 1.6f}, 0.44f, 16.0f / 9);
    add_quad(s, (vec3){-900, -900, 0}, (vec3){1800, 0, 0}, (vec3){0, 1800, 0}, sand);
    ADD_LIGHT(s, &light_cap, ((vec3){4500, 2600, 1100}), -sinf(azimuth) * cosf(elevation),
              cosf(azimuth) * cosf(elevation), sinf(elevation), 0.10f);
    s->horizon = (vec3){1.4f, 0.62f, 0.26f};
    s->zenith = (vec3){0.10f, 0.16f, 0.36f};
    s->fill = (vec3){0.040f, 0.055f, 0.100f};
    s->crops[0] = (cutout){0.30f, 0.52f, 0.16f};
    s->crops[1] = (cutout){0.62f, 0.60f, 0.16f};
    for (size_t i = 0; i < sizeof dune / sizeof *dune; ++i) /* balls almost wholly underground */
        add_ball(s, (vec3){dune[i][0], dune[i][1], dune[i][3] - dune[i][2]}, dune[i][2], sand);
    for (int i = 0; i < 13; ++i) { /* standing stones on a loose ring */
        const float angle = 6.2831853f * (float)i / 13, wobble = 0.35f * (float)((i * 5) % 3);
        const vec3 size = {0.42f, 0.26f, 0.55f + 0.30f * (float)((i * 3) % 4)};
        add_block(s, (4.4f + wobble) * cosf(angle), (3.9f + wobble) * sinf(angle), size,
                  angle + 1.5708f, rock);
    }
    for (int i = 0; i < 6; ++i) {
        const float radius = 0.16f + 0.05f * (float)(i % 3);
        add_ball(s, (vec3){-2.6f + 1.1f * (float)i, -2.4f + 1.0f * (float)((i * 2) % 5), radius},
                 radius, rock);
    }
}
