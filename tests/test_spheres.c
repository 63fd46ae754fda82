/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Samples of spheres through the public interface against exact ones, worked out with 113 bits
 * from the very numbers that are passed: relative distances from 1e-8 to 1e8, elevations near
 * every boundary of the cases. Points are compared in units of the radius, limb included.
 *
 * Bounds are those of rounding, and beyond it by how much the exact sample moves within the CDF
 * error that is allowed: t is moved by that much.
 */
#include "calls.h"
#include "reference.h"
#include "scenes.h"
#include "shapes.h"
#include "worst.h"

enum { SCENES = 300, SAMPLES = 3 };

/* The exact geometry of a scene: centre relative to the receiver, and the local frame. */
struct exact {
    quad center[3], distance, radius;
    quad frame[3][3];
    struct reference r;
};

static quad dot_exact(const quad a[3], const quad b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void normalise(quad v[3])
{
    quad length = quad_sqrt(dot_exact(v, v));
    int i;

    for (i = 0; i < 3; i++)
        v[i] /= length;
}

static void exact_scene(const struct scene *scene, struct exact *e)
{
    quad *x = e->frame[0], *y = e->frame[1], *z = e->frame[2], height;
    int i;

    for (i = 0; i < 3; i++) {
        e->center[i] = (quad)scene->center[i] - scene->position[i];
        z[i] = scene->normal[i];
    }
    e->radius = scene->radius;
    e->distance = quad_sqrt(dot_exact(e->center, e->center));
    normalise(z);
    height = dot_exact(z, e->center);
    for (i = 0; i < 3; i++)
        x[i] = e->center[i] - height * z[i];
    reference_from_sphere(&e->r, quad_sqrt(dot_exact(x, x)), height, e->radius);
    normalise(x);
    for (i = 0; i < 3; i++)
        y[i] = z[(i + 1) % 3] * x[(i + 2) % 3] - z[(i + 2) % 3] * x[(i + 1) % 3];
}

/* The total that a technique samples by. */
static quad exact_total(const struct test_technique *what, const struct exact *e)
{
    switch (what->measure) {
    case PSC_MEASURE_SOLID_ANGLE: return 2 * quad_pi() * e->r.height;
    case PSC_MEASURE_PROJECTED_SOLID_ANGLE: return reference_total(&e->r);
    case PSC_MEASURE_AREA: return 4 * quad_pi() * e->radius * e->radius;
    default: return 2 * quad_pi() * quad_square(e->radius) * (1 - e->radius / e->distance);
    }
}

/* Height of the light above the horizon. */
static quad highest(const struct exact *e)
{
    if (e->r.visible == REFERENCE_LUNE)
        return e->r.rise;
    return e->r.cb < e->r.sa ? 1 : e->r.sa * e->r.cb + e->r.ca * e->r.sb;
}

/* ---- The exact sample */

struct exact_sample {
    quad direction[3], normal[3], distance;
    quad height; /* of the direction above the horizon */
    quad chance; /* pdf, or its inverse for the area measures, in units of the greatest */
    quad weight; /* in units of the greatest */
};

static void to_world(const struct exact *e, const quad local[3], quad world[3])
{
    int i;

    for (i = 0; i < 3; i++)
        world[i] = local[0] * e->frame[0][i] + local[1] * e->frame[1][i] +
                   local[2] * e->frame[2][i];
}

static quad cosine_turn(quad t)
{
    return quad_cos(quad_pi() * (2 * t - 1));
}

static quad sine_turn(quad t)
{
    return quad_sin(quad_pi() * (2 * t - 1));
}

/* The near intersection with the sphere, of the direction axis + offset. */
static void hit(const struct exact *e, const quad offset[3], struct exact_sample *out)
{
    quad world[3], across2 = 0, b, root;
    int i;

    to_world(e, offset, world);
    for (i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        across2 += quad_square(e->center[j] * world[k] - e->center[k] * world[j]);
        out->direction[i] = e->center[i] / e->distance + world[i];
    }
    b = dot_exact(out->direction, e->center);
    root = e->radius * e->radius - across2;
    root = quad_sqrt(root > 0 ? root : 0);
    out->distance = (e->distance - e->radius) * (e->distance + e->radius) / (b + root);
    for (i = 0; i < 3; i++)
        out->normal[i] = (out->distance * out->direction[i] - e->center[i]) / e->radius;
    out->height = e->r.sb + offset[2];
}

static void sample_cone(const struct exact *e, quad s, quad t, struct exact_sample *out)
{
    const struct reference *r = &e->r;
    quad h = s * r->height, side = quad_sqrt(h * (2 - h)), along = side * cosine_turn(t);
    quad offset[3];

    offset[0] = along * r->sb - h * r->cb;
    offset[1] = side * sine_turn(t);
    offset[2] = -along * r->cb - h * r->sb;
    hit(e, offset, out);
}

/* Uniform on the surface: w = 1 - cosine of the angle from the near point. */
static void sample_area(const struct exact *e, quad width, quad s, quad t,
                        struct exact_sample *out)
{
    const struct reference *r = &e->r;
    quad w = s * width, side = quad_sqrt(w * (2 - w)), along = side * cosine_turn(t);
    quad local[3], length2 = 0;
    int i;

    local[0] = along * r->sb - (1 - w) * r->cb;
    local[1] = side * sine_turn(t);
    local[2] = -along * r->cb - (1 - w) * r->sb;
    to_world(e, local, out->normal);
    for (i = 0; i < 3; i++) {
        out->direction[i] = e->center[i] + e->radius * out->normal[i];
        length2 += quad_square(out->direction[i]);
    }
    out->distance = quad_sqrt(length2);
    for (i = 0; i < 3; i++)
        out->direction[i] /= out->distance;
    out->height = dot_exact(out->direction, e->frame[2]);
}

/* The exact sample, with s or t moved. */
static void exact_sample_at(const struct test_technique *what, const struct exact *e, double u,
                            double v, int which, double move, struct exact_sample *out)
{
    int projected = what->measure == PSC_MEASURE_PROJECTED_SOLID_ANGLE, i;
    quad st[2], offset[3], pq[2], facing;

    st[0] = u;
    st[1] = v;
    if (what->map == PSC_MAP_CONCENTRIC && projected) {
        reference_concentric(u, v, st);
    } else if (what->map == PSC_MAP_CONCENTRIC) {
        reference_disk(u, v, pq);
        st[0] = pq[0] * pq[0] + pq[1] * pq[1];
        st[1] = (1 + quad_atan2(pq[1], pq[0]) / quad_pi()) / 2;
    }
    st[which] += move;
    for (i = 0; i < 2; i++)
        st[i] = st[i] < 0 ? 0 : st[i] > 1 ? 1 : st[i];
    if (projected) {
        (what->map == PSC_MAP_RADIAL ? reference_radial_sample
                                     : reference_parallel_sample)(&e->r, st[0], st[1], offset);
        hit(e, offset, out);
        out->chance = out->height / highest(e);
        out->weight = 1;
    } else if (what->measure == PSC_MEASURE_SOLID_ANGLE) {
        sample_cone(e, st[0], st[1], out);
        out->chance = 1;
        out->weight = out->height > 0 ? out->height : 0;
    } else {
        sample_area(e, what->measure == PSC_MEASURE_AREA ? 2 : 1 - e->radius / e->distance,
                    st[0], st[1], out);
        facing = dot_exact(out->direction, out->normal);
        out->chance = quad_abs(facing);
        out->weight = out->height > 0 && facing < 0 ? -facing * out->height : 0;
    }
}

/* pdf and weight as they were returned, in the units of above. */
static void in_units(const struct test_technique *what, const struct exact *e,
                     const psc_light_sample_f64 *found, const struct exact_sample *exact,
                     quad *chance, quad *weight)
{
    quad total = exact_total(what, e), scale = total;

    if (what->measure >= PSC_MEASURE_AREA) {
        scale = total / (exact->distance * exact->distance);
        *chance = 1 / (found->pdf * scale);
    } else {
        *chance = found->pdf * total;
        if (what->measure == PSC_MEASURE_PROJECTED_SOLID_ANGLE)
            *chance /= highest(e);
    }
    *weight = found->weight / scale;
}

/* ---- Comparison */

enum { DIRECTION, POINT, DISTANCE, PDF, WEIGHT, ERRORS };

static const char *const error_names[ERRORS] = {"direction", "point, in radii",
                                                "distance, relative", "pdf", "weight"};
static const double error_bounds[2][ERRORS] = {{5e-7, 2e-6, 2e-6, 2e-6, 2e-6},
                                               {1e-15, 1e-13, 1e-14, 1e-14, 1e-14}};

static double apart(const quad a[3], const quad b[3])
{
    return (double)quad_sqrt(quad_square(a[0] - b[0]) + quad_square(a[1] - b[1]) +
                             quad_square(a[2] - b[2]));
}

static void differences(const struct exact_sample *a, const struct exact_sample *b,
                        double error[ERRORS])
{
    error[DIRECTION] = apart(a->direction, b->direction);
    error[POINT] = apart(a->normal, b->normal);
    error[DISTANCE] = (double)quad_abs(a->distance / b->distance - 1);
    error[PDF] = (double)quad_abs(a->chance - b->chance);
    error[WEIGHT] = (double)quad_abs(a->weight - b->weight);
}

static int within(const double error[ERRORS], const double bound[ERRORS])
{
    int i;

    for (i = 0; i < ERRORS; i++)
        if (!(error[i] <= bound[i]))
            return 0;
    return 1;
}

static void compare(const struct test_technique *what, const struct exact *e, int bits, double u,
                    double v, const psc_light_sample_f64 *found, double error[ERRORS])
{
    double cdf = bits == 64 ? 1e-14 : 3e-7, off[ERRORS];
    /* where the axis is close to the normal, the rounding of the normal turns the local frame */
    double turn = 4.0 * 0x1p-53 / (double)e->r.cb;
    struct exact_sample exact, moved, here;
    int i, sign;

    exact_sample_at(what, e, u, v, 0, 0.0, &exact);
    for (i = 0; i < 3; i++) {
        here.direction[i] = found->direction[i];
        here.normal[i] = found->normal[i];
    }
    here.distance = found->distance;
    in_units(what, e, found, &exact, &here.chance, &here.weight);
    differences(&here, &exact, error);
    if (bits == 32) /* below the smallest number of full precision, float rounds coarser */
        error[WEIGHT] -= 0x1p-149 / (double)exact_total(what, e);
    if (within(error, error_bounds[bits == 64]))
        return;
    for (sign = -2; sign <= 2; sign += sign == -1 ? 2 : 1) {
        exact_sample_at(what, e, u, v, sign % 2 == 0, sign > 0 ? cdf : -cdf, &moved);
        differences(&moved, &exact, off);
        for (i = 0; i < ERRORS; i++) {
            double open = off[i] + (i == DIRECTION ? turn * (double)e->r.sa : turn);
            error[i] = error[i] <= open ? 0.0 : error[i] - open;
        }
    }
}

static void describe(const struct scene *scene, char *text, size_t size)
{
    snprintf(text, size, "position %a %a %a normal %a %a %a center %a %a %a radius %a",
             scene->position[0], scene->position[1], scene->position[2], scene->normal[0],
             scene->normal[1], scene->normal[2], scene->center[0], scene->center[1],
             scene->center[2], scene->radius);
}

static void sweep(const struct test_technique *what)
{
    struct worst worst[2][ERRORS], total_error;
    uint64_t seed = 30;
    int i, j, k, wide;

    memset(worst, 0, sizeof worst);
    memset(&total_error, 0, sizeof total_error);
    for (i = 0; i < SCENES; i++) {
        struct test_sampler s;
        struct scene scene;
        struct exact e;
        double total = NAN;
        char text[300];

        random_scene(&seed, &scene);
        describe(&scene, text, sizeof text);
        exact_scene(&scene, &e);
        build_sphere(make_sampler(&s), what, 0, scene.position, scene.normal, scene.center,
                     scene.radius);
        if (e.r.cb == 0 || e.r.visible == REFERENCE_EMPTY)
            continue; /* no frame, no light */
        psc_sampler_total(s.sampler, &total);
        worst_add(&total_error, (double)quad_abs(total / exact_total(what, &e) - 1),
                  "scene %d: %s", i, text);
        for (j = 0; j < SAMPLES; j++) {
            double u = random_coordinate(&seed), v = random_coordinate(&seed);

            for (wide = 1; wide >= 0; wide--) {
                psc_light_sample_f64 found;
                double error[ERRORS];

                memset(&found, 0xff, sizeof found); /* NaN, should nothing be written */
                if (!wide) {
                    u = (float)u;
                    v = (float)v;
                }
                sample_any(wide ? 64 : 32, s.sampler, u, v, &found);
                compare(what, &e, wide ? 64 : 32, u, v, &found, error);
                for (k = 0; k < ERRORS; k++)
                    worst_add(&worst[wide][k], error[k], "scene %d sample %d: %s u %a v %a", i, j,
                              text, u, v);
            }
        }
    }
    worst_report(&total_error, 1e-14, "%s: total, relative", what->name);
    for (wide = 0; wide < 2; wide++)
        for (k = 0; k < ERRORS; k++)
            worst_report(&worst[wide][k], error_bounds[wide][k], "%s, %s: %s", what->name,
                         wide ? "f64" : "f32", error_names[k]);
}

int main(void)
{
    const struct test_technique *what;

    for (FOR_TECHNIQUES(&shape_sphere, what))
        sweep(what);
    return tap_done();
}
