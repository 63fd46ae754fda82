/* SPDX-License-Identifier: Apache-2.0 */
/* The kernels for this CPU: chosen when a handle is built, so that sampling tests nothing. */
#include <stdatomic.h>

#include "sampler.h"

/* Every variant that was compiled; tests reach them all by these names. */
extern const struct psc_kernel_f32 psc_kernels_f32_base[];
extern const struct psc_kernel_f64 psc_kernels_f64_base[];
#if defined(PSC_HAVE_AVX2)
extern const struct psc_kernel_f32 psc_kernels_f32_avx2[];
extern const struct psc_kernel_f64 psc_kernels_f64_avx2[];
#endif
#if defined(PSC_HAVE_AVX512)
extern const struct psc_kernel_f32 psc_kernels_f32_avx512[];
extern const struct psc_kernel_f64 psc_kernels_f64_avx512[];
#endif

static const struct {
    const struct psc_kernel_f32 *f32;
    const struct psc_kernel_f64 *f64;
} variants[] = {
    {psc_kernels_f32_base, psc_kernels_f64_base},
#if defined(PSC_HAVE_AVX2)
    {psc_kernels_f32_avx2, psc_kernels_f64_avx2},
#endif
#if defined(PSC_HAVE_AVX512)
    {psc_kernels_f32_avx512, psc_kernels_f64_avx512},
#endif
};

/* The best of them that the CPU and the operating system run. */
static unsigned best_variant(void)
{
    unsigned best = 0;

#if defined(PSC_HAVE_AVX2)
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
        best = 1;
#endif
#if defined(PSC_HAVE_AVX512)
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
        __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("fma"))
        best = sizeof variants / sizeof *variants - 1;
#endif
    return best;
}

static unsigned variant(void)
{
    static atomic_uint cached; /* 0: not known yet; every thread would find the same */
    unsigned v = atomic_load_explicit(&cached, memory_order_relaxed);

    if (v == 0) {
        v = best_variant() + 1;
        atomic_store_explicit(&cached, v, memory_order_relaxed);
    }
    return v - 1;
}

const struct psc_kernel_f32 *psc_dispatch_f32(enum psc_kernel_index shape)
{
    return variants[variant()].f32 + shape;
}

const struct psc_kernel_f64 *psc_dispatch_f64(enum psc_kernel_index shape)
{
    return variants[variant()].f64 + shape;
}
