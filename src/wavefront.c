/* SPDX-License-Identifier: Apache-2.0 */
/* One build and one sample per element, in both precisions. */
#include "checks.h"

static inline int is_sampled(psc_result status)
{
    return (status == PSC_SUCCESS) | (status == PSC_CULLED);
}

#define PSC_BITS 64
#include "precision.h"
#include "input_tmpl.h"
#include "results_tmpl.h"
#include "wavefront_tmpl.h"

#undef PSC_BITS
#define PSC_BITS 32
#include "precision.h"
#include "input_tmpl.h"
#include "results_tmpl.h"
#include "wavefront_tmpl.h"
