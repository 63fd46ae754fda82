/* SPDX-License-Identifier: Apache-2.0 */
#include "variants.h"

/* The library's list and choice, under another name. */
#define psc_dispatch variant_best
#include "dispatch.c"
#undef psc_dispatch

#if defined(TEST_SCALAR)
PSC_SHAPES(DECLARE_SHAPE, scalar)
static int runs_scalar(void)
{
    return 1;
}
static const struct psc_variant scalar = VARIANT(scalar);
static const struct psc_variant *const plainest = &scalar;
#else
static const struct psc_variant *const plainest = NULL;
#endif

static const struct psc_variant *used;

unsigned variant_count(void)
{
    return psc_variant_count + (plainest != NULL);
}

const struct psc_variant *variant_at(unsigned i)
{
    return plainest && i == 0 ? plainest : psc_variants + (i - (plainest != NULL));
}

int variant_runs(unsigned i)
{
    return variant_at(i)->runs();
}

const char *variant_name(const struct psc_variant *variant)
{
    return variant->name;
}

void variant_use(const struct psc_variant *variant)
{
    used = variant;
}

const struct psc_variant *psc_dispatch(void); /* src/sampler.h declares the other name here */
const struct psc_variant *psc_dispatch(void)
{
    return used ? used : variant_at(0);
}
