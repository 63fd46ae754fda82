/* SPDX-License-Identifier: Apache-2.0 */
/* The kernels of lights that are seen as a spherical cap. */
#include "cap_views.h"

#if PSC_REAL_BITS == 64
#include "cap_directions.h"
#include "sphere_quick.h"
#endif

#if PSC_REAL_BITS == 32
#undef PSC_BITS
#define PSC_BITS 32
#include "precision.h"
#include "elementary_tmpl.h"
#include "projected_tmpl.h"
#include "cone_map_tmpl.h"
#include "ellipse_map_tmpl.h"
#include "radial_map_tmpl.h"
#include "chord_tmpl.h"
#include "parallel_map_tmpl.h"
#include "segment_tmpl.h"
#include "clipped_map_tmpl.h"
#endif

#include "results_tmpl.h"
#include "sides_tmpl.h"
#include "cap_kernel_tmpl.h"
#include "cap_wave_tmpl.h"

PSC_KERNEL_QUICK(sphere, sphere_quick, FN(cap_sample), FN(cap_sample_n), FN(sphere_wave),
                 sphere_build, cap_pdfs, cap_inverses);
PSC_KERNEL(cap, FN(cap_sample), FN(cap_sample_n), FN(distant_wave), distant_build, cap_pdfs,
           cap_inverses);
