/* SPDX-License-Identifier: Apache-2.0 */
/* Sampling, density and inverse of a built sampler: the public calls in both precisions. */
#include "sampler.h"

/* Blocks of densities and inverses: by the kernel of the family, or one by one. */
static void pdf_block(const psc_sampler *sampler, struct psc_directions *d)
{
    double direction[3];
    size_t i;

    if (sampler->f64->pdf) {
        sampler->f64->pdf(sampler, d);
        return;
    }
    for (i = 0; i < d->count; i++) {
        psc_load_direction(d, i, direction);
        d->pdf[i] = sampler->shape->pdf(sampler, direction, d->epsilon);
    }
}

static void invert_block(const psc_sampler *sampler, struct psc_directions *d)
{
    double direction[3], uv[2];
    size_t i;

    if (sampler->f64->invert) {
        sampler->f64->invert(sampler, d);
        return;
    }
    for (i = 0; i < d->count; i++) {
        psc_load_direction(d, i, direction);
        d->status[i] = sampler->shape->invert(sampler, direction, d->epsilon, uv);
        if (d->status[i] == PSC_SUCCESS) {
            d->uv[0][i] = uv[0];
            d->uv[1][i] = uv[1];
        }
    }
}

#define PSC_BITS 64
#include "precision.h"
#include "input_tmpl.h"
#include "results_tmpl.h"
#include "sample_tmpl.h"

#undef PSC_BITS
#define PSC_BITS 32
#include "precision.h"
#include "input_tmpl.h"
#include "results_tmpl.h"
#include "sample_tmpl.h"
