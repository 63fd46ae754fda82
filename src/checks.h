/* SPDX-License-Identifier: Apache-2.0 */
/* Checking the descriptions of one call: inline, for single builds pay for it each time. */
#ifndef PSC_SRC_CHECKS_H
#define PSC_SRC_CHECKS_H

#include "sampler.h"
#include "table.h"
#include "vector.h"

static inline psc_result psc_check_struct(const void *from, size_t size)
{
    uint32_t given;

    if (!from)
        return PSC_ERROR_NULL_POINTER;
    memcpy(&given, from, sizeof given);
    return given == size ? PSC_SUCCESS : psc_check_other_size(from, size);
}

static inline psc_result psc_check_technique(const psc_technique *technique,
                                             struct psc_request *request)
{
    const psc_result result = psc_check_struct(technique, sizeof *technique);

    if (result != PSC_SUCCESS)
        return result;
    if (technique->measure > PSC_MEASURE_VISIBLE_AREA)
        return PSC_ERROR_UNKNOWN_MEASURE;
    if (technique->map > PSC_MAP_TABULATED)
        return PSC_ERROR_UNKNOWN_MAP;
    if (technique->flags & ~(uint32_t)PSC_TECHNIQUE_ONE_SIDED)
        return PSC_ERROR_UNKNOWN_FLAG;
    request->measure = technique->measure;
    request->map = technique->map;
    request->table = technique->table;
    request->one_sided = (technique->flags & PSC_TECHNIQUE_ONE_SIDED) != 0;
    return PSC_SUCCESS;
}

/* Without looking at the numbers. */
static inline psc_result psc_read_point(uint32_t flags, const double *position,
                                        const double *normal, struct psc_request *request)
{
    if (flags & ~(uint32_t)PSC_RECEIVER_TWO_SIDED)
        return PSC_ERROR_UNKNOWN_FLAG;
    if (!position)
        return PSC_ERROR_NULL_POINTER;
    request->position = position;
    request->normal = normal;
    request->facing = !normal                          ? PSC_FACING_NONE
                      : flags & PSC_RECEIVER_TWO_SIDED ? PSC_FACING_BOTH
                                                       : PSC_FACING_ONE;
    return PSC_SUCCESS;
}

/* The numbers. */
static inline psc_result psc_check_numbers(const struct psc_request *request)
{
    const double *const normal = request->normal;

    if (!is_finite3(request->position) || (normal && !is_finite3(normal)))
        return PSC_ERROR_NOT_FINITE;
    return normal && largest(normal) == 0.0 ? PSC_ERROR_ZERO_VECTOR : PSC_SUCCESS;
}

static inline psc_result psc_check_point(uint32_t flags, const double *position,
                                         const double *normal, struct psc_request *request)
{
    const psc_result result = psc_read_point(flags, position, normal, request);

    return result == PSC_SUCCESS ? psc_check_numbers(request) : result;
}

static inline psc_result psc_check_receiver(const psc_receiver *receiver,
                                            struct psc_request *request)
{
    const psc_result result = psc_check_struct(receiver, sizeof *receiver);

    return result != PSC_SUCCESS
               ? result
               : psc_check_point(receiver->flags, receiver->position, receiver->normal, request);
}

static inline psc_result psc_check_offer(const struct psc_shape_row *shape,
                                         const struct psc_request *request)
{
    if (!(shape->maps[request->measure] >> request->map & 1))
        return PSC_ERROR_UNSUPPORTED_TECHNIQUE;
    if (request->map == PSC_MAP_TABULATED &&
        (!request->table || request->table->magic != PSC_TABLE_MAGIC))
        return PSC_ERROR_NEEDS_TABLE;
    return request->measure == PSC_MEASURE_PROJECTED_SOLID_ANGLE &&
                   request->facing == PSC_FACING_NONE
               ? PSC_ERROR_NEEDS_NORMAL
               : PSC_SUCCESS;
}

#endif
