/* SPDX-License-Identifier: Apache-2.0 */
/* The kernels of flat lights with straight edges. */
#include "kernel_tmpl.h"
#include "flat_map.h"
#include "polygon_build.h"

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
#include "polygon_kernel_tmpl.h"

PSC_KERNEL(triangle, FN(polygon_sample), FN(polygon_sample_n), NULL, triangle_build, NULL, NULL);
