/* SPDX-License-Identifier: Apache-2.0 */
/*
 * The kernels of a family of shapes, NAME_kernel.c, are compiled once per precision and
 * instruction set (PSC_REAL_BITS, PSC_ISA). Each object exports one table per shape, written with
 * PSC_KERNEL below, and calls nothing outside itself, so that no code for a newer CPU can be
 * reached from an older one.
 */
#ifndef PSC_SRC_KERNEL_TMPL_H
#define PSC_SRC_KERNEL_TMPL_H

#include "sampler.h"

#define PSC_KERNEL_TABLE_2(name, bits, isa) psc_kernel_##name##_f##bits##_##isa
#define PSC_KERNEL_TABLE_1(name, bits, isa) PSC_KERNEL_TABLE_2(name, bits, isa)
#define PSC_KERNEL_TABLE(name) PSC_KERNEL_TABLE_1(name, PSC_REAL_BITS, PSC_ISA)

/* The wavefronts of this object's precision. */
#if PSC_REAL_BITS == 64
#define psc_wave psc_wave_f64
#else
#define psc_wave psc_wave_f32
#endif

/* sample, sample_n, wave, build, pdf, invert. The last three work in double and serve both
   precisions: they stand in the table of doubles. */
#define PSC_KERNEL(name, ...) PSC_KERNEL_QUICK(name, NULL, __VA_ARGS__)

/* The same with a quick build, which is in the table of doubles, too. */
#if PSC_REAL_BITS == 64
#define PSC_KERNEL_QUICK(name, quick, ...)                     \
    extern const struct psc_kernel_f64 PSC_KERNEL_TABLE(name); \
    const struct psc_kernel_f64 PSC_KERNEL_TABLE(name) = {__VA_ARGS__, quick}
#else
#define PSC_KERNEL_QUICK(name, quick, sample, sample_n, wave, build, pdf, invert) \
    extern const struct psc_kernel_f32 PSC_KERNEL_TABLE(name);                    \
    const struct psc_kernel_f32 PSC_KERNEL_TABLE(name) = {sample, sample_n, wave}
#endif

#endif
