/* SPDX-License-Identifier: Apache-2.0 */
#include "contour.h"
#include "light_geometry.h"

#define PI 3.14159265358979323846

/* ---- The library's calls, shape by shape --------------------------------------------------- */

/* numbers and parts are what the calls of this shape take of the doubles n and of the inputs p;
   v is the number of vectors. */
#define UNPACK(...) __VA_ARGS__
#define LIGHT_SHAPE(shape, numbers, parts, edge)                                                  \
    static psc_result shape##_build(psc_sampler *sampler, const psc_technique *technique,       \
                                    const psc_receiver *receiver, const double *n, size_t v)    \
    {                                                                                           \
        (void)v;                                                                                \
        return psc_build_##shape(sampler, technique, receiver, UNPACK numbers);                 \
    }                                                                                           \
    static psc_result shape##_sample_n(const psc_technique *technique, size_t count,            \
                                       const psc_receivers_f32 *receivers,                      \
                                       const psc_input_f32 *p, size_t v,                        \
                                       const psc_input_f32 *uv, const psc_samples_f32 *out)     \
    {                                                                                           \
        (void)v;                                                                                \
        return psc_##shape##_sample_n_f32(technique, count, receivers, UNPACK parts, uv, out);  \
    }                                                                                           \
    const light_shape light_##shape = {#shape, shape##_build, shape##_sample_n, shape##_exact,  \
                                       shape##_meet, edge};

/* Spheres and caps know their form factors. */
#define FORM_FACTOR(shape)                                                                      \
    static double shape##_exact(const psc_receiver *receiver, const double *n, size_t v,        \
                                double extinction)                                              \
    {                                                                                           \
        double factor;                                                                          \
        (void)v;                                                                                \
        if (psc_##shape##_form_factor(receiver, n, n[3], &factor) < 0 || extinction > 0)        \
            return NAN;                                                                         \
        return PI * factor;                                                                     \
    }

/* Others have an outline to be integrated along. */
static double exact_inside(const contour *c, const psc_receiver *receiver, double extinction)
{
    const double *n = receiver->normal;
    if (!n)
        return contour_fluence(c, extinction);
    const double length = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    return contour_irradiance(c, (double[]){n[0] / length, n[1] / length, n[2] / length});
}

#define CONTOUR(shape)                                                                          \
    static double shape##_exact(const psc_receiver *receiver, const double *n, size_t v,        \
                                double extinction)                                              \
    {                                                                                           \
        contour c;                                                                              \
        shape##_contour(n, v, receiver->position, &c);                                          \
        return exact_inside(&c, receiver, extinction);                                          \
    }

FORM_FACTOR(sphere)
FORM_FACTOR(cap)
CONTOUR(disk)
CONTOUR(ellipse)
CONTOUR(ellipsoid)
CONTOUR(triangle)
CONTOUR(rectangle)
CONTOUR(polygon)

LIGHT_SHAPE(sphere, (n, n[3]), (p, p + 1), NULL)
LIGHT_SHAPE(cap, (n, n[3]), (p, p + 1), cap_outline)
LIGHT_SHAPE(disk, (n, n + 3, n[6]), (p, p + 1, p + 2), disk_outline)
LIGHT_SHAPE(ellipse, (n, n + 3, n + 6), (p, p + 1, p + 2), ellipse_outline)
LIGHT_SHAPE(ellipsoid, (n, n + 3, n + 6, n + 9), (p, p + 1, p + 2, p + 3), ellipsoid_outline)
LIGHT_SHAPE(triangle, (n, n + 3, n + 6), (p, p + 1, p + 2), triangle_outline)
LIGHT_SHAPE(rectangle, (n, n + 3, n + 6), (p, p + 1, p + 2), rectangle_outline)
LIGHT_SHAPE(polygon, (v, n, 3 * sizeof *n), (v, p), polygon_outline)

/* ---- Any shape ----------------------------------------------------------------------------- */

static size_t vectors_of(const emitter *l)
{
    return (l->count + 2) / 3;
}

static void widen(const emitter *l, double number[LIGHT_NUMBERS])
{
    for (unsigned i = 0; i < l->count; ++i)
        number[i] = l->number[i];
}

psc_result light_build(const emitter *l, psc_sampler *sampler, const psc_technique *technique,
                       const psc_receiver *receiver)
{
    double number[LIGHT_NUMBERS];
    widen(l, number);
    return l->shape->build(sampler, technique, receiver, number, vectors_of(l));
}

psc_result light_sample_n(const emitter *l, const psc_technique *technique, size_t count,
                          const psc_receivers_f32 *receivers, const psc_input_f32 *uv,
                          const psc_samples_f32 *out)
{
    psc_input_f32 part[LIGHT_NUMBERS / 3];
    for (unsigned i = 0; i < vectors_of(l); ++i) {
        const float *n = &l->number[3 * i];
        part[i] = (psc_input_f32){{n, n + 1, n + 2}, 0};
    }
    return l->shape->sample_n(technique, count, receivers, part, vectors_of(l), uv, out);
}

double light_exact(const emitter *l, const psc_receiver *receiver, double extinction)
{
    double number[LIGHT_NUMBERS];
    widen(l, number);
    return l->shape->exact(receiver, number, vectors_of(l), extinction);
}

float light_meet(const emitter *l, vec3 origin, vec3 direction)
{
    return l->shape->meet(l->number, vectors_of(l), origin, direction);
}
