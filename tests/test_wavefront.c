/* SPDX-License-Identifier: Apache-2.0 */
/*
 * The wavefront calls give, element for element and to the bit, what a sampler built and sampled
 * for each gives: all cases and errors mixed, in all layouts, with shared inputs, and with
 * outputs that are wanted in part or not at all.
 */
#include <stdlib.h>

#include "lights.h"
#include "tap.h"

#define REAL float
#define FN(name) name##_f32
#define SUFFIX "f32"
#include "wavefront_tmpl.h"
#undef REAL
#undef FN
#undef SUFFIX

#define REAL double
#define FN(name) name##_f64
#define SUFFIX "f64"
#include "wavefront_tmpl.h"

int main(void)
{
    int i, distant;

    for (i = 0; i < TEST_TECHNIQUES; i++)
        for (distant = 0; distant <= test_techniques[i].distant; distant++) {
            wavefronts_f32(&test_techniques[i], distant);
            wavefronts_f64(&test_techniques[i], distant);
        }
    for (distant = 0; distant < 2; distant++) {
        refusals_f32(distant);
        refusals_f64(distant);
    }
    return tap_done();
}
