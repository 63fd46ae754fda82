/* SPDX-License-Identifier: Apache-2.0 */
/* Checking the caller's descriptions: sizes, enumerators, numbers. */
#include "sampler.h"
#include "table.h"
#include "vector.h"

psc_result psc_check_struct(const void *from, size_t size)
{
    uint32_t given, i;

    if (!from)
        return PSC_ERROR_NULL_POINTER;
    memcpy(&given, from, sizeof given);
    if (given == size)
        return PSC_SUCCESS;
    if (given < size || given > 4096)
        return PSC_ERROR_STRUCT_SIZE;
    for (i = (uint32_t)size; i < given; i++)
        if (((const unsigned char *)from)[i] != 0)
            return PSC_ERROR_UNKNOWN_FIELD;
    return PSC_SUCCESS;
}

psc_result psc_check_allocator(const psc_allocator *allocator)
{
    const psc_result result = psc_check_struct(allocator, sizeof *allocator);

    if (result != PSC_SUCCESS)
        return result;
    if (allocator->reserved != 0)
        return PSC_ERROR_UNKNOWN_FIELD;
    return allocator->allocate && allocator->release ? PSC_SUCCESS : PSC_ERROR_NULL_POINTER;
}

psc_result psc_check_technique(const psc_technique *technique, struct psc_request *request)
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

psc_result psc_check_point(uint32_t flags, const double *position, const double *normal,
                           struct psc_request *request)
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
    if (!is_finite3(position) || (normal && !is_finite3(normal)))
        return PSC_ERROR_NOT_FINITE;
    return normal && largest(normal) == 0.0 ? PSC_ERROR_ZERO_VECTOR : PSC_SUCCESS;
}

psc_result psc_check_receiver(const psc_receiver *receiver, struct psc_request *request)
{
    const psc_result result = psc_check_struct(receiver, sizeof *receiver);

    return result != PSC_SUCCESS
               ? result
               : psc_check_point(receiver->flags, receiver->position, receiver->normal, request);
}

psc_result psc_check_offer(const struct psc_shape_row *shape, const struct psc_request *request)
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

psc_result psc_check_samples(const void *samples, size_t size)
{
    const psc_result result = psc_check_struct(samples, size);
    uint32_t head[2];

    if (result != PSC_SUCCESS)
        return result;
    memcpy(head, samples, sizeof head);
    return head[1] != 0 ? PSC_ERROR_UNKNOWN_FIELD : PSC_SUCCESS;
}
