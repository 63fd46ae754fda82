/* SPDX-License-Identifier: Apache-2.0 */
/* The kernels of lights that are seen as an elliptic cone. */
#include "disk_build.h"
#include "disk_solve.h"
#include "fibre_solve.h"
#include "kernel_tmpl.h"

#if PSC_REAL_BITS == 32
#undef PSC_BITS
#define PSC_BITS 32
#include "precision.h"
#include "elementary_tmpl.h"
#include "chord_tmpl.h"
#include "disk_constants_tmpl.h"
#include "disk_map_tmpl.h"
#include "span_map_tmpl.h"
#include "fibre_map_tmpl.h"
#include "fibre_series_tmpl.h"
#else
#include "span_map_tmpl.h"
#endif

#include "results_tmpl.h"
#include "sides_tmpl.h"
#include "disk_kernel_tmpl.h"
#include "disk_block_tmpl.h"
#include "fibre_round_tmpl.h"
#include "fibre_kernel_tmpl.h"
#include "fibre_block_tmpl.h"
#include "fibre_lanes_tmpl.h"
#include "disk_views_tmpl.h"
#include "disk_lanes_tmpl.h"
#include "fibre_wave_tmpl.h"
#include "disk_wave_results_tmpl.h"
#include "disk_wave_tmpl.h"

PSC_KERNEL(disk, FN(cone_sample), FN(cone_sample_n), FN(disk_wave), disk_build, NULL, NULL);
PSC_KERNEL(ellipse, FN(cone_sample), FN(cone_sample_n), FN(elliptical_wave), elliptical_build, NULL,
           NULL);
PSC_KERNEL(ellipsoid, FN(cone_sample), FN(cone_sample_n), FN(ellipsoid_wave), ellipsoid_build, NULL,
           NULL);
