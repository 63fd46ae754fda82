/* SPDX-License-Identifier: Apache-2.0 */
/* Flat lights with straight edges: what triangles, rectangles and polygons share. */
#ifndef PSC_SRC_POLYGON_LIGHT_H
#define PSC_SRC_POLYGON_LIGHT_H

#include "sampler.h"

psc_result psc_polygon_solid_angle_of(const psc_sampler *s, double *value);
psc_result psc_polygon_projected_solid_angle(const psc_sampler *s, double *value);
psc_result psc_polygon_area(const psc_sampler *s, double *value);
double psc_polygon_pdf(const psc_sampler *s, const double direction[3], double epsilon);
psc_result psc_polygon_invert(const psc_sampler *s, const double direction[3], double epsilon,
                              double uv[2]);

#endif
