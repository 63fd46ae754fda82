/* SPDX-License-Identifier: Apache-2.0 */
/* Diffuse emitters of every shape that the library has: a new one is a row of a table. */
#ifndef LIGHT_H
#define LIGHT_H

#include "vec3.h"

#include <psc/psc.h>

/* How lights are sampled. */
typedef struct technique_row {
    const char *name;
    psc_measure measure;
    psc_map map;
} technique_row;

/* Numbers in the order in which the library takes them: vectors, of which the last may be a
   scalar instead. */
enum { LIGHT_NUMBERS = 48 };

typedef struct emitter {
    const struct light_shape *shape;
    unsigned count; /* of the numbers */
    float number[LIGHT_NUMBERS];
    vec3 radiance;
} emitter;

/* What the renderer asks of a shape. */
typedef struct light_shape {
    const char *name;
    psc_result (*build)(psc_sampler *sampler, const psc_technique *technique,
                        const psc_receiver *receiver, const double *number, size_t vectors);
    psc_result (*sample_n)(const psc_technique *technique, size_t count,
                           const psc_receivers_f32 *receivers, const psc_input_f32 *part,
                           size_t vectors, const psc_input_f32 *uv, const psc_samples_f32 *out);
    /* Integral over the light of cosine * exp(-extinction * distance), without its blockers: for a
       receiver without normal the cosine is 1, and for one with there is no extinction. */
    double (*exact)(const psc_receiver *receiver, const double *number, size_t vectors,
                    double extinction);
    /* Where a ray meets the light first: a distance, infinite if nowhere. */
    float (*meet)(const float *number, size_t vectors, vec3 origin, vec3 direction);
    /* The point p on the edge, which is closed: t from 0 to 1. NULL for solids. */
    void (*outline)(const double *number, size_t vectors, double t, double p[3]);
} light_shape;

extern const light_shape light_sphere, light_cap, light_disk, light_ellipse, light_ellipsoid,
    light_triangle, light_rectangle, light_polygon;

/* The calls above for an emitter. */
psc_result light_build(const emitter *l, psc_sampler *sampler, const psc_technique *technique,
                       const psc_receiver *receiver);
psc_result light_sample_n(const emitter *l, const psc_technique *technique, size_t count,
                          const psc_receivers_f32 *receivers, const psc_input_f32 *uv,
                          const psc_samples_f32 *out);
double light_exact(const emitter *l, const psc_receiver *receiver, double extinction);
float light_meet(const emitter *l, vec3 origin, vec3 direction);

/* Where a ray meets a ball first, or leaves it from inside; infinite if nowhere. */
float meet_ball(vec3 center, float radius, vec3 origin, vec3 direction);

#endif
