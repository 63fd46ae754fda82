/* SPDX-License-Identifier: Apache-2.0 */
/* Triangles: a fan of one. */
#include "build.h"
#include "polygon_light.h"
#include "triangle_build.h"

static const char geometry[] = "vvv"; /* v0, v1, v2 */

const struct psc_shape_row psc_shape_triangle = {
    PSC_SHAPE_TRIANGLE, PSC_KERNEL_TRIANGLE, {1, 1, 1, 0}, psc_polygon_solid_angle_of,
    psc_polygon_projected_solid_angle, psc_polygon_area, psc_polygon_pdf, psc_polygon_invert};

psc_result psc_build_triangle(psc_sampler *sampler, const psc_technique *technique,
                              const psc_receiver *receiver, const double v0[3],
                              const double v1[3], const double v2[3])
{
    const double *const parts[] = {v0, v1, v2};
    const psc_result quick =
        psc_build_quick(sampler, &psc_shape_triangle, technique, receiver, parts, 0.0);

    return quick != PSC_PENDING ? quick
                                : psc_build(sampler, &psc_shape_triangle, geometry, technique,
                                            receiver, parts);
}

psc_result psc_triangle_sample_n_f64(const psc_technique *technique, size_t count,
                                     const psc_receivers_f64 *receivers,
                                     const psc_input_f64 *v0,
                                     const psc_input_f64 *v1,
                                     const psc_input_f64 *v2,
                                     const psc_input_f64 *uv, const psc_samples_f64 *out)
{
    const psc_input_f64 *const parts[] = {v0, v1, v2};

    return psc_wavefront_f64(&psc_shape_triangle, geometry, technique, count, receivers, parts, uv,
                             out);
}

psc_result psc_triangle_sample_n_f32(const psc_technique *technique, size_t count,
                                     const psc_receivers_f32 *receivers,
                                     const psc_input_f32 *v0,
                                     const psc_input_f32 *v1,
                                     const psc_input_f32 *v2,
                                     const psc_input_f32 *uv, const psc_samples_f32 *out)
{
    const psc_input_f32 *const parts[] = {v0, v1, v2};

    return psc_wavefront_f32(&psc_shape_triangle, geometry, technique, count, receivers, parts, uv,
                             out);
}

psc_result psc_triangle_solid_angle(const double position[3], const double v0[3],
                                    const double v1[3], const double v2[3], double *solid_angle)
{
    struct psc_triangle_words words;
    struct psc_triangle_view seen;
    struct psc_polygon_view view;
    double vertices[9];

    if (!position || !v0 || !v1 || !v2 || !solid_angle)
        return PSC_ERROR_NULL_POINTER;
    memcpy(vertices, v0, 3 * sizeof *v0);
    memcpy(vertices + 3, v1, 3 * sizeof *v1);
    memcpy(vertices + 6, v2, 3 * sizeof *v2);
    if (!is_finite3(position) || !is_finite3(v0) || !is_finite3(v1) || !is_finite3(v2) ||
        !see_polygon(position, 3, vertices, &view))
        return PSC_ERROR_NOT_FINITE;
    triangle_words(&view, vertices, 0, 1, 2, &words);
    see_triangle(&words, &seen);
    *solid_angle = 2.0 * seen.half;
    return *solid_angle > 0.0 ? PSC_SUCCESS : PSC_EMPTY;
}

psc_result psc_triangle_form_factor(const psc_receiver *receiver, const double v0[3],
                                    const double v1[3], const double v2[3], double *form_factor)
{
    const double *const parts[] = {v0, v1, v2};

    return psc_form_factor(&psc_shape_triangle, geometry, receiver, parts, form_factor);
}
