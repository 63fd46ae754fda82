/* SPDX-License-Identifier: Apache-2.0 */
/*
 * The interface, written a second time: what programs were compiled against. Within one soname
 * lines are only added here; one that no longer compiles is a break. Sizes are given in W, the
 * bytes of a pointer, where targets differ. It sees neither soname nor symbol versions: those are
 * in abi/libpsc.symbols.
 */
#include "tap.h"

#include <psc/psc.h>

#define W sizeof(void *)
#define D _Alignof(double)

#define SIZE(T, size, align) _Static_assert(sizeof(T) == (size) && _Alignof(T) == (align), #T)
#define TYPE(T, t) _Static_assert(_Generic((T)0, t : 1, default : 0), #T)
#define CONSTANT(c, value) _Static_assert((c) == (value), #c)
/* The last argument is the type of a pointer to the field. */
#define FIELD(T, f, at, ...) \
    _Static_assert(offsetof(T, f) == (at), #T "." #f); \
    _Static_assert(_Generic(&((T *)0)->f, __VA_ARGS__ : 1, default : 0), #T "." #f)

_Static_assert(PSC_VERSION == (PSC_VERSION_MAJOR << 22 | PSC_VERSION_MINOR << 12
                               | PSC_VERSION_PATCH), "PSC_VERSION");

TYPE(psc_result, int32_t);
CONSTANT(PSC_SUCCESS, 0);
CONSTANT(PSC_EMPTY, 1);
CONSTANT(PSC_CULLED, 2);
CONSTANT(PSC_OUTSIDE, 3);
CONSTANT(PSC_ERROR_NULL_POINTER, -1);
CONSTANT(PSC_ERROR_STRUCT_SIZE, -2);
CONSTANT(PSC_ERROR_UNKNOWN_FIELD, -3);
CONSTANT(PSC_ERROR_STORAGE, -4);
CONSTANT(PSC_ERROR_OUT_OF_MEMORY, -5);
CONSTANT(PSC_ERROR_NOT_FINITE, -6);
CONSTANT(PSC_ERROR_ZERO_VECTOR, -7);
CONSTANT(PSC_ERROR_NEGATIVE_SIZE, -8);
CONSTANT(PSC_ERROR_HALF_ANGLE, -9);
CONSTANT(PSC_ERROR_UNKNOWN_MEASURE, -10);
CONSTANT(PSC_ERROR_UNKNOWN_MAP, -11);
CONSTANT(PSC_ERROR_UNKNOWN_FLAG, -12);
CONSTANT(PSC_ERROR_UNSUPPORTED_TECHNIQUE, -13);
CONSTANT(PSC_ERROR_NEEDS_NORMAL, -14);
CONSTANT(PSC_ERROR_UNKNOWN_VERSION, -15);
CONSTANT(PSC_ERROR_VERTEX_COUNT, -16);
CONSTANT(PSC_ERROR_NOT_PLANAR, -17);
CONSTANT(PSC_ERROR_NOT_CONVEX, -18);
CONSTANT(PSC_ERROR_NOT_RECTANGLE, -19);
CONSTANT(PSC_ERROR_NEEDS_TABLE, -20);
CONSTANT(PSC_ERROR_RESOLUTION, -21);

TYPE(psc_measure, uint32_t);
CONSTANT(PSC_MEASURE_SOLID_ANGLE, 0);
CONSTANT(PSC_MEASURE_PROJECTED_SOLID_ANGLE, 1);
CONSTANT(PSC_MEASURE_AREA, 2);
CONSTANT(PSC_MEASURE_VISIBLE_AREA, 3);

TYPE(psc_map, uint32_t);
CONSTANT(PSC_MAP_RADIAL, 0);
CONSTANT(PSC_MAP_PARALLEL, 1);
CONSTANT(PSC_MAP_CONCENTRIC, 2);
CONSTANT(PSC_MAP_QUASI_UNIFORM, 3);
CONSTANT(PSC_MAP_TABULATED, 4);
CONSTANT(PSC_TECHNIQUE_ONE_SIDED, 1);

TYPE(psc_shape, uint32_t);
CONSTANT(PSC_SHAPE_NONE, 0);
CONSTANT(PSC_SHAPE_SPHERE, 1);
CONSTANT(PSC_SHAPE_CAP, 2);
CONSTANT(PSC_SHAPE_DISK, 3);
CONSTANT(PSC_SHAPE_ELLIPSE, 4);
CONSTANT(PSC_SHAPE_ELLIPSOID, 5);
CONSTANT(PSC_SHAPE_TRIANGLE, 6);
CONSTANT(PSC_SHAPE_RECTANGLE, 7);
CONSTANT(PSC_SHAPE_POLYGON, 8);

TYPE(psc_case, uint32_t);
CONSTANT(PSC_CASE_EMPTY, 0);
CONSTANT(PSC_CASE_ELLIPSE, 1);
CONSTANT(PSC_CASE_ELLIPSE_AND_LUNE, 2);
CONSTANT(PSC_CASE_LUNE, 3);
CONSTANT(PSC_CASE_INSIDE, 4);
CONSTANT(PSC_CASE_NO_HORIZON, 5);
CONSTANT(PSC_CASE_ABOVE, 6);
CONSTANT(PSC_CASE_CLIPPED, 7);

SIZE(psc_technique, 16 + W, W);
FIELD(psc_technique, struct_size, 0, uint32_t *);
FIELD(psc_technique, measure, 4, uint32_t *);
FIELD(psc_technique, map, 8, uint32_t *);
FIELD(psc_technique, flags, 12, uint32_t *);
FIELD(psc_technique, table, 16, const psc_table **);

CONSTANT(PSC_RECEIVER_TWO_SIDED, 1);
SIZE(psc_receiver, 8 + 2 * W, W);
FIELD(psc_receiver, struct_size, 0, uint32_t *);
FIELD(psc_receiver, flags, 4, uint32_t *);
FIELD(psc_receiver, position, 8, const double **);
FIELD(psc_receiver, normal, 8 + W, const double **);

SIZE(psc_sampler_storage, 16384, D > W ? D : W);

SIZE(psc_allocator, 8 + 3 * W, W);
FIELD(psc_allocator, struct_size, 0, uint32_t *);
FIELD(psc_allocator, reserved, 4, uint32_t *);
FIELD(psc_allocator, user, 8, void **);
FIELD(psc_allocator, allocate, 8 + W, void *(**)(void *, size_t, size_t));
FIELD(psc_allocator, release, 8 + 2 * W, void (**)(void *, void *));

SIZE(psc_light_sample_f64, 112, D);
FIELD(psc_light_sample_f64, direction, 0, double (*)[3]);
FIELD(psc_light_sample_f64, pdf, 24, double *);
FIELD(psc_light_sample_f64, point, 32, double (*)[3]);
FIELD(psc_light_sample_f64, distance, 56, double *);
FIELD(psc_light_sample_f64, normal, 64, double (*)[3]);
FIELD(psc_light_sample_f64, weight, 88, double *);
FIELD(psc_light_sample_f64, surface, 96, double (*)[2]);

SIZE(psc_light_sample_f32, 56, 4);
FIELD(psc_light_sample_f32, direction, 0, float (*)[3]);
FIELD(psc_light_sample_f32, pdf, 12, float *);
FIELD(psc_light_sample_f32, point, 16, float (*)[3]);
FIELD(psc_light_sample_f32, distance, 28, float *);
FIELD(psc_light_sample_f32, normal, 32, float (*)[3]);
FIELD(psc_light_sample_f32, weight, 44, float *);
FIELD(psc_light_sample_f32, surface, 48, float (*)[2]);

SIZE(psc_input_f64, 4 * W, W);
FIELD(psc_input_f64, component, 0, const double *(*)[3]);
FIELD(psc_input_f64, stride, 3 * W, ptrdiff_t *);
SIZE(psc_input_f32, 4 * W, W);
FIELD(psc_input_f32, component, 0, const float *(*)[3]);
FIELD(psc_input_f32, stride, 3 * W, ptrdiff_t *);
SIZE(psc_output_f64, 4 * W, W);
FIELD(psc_output_f64, component, 0, double *(*)[3]);
FIELD(psc_output_f64, stride, 3 * W, ptrdiff_t *);
SIZE(psc_output_f32, 4 * W, W);
FIELD(psc_output_f32, component, 0, float *(*)[3]);
FIELD(psc_output_f32, stride, 3 * W, ptrdiff_t *);
SIZE(psc_output_result, 2 * W, W);
FIELD(psc_output_result, data, 0, int32_t **);
FIELD(psc_output_result, stride, W, ptrdiff_t *);

SIZE(psc_samples_f64, 8 + 30 * W, W);
FIELD(psc_samples_f64, struct_size, 0, uint32_t *);
FIELD(psc_samples_f64, reserved, 4, uint32_t *);
FIELD(psc_samples_f64, direction, 8, psc_output_f64 *);
FIELD(psc_samples_f64, pdf, 8 + 4 * W, psc_output_f64 *);
FIELD(psc_samples_f64, point, 8 + 8 * W, psc_output_f64 *);
FIELD(psc_samples_f64, distance, 8 + 12 * W, psc_output_f64 *);
FIELD(psc_samples_f64, normal, 8 + 16 * W, psc_output_f64 *);
FIELD(psc_samples_f64, weight, 8 + 20 * W, psc_output_f64 *);
FIELD(psc_samples_f64, surface, 8 + 24 * W, psc_output_f64 *);
FIELD(psc_samples_f64, status, 8 + 28 * W, psc_output_result *);

SIZE(psc_samples_f32, 8 + 30 * W, W);
FIELD(psc_samples_f32, struct_size, 0, uint32_t *);
FIELD(psc_samples_f32, reserved, 4, uint32_t *);
FIELD(psc_samples_f32, direction, 8, psc_output_f32 *);
FIELD(psc_samples_f32, pdf, 8 + 4 * W, psc_output_f32 *);
FIELD(psc_samples_f32, point, 8 + 8 * W, psc_output_f32 *);
FIELD(psc_samples_f32, distance, 8 + 12 * W, psc_output_f32 *);
FIELD(psc_samples_f32, normal, 8 + 16 * W, psc_output_f32 *);
FIELD(psc_samples_f32, weight, 8 + 20 * W, psc_output_f32 *);
FIELD(psc_samples_f32, surface, 8 + 24 * W, psc_output_f32 *);
FIELD(psc_samples_f32, status, 8 + 28 * W, psc_output_result *);

SIZE(psc_receivers_f64, 8 + 8 * W, W);
FIELD(psc_receivers_f64, struct_size, 0, uint32_t *);
FIELD(psc_receivers_f64, flags, 4, uint32_t *);
FIELD(psc_receivers_f64, position, 8, psc_input_f64 *);
FIELD(psc_receivers_f64, normal, 8 + 4 * W, psc_input_f64 *);
SIZE(psc_receivers_f32, 8 + 8 * W, W);
FIELD(psc_receivers_f32, struct_size, 0, uint32_t *);
FIELD(psc_receivers_f32, flags, 4, uint32_t *);
FIELD(psc_receivers_f32, position, 8, psc_input_f32 *);
FIELD(psc_receivers_f32, normal, 8 + 4 * W, psc_input_f32 *);

SIZE(psc_description, 24, 4);
FIELD(psc_description, struct_size, 0, uint32_t *);
FIELD(psc_description, shape, 4, uint32_t *);
FIELD(psc_description, measure, 8, uint32_t *);
FIELD(psc_description, map, 12, uint32_t *);
FIELD(psc_description, visibility, 16, uint32_t *);
FIELD(psc_description, reserved, 20, uint32_t *);

/* Place in the table, name, type: both of psc_NAME() and of the table's field. */
#define FUNCTIONS(F) \
    F(0, version, uint32_t, (void)) \
    F(1, result_string, const char *, (int32_t)) \
    F(2, sampler_size, size_t, (void)) \
    F(3, sampler_align, size_t, (void)) \
    F(4, sampler_init, int32_t, (void *, size_t, psc_sampler **)) \
    F(5, sampler_create, int32_t, (const psc_allocator *, psc_sampler **)) \
    F(6, sampler_destroy, void, (psc_sampler *)) \
    F(7, build_sphere, int32_t, \
      (psc_sampler *, const psc_technique *, const psc_receiver *, const double *, double)) \
    F(8, build_cap, int32_t, \
      (psc_sampler *, const psc_technique *, const psc_receiver *, const double *, double)) \
    F(9, build_disk, int32_t, \
      (psc_sampler *, const psc_technique *, const psc_receiver *, const double *, \
       const double *, double)) \
    F(10, build_ellipse, int32_t, \
      (psc_sampler *, const psc_technique *, const psc_receiver *, const double *, \
       const double *, const double *)) \
    F(11, build_ellipsoid, int32_t, \
      (psc_sampler *, const psc_technique *, const psc_receiver *, const double *, \
       const double *, const double *, const double *)) \
    F(12, build_triangle, int32_t, \
      (psc_sampler *, const psc_technique *, const psc_receiver *, const double *, \
       const double *, const double *)) \
    F(13, build_rectangle, int32_t, \
      (psc_sampler *, const psc_technique *, const psc_receiver *, const double *, \
       const double *, const double *)) \
    F(14, build_polygon, int32_t, \
      (psc_sampler *, const psc_technique *, const psc_receiver *, size_t, const double *, \
       ptrdiff_t)) \
    F(15, sample_f64, int32_t, (const psc_sampler *, double, double, psc_light_sample_f64 *)) \
    F(16, sample_f32, int32_t, (const psc_sampler *, float, float, psc_light_sample_f32 *)) \
    F(17, pdf_f64, int32_t, (const psc_sampler *, const double *, double *)) \
    F(18, pdf_f32, int32_t, (const psc_sampler *, const float *, float *)) \
    F(19, invert_f64, int32_t, (const psc_sampler *, const double *, double *)) \
    F(20, invert_f32, int32_t, (const psc_sampler *, const float *, float *)) \
    F(21, sample_n_f64, int32_t, \
      (const psc_sampler *, size_t, const psc_input_f64 *, const psc_samples_f64 *)) \
    F(22, sample_n_f32, int32_t, \
      (const psc_sampler *, size_t, const psc_input_f32 *, const psc_samples_f32 *)) \
    F(23, pdf_n_f64, int32_t, \
      (const psc_sampler *, size_t, const psc_input_f64 *, const psc_output_f64 *)) \
    F(24, pdf_n_f32, int32_t, \
      (const psc_sampler *, size_t, const psc_input_f32 *, const psc_output_f32 *)) \
    F(25, invert_n_f64, int32_t, \
      (const psc_sampler *, size_t, const psc_input_f64 *, const psc_output_f64 *, \
       const psc_output_result *)) \
    F(26, invert_n_f32, int32_t, \
      (const psc_sampler *, size_t, const psc_input_f32 *, const psc_output_f32 *, \
       const psc_output_result *)) \
    F(27, sphere_sample_n_f64, int32_t, \
      (const psc_technique *, size_t, const psc_receivers_f64 *, const psc_input_f64 *, \
       const psc_input_f64 *, const psc_input_f64 *, const psc_samples_f64 *)) \
    F(28, sphere_sample_n_f32, int32_t, \
      (const psc_technique *, size_t, const psc_receivers_f32 *, const psc_input_f32 *, \
       const psc_input_f32 *, const psc_input_f32 *, const psc_samples_f32 *)) \
    F(29, cap_sample_n_f64, int32_t, \
      (const psc_technique *, size_t, const psc_receivers_f64 *, const psc_input_f64 *, \
       const psc_input_f64 *, const psc_input_f64 *, const psc_samples_f64 *)) \
    F(30, cap_sample_n_f32, int32_t, \
      (const psc_technique *, size_t, const psc_receivers_f32 *, const psc_input_f32 *, \
       const psc_input_f32 *, const psc_input_f32 *, const psc_samples_f32 *)) \
    F(31, disk_sample_n_f64, int32_t, \
      (const psc_technique *, size_t, const psc_receivers_f64 *, const psc_input_f64 *, \
       const psc_input_f64 *, const psc_input_f64 *, const psc_input_f64 *, \
       const psc_samples_f64 *)) \
    F(32, disk_sample_n_f32, int32_t, \
      (const psc_technique *, size_t, const psc_receivers_f32 *, const psc_input_f32 *, \
       const psc_input_f32 *, const psc_input_f32 *, const psc_input_f32 *, \
       const psc_samples_f32 *)) \
    F(33, ellipse_sample_n_f64, int32_t, \
      (const psc_technique *, size_t, const psc_receivers_f64 *, const psc_input_f64 *, \
       const psc_input_f64 *, const psc_input_f64 *, const psc_input_f64 *, \
       const psc_samples_f64 *)) \
    F(34, ellipse_sample_n_f32, int32_t, \
      (const psc_technique *, size_t, const psc_receivers_f32 *, const psc_input_f32 *, \
       const psc_input_f32 *, const psc_input_f32 *, const psc_input_f32 *, \
       const psc_samples_f32 *)) \
    F(35, ellipsoid_sample_n_f64, int32_t, \
      (const psc_technique *, size_t, const psc_receivers_f64 *, const psc_input_f64 *, \
       const psc_input_f64 *, const psc_input_f64 *, const psc_input_f64 *, \
       const psc_input_f64 *, const psc_samples_f64 *)) \
    F(36, ellipsoid_sample_n_f32, int32_t, \
      (const psc_technique *, size_t, const psc_receivers_f32 *, const psc_input_f32 *, \
       const psc_input_f32 *, const psc_input_f32 *, const psc_input_f32 *, \
       const psc_input_f32 *, const psc_samples_f32 *)) \
    F(37, triangle_sample_n_f64, int32_t, \
      (const psc_technique *, size_t, const psc_receivers_f64 *, const psc_input_f64 *, \
       const psc_input_f64 *, const psc_input_f64 *, const psc_input_f64 *, \
       const psc_samples_f64 *)) \
    F(38, triangle_sample_n_f32, int32_t, \
      (const psc_technique *, size_t, const psc_receivers_f32 *, const psc_input_f32 *, \
       const psc_input_f32 *, const psc_input_f32 *, const psc_input_f32 *, \
       const psc_samples_f32 *)) \
    F(39, rectangle_sample_n_f64, int32_t, \
      (const psc_technique *, size_t, const psc_receivers_f64 *, const psc_input_f64 *, \
       const psc_input_f64 *, const psc_input_f64 *, const psc_input_f64 *, \
       const psc_samples_f64 *)) \
    F(40, rectangle_sample_n_f32, int32_t, \
      (const psc_technique *, size_t, const psc_receivers_f32 *, const psc_input_f32 *, \
       const psc_input_f32 *, const psc_input_f32 *, const psc_input_f32 *, \
       const psc_samples_f32 *)) \
    F(41, polygon_sample_n_f64, int32_t, \
      (const psc_technique *, size_t, const psc_receivers_f64 *, size_t, const psc_input_f64 *, \
       const psc_input_f64 *, \
       const psc_samples_f64 *)) \
    F(42, polygon_sample_n_f32, int32_t, \
      (const psc_technique *, size_t, const psc_receivers_f32 *, size_t, const psc_input_f32 *, \
       const psc_input_f32 *, \
       const psc_samples_f32 *)) \
    F(43, sampler_describe, int32_t, (const psc_sampler *, psc_description *)) \
    F(44, sampler_total, int32_t, (const psc_sampler *, double *)) \
    F(45, sampler_solid_angle, int32_t, (const psc_sampler *, double *)) \
    F(46, sampler_projected_solid_angle, int32_t, (const psc_sampler *, double *)) \
    F(47, sampler_form_factor, int32_t, (const psc_sampler *, double *)) \
    F(48, sampler_area, int32_t, (const psc_sampler *, double *)) \
    F(49, sphere_solid_angle, int32_t, (const double *, const double *, double, double *)) \
    F(50, sphere_form_factor, int32_t, (const psc_receiver *, const double *, double, double *)) \
    F(51, cap_solid_angle, int32_t, (double, double *)) \
    F(52, cap_form_factor, int32_t, (const psc_receiver *, const double *, double, double *)) \
    F(53, disk_solid_angle, int32_t, \
      (const double *, const double *, const double *, double, double *)) \
    F(54, ellipse_solid_angle, int32_t, \
      (const double *, const double *, const double *, const double *, double *)) \
    F(55, ellipsoid_solid_angle, int32_t, \
      (const double *, const double *, const double *, const double *, const double *, double *)) \
    F(56, triangle_solid_angle, int32_t, \
      (const double *, const double *, const double *, const double *, double *)) \
    F(57, triangle_form_factor, int32_t, \
      (const psc_receiver *, const double *, const double *, const double *, double *)) \
    F(58, rectangle_solid_angle, int32_t, \
      (const double *, const double *, const double *, const double *, double *)) \
    F(59, rectangle_form_factor, int32_t, \
      (const psc_receiver *, const double *, const double *, const double *, double *)) \
    F(60, polygon_solid_angle, int32_t, \
      (const double *, size_t, const double *, ptrdiff_t, double *)) \
    F(61, polygon_form_factor, int32_t, \
      (const psc_receiver *, size_t, const double *, ptrdiff_t, double *)) \
    F(62, disk_form_factor, int32_t, \
      (const psc_receiver *, const double *, const double *, double, double *)) \
    F(63, ellipse_form_factor, int32_t, \
      (const psc_receiver *, const double *, const double *, const double *, double *)) \
    F(64, ellipsoid_form_factor, int32_t, \
      (const psc_receiver *, const double *, const double *, const double *, const double *, \
       double *)) \
    F(65, table_size, size_t, (uint32_t)) \
    F(66, table_init, int32_t, (void *, size_t, uint32_t, const psc_table **))

#define FUNCTION(place, name, result, parameters) \
    _Static_assert(_Generic(&psc_##name, result(*) parameters : 1, default : 0), "psc_" #name); \
    FIELD(psc_api_1, name, (place) * W, result(**) parameters);

FUNCTIONS(FUNCTION)
SIZE(psc_api_1, 67 * W, W);
_Static_assert(_Generic(&psc_get_api, int32_t (*)(uint32_t, void *, size_t) : 1, default : 0),
               "psc_get_api");

int main(void)
{
    psc_api_1 api = {0};
    tap_ok(psc_version() == PSC_VERSION, "library and header are of one version");
    tap_ok(psc_get_api(1, &api, sizeof api) == PSC_SUCCESS, "psc_get_api()");
#define POINTER(place, name, result, parameters) \
    tap_ok(api.name == psc_##name, "the table's " #name);
    FUNCTIONS(POINTER)
    return tap_done();
}
