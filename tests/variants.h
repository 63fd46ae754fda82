/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Every variant of the kernels, at will: a program that links variants.c together with the
 * library's objects has its choice instead of that of src/dispatch.c, so that all public calls
 * can be run on each of them in turn.
 */
#ifndef PSC_TESTS_VARIANTS_H
#define PSC_TESTS_VARIANTS_H

struct psc_variant;

/* From the plainest to the widest: those of the library, and before them, in programs compiled
   with TEST_SCALAR, one without vector instructions. */
unsigned variant_count(void);
const struct psc_variant *variant_at(unsigned i);
const char *variant_name(const struct psc_variant *variant);

/* Whether this CPU runs it. */
int variant_runs(unsigned i);

/* What samplers are bound to from now on. One that was built before keeps its variant. */
void variant_use(const struct psc_variant *variant);

/* The one that the library takes. */
const struct psc_variant *variant_best(void);

#endif
