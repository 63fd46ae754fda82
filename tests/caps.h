/* SPDX-License-Identifier: Apache-2.0 */
/* Random caps where it is hard: half-angles evenly in the logarithm from 1e-8 to a right angle,
   elevations close to and exactly on every boundary between the cases. */
#ifndef PSC_TESTS_CAPS_H
#define PSC_TESTS_CAPS_H

#include "random.h"

#define RIGHT_ANGLE 0x1.921fb54442d18p+0

/* Distance to a boundary, relative to the half-angle; sometimes 0. */
static inline double random_margin(uint64_t *state)
{
    return random_below(state, 16) == 0 ? 0.0 : random_log(state, 1e-12, 1.0);
}

static inline void random_cap(uint64_t *state, double *alpha, double *beta)
{
    double a = random_below(state, 20) == 0 ? RIGHT_ANGLE : random_log(state, 1e-8, RIGHT_ANGLE);
    double margin = random_margin(state), b;

    switch (random_below(state, 7)) {
    case 0: b = a * (1.0 + margin); break;
    case 1: b = a * (1.0 - margin); break;
    case 2: b = a * margin; break;
    case 3: b = -a * margin; break;
    case 4: b = -a * (1.0 - margin); break;
    case 5: b = random_between(state, -a, RIGHT_ANGLE); break;
    default: b = RIGHT_ANGLE - random_margin(state) * RIGHT_ANGLE; break;
    }
    *alpha = a;
    *beta = fmin(b, RIGHT_ANGLE);
}

#endif
