/* SPDX-License-Identifier: Apache-2.0 */
/* The kernels of flat lights with straight edges. */
#include "fan_plain.h"
#include "flat_map.h"
#include "kernel_tmpl.h"
#include "rectangle_build.h"
#include "triangle_build.h"

#undef PSC_BITS
#define PSC_BITS 64
#include "precision.h"
#include "fan_map_tmpl.h"

#if PSC_REAL_BITS == 32
#undef PSC_BITS
#define PSC_BITS 32
#include "precision.h"
#include "elementary_tmpl.h"
#include "fan_map_tmpl.h"
#endif

#include "results_tmpl.h"
#include "sides_tmpl.h"
#include "sector_map_tmpl.h"
#include "rectangle_kernel_tmpl.h"
#include "polygon_kernel_tmpl.h"
#include "pending_tmpl.h"
#include "triangle_wave_tmpl.h"
#include "rectangle_wave_tmpl.h"
#include "fan_wave_tmpl.h"

#if PSC_REAL_BITS == 64
#include "polygon_quick.h"
#include "rectangle_directions.h"

static psc_result build_triangle(psc_sampler *s, const struct psc_request *request,
                                 const double *geometry)
{
    return triangle_build(s, request, geometry);
}

static psc_result build_rectangle(psc_sampler *s, const struct psc_request *request,
                                  const double *geometry)
{
    return rectangle_build(s, request, geometry);
}

static psc_result build_polygon(psc_sampler *s, const struct psc_request *request,
                                const double *geometry)
{
    return polygon_build(s, request, geometry);
}
#endif

PSC_KERNEL_QUICK(triangle, triangle_quick, FN(triangle_sample), FN(polygon_sample_n),
                 FN(triangle_wave), build_triangle, NULL, NULL);
PSC_KERNEL_QUICK(rectangle, rectangle_quick, FN(any_rectangle_sample), FN(polygon_sample_n),
                 FN(rectangle_wave), build_rectangle, rectangle_pdfs, rectangle_inverses);
PSC_KERNEL(polygon, FN(polygon_sample), FN(polygon_sample_n), FN(polygon_wave), build_polygon, NULL,
           NULL);
