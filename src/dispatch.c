/* SPDX-License-Identifier: Apache-2.0 */
/* The kernels for this CPU: chosen when a handle is built, so that sampling tests nothing. */
#include <stdatomic.h>

#include "sampler.h"

#define DECLARE_SHAPE(isa, NAME, name)                             \
    extern const struct psc_kernel_f32 psc_kernel_##name##_f32_##isa; \
    extern const struct psc_kernel_f64 psc_kernel_##name##_f64_##isa;
#define ROW_F32(isa, NAME, name) &psc_kernel_##name##_f32_##isa,
#define ROW_F64(isa, NAME, name) &psc_kernel_##name##_f64_##isa,
#define VARIANT(isa) {#isa, runs_##isa, {PSC_SHAPES(ROW_F32, isa)}, {PSC_SHAPES(ROW_F64, isa)}}

/* Exactly the features that meson.build compiles the variants for. */
PSC_SHAPES(DECLARE_SHAPE, base)
static int runs_base(void)
{
    return 1;
}

#if defined(PSC_HAVE_AVX2)
PSC_SHAPES(DECLARE_SHAPE, avx2)
static int runs_avx2(void)
{
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
}
#endif

#if defined(PSC_HAVE_AVX512)
PSC_SHAPES(DECLARE_SHAPE, avx512)
static int runs_avx512(void)
{
    return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
           __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("fma");
}
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

const struct psc_variant *psc_dispatch(void)
{
    static atomic_uint cached; /* 0: not known yet; every thread would find the same */
    unsigned v = atomic_load_explicit(&cached, memory_order_relaxed);

    if (v == 0) {
        for (v = psc_variant_count; !psc_variants[v - 1].runs(); v--)
            ;
        atomic_store_explicit(&cached, v, memory_order_relaxed);
    }
    return psc_variants + (v - 1);
}
