/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Every sample is one: finite, of unit length, its point on the light and where the direction
 * says, with its normal and texture coordinates, the density that its measure has there, and
 * culled for a reason; at the ends of the square, from inside, from the surface, from both sides of
 * the receiver, close by and far away.
 */
#include "shapes.h"
#include "vectors.h"
#include "worst.h"

enum { LIGHTS = 400, SAMPLES = 12 };

struct errors {
    struct worst unit, normal_unit, on_surface, along, normal, density, weight, culled, texture;
    long odd; /* something that no sample may be */
    char first_odd[sizeof ((struct worst *)0)->where];
};

static double unit_of(int bits)
{
    return bits == 64 ? 0x1p-53 : 0x1p-24;
}

static double off_unit(const double v[3])
{
    return fabs(dot(v, v) - 1.0) / 2.0;
}

static double largest(const double v[3])
{
    return fmax(fabs(v[0]), fmax(fabs(v[1]), fabs(v[2])));
}

static double distance(const double a[3], const double b[3])
{
    double d[3];

    subtract3(a, b, d);
    return sqrt(dot(d, d));
}

/* The pdf may be beyond all numbers: of the area measures where the surface is seen edge-on, and
   of uneven maps where little of a tiny light is sampled often. */
static int finite_sample(const psc_light_sample_f64 *s, const struct light *light)
{
    const int bounded = light->what->measure < PSC_MEASURE_AREA && !is_uneven(light->what);
    double sum = s->weight + s->surface[0] + s->surface[1];
    int i;

    if (bounded || s->weight >= 1e-30)
        sum += s->pdf;
    for (i = 0; i < 3; i++)
        sum += s->direction[i] + s->point[i] + s->normal[i];
    return s->pdf >= 0.0 && s->weight >= 0.0 && isfinite(sum) &&
           (is_distant(light->shape) ? isinf(s->distance) : isfinite(s->distance));
}

/* At the receiver; 1 without a normal. */
static double receiver_cosine(const struct light *light, const psc_light_sample_f64 *s)
{
    double cosine;

    if (!light->has_normal)
        return 1.0;
    cosine = dot(s->direction, light->normal) / sqrt(dot(light->normal, light->normal));
    return light->flags ? fabs(cosine) : cosine;
}

/* The cosine at the surface of a closed light sampled by area: below 0 on the near side, 0 at the
   limb; or -1 if nothing is turned away. */
static double turned_away(const struct light *light, const psc_sampler *sampler,
                          const psc_light_sample_f64 *s)
{
    psc_description d = {sizeof d, 0, 0, 0, 0, 0};

    psc_sampler_describe(sampler, &d);
    return light->shape->flat || light->what->measure < PSC_MEASURE_AREA ||
                   d.visibility == PSC_CASE_INSIDE
               ? -1.0
               : dot(s->direction, s->normal);
}

/* What the pdf must be, by what the measure is, times what makes the rounding of the direction
   count once: the cosine at the light, for area. */
static double density_error(const struct light *light, double total,
                            const psc_light_sample_f64 *s)
{
    const double cosine = receiver_cosine(light, s);

    switch (light->what->measure) {
    case PSC_MEASURE_SOLID_ANGLE: return s->pdf * total - 1.0;
    case PSC_MEASURE_PROJECTED_SOLID_ANGLE: return s->pdf * total - cosine;
    default:
        return s->distance * s->distance / (total * s->pdf) -
               fabs(dot(s->direction, s->normal));
    }
}

/* How far the normal next to a point turns when that is moved by a step in any direction. */
static double normal_motion(const struct light *light, const double point[3],
                            const double normal[3], double step)
{
    double sum = 0.0;
    int i;

    for (i = 0; i < 3; i++) {
        double moved[3] = {point[0], point[1], point[2]}, other[3];

        moved[i] += 4.0 * step;
        light->shape->surface(light->geometry, moved, other);
        sum += distance(normal, other);
    }
    return sum;
}

/* Vertices are in one plane to rounding only: a receiver that is no farther from it sees some of
   the light from the front and some from the back, a polygon that is not convex. */
static int in_plane(const struct light *light, double reach)
{
    double normal[3], to[3];

    if (part_count(light->shape) <= 3 ||
        light->what->measure != PSC_MEASURE_PROJECTED_SOLID_ANGLE)
        return 0;
    light->shape->surface(light->geometry, light->middle, normal);
    subtract3(light->middle, light->position, to);
    return fabs(dot(to, normal)) <= 16.0 * reach * 0x1p-53;
}

static void check(int bits, const struct light *light, const psc_sampler *sampler, double u,
                  double v, psc_result result, const psc_light_sample_f64 *s, struct errors *e)
{
    const char *text = "%s f%d u %a v %a", *name = describe_light(light);
    const struct shape *shape = light->shape;
    const double unit = unit_of(bits);
    double normal[3], other[3], reach, off, cosine, away, total = NAN;
    int i;

    if (!((result == PSC_SUCCESS || result == PSC_CULLED) && finite_sample(s, light)) ||
        (result == PSC_CULLED) != (s->weight == 0.0) ||
        (!shape->texture && (s->surface[0] != 0.0 || s->surface[1] != 0.0))) {
        e->odd++;
        snprintf(e->first_odd, sizeof e->first_odd, text, name, bits, u, v);
    }
    worst_add(&e->unit, off_unit(s->direction) / unit, text, name, bits, u, v);
    worst_add(&e->normal_unit, off_unit(s->normal) / unit, text, name, bits, u, v);
    cosine = receiver_cosine(light, s);
    if (result == PSC_SUCCESS && isfinite(s->pdf))
        worst_add(&e->weight, fabs(s->weight * s->pdf - cosine) / unit, text, name, bits, u, v);
    away = turned_away(light, sampler, s);
    off = fmax(-cosine, away);
    if (!is_rejected(light->what, s->pdf))
        worst_add(&e->culled, (result == PSC_CULLED ? -off : off) / unit, text, name, bits, u, v);
    psc_sampler_total(sampler, &total);
    if (isfinite(s->pdf))
        worst_add(&e->density, fabs(density_error(light, total, s)) / unit, text, name, bits, u,
                  v);
    off = shape->surface(light->geometry, s->point, normal);
    if (is_distant(shape)) {
        for (i = 0; i < 3; i++)
            if (s->point[i] != s->direction[i] || s->normal[i] != normal[i])
                e->odd++;
        return;
    }
    /* coordinates round by their own size: the point that is meant is within that */
    reach = largest(light->middle) + largest(light->position) + light->reach + s->distance;
    worst_add(&e->on_surface, off / (reach * unit), text, name, bits, u, v);
    for (i = 0; i < 3; i++)
        other[i] = light->position[i] + s->distance * s->direction[i];
    if (!in_plane(light, reach))
        worst_add(&e->along, distance(s->point, other) / (reach * unit), text, name, bits, u, v);
    off = distance(s->normal, normal) - normal_motion(light, s->point, normal, reach * unit);
    worst_add(&e->normal, off / unit, text, name, bits, u, v);
    if (shape->texture) {
        shape->texture(light->geometry, s->surface, other);
        worst_add(&e->texture, distance(s->point, other) / (reach * unit), text, name, bits, u, v);
    }
}

static void any_light(uint64_t *seed, int i, const struct shape *shape,
                      const struct test_technique *what, struct light *light)
{
    switch (i % 8) {
    case 0: exact_light(seed, shape, what, light); break;
    case 4: random_hard_light(seed, shape, what, light); break;
    default: random_light(seed, shape, what, light); break;
    }
}

static void hits(const struct shape *shape, const struct test_technique *what, int bits)
{
    static const double ends[4] = {0.0, 1.0, 0x1p-149, 1.0 - 0x1p-24};
    struct errors e;
    uint64_t seed = 120;
    int i, j;

    memset(&e, 0, sizeof e);
    for (i = 0; i < LIGHTS; i++) {
        struct test_sampler s;
        struct light light;

        any_light(&seed, i, shape, what, &light);
        if (build_light(make_sampler(&s), &light) != PSC_SUCCESS)
            continue;
        for (j = 0; j < SAMPLES + 16; j++) {
            double u = random_coordinate(&seed), v = random_coordinate(&seed);
            psc_light_sample_f64 sample;
            psc_result result;

            if (j < 16) {
                u = ends[j / 4];
                v = ends[j % 4];
            }
            memset(&sample, 0xff, sizeof sample);
            result = sample_any(bits, s.sampler, u, v, &sample);
            check(bits, &light, s.sampler, u, v, result, &sample, &e);
        }
    }
    if (!tap_ok(e.odd == 0, "%s, %s, f%d: %ld results that are no samples", shape->name,
                what->name, bits, e.odd))
        tap_note("    at %s", e.first_odd);
#define REPORT(field, bound, words)                                                          \
    worst_report(&e.field, bound, "%s, %s, f%d: " words ", in roundings", shape->name,       \
                 what->name, bits)
    REPORT(unit, 8.0, "unit direction");
    REPORT(normal_unit, 16.0, "unit normal");
    if (!is_uneven(what)) /* those: test_cells.c */
        REPORT(density, 32.0, "density of the measure");
    REPORT(weight, 32.0, "weight times pdf");
    REPORT(culled, 32.0, "on the wrong side, or culled on the right one");
    if (!is_distant(shape)) {
        REPORT(on_surface, 16.0, "point on the light");
        REPORT(along, 16.0, "point along the direction");
        REPORT(normal, 16.0, "normal at the point");
    }
    if (shape->texture)
        REPORT(texture, 16.0, "point of the texture coordinates");
#undef REPORT
}

int main(void)
{
    const struct test_technique *what;
    int i, bits;

    for (i = 0; shapes[i]; i++)
        for (FOR_TECHNIQUES(shapes[i], what))
            for (bits = 32; bits <= 64; bits += 32)
                hits(shapes[i], what, bits);
    return tap_done();
}
