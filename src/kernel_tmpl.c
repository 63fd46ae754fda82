/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Compiled once per precision and instruction set (PSC_REAL_BITS, PSC_ISA): the vector loops of
 * every family of lights. Exports one table and calls nothing outside itself, so that no code
 * for a newer CPU can be reached from an older one.
 */
#include "cap_views.h"

#if PSC_REAL_BITS == 32
#undef PSC_BITS
#define PSC_BITS 32
#include "precision.h"
#include "elementary_tmpl.h"
#include "projected_tmpl.h"
#include "cone_map_tmpl.h"
#include "ellipse_map_tmpl.h"
#include "radial_map_tmpl.h"
#include "parallel_map_tmpl.h"
#endif

#include "results_tmpl.h"
#include "cap_kernel_tmpl.h"
#include "cap_wave_tmpl.h"

#define TABLE_2(bits, isa) psc_kernels_f##bits##_##isa
#define TABLE_1(bits, isa) TABLE_2(bits, isa)
#define TABLE TABLE_1(PSC_REAL_BITS, PSC_ISA)

#if PSC_REAL_BITS == 64
#define ROW(name, build) {FN(cap_sample), FN(cap_sample_n), FN(name##_wave), build}
#else
#define ROW(name, build) {FN(cap_sample), FN(cap_sample_n), FN(name##_wave)}
#endif

/* A shape is one row. */
extern const struct FN(psc_kernel) TABLE[];
const struct FN(psc_kernel) TABLE[PSC_KERNEL_COUNT] = {
    [PSC_KERNEL_SPHERE] = ROW(sphere, sphere_build),
    [PSC_KERNEL_CAP] = ROW(distant, distant_build),
};
