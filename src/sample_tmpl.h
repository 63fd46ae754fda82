/* SPDX-License-Identifier: Apache-2.0 */
/* Template: see precision.h. Densities and inverses work in double behind both precisions. */

#undef DIRECTION_EPSILON
#if PSC_BITS == 64
#define DIRECTION_EPSILON (0.5 * DBL_EPSILON)
#else
#define DIRECTION_EPSILON (0.5 * FLT_EPSILON)
#endif

psc_result FN(psc_sample)(const psc_sampler *sampler, real u, real v, FN(psc_light_sample) *sample)
{
    return sampler->KERNEL->sample(sampler, u, v, sample);
}

psc_result FN(psc_pdf)(const psc_sampler *sampler, const real direction[3], real *pdf)
{
    const double d[3] = {(double)direction[0], (double)direction[1], (double)direction[2]};

    *pdf = K(0.0);
    if (sampler->sides == 0)
        return PSC_EMPTY;
    *pdf = (real)sampler->shape->pdf(sampler, d, DIRECTION_EPSILON);
    return PSC_SUCCESS;
}

psc_result FN(psc_invert)(const psc_sampler *sampler, const real direction[3], real uv[2])
{
    const double d[3] = {(double)direction[0], (double)direction[1], (double)direction[2]};
    double wide[2];
    psc_result result;

    if (sampler->sides == 0)
        return PSC_EMPTY;
    result = sampler->shape->invert(sampler, d, DIRECTION_EPSILON, wide);
    if (result == PSC_SUCCESS) {
        uv[0] = (real)wide[0];
        uv[1] = (real)wide[1];
    }
    return result;
}

psc_result FN(psc_sample_n)(const psc_sampler *sampler, size_t count, const FN(psc_input) *uv,
                            const FN(psc_samples) *out)
{
    const psc_result result = psc_check_samples(out, sizeof *out);

    if (!sampler || !FN(complete)(uv, 2))
        return PSC_ERROR_NULL_POINTER;
    if (result != PSC_SUCCESS)
        return result;
    if (sampler->sides == 0) {
        psc_fill_status(&out->status, count, PSC_EMPTY);
        return PSC_EMPTY;
    }
    sampler->KERNEL->sample_n(sampler, count, uv, out);
    return PSC_SUCCESS;
}

/* n elements of a component, widened. */
static void FN(widen)(const FN(psc_input) *input, int component, size_t first, size_t n,
                      double *to)
{
    size_t i;

    if (input->stride == (ptrdiff_t)sizeof(real)) {
        const real *from = input->component[component] + first;

        for (i = 0; i < n; i++)
            to[i] = (double)from[i];
    } else {
        for (i = 0; i < n; i++)
            to[i] = (double)FN(element)(input, component, first + i);
    }
}

/* The block of directions from first on. */
static void FN(load_directions)(const FN(psc_input) *input, size_t first, size_t n,
                                struct psc_directions *d)
{
    int c;

    d->count = n;
    d->epsilon = DIRECTION_EPSILON;
    for (c = 0; c < 3; c++)
        FN(widen)(input, c, first, n, d->direction[c]);
}

/* A component of a block's results, of the elements of the index or all; see scatter(). */
static void FN(store_component)(const double *from, const FN(psc_output) *to, int component,
                                size_t first, const uint32_t *index, size_t n)
{
    real values[PSC_BLOCK];
    size_t i;

    if (!to->component[component])
        return;
    for (i = 0; i < n; i++)
        values[i] = (real)from[index ? index[i] : i];
    FN(scatter)(values, NULL, to->component[component], to->stride, first, index, n);
}

psc_result FN(psc_pdf_n)(const psc_sampler *sampler, size_t count,
                         const FN(psc_input) *direction, const FN(psc_output) *pdf)
{
    struct psc_directions d;
    size_t first, n;

    if (!sampler || !FN(complete)(direction, 3) || !pdf || !pdf->component[0])
        return PSC_ERROR_NULL_POINTER;
    if (sampler->sides == 0)
        memset(d.pdf, 0, sizeof d.pdf);
    for (first = 0; first < count; first += n) {
        n = MIN(count - first, PSC_BLOCK);
        if (sampler->sides > 0) {
            FN(load_directions)(direction, first, n, &d);
            pdf_block(sampler, &d);
        }
        FN(store_component)(d.pdf, pdf, 0, first, NULL, n);
    }
    return sampler->sides == 0 ? PSC_EMPTY : PSC_SUCCESS;
}

psc_result FN(psc_invert_n)(const psc_sampler *sampler, size_t count,
                            const FN(psc_input) *direction, const FN(psc_output) *uv,
                            const psc_output_result *status)
{
    struct psc_directions d;
    uint32_t index[PSC_BLOCK];
    size_t first, n, i, good;
    int c;

    if (!sampler || !FN(complete)(direction, 3) || !uv)
        return PSC_ERROR_NULL_POINTER;
    if (sampler->sides == 0) {
        if (status)
            psc_fill_status(status, count, PSC_EMPTY);
        return PSC_EMPTY;
    }
    for (first = 0; first < count; first += n) {
        n = MIN(count - first, PSC_BLOCK);
        FN(load_directions)(direction, first, n, &d);
        invert_block(sampler, &d);
        for (good = 0, i = 0; i < n; i++) {
            index[good] = (uint32_t)i;
            good += d.status[i] == PSC_SUCCESS;
        }
        for (c = 0; c < 2; c++)
            FN(store_component)(d.uv[c], uv, c, first, good == n ? NULL : index, good);
        if (status)
            FN(scatter_status)(status, d.status, first, NULL, n);
    }
    return PSC_SUCCESS;
}
