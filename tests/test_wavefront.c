/* SPDX-License-Identifier: Apache-2.0 */
/*
 * The wavefront calls give, element for element and to the bit, what a sampler built and sampled
 * for each gives: all cases and errors mixed, in all layouts, with shared inputs, and with
 * outputs that are wanted in part or not at all.
 */
#include <stdlib.h>

#include "shapes.h"
#include "tap.h"
#include "vectors.h"

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
    const struct test_technique *what;
    int i;

    for (i = 0; shapes[i]; i++) {
        for (FOR_TECHNIQUES(shapes[i], what)) {
            wavefronts_f32(shapes[i], what);
            wavefronts_f64(shapes[i], what);
        }
        refusals_f32(shapes[i]);
        refusals_f64(shapes[i]);
    }
    return tap_done();
}
