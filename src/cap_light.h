/* SPDX-License-Identifier: Apache-2.0 */
/* Lights that are seen as a spherical cap: what spheres and distant lights share. */
#ifndef PSC_SRC_CAP_LIGHT_H
#define PSC_SRC_CAP_LIGHT_H

#include "sampler.h"

/* Where the cap is: directions are unit vectors, sideways is normal x axis / cos beta. */
struct psc_cap_frame {
    double normal[3], axis[3], sideways[3];
};

/* The frame of a cap without horizon, or around the normal itself. */
void psc_cap_frame_around(const double axis[3], struct psc_cap_frame *frame);

/* Sets up the sides of a sampler for (projected) solid angle. s->cap is filled; h0 is 1 - cos
   alpha, up to 2. PSC_EMPTY if nothing is above the horizon. */
psc_result psc_cap_sides(psc_sampler *s, const struct psc_cap_frame *frame, double h0);

/* The frame of the cone and area maps of a side: x is down towards the horizon. */
void psc_cone_side(struct psc_side *side, const struct psc_cap *cap,
                   const struct psc_cap_frame *frame);

/* Where the cap lies to the horizon, for a receiver of this facing. */
psc_case psc_cap_case(const struct psc_cap *cap, enum psc_facing facing);

/* Projected solid angle above the horizon (both = 0), or on both sides of it. */
double psc_cap_projected(const struct psc_cap *cap, int both);

psc_result psc_cap_projected_solid_angle(const psc_sampler *s, double *value);
psc_result psc_cap_whole_solid_angle(const psc_sampler *s, double *value);
double psc_cap_pdf(const psc_sampler *s, const double direction[3], double epsilon);
psc_result psc_cap_invert(const psc_sampler *s, const double direction[3], double epsilon,
                          double uv[2]);

#endif
