/* SPDX-License-Identifier: Apache-2.0 */
/* Ellipsoids. */
#include "disk_light.h"

static const char geometry[] = "vvvv"; /* center, three conjugate semi-axes */

const struct psc_shape_row psc_shape_ellipsoid = {
    PSC_SHAPE_ELLIPSOID, PSC_KERNEL_ELLIPSOID, {31, 2, 0, 0}, psc_disk_whole_solid_angle,
    psc_disk_projected_solid_angle, psc_disk_area, psc_disk_pdf, psc_disk_invert};

psc_result psc_build_ellipsoid(psc_sampler *sampler, const psc_technique *technique,
                          const psc_receiver *receiver, const double center[3],
                          const double axis_u[3], const double axis_v[3], const double axis_w[3])
{
    const double *const parts[] = {center, axis_u, axis_v, axis_w};
    struct psc_request request;
    double numbers[12];

    if (!center || !axis_u || !axis_v || !axis_w ||
        !psc_disk_well(sampler, &psc_shape_ellipsoid, technique, receiver, &request))
        return psc_build(sampler, &psc_shape_ellipsoid, geometry, technique, receiver, parts);
    copy3(center, numbers);
    copy3(axis_u, numbers + 3);
    copy3(axis_v, numbers + 6);
    copy3(axis_w, numbers + 9);
    request.numbers = 12;
    return psc_fill(sampler, &psc_shape_ellipsoid, &request, numbers, 12);
}

psc_result psc_ellipsoid_sample_n_f64(const psc_technique *technique, size_t count,
                                      const psc_receivers_f64 *receivers,
                                      const psc_input_f64 *center, const psc_input_f64 *axis_u,
                                      const psc_input_f64 *axis_v, const psc_input_f64 *axis_w,
                                      const psc_input_f64 *uv, const psc_samples_f64 *out)
{
    const psc_input_f64 *const parts[] = {center, axis_u, axis_v, axis_w};

    return psc_wavefront_f64(&psc_shape_ellipsoid, geometry, technique, count, receivers, parts, uv,
                             out);
}

psc_result psc_ellipsoid_sample_n_f32(const psc_technique *technique, size_t count,
                                      const psc_receivers_f32 *receivers,
                                      const psc_input_f32 *center, const psc_input_f32 *axis_u,
                                      const psc_input_f32 *axis_v, const psc_input_f32 *axis_w,
                                      const psc_input_f32 *uv, const psc_samples_f32 *out)
{
    const psc_input_f32 *const parts[] = {center, axis_u, axis_v, axis_w};

    return psc_wavefront_f32(&psc_shape_ellipsoid, geometry, technique, count, receivers, parts, uv,
                             out);
}

psc_result psc_ellipsoid_solid_angle(const double position[3], const double center[3],
                                     const double axis_u[3], const double axis_v[3],
                                     const double axis_w[3], double *solid_angle)
{
    const double *const parts[] = {center, axis_u, axis_v, axis_w};

    return psc_disk_ask_solid_angle(&psc_shape_ellipsoid, geometry, position, parts, solid_angle);
}

psc_result psc_ellipsoid_form_factor(const psc_receiver *receiver, const double center[3],
                                      const double axis_u[3], const double axis_v[3],
                                      const double axis_w[3], double *form_factor)
{
    const double *const parts[] = {center, axis_u, axis_v, axis_w};

    return psc_form_factor(&psc_shape_ellipsoid, geometry, receiver, parts, form_factor);
}
