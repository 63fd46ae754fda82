/* SPDX-License-Identifier: Apache-2.0 */
/* The series of fibres in double, and which cones have one. */
#ifndef PSC_SRC_FIBRE_SERIES_H
#define PSC_SRC_FIBRE_SERIES_H

#include "ellipse_chord.h"
#include "fibre_density.h"

#include "fibre_series_tmpl.h"

/* Rules of nodes, see ellipse_rules.h, by the largest tangent of a semi-arc that each serves. */
#define PSC_FIBRE_RULES(X) \
    X(0, 4, 0.025)         \
    X(1, 8, 0.22)          \
    X(2, 12, 0.55)         \
    X(3, 16, 0.8)          \
    X(4, 24, PSC_SERIES_TANGENT)
#define PSC_SERIES_TANGENT 1.25

#endif
