/* SPDX-License-Identifier: Apache-2.0 */
/* The function table, for programs that load the library at run time. */
#include <string.h>

#include <psc/psc.h>

static const psc_api_1 api = {
    psc_version,
    psc_result_string,
    psc_sampler_size,
    psc_sampler_align,
    psc_sampler_init,
    psc_sampler_create,
    psc_sampler_destroy,
    psc_build_sphere,
    psc_build_cap,
    psc_build_disk,
    psc_build_ellipse,
    psc_build_ellipsoid,
    psc_build_triangle,
    psc_build_rectangle,
    psc_build_polygon,
    psc_sample_f64,
    psc_sample_f32,
    psc_pdf_f64,
    psc_pdf_f32,
    psc_invert_f64,
    psc_invert_f32,
    psc_sample_n_f64,
    psc_sample_n_f32,
    psc_pdf_n_f64,
    psc_pdf_n_f32,
    psc_invert_n_f64,
    psc_invert_n_f32,
    psc_sphere_sample_n_f64,
    psc_sphere_sample_n_f32,
    psc_cap_sample_n_f64,
    psc_cap_sample_n_f32,
    psc_disk_sample_n_f64,
    psc_disk_sample_n_f32,
    psc_ellipse_sample_n_f64,
    psc_ellipse_sample_n_f32,
    psc_ellipsoid_sample_n_f64,
    psc_ellipsoid_sample_n_f32,
    psc_triangle_sample_n_f64,
    psc_triangle_sample_n_f32,
    psc_rectangle_sample_n_f64,
    psc_rectangle_sample_n_f32,
    psc_polygon_sample_n_f64,
    psc_polygon_sample_n_f32,
    psc_sampler_describe,
    psc_sampler_total,
    psc_sampler_solid_angle,
    psc_sampler_projected_solid_angle,
    psc_sampler_form_factor,
    psc_sampler_area,
    psc_sphere_solid_angle,
    psc_sphere_form_factor,
    psc_cap_solid_angle,
    psc_cap_form_factor,
    psc_disk_solid_angle,
    psc_ellipse_solid_angle,
    psc_ellipsoid_solid_angle,
    psc_triangle_solid_angle,
    psc_triangle_form_factor,
    psc_rectangle_solid_angle,
    psc_rectangle_form_factor,
    psc_polygon_solid_angle,
    psc_polygon_form_factor,
    psc_disk_form_factor,
    psc_ellipse_form_factor,
    psc_ellipsoid_form_factor,
    psc_table_size,
    psc_table_init,
};

psc_result psc_get_api(uint32_t version, void *table, size_t size)
{
    if (!table)
        return PSC_ERROR_NULL_POINTER;
    if (size == 0 || size % sizeof(void (*)(void)) != 0)
        return PSC_ERROR_STRUCT_SIZE;
    if (version != 1 || size > sizeof api)
        return PSC_ERROR_UNKNOWN_VERSION;
    memcpy(table, &api, size);
    return PSC_SUCCESS;
}
