/* SPDX-License-Identifier: Apache-2.0 */
#include "scene.h"

#include <string.h>

static const vec3 white = {0.75f, 0.73f, 0.70f};

/* ---- Building blocks --------------------------------------------------------------------- */

static quad *add_quad(scene *s, vec3 corner, vec3 edge_u, vec3 edge_v, vec3 albedo)
{
    quad *q = &s->quads[s->quad_count++];
    *q = (quad){corner, scale(edge_u, 1 / dot(edge_u, edge_u)),
                scale(edge_v, 1 / dot(edge_v, edge_v)), unit(cross(edge_u, edge_v)), albedo, 0};
    return q;
}

static void add_ball(scene *s, vec3 center, float radius, vec3 albedo)
{
    s->balls[s->ball_count++] = (ball){center, radius, albedo};
}

/* A block that stands on the ground z = 0, turned about its vertical axis. */
static void add_block(scene *s, float x, float y, vec3 size, float turn, vec3 albedo)
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

static void add_light(scene *s, vec3 center, float radius, vec3 radiance)
{
    s->lights[s->light_count++] = (emitter){0, center, radius, radiance};
}

static void look_at(scene *s, vec3 eye, vec3 target, float tangent, float aspect)
{
    s->eye = eye;
    s->aspect = aspect;
    s->forward = unit(sub(target, eye));
    s->right = unit(cross(s->forward, (vec3){0, 0, 1}));
    s->up = scale(cross(s->right, s->forward), tangent / aspect);
    s->right = scale(s->right, tangent);
}

/* ---- The scenes -------------------------------------------------------------------------- */

static void make_cornell(scene *s)
{
    const vec3 red = {0.63f, 0.09f, 0.07f}, green = {0.14f, 0.45f, 0.12f};
    const vec3 x = {2, 0, 0}, y = {0, 2, 0}, z = {0, 0, 2}, corner = {-1, -1, 0};

    look_at(s, (vec3){0, -4.75f, 1}, (vec3){0, 0, 1}, 0.2715f, 1);
    add_quad(s, corner, x, y, white);
    add_quad(s, add(corner, z), x, y, white);
    add_quad(s, add(corner, y), x, z, white);
    add_quad(s, corner, y, z, red);
    add_quad(s, add(corner, x), y, z, green);
    add_light(s, (vec3){-0.68f, 0.35f, 1.60f}, 0.24f, (vec3){9.0f, 7.6f, 5.8f});
    add_light(s, (vec3){0.76f, 0.45f, 1.36f}, 0.17f, (vec3){9.0f, 8.4f, 7.8f});
    add_light(s, (vec3){0.06f, -0.55f, 0.15f}, 0.12f, (vec3){11.0f, 9.5f, 7.5f});
    add_light(s, (vec3){-0.78f, -0.30f, 0.30f}, 0.14f, (vec3){8.0f, 8.4f, 9.0f});
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

static void make_dome(scene *s)
{
    const vec3 stone = {0.62f, 0.60f, 0.57f};

    look_at(s, (vec3){0, -6.4f, 4.1f}, (vec3){0, -0.2f, 0.1f}, 0.42f, 4.0f / 3);
    add_quad(s, (vec3){-30, -30, 0}, (vec3){60, 0, 0}, (vec3){0, 60, 0}, white)->checkered = 1;
    add_light(s, (vec3){0, 0, -0.45f}, 1.0f, (vec3){20, 14, 8.5f});
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

static void make_sun(scene *s)
{
    const vec3 sand = {0.72f, 0.60f, 0.46f}, rock = {0.50f, 0.45f, 0.42f};
    const float azimuth = -0.13f, elevation = -0.04f;
    static const float dune[][4] = {{-14, 24, 30, 1.0f}, {19, 40, 50, 1.5f}};

    look_at(s, (vec3){0, -13, 3.6f}, (vec3){0, 0, 1.6f}, 0.44f, 16.0f / 9);
    add_quad(s, (vec3){-900, -900, 0}, (vec3){1800, 0, 0}, (vec3){0, 1800, 0}, sand);
    s->lights[s->light_count++] = (emitter){
        1,
        {-sinf(azimuth) * cosf(elevation), cosf(azimuth) * cosf(elevation), sinf(elevation)},
        0.10f,
        {4500, 2600, 1100}};
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

void scene_make(scene *s, int number)
{
    static const struct {
        const char *name, *title;
        int open;
        void (*make)(scene *);
    } table[SCENE_COUNT] = {
        {"cornell", "Cornell box, four spherical lights, occluders", 0, make_cornell},
        {"cornell-open", "Cornell box, four spherical lights, no occluders", 1, make_cornell},
        {"dome", "Sphere cutting the floor, its centre below, occluders", 0, make_dome},
        {"dome-open", "Sphere cutting the floor, its centre below, no occluders", 1, make_dome},
        {"sun", "Low sun, its centre below the horizon, occluders", 0, make_sun},
    };
    memset(s, 0, sizeof *s);
    s->name = table[number].name;
    s->title = table[number].title;
    s->open = table[number].open;
    table[number].make(s);
}

/* ---- Rays -------------------------------------------------------------------------------- */

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

/* The nearer meeting point, or the farther one from inside. The discriminant is formed from the
   vector across the ray, which keeps its digits for the big balls [Haines 2019]. */
static inline float meet_ball(vec3 center, float radius, vec3 origin, vec3 direction)
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

static void sky(const scene *s, vec3 direction, hit *h)
{
    const float t = direction.z < 0 ? 0 : 1 - expf(-7 * direction.z);
    h->albedo = add(scale(s->horizon, 1 - t), scale(s->zenith, t));
}

int scene_look(const scene *s, float x, float y, hit *h)
{
    const vec3 d = unit(add(s->forward, add(scale(s->right, x), scale(s->up, y))));
    float nearest = INFINITY;
    int surface = 0;

    sky(s, d, h);
    for (size_t i = 0; i < s->light_count; ++i) {
        const emitter *l = &s->lights[i];
        const float t = !l->distant ? meet_ball(l->center, l->radius, s->eye, d)
                        : dot(l->center, d) > cosf(l->radius) ? 1e30f : INFINITY;
        if (t < nearest) {
            nearest = t;
            h->albedo = l->radiance;
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
    return surface;
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
