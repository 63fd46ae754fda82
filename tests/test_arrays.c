/* SPDX-License-Identifier: Apache-2.0 */
/*
 * The array calls give, element for element and to the bit, what the calls for one give: for
 * every shape and technique, for counts around the widths of vectors, in all layouts, with outputs that
 * are wanted in part or not at all.
 */
#include <stdlib.h>

#include "shapes.h"
#include "tap.h"

#define REAL float
#define FN(name) name##_f32
#define SUFFIX "f32"
#include "arrays_tmpl.h"
#undef REAL
#undef FN
#undef SUFFIX

#define REAL double
#define FN(name) name##_f64
#define SUFFIX "f64"
#include "arrays_tmpl.h"

int main(void)
{
    const struct test_technique *what;
    int i;

    for (i = 0; shapes[i]; i++)
        for (FOR_TECHNIQUES(shapes[i], what)) {
            arrays_f32(shapes[i], what);
            arrays_f64(shapes[i], what);
        }
    refusals_f32();
    refusals_f64();
    return tap_done();
}
