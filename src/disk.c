/* SPDX-License-Identifier: Apache-2.0 */
/* Circular disks. */
#include "disk_light.h"

static const char geometry[] = "vvs"; /* center, normal, radius */

const struct psc_shape_row psc_shape_disk = {
    PSC_SHAPE_DISK, PSC_KERNEL_DISK, {31, 2, 7, 0}, psc_disk_whole_solid_angle,
    psc_disk_projected_solid_angle, psc_disk_area, psc_disk_pdf, psc_disk_invert};

psc_result psc_build_disk(psc_sampler *sampler, const psc_technique *technique,
                          const psc_receiver *receiver, const double center[3],
                          const double normal[3], double radius)
{
    const double *const parts[] = {center, normal, &radius};
    struct psc_request request;
    double numbers[7];

    if (!center || !normal ||
        !psc_disk_well(sampler, &psc_shape_disk, technique, receiver, &request))
        return psc_build(sampler, &psc_shape_disk, geometry, technique, receiver, parts);
    copy3(center, numbers);
    copy3(normal, numbers + 3);
    numbers[6] = radius;
    request.numbers = 7;
    return psc_fill(sampler, &psc_shape_disk, &request, numbers, 7);
}

psc_result psc_disk_sample_n_f64(const psc_technique *technique, size_t count,
                                 const psc_receivers_f64 *receivers, const psc_input_f64 *center,
                                 const psc_input_f64 *normal, const psc_input_f64 *radius,
                                 const psc_input_f64 *uv, const psc_samples_f64 *out)
{
    const psc_input_f64 *const parts[] = {center, normal, radius};

    return psc_wavefront_f64(&psc_shape_disk, geometry, technique, count, receivers, parts, uv,
                             out);
}

psc_result psc_disk_sample_n_f32(const psc_technique *technique, size_t count,
                                 const psc_receivers_f32 *receivers, const psc_input_f32 *center,
                                 const psc_input_f32 *normal, const psc_input_f32 *radius,
                                 const psc_input_f32 *uv, const psc_samples_f32 *out)
{
    const psc_input_f32 *const parts[] = {center, normal, radius};

    return psc_wavefront_f32(&psc_shape_disk, geometry, technique, count, receivers, parts, uv,
                             out);
}

psc_result psc_disk_solid_angle(const double position[3], const double center[3],
                                const double normal[3], double radius, double *solid_angle)
{
    const double *const parts[] = {center, normal, &radius};

    return psc_disk_ask_solid_angle(&psc_shape_disk, geometry, position, parts, solid_angle);
}

psc_result psc_disk_form_factor(const psc_receiver *receiver, const double center[3],
                                 const double normal[3], double radius, double *form_factor)
{
    const double *const parts[] = {center, normal, &radius};

    return psc_form_factor(&psc_shape_disk, geometry, receiver, parts, form_factor);
}
