/* SPDX-License-Identifier: Apache-2.0 */
/* How exact the rivals are: the place of their samples in the unit square, by the library's
   inverse in double precision. */
#include "bench.h"

#include <string.h>

#include "../calls.h"

#define BITS 64
#include "../real.h"
#include "vectors_tmpl.h"
#include "paper_tmpl.h"
#include "errors_tmpl.h"

#undef BITS
#define BITS 32
#include "../real.h"
#include "vectors_tmpl.h"
#include "paper_tmpl.h"
#include "errors_tmpl.h"

struct cdf_error cdf_errors[CDF_ERRORS];

void measure_errors(void)
{
    int map, which, bits;
    struct cdf_error *e = cdf_errors;

    for (bits = 64; bits >= 32; bits -= 32)
        for (map = 0; map < 2; map++)
            for (which = 0; which < CASE_CORNELL; which++, e++) {
                e->method = map ? "parallel" : "radial";
                e->which = which;
                e->bits = bits;
                if (bits == 64)
                    measure_f64(e, map);
                else
                    measure_f32(e, map);
            }
}
