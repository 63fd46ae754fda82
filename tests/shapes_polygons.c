/* SPDX-License-Identifier: Apache-2.0 */
/* Triangles, rectangles and convex polygons, for the tests of all shapes. */
#include "exact.h"
#include "vectors.h"

/* to - from, and what rounding took from that. */
static void exact_edge(const double *from, const double *to, double edge[3], double rest[3])
{
    int i;

    for (i = 0; i < 3; i++) {
        double sum[2] = {to[i], 0.0};

        add_product(-1.0, from[i], sum);
        edge[i] = sum[0];
        rest[i] = sum[1];
    }
}

/* (b - a) x (c - a), just as right. */
static void exact_normal(const double *a, const double *b, const double *c, double normal[3])
{
    double first[3], second[3], first_rest[3], second_rest[3], more[3], less[3];
    int i;

    exact_edge(a, b, first, first_rest);
    exact_edge(a, c, second, second_rest);
    exact_cross(first, second, normal);
    cross(first_rest, second, more);
    cross(second_rest, first, less);
    for (i = 0; i < 3; i++)
        normal[i] += more[i] - less[i];
}

/* Where a ray meets the plane through a point with a normal: how far along it, and the offset of
   that from the point. */
static double meet_plane(const double *at, const double normal[3], const double from[3],
                         const double direction[3], double offset[3])
{
    double to[3], along;
    int i;

    subtract3(at, from, to);
    along = dot(to, normal) / dot(direction, normal);
    for (i = 0; i < 3; i++)
        offset[i] = along * direction[i] - to[i];
    return along;
}

static void affine(const double *origin, const double first[3], const double second[3],
                   const double st[2], double point[3])
{
    int i;

    for (i = 0; i < 3; i++)
        point[i] = origin[i] + (st[0] * first[i] + st[1] * second[i]);
}

static const struct test_technique fan_techniques[] = {
    {"solid angle, radial", PSC_MEASURE_SOLID_ANGLE, PSC_MAP_RADIAL},
    {"projected solid angle, radial", PSC_MEASURE_PROJECTED_SOLID_ANGLE, PSC_MAP_RADIAL},
    {"area, radial", PSC_MEASURE_AREA, PSC_MAP_RADIAL},
    {NULL, 0, 0},
};

/* ---- What triangles and polygons share: n vertices ---- */

/* Vertices on an ellipse, no two of them far apart: so the polygon is convex, and the middle is
   inside. Hard ones are needles, or have an edge that is hardly one; but of the edges that the
   texture of a polygon is made of, as long as there are others. */
static void polygon_make(uint64_t *state, int n, int hard, double *g)
{
    const double pi = 3.14159265358979323846;
    const double start = random_between(state, 0.0, 2.0 * pi);
    const double turn = random_between(state, 0.0, 2.0 * pi);
    const int pair = hard && random_below(state, 2);
    const double aspect = random_log(state, hard && !pair ? 1e-8 : 0.3, 1.0);
    double middle[2] = {0.0, 0.0}, size = 0.0, angle = 0.0;
    int i;

    for (i = 0; i < n; i++) {
        const double before = angle;
        double x, y;

        angle = start + 2.0 * pi * (i + random_between(state, -0.2, 0.2)) / n;
        if (pair && i == (n > 3 ? 2 : 1))
            angle = before + random_log(state, 1e-8, 1.0) / n;
        x = cos(angle);
        y = aspect * sin(angle);
        g[3 * i] = cos(turn) * x - sin(turn) * y;
        g[3 * i + 1] = sin(turn) * x + cos(turn) * y;
        g[3 * i + 2] = 0.0;
        middle[0] += g[3 * i] / n;
        middle[1] += g[3 * i + 1] / n;
    }
    for (i = 0; i < n; i++) {
        g[3 * i] -= middle[0];
        g[3 * i + 1] -= middle[1];
        size = fmax(size, hypot(g[3 * i], g[3 * i + 1]));
    }
    for (i = 0; i < 3 * n; i++)
        g[i] /= size;
}

/* The same of integers, exactly convex: what was rounded is stretched after that. Vertices may be
   the same, or in line, but not the first and its neighbours, which the texture needs. */
static void polygon_on_grid(uint64_t *state, int n, int hard, double *g)
{
    const int stretch = hard ? random_below(state, 8) : 7;
    const int k = 2 + random_below(state, n - 2), kind = random_below(state, 8);
    int i;

    polygon_make(state, n, 0, g);
    for (i = 0; i < 3 * n; i++)
        g[i] = floor(g[i] * 0x1p11 + 0.5) * 0x1p-12;
    for (i = 0; i < n; i++) {
        g[3 * i] *= power_of_two(7 - 8);
        g[3 * i + 1] *= power_of_two(stretch - 8);
    }
    for (i = 0; i < 2 && kind < 2 && k + 1 < n; i++) {
        const double before = g[3 * (k - 1) + i], after = g[3 * (k + 1) + i];

        g[3 * k + i] = kind ? before : 0.5 * (before + after);
    }
}

/* The unit normal, along the sum of the triangles of the fan: vertices may not be quite in one
   plane. */
static void polygon_normal(int n, const double *g, double normal[3])
{
    double area[3], sum[3] = {0.0, 0.0, 0.0};
    int i, k;

    for (i = 1; i + 1 < n; i++) {
        exact_normal(g, g + 3 * i, g + 3 * (i + 1), area);
        for (k = 0; k < 3; k++)
            sum[k] += area[k];
    }
    scale3(sum, 1.0 / sqrt(dot(sum, sum)), normal);
}

/* How far an offset from the first vertex is outside the edge from vertex i, in the plane. */
static double beyond_edge(int n, const double *g, const double normal[3], int i,
                          const double offset[3])
{
    const double *from = g + 3 * i, *to = g + 3 * ((i + 1) % n);
    double edge[3], start[3], out[3], length;

    subtract3(to, from, edge);
    subtract3(from, g, start);
    subtract3(offset, start, start);
    cross(edge, normal, out);
    length = sqrt(dot(edge, edge));
    return length > 0.0 ? dot(start, out) / length : -HUGE_VAL;
}

static double polygon_hit(int n, const double *g, const double from[3], const double direction[3])
{
    double normal[3], offset[3], along;
    int i;

    exact_normal(g, g + 3 * (n / 3), g + 3 * (2 * n / 3), normal);
    along = meet_plane(g, normal, from, direction, offset);
    for (i = 0; i < n; i++)
        if (!(beyond_edge(n, g, normal, i, offset) <= 0.0))
            return -1.0;
    return along > 0.0 ? along : -1.0;
}

static double polygon_surface(int n, const double *g, const double point[3], double normal[3])
{
    double offset[3], off;
    int i;

    polygon_normal(n, g, normal);
    subtract3(point, g, offset);
    off = fabs(dot(offset, normal));
    for (i = 0; i < n; i++)
        off = fmax(off, beyond_edge(n, g, normal, i, offset));
    return off;
}

static void polygon_texture(int n, const double *g, const double st[2], double point[3])
{
    double first[3], second[3];

    subtract3(g + 3, g, first);
    subtract3(g + 3 * (n - 1), g, second);
    affine(g, first, second, st, point);
}

/* ---- Rows of a number of vertices ---- */

#define VERTICES(name, n)                                                                       \
    static void name##_make(uint64_t *state, const struct test_technique *what, int hard,       \
                            double *g)                                                          \
    {                                                                                           \
        (void)what;                                                                             \
        polygon_make(state, n, hard, g);                                                        \
    }                                                                                           \
    static void name##_on_grid(uint64_t *state, const struct test_technique *what, int hard,    \
                               double *g)                                                       \
    {                                                                                           \
        (void)what;                                                                             \
        polygon_on_grid(state, n, hard, g);                                                     \
    }                                                                                           \
    static void name##_exact(uint64_t *state, struct light *light)                              \
    {                                                                                           \
        place_exactly(state, light, name##_on_grid);                                            \
    }                                                                                           \
    static double name##_hit(const double *g, const double from[3], const double direction[3])  \
    {                                                                                           \
        return polygon_hit(n, g, from, direction);                                              \
    }                                                                                           \
    static double name##_surface(const double *g, const double point[3], double normal[3])      \
    {                                                                                           \
        return polygon_surface(n, g, point, normal);                                            \
    }                                                                                           \
    static void name##_texture(const double *g, const double st[2], double point[3])            \
    {                                                                                           \
        polygon_texture(n, g, st, point);                                                       \
    }

#define VERTEX_ROW(id, words, kind, letters, ...)                                            \
    const struct shape shape_##id = {                                                        \
        .name = words, .shape = kind, .parts = letters, .flat = 1, .azimuth_jumps = 0.2,     \
        .techniques = fan_techniques, .build = id##_build, .wave_f32 = id##_wave_f32,        \
        .wave_f64 = id##_wave_f64, .solid_angle = id##_solid_angle, .make = id##_make,       \
        .form_factor = id##_form_factor, .hit = id##_hit, .surface = id##_surface, .texture = id##_texture,            \
        .exact = id##_exact, __VA_ARGS__}

static psc_result triangle_build(psc_sampler *sampler, const psc_technique *technique,
                                 const psc_receiver *receiver, const double *g)
{
    return psc_build_triangle(sampler, technique, receiver, g, g + 3, g + 6);
}

SHAPE_WAVES(triangle, triangle, in[0], in[1], in[2])

static psc_result triangle_solid_angle(const double position[3], const double *g, double *value)
{
    return psc_triangle_solid_angle(position, g, g + 3, g + 6, value);
}

static psc_result triangle_form_factor(const psc_receiver *receiver, const double *g,
                                       double *value)
{
    return psc_triangle_form_factor(receiver, g, g + 3, g + 6, value);
}

VERTICES(triangle, 3)
VERTEX_ROW(triangle, "triangle", PSC_SHAPE_TRIANGLE, "ppp", .bound = 0);

#define POLYGON(n, letters)                                                                    \
    static psc_result polygon##n##_build(psc_sampler *sampler, const psc_technique *technique, \
                                         const psc_receiver *receiver, const double *g)        \
    {                                                                                          \
        return psc_build_polygon(sampler, technique, receiver, n, g, 3 * sizeof *g);           \
    }                                                                                          \
    SHAPE_WAVES(polygon##n, polygon, n, in[0])                                                 \
    static psc_result polygon##n##_solid_angle(const double position[3], const double *g,      \
                                               double *value)                                  \
    {                                                                                          \
        return psc_polygon_solid_angle(position, n, g, 3 * sizeof *g, value);                  \
    }                                                                                          \
    static psc_result polygon##n##_form_factor(const psc_receiver *receiver, const double *g,  \
                                               double *value)                                  \
    {                                                                                          \
        return psc_polygon_form_factor(receiver, n, g, 3 * sizeof *g, value);                  \
    }                                                                                          \
    VERTICES(polygon##n, n)                                                                    \
    VERTEX_ROW(polygon##n, #n "-gon", PSC_SHAPE_POLYGON, letters, .bound = 1, .joined = 1)

POLYGON(3, "ppp");
POLYGON(4, "pppp");
POLYGON(5, "ppppp");
POLYGON(8, "pppppppp");
POLYGON(16, "pppppppppppppppp");

/* ---- Rectangles ---- */

static psc_result rectangle_build(psc_sampler *sampler, const psc_technique *technique,
                                  const psc_receiver *receiver, const double *g)
{
    return psc_build_rectangle(sampler, technique, receiver, g, g + 3, g + 6);
}

SHAPE_WAVES(rectangle, rectangle, in[0], in[1], in[2])

static psc_result rectangle_solid_angle(const double position[3], const double *g, double *value)
{
    return psc_rectangle_solid_angle(position, g, g + 3, g + 6, value);
}

static psc_result rectangle_form_factor(const psc_receiver *receiver, const double *g,
                                        double *value)
{
    return psc_rectangle_form_factor(receiver, g, g + 3, g + 6, value);
}

static void rectangle_make(uint64_t *state, const struct test_technique *what, int hard, double *g)
{
    const double turn = random_between(state, 0.0, 6.2831853);
    const double aspect = random_log(state, hard ? 1e-8 : 0.2, 1.0);
    const double long_side = 1.999 / sqrt(1.0 + aspect * aspect), short_side = aspect * long_side;
    const int tall = random_below(state, 2);
    const double width = tall ? short_side : long_side, height = tall ? long_side : short_side;
    int i;

    (void)what;
    g[3] = width * cos(turn);
    g[4] = width * sin(turn);
    g[6] = height * -sin(turn);
    g[7] = height * cos(turn);
    g[2] = g[5] = g[8] = 0.0;
    for (i = 0; i < 2; i++)
        g[i] = -0.5 * (g[3 + i] + g[6 + i]);
}

/* The fractions of the edges at an offset from the corner. */
static void along_edges(const double *g, const double offset[3], double st[2])
{
    st[0] = dot(offset, g + 3) / dot(g + 3, g + 3);
    st[1] = dot(offset, g + 6) / dot(g + 6, g + 6);
}

static double rectangle_hit(const double *g, const double from[3], const double direction[3])
{
    double normal[3], offset[3], st[2], along;

    exact_cross(g + 3, g + 6, normal);
    along = meet_plane(g, normal, from, direction, offset);
    along_edges(g, offset, st);
    return along > 0.0 && st[0] >= 0.0 && st[0] <= 1.0 && st[1] >= 0.0 && st[1] <= 1.0 ? along
                                                                                     : -1.0;
}

static double rectangle_surface(const double *g, const double point[3], double normal[3])
{
    double offset[3], st[2], beyond = 0.0;
    int i;

    exact_cross(g + 3, g + 6, normal);
    scale3(normal, 1.0 / sqrt(dot(normal, normal)), normal);
    subtract3(point, g, offset);
    along_edges(g, offset, st);
    for (i = 0; i < 2; i++) {
        const double *edge = g + 3 + 3 * i;

        beyond = fmax(beyond, (fabs(st[i] - 0.5) - 0.5) * sqrt(dot(edge, edge)));
    }
    return fmax(fabs(dot(offset, normal)), beyond);
}

static void rectangle_texture(const double *g, const double st[2], double point[3])
{
    affine(g, g + 3, g + 6, st, point);
}

/* Edges of integers at an exactly right angle. */
static void rectangle_on_grid(uint64_t *state, const struct test_technique *what, int hard,
                              double *g)
{
    const int64_t ratio = random_below(state, 16) ? (int64_t)1 << random_below(state, 5) : 0;
    int64_t a, b;

    (void)what;
    do {
        a = around(state, (int64_t)1 << (hard ? random_below(state, 20) : 19));
        b = around(state, (int64_t)1 << (hard ? random_below(state, 20) : 19));
    } while (a == 0 && b == 0);
    memset(g, 0, 9 * sizeof *g);
    g[3] = (double)a * 0x1p-20;
    g[4] = (double)b * 0x1p-20;
    g[6] = (double)(-b * ratio) * 0x1p-20;
    g[7] = (double)(a * ratio) * 0x1p-20;
    g[0] = -0.5 * (g[3] + g[6]);
    g[1] = -0.5 * (g[4] + g[7]);
}

static void rectangle_exact(uint64_t *state, struct light *light)
{
    place_exactly(state, light, rectangle_on_grid);
}

static const struct test_technique rectangle_techniques[] = {
    {"solid angle, radial", PSC_MEASURE_SOLID_ANGLE, PSC_MAP_RADIAL},
    {"solid angle, parallel", PSC_MEASURE_SOLID_ANGLE, PSC_MAP_PARALLEL},
    {"projected solid angle, radial", PSC_MEASURE_PROJECTED_SOLID_ANGLE, PSC_MAP_RADIAL},
    {"area, radial", PSC_MEASURE_AREA, PSC_MAP_RADIAL},
    {"area, parallel", PSC_MEASURE_AREA, PSC_MAP_PARALLEL},
    {NULL, 0, 0},
};

const struct shape shape_rectangle = {
    .name = "rectangle", .shape = PSC_SHAPE_RECTANGLE, .parts = "pee", .flat = 1, .bound = 1,
    .azimuth_jumps = 0.2, .techniques = rectangle_techniques, .build = rectangle_build,
    .wave_f32 = rectangle_wave_f32, .wave_f64 = rectangle_wave_f64,
    .solid_angle = rectangle_solid_angle, .form_factor = rectangle_form_factor,
    .make = rectangle_make, .hit = rectangle_hit,
    .surface = rectangle_surface, .texture = rectangle_texture, .exact = rectangle_exact,
};
