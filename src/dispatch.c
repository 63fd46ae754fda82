/* SPDX-License-Identifier: Apache-2.0 */
/* The kernels for this CPU: chosen when a handle is built, so that sampling tests nothing. */
#include <stdatomic.h>

#include "sampler.h"

#define DECLARE(isa)                                          \
    extern const struct psc_kernel_f32 psc_kernels_f32_##isa[]; \
    extern const struct psc_kernel_f64 psc_kernels_f64_##isa[];
#define VARIANT(isa) {#isa, psc_kernels_f32_##isa, psc_kernels_f64_##isa}

DECLARE(base)
#if defined(PSC_HAVE_AVX2)
DECLARE(avx2)
#endif
#if defined(PSC_HAVE_AVX512)
DECLARE(avx512)
#endif

const struct psc_variant psc_variants[] = {
    VARIANT(base),
#if defined(PSC_HAVE_AVX2)
    VARIANT(avx2),
#endif
#if defined(PSC_HAVE_AVX512)
    VARIANT(avx512),
#endif
};
const unsigned psc_variant_count = sizeof psc_variants / sizeof *psc_variants;

/* Exactly the features that meson.build compiles the variant for. */
int psc_variant_runs(unsigned variant)
{
#if defined(PSC_HAVE_AVX2)
    if (psc_variants[variant].f64 == psc_kernels_f64_avx2)
        return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
#endif
#if defined(PSC_HAVE_AVX512)
    if (psc_variants[variant].f64 == psc_kernels_f64_avx512)
        return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
               __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("fma");
#endif
    return variant == 0;
}

const struct psc_variant *psc_dispatch(void)
{
    static atomic_uint cached; /* 0: not known yet; every thread would find the same */
    unsigned v = atomic_load_explicit(&cached, memory_order_relaxed);

    if (v == 0) {
        for (v = psc_variant_count; !psc_variant_runs(v - 1); v--)
            ;
        atomic_store_explicit(&cached, v, memory_order_relaxed);
    }
    return psc_variants + (v - 1);
}
