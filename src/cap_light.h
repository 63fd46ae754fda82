/* SPDX-License-Identifier: Apache-2.0 */
/* Lights that are seen as a spherical cap: what spheres and distant lights share. */
#ifndef PSC_SRC_CAP_LIGHT_H
#define PSC_SRC_CAP_LIGHT_H

#include "sampler.h"

/* Projected solid angle above the horizon (both = 0), or on both sides of it. */
double psc_cap_projected(const struct psc_cap *cap, int both);

psc_result psc_cap_projected_solid_angle(const psc_sampler *s, double *value);
psc_result psc_cap_whole_solid_angle(const psc_sampler *s, double *value);
double psc_cap_pdf(const psc_sampler *s, const double direction[3], double epsilon);
psc_result psc_cap_invert(const psc_sampler *s, const double direction[3], double epsilon,
                          double uv[2]);

#endif
