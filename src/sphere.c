/* SPDX-License-Identifier: Apache-2.0 */
/* Spheres: a cap of directions with sin alpha = radius / distance, and a surface to hit. */
#include "build.h"
#include "cap_light.h"
#include "cap_view.h"

static psc_result area(const psc_sampler *s, double *value)
{
    *value = 4.0 * PSC_PI * (s->cap.radius * s->cap.radius);
    return *value > 0.0 ? PSC_SUCCESS : PSC_EMPTY;
}

static const char geometry[] = "vs"; /* center, radius */

const struct psc_shape_row psc_shape_sphere = {
    PSC_SHAPE_SPHERE, PSC_KERNEL_SPHERE, {5, 7, 5, 5}, psc_cap_whole_solid_angle,
    psc_cap_projected_solid_angle, area, psc_cap_pdf, psc_cap_invert};

psc_result psc_build_sphere(psc_sampler *sampler, const psc_technique *technique,
                            const psc_receiver *receiver, const double center[3], double radius)
{
    const psc_result quick =
        psc_build_quick(sampler, &psc_shape_sphere, technique, receiver, &center, radius);

    if (quick != PSC_PENDING)
        return quick;
    return psc_build_vector_scalar(sampler, &psc_shape_sphere, technique, receiver, center, radius);
}

psc_result psc_sphere_sample_n_f64(const psc_technique *technique, size_t count,
                                   const psc_receivers_f64 *receivers,
                                   const psc_input_f64 *center, const psc_input_f64 *radius,
                                   const psc_input_f64 *uv, const psc_samples_f64 *out)
{
    const psc_input_f64 *const parts[] = {center, radius};

    return psc_wavefront_f64(&psc_shape_sphere, geometry, technique, count, receivers, parts, uv, out);
}

psc_result psc_sphere_sample_n_f32(const psc_technique *technique, size_t count,
                                   const psc_receivers_f32 *receivers,
                                   const psc_input_f32 *center, const psc_input_f32 *radius,
                                   const psc_input_f32 *uv, const psc_samples_f32 *out)
{
    const psc_input_f32 *const parts[] = {center, radius};

    return psc_wavefront_f32(&psc_shape_sphere, geometry, technique, count, receivers, parts, uv, out);
}

psc_result psc_sphere_solid_angle(const double position[3], const double center[3],
                                  double radius, double *solid_angle)
{
    struct psc_cap_view o;

    if (!position || !center || !solid_angle)
        return PSC_ERROR_NULL_POINTER;
    if (!is_finite3(position) || !is_finite3(center) || !is_finite(radius))
        return PSC_ERROR_NOT_FINITE;
    if (radius < 0.0)
        return PSC_ERROR_NEGATIVE_SIZE;
    *solid_angle = 0.0;
    if (radius == 0.0)
        return PSC_EMPTY;
    see_sphere(position, NULL, center, radius, &o);
    if (!is_finite(o.distance))
        return PSC_ERROR_NOT_FINITE;
    *solid_angle = 2.0 * PSC_PI * o.h0;
    return PSC_SUCCESS;
}

psc_result psc_sphere_form_factor(const psc_receiver *receiver, const double center[3],
                                  double radius, double *form_factor)
{
    struct psc_request request;
    struct psc_cap_view o;
    psc_result result;
    int both;

    if (!form_factor || !center)
        return PSC_ERROR_NULL_POINTER;
    result = psc_check_receiver(receiver, &request);
    if (result != PSC_SUCCESS)
        return result;
    if (!request.normal)
        return PSC_ERROR_NEEDS_NORMAL;
    if (!is_finite3(center) || !is_finite(radius))
        return PSC_ERROR_NOT_FINITE;
    if (radius < 0.0)
        return PSC_ERROR_NEGATIVE_SIZE;
    *form_factor = 0.0;
    if (radius == 0.0)
        return PSC_EMPTY;
    see_sphere(request.position, request.normal, center, radius, &o);
    if (!is_finite(o.distance))
        return PSC_ERROR_NOT_FINITE;
    both = request.facing == PSC_FACING_BOTH;
    *form_factor = o.power < 0.0 ? 1.0 + both : psc_cap_projected(&o.cap, both) * (1.0 / PSC_PI);
    return *form_factor > 0.0 ? PSC_SUCCESS : PSC_EMPTY;
}
