/* SPDX-License-Identifier: Apache-2.0 */
/* Lights that are seen as an elliptic cone: what disks, elliptical disks and ellipsoids share. */
#ifndef PSC_SRC_DISK_LIGHT_H
#define PSC_SRC_DISK_LIGHT_H

#include "build.h"

psc_result psc_disk_whole_solid_angle(const psc_sampler *s, double *value);
psc_result psc_disk_projected_solid_angle(const psc_sampler *s, double *value);
psc_result psc_disk_area(const psc_sampler *s, double *value);
double psc_disk_pdf(const psc_sampler *s, const double direction[3], double epsilon);
psc_result psc_disk_invert(const psc_sampler *s, const double direction[3], double epsilon,
                           double uv[2]);

/* Whether all but the numbers of the geometry is well, as it usually is; request is that then. */
static inline int psc_disk_well(psc_sampler *sampler, const struct psc_shape_row *shape,
                                const psc_technique *technique, const psc_receiver *receiver,
                                struct psc_request *request)
{
    return sampler && psc_check_technique(technique, request) == PSC_SUCCESS &&
           psc_check_receiver(receiver, request) == PSC_SUCCESS &&
           psc_check_offer(shape, request) == PSC_SUCCESS;
}

/* The solid angle of a shape without a sampler: parts as for psc_build(). */
psc_result psc_disk_ask_solid_angle(const struct psc_shape_row *shape, const char *kinds,
                                    const double position[3], const double *const parts[],
                                    double *solid_angle);

#endif
