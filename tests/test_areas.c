/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Triangles, rectangles and polygons by area wherever they are hard: tiny and huge, needles, the
 * receiver next to an edge, a vertex or the plane. The map is one formula [Turk90], whose points,
 * directions and densities are compared with the same in 113 bits, from the numbers that were given.
 */
#include "reference_polygons.h"
#include "shapes.h"
#include "vectors.h"
#include "worst.h"

enum { LIGHTS = 400, SAMPLES = 4, VERTICES = 16 };

/*
 * In roundings: of the shares of the vertices, which the point carries as far as the light is larger
 * than its distance, and the density as its third power; and of the light's volume as the receiver
 * sees it, to which plain arithmetic may do 64.
 */
static const double direction_bound = 8.0, density_bound = 64.0;

/* Of fans, whose triangles share u. */
static const double fan_direction_bound = 16.0;

/* The polygon as the receiver sees it. */
struct subject {
    int count;
    quad vertex[VERTICES][3];
    quad below[VERTICES], area;
    double extent;
};

static void subtract(const quad a[3], const quad b[3], quad to[3])
{
    int c;

    for (c = 0; c < 3; c++)
        to[c] = a[c] - b[c];
}

static void make_subject(const struct light *light, struct subject *o)
{
    const int n = part_count(light->shape), rectangle = light->shape->shape == PSC_SHAPE_RECTANGLE;
    quad first[3], second[3], normal[3], along;
    int i, c;

    o->count = rectangle ? 4 : n;
    for (i = 0; i < n; i++)
        for (c = 0; c < 3; c++)
            o->vertex[i][c] = light->geometry[3 * i + c] -
                              (rectangle && i > 0 ? 0 : (quad)light->position[c]);
    if (rectangle) {
        along = reference_dot(o->vertex[1], o->vertex[2]) /
                reference_dot(o->vertex[1], o->vertex[1]);
        for (c = 0; c < 3; c++) {
            const quad across = o->vertex[2][c] - along * o->vertex[1][c];

            o->vertex[1][c] += o->vertex[0][c];
            o->vertex[2][c] = o->vertex[1][c] + across;
            o->vertex[3][c] = o->vertex[0][c] + across;
        }
    }
    o->area = 0;
    o->extent = 0.0;
    for (i = 1; i + 1 < o->count; i++) {
        subtract(o->vertex[i], o->vertex[0], first);
        subtract(o->vertex[i + 1], o->vertex[0], second);
        reference_cross(first, second, normal);
        o->extent = fmax(o->extent, (double)(reference_length(first) + reference_length(second)));
        o->below[i] = o->area;
        o->area += reference_length(normal) / 2;
    }
    o->below[i] = o->area;
}

/* The point of the map as the receiver sees it, and the normal of its triangle, whose length is twice
   the area. */
static void reference_point(const struct subject *o, int triangle, int parallel, double u, double v,
                            quad point[3], quad normal[3])
{
    const quad *a = o->vertex[0], *b = o->vertex[1], *c = o->vertex[2];
    quad root = quad_sqrt(v), within = u, first[3], second[3];
    int i, k;

    if (parallel) {
        subtract(o->vertex[1], o->vertex[0], first);
        subtract(o->vertex[3], o->vertex[0], second);
        reference_cross(first, second, normal);
        for (i = 0; i < 3; i++)
            point[i] = o->vertex[0][i] + u * first[i] + v * second[i];
        return;
    }
    if (!triangle) {
        for (k = 1; k + 2 < o->count && (quad)u * o->area >= o->below[k + 1]; k++)
            ;
        within = (u * o->area - o->below[k]) / (o->below[k + 1] - o->below[k]);
        a = o->vertex[k];
        b = o->vertex[0];
        c = o->vertex[k + 1];
    }
    subtract(a, b, first);
    subtract(c, b, second);
    reference_cross(first, second, normal);
    for (i = 0; i < 3; i++)
        point[i] = b[i] + root * ((1 - within) * first[i] + within * second[i]);
}

struct errors {
    struct worst direction[2], density[2];
    long odd;
};

static void check_sample(const struct light *light, int hard, const struct subject *o,
                         const psc_sampler *sampler, int wide, double u, double v,
                         struct errors *e)
{
    const double unit = wide ? 0x1p-53 : 0x1p-24;
    const int parallel = light->what->map == PSC_MAP_PARALLEL;
    const int triangle = light->shape->shape == PSC_SHAPE_TRIANGLE;
    quad point[3], normal[3], distance, cosine, pdf, off = 0;
    psc_light_sample_f64 s;
    double more;
    int c;

    if (!wide) {
        u = (float)u;
        v = (float)v;
    }
    memset(&s, 0xff, sizeof s);
    sample_any(wide ? 64 : 32, sampler, u, v, &s);
    reference_point(o, triangle, parallel, u, v, point, normal);
    distance = reference_length(point);
    e->odd += !(s.weight >= 0.0 && s.distance > 0.0);
    if (!(distance > 0))
        return;
    more = 1.0 + o->extent / (double)distance;
    cosine = quad_abs(reference_dot(point, normal)) / (distance * reference_length(normal));
    pdf = distance * distance / (o->area * cosine);
    for (c = 0; c < 3; c++)
        off += (s.direction[c] - point[c] / distance) * (s.direction[c] - point[c] / distance);
    worst_add(&e->direction[wide], sqrt((double)off) / (unit * more), "%s u %a v %a", describe_light(light),
              u, v);
    /* Rounding leaves the vertices of others not in one plane, and turns that of needles. */
    if (o->count > 3 && light->shape->shape != PSC_SHAPE_RECTANGLE) {
        if (hard)
            return;
        more += o->extent * o->extent / (double)(o->area * cosine);
    }
    /* Two words tell a height down to 1e-32 of a length, and a needle's edges less. */
    if (cosine > 1e-15 && pdf < (wide ? 1e300 : 1e37) && pdf > (wide ? 1e-300 : 1e-37))
        worst_add(&e->density[wide], fabs((double)(s.pdf / pdf - 1)) / (unit * more), "%s u %a v %a",
                  describe_light(light), u, v);
}

static void sweep(const struct shape *shape, const struct test_technique *what)
{
    static struct errors e;
    static struct subject o;
    uint64_t seed = 310;
    int i, j, wide;

    memset(&e, 0, sizeof e);
    for (i = 0; i < LIGHTS; i++) {
        struct test_sampler s;
        struct light light;

        (i % 2 ? random_hard_light : random_light)(&seed, shape, what, &light);
        light.technique_flags = 0;
        light.has_normal = 0;
        light.flags = 0;
        if (build_light(make_sampler(&s), &light) != PSC_SUCCESS)
            continue;
        make_subject(&light, &o);
        for (j = 0; j < SAMPLES; j++) {
            const double u = random_uniform(&seed), v = random_coordinate(&seed);

            for (wide = 0; wide < 2; wide++)
                check_sample(&light, i % 2, &o, s.sampler, wide, u, v, &e);
        }
    }
    tap_ok(e.odd == 0, "%s, %s: %ld samples are none", shape->name, what->name, e.odd);
    for (wide = 0; wide < 2; wide++) {
        const int bits = wide ? 64 : 32;

        worst_report(&e.direction[wide], o.count > 4 ? fan_direction_bound : direction_bound, "%s, %s, f%d: directions, in roundings",
                     shape->name, what->name, bits);
        worst_report(&e.density[wide], density_bound, "%s, %s, f%d: densities, in roundings",
                     shape->name, what->name, bits);
    }
}

int main(void)
{
    static const struct shape *const those[] = {&shape_triangle, &shape_rectangle, &shape_polygon3,
                                                &shape_polygon4, &shape_polygon5,  &shape_polygon8,
                                                &shape_polygon16};
    const struct test_technique *what;
    size_t i;

    for (i = 0; i < sizeof those / sizeof *those; i++)
        for (FOR_TECHNIQUES(those[i], what))
            if (what->measure == PSC_MEASURE_AREA)
                sweep(those[i], what);
    return tap_done();
}
