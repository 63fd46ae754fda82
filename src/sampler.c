/* SPDX-License-Identifier: Apache-2.0 */
/* The life of a handle, the way into every build, and the questions it answers. */
#include <stdlib.h>

#include "build.h"

size_t psc_sampler_size(void)
{
    return sizeof(psc_sampler);
}

size_t psc_sampler_align(void)
{
    return _Alignof(psc_sampler);
}

void psc_clear(psc_sampler *sampler)
{
    /* With no side, the rest is never read. */
    sampler->shape = NULL;
    sampler->measure = 0;
    sampler->map = 0;
    sampler->visibility = PSC_CASE_EMPTY;
    sampler->facing = PSC_FACING_NONE;
    sampler->sides = 0;
    sampler->total = 0.0;
}

psc_result psc_sampler_init(void *memory, size_t size, psc_sampler **out)
{
    psc_sampler *sampler = memory;

    if (!out)
        return PSC_ERROR_NULL_POINTER;
    *out = NULL;
    if (!memory)
        return PSC_ERROR_NULL_POINTER;
    if (size < sizeof(psc_sampler) || (uintptr_t)memory % _Alignof(psc_sampler) != 0)
        return PSC_ERROR_STORAGE;
    memset(sampler, 0, sizeof *sampler);
    sampler->f32 = psc_dispatch()->f32[0];
    sampler->f64 = psc_dispatch()->f64[0];
    *out = sampler;
    return PSC_SUCCESS;
}

static void *default_allocate(void *user, size_t size, size_t align)
{
    (void)user, (void)align; /* within malloc's, by the assertion in sampler.h */
    return malloc(size);
}

static void default_release(void *user, void *memory)
{
    (void)user;
    free(memory);
}

psc_result psc_sampler_create(const psc_allocator *allocator, psc_sampler **out)
{
    psc_allocator use = {sizeof(psc_allocator), 0, NULL, default_allocate, default_release};
    psc_result result;
    void *memory;

    if (!out)
        return PSC_ERROR_NULL_POINTER;
    *out = NULL;
    if (allocator) {
        result = psc_check_allocator(allocator);
        if (result != PSC_SUCCESS)
            return result;
        use = *allocator;
    }
    memory = use.allocate(use.user, sizeof(psc_sampler), _Alignof(psc_sampler));
    if (!memory)
        return PSC_ERROR_OUT_OF_MEMORY;
    result = psc_sampler_init(memory, sizeof(psc_sampler), out);
    if (result == PSC_SUCCESS)
        (*out)->allocator = use;
    else
        use.release(use.user, memory);
    return result;
}

void psc_sampler_destroy(psc_sampler *sampler)
{
    if (sampler && sampler->allocator.release)
        sampler->allocator.release(sampler->allocator.user, sampler);
}

psc_result psc_build_numbers(psc_sampler *sampler, const struct psc_shape_row *shape,
                             const struct psc_request *request, const double *geometry)
{
    return psc_fill(sampler, shape, request, geometry, request->numbers);
}

psc_result psc_build(psc_sampler *sampler, const struct psc_shape_row *shape, const char *kinds,
                     const psc_technique *technique, const psc_receiver *receiver,
                     const double *const parts[])
{
    double geometry[PSC_MAX_GEOMETRY];
    struct psc_request request;
    psc_result result;
    int i, k, n = 0;

    if (!sampler)
        return PSC_ERROR_NULL_POINTER;
    result = psc_check_technique(technique, &request);
    if (result == PSC_SUCCESS)
        result = psc_check_receiver(receiver, &request);
    for (i = 0; kinds[i] && result == PSC_SUCCESS; i++) {
        const int numbers = kinds[i] == 'v' ? 3 : 1;

        if (!parts[i])
            result = PSC_ERROR_NULL_POINTER;
        for (k = 0; parts[i] && k < numbers; k++)
            geometry[n++] = parts[i][k];
    }
    request.numbers = n; /* which tell a polygon its vertices */
    if (result == PSC_SUCCESS)
        result = psc_check_offer(shape, &request);
    if (result == PSC_SUCCESS)
        return psc_fill(sampler, shape, &request, geometry, n);
    psc_clear(sampler);
    return result;
}

psc_result psc_form_factor(const struct psc_shape_row *shape, const char *kinds,
                           const psc_receiver *receiver, const double *const parts[],
                           double *form_factor)
{
    const int radial = shape->maps[PSC_MEASURE_PROJECTED_SOLID_ANGLE] >> PSC_MAP_RADIAL & 1;
    const psc_technique technique = {sizeof technique, PSC_MEASURE_PROJECTED_SOLID_ANGLE,
                                     radial ? PSC_MAP_RADIAL : PSC_MAP_PARALLEL, 0, NULL};
    psc_sampler_storage storage;
    psc_sampler *sampler;
    psc_result result;

    if (!form_factor)
        return PSC_ERROR_NULL_POINTER;
    psc_sampler_init(&storage, sizeof storage, &sampler);
    result = psc_build(sampler, shape, kinds, &technique, receiver, parts);
    if (result >= 0)
        *form_factor = sampler->total * (1.0 / PSC_PI);
    return result;
}

/* ---- Questions ---- */

psc_result psc_sampler_describe(const psc_sampler *sampler, psc_description *description)
{
    psc_description d;

    if (!sampler || !description)
        return PSC_ERROR_NULL_POINTER;
    if (description->struct_size < sizeof d || description->struct_size > 4096)
        return PSC_ERROR_STRUCT_SIZE;
    memset(&d, 0, sizeof d);
    d.struct_size = description->struct_size;
    d.shape = sampler->shape ? sampler->shape->shape : PSC_SHAPE_NONE;
    d.measure = sampler->measure;
    d.map = sampler->map;
    d.visibility = sampler->visibility;
    memset(description, 0, description->struct_size);
    memcpy(description, &d, sizeof d);
    return sampler->sides == 0 ? PSC_EMPTY : PSC_SUCCESS;
}

psc_result psc_sampler_total(const psc_sampler *sampler, double *total)
{
    if (!sampler || !total)
        return PSC_ERROR_NULL_POINTER;
    *total = sampler->total;
    return sampler->sides == 0 ? PSC_EMPTY : PSC_SUCCESS;
}

typedef psc_result (*question)(const psc_sampler *sampler, double *value);

static psc_result ask(const psc_sampler *sampler, size_t which, double *value)
{
    const struct psc_shape_row *row;
    question q;

    if (!sampler || !value)
        return PSC_ERROR_NULL_POINTER;
    row = sampler->shape;
    if (!row) {
        *value = 0.0;
        return PSC_EMPTY;
    }
    q = which == 0 ? row->solid_angle : which == 1 ? row->projected_solid_angle : row->area;
    return q(sampler, value);
}

psc_result psc_sampler_solid_angle(const psc_sampler *sampler, double *solid_angle)
{
    return ask(sampler, 0, solid_angle);
}

psc_result psc_sampler_projected_solid_angle(const psc_sampler *sampler,
                                             double *projected_solid_angle)
{
    return ask(sampler, 1, projected_solid_angle);
}

psc_result psc_sampler_form_factor(const psc_sampler *sampler, double *form_factor)
{
    const psc_result result = ask(sampler, 1, form_factor);

    if (result >= 0)
        *form_factor *= 1.0 / PSC_PI;
    return result;
}

psc_result psc_sampler_area(const psc_sampler *sampler, double *area)
{
    return ask(sampler, 2, area);
}
