/* SPDX-License-Identifier: Apache-2.0 */
/*
 * The builds that a path tracer makes for each light and shading point, from the public call's
 * arguments straight to the sampler, which is complete afterwards but for what the caller knows of
 * itself (kernels and shape). PSC_PENDING: not one of these. Everything else, and everything that
 * is wrong, is left to the build for all.
 */
#ifndef PSC_SRC_POLYGON_QUICK_H
#define PSC_SRC_POLYGON_QUICK_H

#include "rectangle_build.h"
#include "triangle_build.h"

/* Whether a light is asked for by solid angle or area in this map, and all is there. */
PSC_LANE int is_quick(const psc_technique *technique, const psc_receiver *receiver, psc_map map,
                      const double *const vectors[])
{
    return technique && technique->struct_size == sizeof *technique &&
           (technique->measure == PSC_MEASURE_SOLID_ANGLE ||
            technique->measure == PSC_MEASURE_AREA) &&
           technique->map == map && technique->flags <= PSC_TECHNIQUE_ONE_SIDED && receiver &&
           receiver->struct_size == sizeof *receiver &&
           receiver->flags <= PSC_RECEIVER_TWO_SIDED && receiver->position && vectors[0] &&
           vectors[1] && vectors[2];
}

PSC_LANE enum psc_facing quick_facing(const psc_receiver *receiver)
{
    return !receiver->normal ? PSC_FACING_NONE
           : !receiver->flags ? PSC_FACING_ONE
                              : PSC_FACING_BOTH;
}

/* What is left when the light is there, or nothing is seen of it. */
PSC_LANE psc_result quick_finish(psc_sampler *s, const psc_technique *technique,
                                 enum psc_facing facing, psc_result result)
{
    if (result == PSC_PENDING)
        return PSC_PENDING;
    s->measure = technique->measure;
    s->map = technique->map;
    s->facing = facing;
    s->projected = 0;
    if (result == PSC_SUCCESS)
        s->inverse_total = 1.0 / s->total;
    else
        psc_see_nothing(s);
    return result;
}

static psc_result triangle_quick(psc_sampler *s, const psc_technique *technique,
                                 const psc_receiver *receiver, const double *const vertices[],
                                 double unused)
{
    enum psc_facing facing;

    (void)unused;
    if (!is_quick(technique, receiver, PSC_MAP_RADIAL, vertices))
        return PSC_PENDING;
    facing = quick_facing(receiver);
    return quick_finish(s, technique, facing,
                        technique->measure == PSC_MEASURE_AREA
                            ? plain_area_build(s, receiver->position, receiver->normal, vertices,
                                               technique->flags != 0, facing)
                            : plain_triangle_build(s, receiver->position, receiver->normal,
                                                   vertices, technique->flags != 0, facing));
}

static psc_result rectangle_quick(psc_sampler *s, const psc_technique *technique,
                                  const psc_receiver *receiver, const double *const vectors[],
                                  double unused)
{
    enum psc_facing facing;

    (void)unused;
    if (!is_quick(technique, receiver, PSC_MAP_PARALLEL, vectors))
        return PSC_PENDING;
    facing = quick_facing(receiver);
    copy3(vectors[0], s->polygon.corner[0]);
    copy3(vectors[1], s->polygon.corner[1]);
    copy3(vectors[2], s->polygon.corner[2]);
    return quick_finish(s, technique, facing,
                        plain_rectangle_build(s, technique->measure == PSC_MEASURE_AREA,
                                              receiver->position, receiver->normal,
                                              s->polygon.corner[0], technique->flags != 0,
                                              facing));
}

#endif
