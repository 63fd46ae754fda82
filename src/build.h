/* SPDX-License-Identifier: Apache-2.0 */
/* The way into every build, inline: one sample for each build is what a path tracer takes. */
#ifndef PSC_SRC_BUILD_H
#define PSC_SRC_BUILD_H

#include "checks.h"

/* Builds a shape from a checked request and the numbers of its geometry, which are finite, or whose
   build tells if they are not. */
static inline psc_result psc_fill_unchecked(psc_sampler *sampler,
                                            const struct psc_shape_row *shape,
                                            const struct psc_request *request,
                                            const double *geometry)
{
    const struct psc_variant *const kernels = psc_dispatch();
    psc_result result;

    sampler->f32 = kernels->f32[shape->kernel];
    sampler->f64 = kernels->f64[shape->kernel];
    sampler->shape = shape;
    sampler->measure = request->measure;
    sampler->map = request->map;
    sampler->facing = request->facing;
    sampler->projected = request->measure == PSC_MEASURE_PROJECTED_SOLID_ANGLE;
    sampler->sides = 0;
    sampler->total = 0.0;

    result = sampler->f64->build(sampler, request, geometry);
    if (result == PSC_SUCCESS && sampler->total > 0.0) {
        sampler->inverse_total = 1.0 / sampler->total;
        return PSC_SUCCESS;
    }
    if (result < 0) {
        psc_clear(sampler);
        return result;
    }
    /* Nothing to see, or smaller than the smallest number. */
    psc_see_nothing(sampler);
    return PSC_EMPTY;
}

/* The same with that check. */
static inline psc_result psc_fill(psc_sampler *sampler, const struct psc_shape_row *shape,
                                  const struct psc_request *request, const double *geometry,
                                  int numbers)
{
    int i, finite = 1;

    for (i = 0; i < numbers; i++)
        finite &= is_finite(geometry[i]);
    if (finite)
        return psc_fill_unchecked(sampler, shape, request, geometry);
    psc_clear(sampler);
    return PSC_ERROR_NOT_FINITE;
}

/* What the shape's kernel has for the usual case, or PSC_PENDING: the sampler is to be built. */
static inline psc_result psc_build_quick(psc_sampler *sampler, const struct psc_shape_row *shape,
                                         const psc_technique *technique,
                                         const psc_receiver *receiver,
                                         const double *const vectors[], double scalar)
{
    const struct psc_variant *const kernels = psc_dispatch();
    const struct psc_kernel_f64 *const own = kernels->f64[shape->kernel];
    const psc_result result =
        sampler ? own->quick(sampler, technique, receiver, vectors, scalar) : PSC_PENDING;

    if (result != PSC_PENDING) {
        sampler->f32 = kernels->f32[shape->kernel];
        sampler->f64 = own;
        sampler->shape = shape;
    }
    return result;
}

/* Builds a shape whose geometry is a vector and a scalar. */
static inline psc_result psc_build_vector_scalar(psc_sampler *sampler,
                                                 const struct psc_shape_row *shape,
                                                 const psc_technique *technique,
                                                 const psc_receiver *receiver,
                                                 const double vector[3], double scalar)
{
    struct psc_request request;
    double geometry[4];
    psc_result result;

    if (!sampler)
        return PSC_ERROR_NULL_POINTER;
    result = psc_check_technique(technique, &request);
    if (result == PSC_SUCCESS)
        result = psc_check_receiver(receiver, &request);
    if (result == PSC_SUCCESS && !vector)
        result = PSC_ERROR_NULL_POINTER;
    if (result == PSC_SUCCESS)
        result = psc_check_offer(shape, &request);
    if (result != PSC_SUCCESS) {
        psc_clear(sampler);
        return result;
    }
    copy3(vector, geometry);
    geometry[3] = scalar;
    return psc_fill(sampler, shape, &request, geometry, 4);
}

#endif
