/* SPDX-License-Identifier: Apache-2.0 */
/*
 * The build that a path tracer makes for each light and shading point, from the public call's
 * arguments straight to the sampler, which is complete afterwards but for what the caller knows of
 * itself (kernels and shape). PSC_PENDING: not one of these. Everything else, and everything that
 * is wrong, is left to the build for all.
 */
#ifndef PSC_SRC_TRIANGLE_QUICK_H
#define PSC_SRC_TRIANGLE_QUICK_H

#include "triangle_build.h"

static psc_result triangle_quick(psc_sampler *s, const psc_technique *technique,
                                 const psc_receiver *receiver, const double *const vertices[],
                                 double unused)
{
    enum psc_facing facing;
    psc_result result;

    (void)unused;
    if (!technique || technique->struct_size != sizeof *technique ||
        (technique->measure != PSC_MEASURE_SOLID_ANGLE && technique->measure != PSC_MEASURE_AREA) ||
        technique->map != PSC_MAP_RADIAL || technique->flags > PSC_TECHNIQUE_ONE_SIDED)
        return PSC_PENDING;
    if (!receiver || receiver->struct_size != sizeof *receiver ||
        receiver->flags > PSC_RECEIVER_TWO_SIDED || !receiver->position || !vertices[0] ||
        !vertices[1] || !vertices[2])
        return PSC_PENDING;
    facing = !receiver->normal   ? PSC_FACING_NONE
             : !receiver->flags ? PSC_FACING_ONE
                                : PSC_FACING_BOTH;
    result = technique->measure == PSC_MEASURE_AREA
                 ? plain_area_build(s, receiver->position, receiver->normal, vertices,
                                    technique->flags != 0, facing)
                 : plain_triangle_build(s, receiver->position, receiver->normal, vertices,
                                        technique->flags != 0, facing);
    if (result == PSC_PENDING)
        return PSC_PENDING;
    s->measure = technique->measure;
    s->map = PSC_MAP_RADIAL;
    s->facing = facing;
    s->projected = 0;
    if (result == PSC_SUCCESS) {
        s->inverse_total = 1.0 / s->total;
        return PSC_SUCCESS;
    }
    psc_see_nothing(s);
    return PSC_EMPTY;
}

#endif
