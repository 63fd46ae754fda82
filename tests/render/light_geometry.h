/* SPDX-License-Identifier: Apache-2.0 */
/* Rays and edges of lights, in the numbers of an emitter. */
#ifndef LIGHT_GEOMETRY_H
#define LIGHT_GEOMETRY_H

#include "light.h"

/* See light_shape.meet. */
float sphere_meet(const float *number, size_t vectors, vec3 origin, vec3 direction);
float cap_meet(const float *number, size_t vectors, vec3 origin, vec3 direction);
float disk_meet(const float *number, size_t vectors, vec3 origin, vec3 direction);
float ellipse_meet(const float *number, size_t vectors, vec3 origin, vec3 direction);
float ellipsoid_meet(const float *number, size_t vectors, vec3 origin, vec3 direction);
float triangle_meet(const float *number, size_t vectors, vec3 origin, vec3 direction);
float rectangle_meet(const float *number, size_t vectors, vec3 origin, vec3 direction);
float polygon_meet(const float *number, size_t vectors, vec3 origin, vec3 direction);

/* See light_shape.outline. */
void cap_outline(const double *number, size_t vectors, double t, double p[3]);
void disk_outline(const double *number, size_t vectors, double t, double p[3]);
void ellipse_outline(const double *number, size_t vectors, double t, double p[3]);
void ellipsoid_outline(const double *number, size_t vectors, double t, double p[3]);
void triangle_outline(const double *number, size_t vectors, double t, double p[3]);
void rectangle_outline(const double *number, size_t vectors, double t, double p[3]);
void polygon_outline(const double *number, size_t vectors, double t, double p[3]);

#endif
