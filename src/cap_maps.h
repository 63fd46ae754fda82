/* SPDX-License-Identifier: Apache-2.0 */
/* Every map of a cap, in double. */
#ifndef PSC_SRC_CAP_MAPS_H
#define PSC_SRC_CAP_MAPS_H

#include "lobe.h"
#include "segment.h"

#define PSC_BITS 64
#include "precision.h"
#include "projected_tmpl.h"
#include "cone_map_tmpl.h"
#include "ellipse_map_tmpl.h"
#include "radial_map_tmpl.h"
#include "chord_tmpl.h"
#include "parallel_map_tmpl.h"
#include "clipped_map_tmpl.h"
#include "area_map.h"
#include "lune_map.h"
#include "parallel_map.h"

#endif
