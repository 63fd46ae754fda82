/* SPDX-License-Identifier: Apache-2.0 */
/* What the code asks of the compiler beyond C11. */
#ifndef PSC_SRC_COMPILER_H
#define PSC_SRC_COMPILER_H

#include <float.h>

#if defined(__FAST_MATH__)
#error "libpsc promises the same bits everywhere: build it without -ffast-math"
#endif
#if defined(FLT_EVAL_METHOD) && FLT_EVAL_METHOD != 0
#error "libpsc needs arithmetic in the precision of its operands (on i686: -msse2 -mfpmath=sse)"
#endif

/* A lane function: straight-line arithmetic for one sample, which loops inline and vectorise. */
#if defined(__GNUC__)
#define PSC_LANE static inline __attribute__((always_inline))
#else
#define PSC_LANE static inline
#endif

/* A function whose loop is to stay apart from the loop around its call: gcc 12 tries to make that
   one vector code, too, and goes on with shorter vectors. Not all that include it need call it. */
#if defined(__GNUC__)
#define PSC_APART static __attribute__((noinline, unused))
#else
#define PSC_APART static
#endif

/* Before a short loop of constant length inside a loop that is to vectorise. */
#if defined(__clang__)
#define PSC_UNROLL _Pragma("unroll")
#elif defined(__GNUC__)
#define PSC_UNROLL _Pragma("GCC unroll 24")
#else
#define PSC_UNROLL
#endif

/* Before a short loop of constant length that is to become vector code itself, not many scalar
   statements. */
#if defined(__clang__)
#define PSC_KEEP_LOOP
#elif defined(__GNUC__)
#define PSC_KEEP_LOOP _Pragma("GCC unroll 1")
#else
#define PSC_KEEP_LOOP
#endif

#endif
