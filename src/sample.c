/* SPDX-License-Identifier: Apache-2.0 */
/* Sampling, density and inverse of a built sampler: the public calls in both precisions. */
#include "sampler.h"

#define PSC_BITS 64
#include "precision.h"
#include "input_tmpl.h"
#include "sample_tmpl.h"

#undef PSC_BITS
#define PSC_BITS 32
#include "precision.h"
#include "input_tmpl.h"
#include "sample_tmpl.h"
