/* SPDX-License-Identifier: Apache-2.0 */
#include "variants.h"

#include "sampler.h"

#define TABLES(isa)                                            \
    extern const struct psc_kernel_f32 psc_kernels_f32_##isa[]; \
    extern const struct psc_kernel_f64 psc_kernels_f64_##isa[];
#define ROW(isa) {#isa, runs_##isa, psc_kernels_f32_##isa, psc_kernels_f64_##isa},

TABLES(base)
static int runs_base(void) { return 1; }

#if defined(TEST_SCALAR)
TABLES(scalar)
static int runs_scalar(void) { return 1; }
#endif

#if defined(PSC_HAVE_AVX2)
TABLES(avx2)
static int runs_avx2(void) { return __builtin_cpu_supports("avx2"); }
#endif

#if defined(PSC_HAVE_AVX512)
TABLES(avx512)
static int runs_avx512(void)
{
    return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
           __builtin_cpu_supports("avx512vl");
}
#endif

const struct variant variants[] = {
#if defined(TEST_SCALAR)
    ROW(scalar)
#endif
    ROW(base)
#if defined(PSC_HAVE_AVX2)
    ROW(avx2)
#endif
#if defined(PSC_HAVE_AVX512)
    ROW(avx512)
#endif
};
const size_t variant_count = sizeof variants / sizeof *variants;

static const struct variant *used = variants;

void variant_use(const struct variant *variant)
{
    used = variant;
}

const struct variant *variant_best(void)
{
    const struct variant *best = variants;
    size_t i;

    for (i = 1; i < variant_count; i++)
        if (variants[i].runs())
            best = variants + i;
    return best;
}

const struct psc_kernel_f32 *psc_dispatch_f32(enum psc_family family)
{
    return used->f32 + family;
}

const struct psc_kernel_f64 *psc_dispatch_f64(enum psc_family family)
{
    return used->f64 + family;
}
