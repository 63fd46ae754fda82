/* SPDX-License-Identifier: Apache-2.0 */
/* Rectangles: a corner and two edges. */
#include "build.h"
#include "polygon_light.h"
#include "rectangle_build.h"

static const char geometry[] = "vvv"; /* corner, edge_u, edge_v */

const struct psc_shape_row psc_shape_rectangle = {
    PSC_SHAPE_RECTANGLE, PSC_KERNEL_RECTANGLE, {3, 1, 3, 0}, psc_polygon_solid_angle_of,
    psc_polygon_projected_solid_angle, psc_polygon_area, psc_polygon_pdf, psc_polygon_invert};

psc_result psc_build_rectangle(psc_sampler *sampler, const psc_technique *technique,
                               const psc_receiver *receiver, const double corner[3],
                               const double edge_u[3], const double edge_v[3])
{
    const double *const parts[] = {corner, edge_u, edge_v};
    const psc_result quick =
        psc_build_quick(sampler, &psc_shape_rectangle, technique, receiver, parts, 0.0);

    return quick != PSC_PENDING ? quick
                                : psc_build(sampler, &psc_shape_rectangle, geometry, technique,
                                            receiver, parts);
}

psc_result psc_rectangle_sample_n_f64(const psc_technique *technique, size_t count,
                                     const psc_receivers_f64 *receivers,
                                     const psc_input_f64 *corner,
                                     const psc_input_f64 *edge_u,
                                     const psc_input_f64 *edge_v,
                                     const psc_input_f64 *uv, const psc_samples_f64 *out)
{
    const psc_input_f64 *const parts[] = {corner, edge_u, edge_v};

    return psc_wavefront_f64(&psc_shape_rectangle, geometry, technique, count, receivers, parts, uv,
                             out);
}

psc_result psc_rectangle_sample_n_f32(const psc_technique *technique, size_t count,
                                     const psc_receivers_f32 *receivers,
                                     const psc_input_f32 *corner,
                                     const psc_input_f32 *edge_u,
                                     const psc_input_f32 *edge_v,
                                     const psc_input_f32 *uv, const psc_samples_f32 *out)
{
    const psc_input_f32 *const parts[] = {corner, edge_u, edge_v};

    return psc_wavefront_f32(&psc_shape_rectangle, geometry, technique, count, receivers, parts, uv,
                             out);
}

psc_result psc_rectangle_solid_angle(const double position[3], const double corner[3],
                                     const double edge_u[3], const double edge_v[3],
                                     double *solid_angle)
{
    double numbers[9], half;
    psc_result result;

    if (!position || !corner || !edge_u || !edge_v || !solid_angle)
        return PSC_ERROR_NULL_POINTER;
    memcpy(numbers, corner, 3 * sizeof *corner);
    memcpy(numbers + 3, edge_u, 3 * sizeof *edge_u);
    memcpy(numbers + 6, edge_v, 3 * sizeof *edge_v);
    if (!is_finite3(position) || !is_finite3(corner) || !is_finite3(edge_u) ||
        !is_finite3(edge_v))
        return PSC_ERROR_NOT_FINITE;
    result = rectangle_half(position, numbers, &half);
    if (result != PSC_SUCCESS)
        return result;
    *solid_angle = 2.0 * half;
    return *solid_angle > 0.0 ? PSC_SUCCESS : PSC_EMPTY;
}

psc_result psc_rectangle_form_factor(const psc_receiver *receiver, const double corner[3],
                                     const double edge_u[3], const double edge_v[3],
                                     double *form_factor)
{
    const double *const parts[] = {corner, edge_u, edge_v};

    return psc_form_factor(&psc_shape_rectangle, geometry, receiver, parts, form_factor);
}
