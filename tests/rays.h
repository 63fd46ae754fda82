/* SPDX-License-Identifier: Apache-2.0 */
/* Directions spread evenly about a light, for tests that ask plain geometry which of them hit. */
#ifndef PSC_TESTS_RAYS_H
#define PSC_TESTS_RAYS_H

#include "shapes.h"
#include "vectors.h"

/* Around all of the light. */
struct cone {
    double axis[3], x[3], y[3], versine, solid_angle; /* 1 - cosine of the half-angle */
};

static inline void make_cone(const struct light *light, struct cone *cone)
{
    const double pi = 3.14159265358979323846;
    uint64_t seed = 1;
    double length, sine;

    cone->versine = 2.0;
    if (is_distant(light->shape)) {
        memcpy(cone->axis, light->middle, sizeof cone->axis);
        cone->versine = fmin(1.0 - cos(fmin(light->geometry[3], 3.1) + 0.01), 2.0);
        length = 1.0;
    } else {
        subtract3(light->middle, light->position, cone->axis);
        length = sqrt(dot(cone->axis, cone->axis));
        sine = 1.001 * light->reach / length;
        if (sine < 1.0)
            cone->versine = sine * sine / (1.0 + sqrt((1.0 - sine) * (1.0 + sine)));
    }
    if (light->shape->flat && length == 0.0)
        cone->axis[2] = length = 1.0;
    scale3(cone->axis, 1.0 / length, cone->axis);
    random_across(&seed, cone->axis, cone->x);
    cross(cone->axis, cone->x, cone->y);
    cone->solid_angle = 2.0 * pi * cone->versine;
}

/* Direction i of a lattice of any length on the cone: the additive recurrence by the plastic
   number, whose points lie evenly in the square however many there are. */
static inline void cone_direction(const struct cone *cone, int i, double w[3])
{
    const double a = 0.7548776662466927, b = 0.5698402909980532;
    const double u = fmod(0.5 + i * a, 1.0), v = fmod(0.5 + i * b, 1.0) * 6.283185307179586;
    const double h = u * cone->versine, sine = sqrt(h * (2.0 - h));
    int k;

    for (k = 0; k < 3; k++)
        w[k] = (1.0 - h) * cone->axis[k] + sine * (cos(v) * cone->x[k] + sin(v) * cone->y[k]);
}

/* Whether the light fills enough of the cone for a lattice to hold it: not one seen edge-on. */
static inline int fills_cone(const struct light *light)
{
    struct cone cone;
    double w[3];
    int i, hits = 0;

    make_cone(light, &cone);
    for (i = 0; i < 2000; i++) {
        cone_direction(&cone, i, w);
        hits += light->shape->hit(light->geometry, light->position, w) >= 0.0;
    }
    return hits > 200;
}

/* The cosine that counts at the receiver: 0 below its horizon, 1 without a normal. */
static inline double cosine_at(const struct light *light, const double w[3])
{
    double cosine;

    if (!light->has_normal)
        return 1.0;
    cosine = dot(w, light->normal) / sqrt(dot(light->normal, light->normal));
    return light->flags ? fabs(cosine) : fmax(cosine, 0.0);
}

#endif
