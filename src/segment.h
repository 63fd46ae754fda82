/* SPDX-License-Identifier: Apache-2.0 */
/* Circular segments in double. */
#ifndef PSC_SRC_SEGMENT_H
#define PSC_SRC_SEGMENT_H

#include "elementary.h"

#define PSC_BITS 64
#include "precision.h"
#include "segment_tmpl.h"

#endif
