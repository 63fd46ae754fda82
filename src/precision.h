/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Selects the precision of the templates (*_tmpl.h) that are included after it:
 *
 *     #define PSC_BITS 32
 *     #include "precision.h"
 *     #include "elementary_tmpl.h"
 *
 * real is the type, FN(name) the name with its suffix, KERNEL the suffix, K(x) a constant. No include guard: a
 * translation unit may work in both precisions.
 */
#include "compiler.h"

#undef real
#undef FN
#undef K
#undef SQRT
#undef ABS
#undef COPYSIGN
#undef SMALLEST
#undef KERNEL

#if PSC_BITS == 64
#define real double
#define FN(name) name##_f64
#define KERNEL f64
#define K(x) x
#define SQRT(x) __builtin_sqrt(x)
#define ABS(x) __builtin_fabs(x)
#define COPYSIGN(x, s) __builtin_copysign(x, s)
#define SMALLEST DBL_MIN
#else
#define real float
#define FN(name) name##_f32
#define KERNEL f32
#define K(x) x##f
#define SQRT(x) __builtin_sqrtf(x)
#define ABS(x) __builtin_fabsf(x)
#define COPYSIGN(x, s) __builtin_copysignf(x, s)
#define SMALLEST FLT_MIN
#endif

/* Comparisons, not fmin and fmax: those are calls, and treat NaN in a way that costs. */
#undef MIN
#undef MAX
#define MIN(a, b) ((a) < (b) ? (a) : (b))
#define MAX(a, b) ((a) > (b) ? (a) : (b))
