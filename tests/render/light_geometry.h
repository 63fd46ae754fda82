/* SPDX-License-Identifier: Apache-2.0 */
/* Rays and edges of lights, in the numbers of an emitter. */
#ifndef LIGHT_GEOMETRY_H
#define LIGHT_GEOMETRY_H

#include "light.h"

float sphere_meet(const float *number, size_t vectors, vec3 origin, vec3 direction);
float cap_meet(const float *number, size_t vectors, vec3 origin, vec3 direction);

void cap_outline(const double *number, size_t vectors, double t, double p[3]);

#endif
