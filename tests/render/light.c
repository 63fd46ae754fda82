/* SPDX-License-Identifier: Apache-2.0 */
#include "light_geometry.h"

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
    static psc_result shape##_form_factor(const psc_receiver *receiver, const double *n,        \
                                          size_t v, double *form_factor)                        \
    {                                                                                           \
        (void)v;                                                                                \
        return psc_##shape##_form_factor(receiver, UNPACK numbers, form_factor);                \
    }                                                                                           \
    const light_shape light_##shape = {#shape, shape##_build, shape##_sample_n,                 \
                                       shape##_form_factor, shape##_meet, edge};

LIGHT_SHAPE(sphere, (n, n[3]), (p, p + 1), NULL)
LIGHT_SHAPE(cap, (n, n[3]), (p, p + 1), cap_outline)

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

psc_result light_form_factor(const emitter *l, const psc_receiver *receiver, double *form_factor)
{
    double number[LIGHT_NUMBERS];
    widen(l, number);
    return l->shape->form_factor(receiver, number, vectors_of(l), form_factor);
}

float light_meet(const emitter *l, vec3 origin, vec3 direction)
{
    return l->shape->meet(l->number, vectors_of(l), origin, direction);
}
