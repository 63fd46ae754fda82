/* SPDX-License-Identifier: Apache-2.0 */
/* Checking the caller's descriptions, where it is seldom or long; see checks.h. */
#include "checks.h"

psc_result psc_check_other_size(const void *from, size_t size)
{
    uint32_t given, i;

    memcpy(&given, from, sizeof given);
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

psc_result psc_check_samples(const void *samples, size_t size)
{
    const psc_result result = psc_check_struct(samples, size);
    uint32_t head[2];

    if (result != PSC_SUCCESS)
        return result;
    memcpy(head, samples, sizeof head);
    return head[1] != 0 ? PSC_ERROR_UNKNOWN_FIELD : PSC_SUCCESS;
}
