/* SPDX-License-Identifier: Apache-2.0 */
/* Exact light from what a light's outline encloses, by integrals along the outline: no step is
   shared with the library. */
#ifndef CONTOUR_H
#define CONTOUR_H

#include <stddef.h>

enum { CONTOUR_VERTICES = 16 };

/* An outline, relative to the receiver: a polygon, or (without vertices) an ellipse center +
   cos(t) u + sin(t) v. */
typedef struct contour {
    size_t count;
    double vertex[CONTOUR_VERTICES][3];
    double center[3], u[3], v[3];
} contour;

/* Outlines of lights, from the numbers of an emitter, as seen from a position. */
void disk_contour(const double *number, size_t vectors, const double from[3], contour *c);
void ellipse_contour(const double *number, size_t vectors, const double from[3], contour *c);
void ellipsoid_contour(const double *number, size_t vectors, const double from[3], contour *c);
void triangle_contour(const double *number, size_t vectors, const double from[3], contour *c);
void rectangle_contour(const double *number, size_t vectors, const double from[3], contour *c);
void polygon_contour(const double *number, size_t vectors, const double from[3], contour *c);

/* Integral of the cosine over the directions inside, above the horizon of a unit normal. */
double contour_irradiance(const contour *c, const double normal[3]);

/* Integral of exp(-extinction * distance) over the directions to a flat ellipse. */
double contour_fluence(const contour *c, double extinction);

#endif
