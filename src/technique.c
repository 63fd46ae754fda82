/* SPDX-License-Identifier: Apache-2.0 */
/* Reading the caller's descriptions: sizes, enumerators, numbers. */
#include "sampler.h"
#include "vector.h"

/* Copies a description of any version into the one known here. */
static psc_result read_struct(const void *from, size_t first_size, void *to, size_t size)
{
    uint32_t given, i;

    if (!from)
        return PSC_ERROR_NULL_POINTER;
    memcpy(&given, from, sizeof given);
    if (given < first_size || given > 4096)
        return PSC_ERROR_STRUCT_SIZE;
    memset(to, 0, size);
    memcpy(to, from, MIN(given, size));
    for (i = (uint32_t)size; i < given; i++)
        if (((const unsigned char *)from)[i] != 0)
            return PSC_ERROR_UNKNOWN_FIELD;
    return PSC_SUCCESS;
}

psc_result psc_read_allocator(const psc_allocator *from, psc_allocator *to)
{
    psc_result result = read_struct(from, sizeof(psc_allocator), to, sizeof *to);

    if (result != PSC_SUCCESS)
        return result;
    if (to->reserved != 0)
        return PSC_ERROR_UNKNOWN_FIELD;
    return to->allocate && to->release ? PSC_SUCCESS : PSC_ERROR_NULL_POINTER;
}

psc_result psc_read_technique(const psc_technique *technique, struct psc_request *request)
{
    psc_technique t;
    psc_result result = read_struct(technique, sizeof(psc_technique), &t, sizeof t);

    if (result != PSC_SUCCESS)
        return result;
    if (t.measure > PSC_MEASURE_VISIBLE_AREA)
        return PSC_ERROR_UNKNOWN_MEASURE;
    if (t.map > PSC_MAP_CONCENTRIC)
        return PSC_ERROR_UNKNOWN_MAP;
    if (t.flags != 0)
        return PSC_ERROR_UNKNOWN_FLAG;
    request->measure = t.measure;
    request->map = t.map;
    return PSC_SUCCESS;
}

psc_result psc_check_receiver(uint32_t flags, const double *position, const double *normal,
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

psc_result psc_read_receiver(const psc_receiver *receiver, struct psc_request *request)
{
    psc_receiver r;
    psc_result result = read_struct(receiver, sizeof(psc_receiver), &r, sizeof r);

    return result != PSC_SUCCESS ? result
                                 : psc_check_receiver(r.flags, r.position, r.normal, request);
}

/* Of the arrays' descriptions too; their pointers are used where they stand. */
psc_result psc_check_samples(const void *samples, size_t size)
{
    uint32_t head[2];

    if (!samples)
        return PSC_ERROR_NULL_POINTER;
    memcpy(head, samples, sizeof head);
    return head[0] != size ? PSC_ERROR_STRUCT_SIZE
           : head[1] != 0  ? PSC_ERROR_UNKNOWN_FIELD
                           : PSC_SUCCESS;
}
