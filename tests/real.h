/* SPDX-License-Identifier: Apache-2.0 */
/* Selects the precision, by BITS, of the templates (*_tmpl.h) that are included after it. No
   include guard: they are included twice. */
#include <psc/psc.h>
#include <tgmath.h> /* sin(x) is sinf(x) if x is a float */

#undef real
#undef FN
#if BITS == 64
#define real double
#define FN(name) name##_f64
#else
#define real float
#define FN(name) name##_f32
#endif
#define R(x) ((real)(x))
#define PI 3.14159265358979323846
#undef MIN
#undef MAX
#define MIN(a, b) ((a) < (b) ? (a) : (b)) /* fmin and fmax are calls */
#define MAX(a, b) ((a) > (b) ? (a) : (b))
