/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Every variant of the kernels, at will: a program that links variants.c together with the
 * library's objects has its choice instead of that of src/dispatch.c, so that all public calls
 * can be run on each of them in turn.
 */
#ifndef PSC_TESTS_VARIANTS_H
#define PSC_TESTS_VARIANTS_H

#include <stddef.h>

struct variant {
    const char *name;
    int (*runs)(void); /* whether this CPU can */
    const struct psc_kernel_f32 *f32;
    const struct psc_kernel_f64 *f64;
};

/* From the plainest to the widest; the library takes the last that runs. */
extern const struct variant variants[];
extern const size_t variant_count;

/* What samplers are bound to from now on. One that was built before keeps its variant. */
void variant_use(const struct variant *variant);

/* The one that the library would take. */
const struct variant *variant_best(void);

#endif
