/* SPDX-License-Identifier: Apache-2.0 */
/* Convex polygons: a fan about the first vertex. */
#include "build.h"
#include "polygon_build.h"
#include "polygon_light.h"

const struct psc_shape_row psc_shape_polygon = {
    PSC_SHAPE_POLYGON, PSC_KERNEL_POLYGON, {1, 1, 1, 0}, psc_polygon_solid_angle_of,
    psc_polygon_projected_solid_angle, psc_polygon_area, psc_polygon_pdf, psc_polygon_invert};

static int is_vertex_count(size_t count)
{
    return count >= 3 && count <= PSC_MAX_VERTICES;
}

/* A v for each vertex. */
static const char *geometry_of(size_t count)
{
    static const char most[] = "vvvvvvvvvvvvvvvv";

    return most + (PSC_MAX_VERTICES - count);
}

static const double *vertex_at(const double *vertices, ptrdiff_t stride, size_t i)
{
    return (const double *)(const void *)((const char *)vertices + (ptrdiff_t)i * stride);
}

static void vertex_parts(const double *vertices, ptrdiff_t stride, size_t count,
                         const double *parts[PSC_MAX_VERTICES])
{
    size_t i;

    for (i = 0; i < count; i++)
        parts[i] = vertices ? vertex_at(vertices, stride, i) : NULL;
}

/* With what may be wrong looked for in the order of all builds. */
static psc_result build_checked(psc_sampler *sampler, const psc_technique *technique,
                                const psc_receiver *receiver, size_t count, const double *vertices,
                                ptrdiff_t stride)
{
    const double *parts[PSC_MAX_VERTICES];

    if (!sampler)
        return PSC_ERROR_NULL_POINTER;
    if (!is_vertex_count(count)) {
        psc_clear(sampler);
        return PSC_ERROR_VERTEX_COUNT;
    }
    vertex_parts(vertices, stride, count, parts);
    return psc_build(sampler, &psc_shape_polygon, geometry_of(count), technique, receiver, parts);
}

psc_result psc_build_polygon(psc_sampler *sampler, const psc_technique *technique,
                             const psc_receiver *receiver, size_t count, const double *vertices,
                             ptrdiff_t stride)
{
    double numbers[3 * PSC_MAX_VERTICES];
    struct psc_request request;
    size_t i;

    /* Of all that may be wrong, the build itself looks at the numbers. */
    if (!sampler || !vertices || !is_vertex_count(count) ||
        psc_check_technique(technique, &request) != PSC_SUCCESS ||
        psc_check_struct(receiver, sizeof *receiver) != PSC_SUCCESS ||
        psc_read_point(receiver->flags, receiver->position, receiver->normal, &request) !=
            PSC_SUCCESS ||
        psc_check_offer(&psc_shape_polygon, &request) != PSC_SUCCESS)
        return build_checked(sampler, technique, receiver, count, vertices, stride);
    request.numbers = 3 * (int)count;
    if (stride == (ptrdiff_t)(3 * sizeof *vertices))
        return psc_fill_unchecked(sampler, &psc_shape_polygon, &request, vertices);
    for (i = 0; i < count; i++)
        copy3(vertex_at(vertices, stride, i), numbers + 3 * i);
    return psc_fill_unchecked(sampler, &psc_shape_polygon, &request, numbers);
}

psc_result psc_polygon_sample_n_f64(const psc_technique *technique, size_t count,
                                    const psc_receivers_f64 *receivers, size_t vertex_count,
                                    const psc_input_f64 *vertices, const psc_input_f64 *uv,
                                    const psc_samples_f64 *out)
{
    const psc_input_f64 *parts[PSC_MAX_VERTICES] = {NULL};
    size_t i;

    if (!is_vertex_count(vertex_count))
        return PSC_ERROR_VERTEX_COUNT;
    for (i = 0; vertices && i < vertex_count; i++)
        parts[i] = vertices + i;
    return psc_wavefront_f64(&psc_shape_polygon, geometry_of(vertex_count), technique, count,
                             receivers, parts, uv, out);
}

psc_result psc_polygon_sample_n_f32(const psc_technique *technique, size_t count,
                                    const psc_receivers_f32 *receivers, size_t vertex_count,
                                    const psc_input_f32 *vertices, const psc_input_f32 *uv,
                                    const psc_samples_f32 *out)
{
    const psc_input_f32 *parts[PSC_MAX_VERTICES] = {NULL};
    size_t i;

    if (!is_vertex_count(vertex_count))
        return PSC_ERROR_VERTEX_COUNT;
    for (i = 0; vertices && i < vertex_count; i++)
        parts[i] = vertices + i;
    return psc_wavefront_f32(&psc_shape_polygon, geometry_of(vertex_count), technique, count,
                             receivers, parts, uv, out);
}

psc_result psc_polygon_solid_angle(const double position[3], size_t count, const double *vertices,
                                   ptrdiff_t stride, double *solid_angle)
{
    const psc_technique technique = {sizeof technique, PSC_MEASURE_SOLID_ANGLE, PSC_MAP_RADIAL, 0,
                                     NULL};
    const psc_receiver receiver = {sizeof receiver, 0, position, NULL};
    psc_sampler sampler;
    psc_result result;

    if (!position || !vertices || !solid_angle)
        return PSC_ERROR_NULL_POINTER;
    result = psc_build_polygon(&sampler, &technique, &receiver, count, vertices, stride);
    if (result >= 0)
        *solid_angle = sampler.total;
    return result;
}

psc_result psc_polygon_form_factor(const psc_receiver *receiver, size_t count,
                                   const double *vertices, ptrdiff_t stride, double *form_factor)
{
    const double *parts[PSC_MAX_VERTICES];

    if (!is_vertex_count(count))
        return PSC_ERROR_VERTEX_COUNT;
    vertex_parts(vertices, stride, count, parts);
    return psc_form_factor(&psc_shape_polygon, geometry_of(count), receiver, parts, form_factor);
}
