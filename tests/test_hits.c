/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Every sample is one: finite, of unit length, inside the light, its point on the sphere and
 * where the direction says, with its normal; at the ends of the square, from inside, from the
 * surface, from both sides of the receiver, close by and far away.
 */
#include "lights.h"
#include "worst.h"

enum { LIGHTS = 400, SAMPLES = 12 };

struct errors {
    struct worst unit, normal_unit, on_sphere, along, normal, weight;
    long odd; /* something that no sample may be */
    char first_odd[400];
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

/* Of the area measures the pdf grows beyond all numbers towards the limb. */
static int finite_sample(const psc_light_sample_f64 *s, int distant, int area)
{
    double sum = s->weight + s->surface[0] + s->surface[1];
    int i;

    if (!(area && s->weight < 1e-30))
        sum += s->pdf;

    for (i = 0; i < 3; i++)
        sum += s->direction[i] + s->point[i] + s->normal[i];
    return s->pdf >= 0.0 && s->weight >= 0.0 && isfinite(sum) && s->surface[0] == 0.0 &&
           s->surface[1] == 0.0 && (distant ? isinf(s->distance) : isfinite(s->distance));
}

static void check(int bits, const struct light *light, double u, double v, psc_result result,
                  const psc_light_sample_f64 *s, struct errors *e)
{
    const char *text = "%s f%d u %a v %a", *name = describe_light(light);
    const struct scene *scene = &light->scene;
    double unit = unit_of(bits), from_center[3], expected[3], off[3], reach, radius, cosine;
    int i, area = light->what->measure >= PSC_MEASURE_AREA;

    if (!((result == PSC_SUCCESS || result == PSC_CULLED) &&
          finite_sample(s, light->distant, area)) ||
        (result == PSC_CULLED) != (s->weight == 0.0)) {
        e->odd++;
        snprintf(e->first_odd, sizeof e->first_odd, text, name, bits, u, v);
    }
    worst_add(&e->unit, off_unit(s->direction) / unit, text, name, bits, u, v);
    worst_add(&e->normal_unit, off_unit(s->normal) / unit, text, name, bits, u, v);
    if (light->has_normal) {
        /* weight times pdf is the cosine */
        double length = sqrt(dot(scene->normal, scene->normal));
        cosine = dot(s->direction, scene->normal) / length;
        cosine = light->flags ? fabs(cosine) : fmax(cosine, 0.0);
        if (result == PSC_SUCCESS && isfinite(s->pdf))
            worst_add(&e->weight, fabs(s->weight * s->pdf - cosine) / unit, text, name, bits, u,
                      v);
    } else if (result == PSC_SUCCESS && isfinite(s->pdf)) {
        worst_add(&e->weight, fabs(s->weight * s->pdf - 1.0) / unit, text, name, bits, u, v);
    }
    if (light->distant) {
        for (i = 0; i < 3; i++)
            if (s->point[i] != s->direction[i] || s->normal[i] != -s->direction[i])
                e->odd++;
        return;
    }
    radius = scene->radius;
    /* coordinates round by their own size: the point that is meant is within that */
    reach = largest(scene->center) + largest(scene->position) + radius + s->distance;
    for (i = 0; i < 3; i++) {
        from_center[i] = s->point[i] - scene->center[i];
        expected[i] = scene->position[i] + s->distance * s->direction[i];
        off[i] = s->point[i] - expected[i];
    }
    worst_add(&e->on_sphere, fabs(sqrt(dot(from_center, from_center)) - radius) / (reach * unit),
              text, name, bits, u, v);
    worst_add(&e->along, sqrt(dot(off, off)) / (reach * unit), text, name, bits, u, v);
    for (i = 0; i < 3; i++)
        off[i] = from_center[i] - radius * s->normal[i];
    worst_add(&e->normal, sqrt(dot(off, off)) / (reach * unit), text, name, bits, u, v);
}

static void hits(const struct test_technique *what, int bits)
{
    static const double ends[4] = {0.0, 1.0, 0x1p-149, 1.0 - 0x1p-24};
    struct errors e;
    uint64_t seed = 120;
    int i, j;

    memset(&e, 0, sizeof e);
    for (i = 0; i < LIGHTS; i++) {
        struct test_sampler s;
        struct light light;

        random_light(&seed, what, &light);
        if (i % 4 == 0 && !light.distant) { /* harder ones, and on the surface exactly */
            random_scene(&seed, &light.scene);
            if (i % 8 == 0) {
                memset(light.scene.position, 0, sizeof light.scene.position);
                memset(light.scene.center, 0, sizeof light.scene.center);
                light.scene.center[random_below(&seed, 3)] = light.scene.radius;
            }
        }
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
            check(bits, &light, u, v, result, &sample, &e);
        }
    }
    if (!tap_ok(e.odd == 0, "%s, f%d: %ld results that are no samples", what->name, bits, e.odd))
        tap_note("    at %s", e.first_odd);
    worst_report(&e.unit, 8.0, "%s, f%d: unit direction, in roundings", what->name, bits);
    worst_report(&e.normal_unit, 16.0, "%s, f%d: unit normal, in roundings", what->name, bits);
    worst_report(&e.weight, 32.0, "%s, f%d: weight times pdf, in roundings", what->name, bits);
    worst_report(&e.on_sphere, 16.0, "%s, f%d: point on the sphere, in roundings", what->name,
                 bits);
    worst_report(&e.along, 16.0, "%s, f%d: point along the direction, in roundings", what->name,
                 bits);
    worst_report(&e.normal, 16.0, "%s, f%d: normal at the point, in roundings", what->name, bits);
}

int main(void)
{
    int i, bits;

    for (i = 0; i < TEST_TECHNIQUES; i++)
        for (bits = 32; bits <= 64; bits += 32)
            hits(&test_techniques[i], bits);
    return tap_done();
}
