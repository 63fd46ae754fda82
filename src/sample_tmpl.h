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

static real FN(pdf)(const psc_sampler *sampler, real x, real y, real z)
{
    const double direction[3] = {(double)x, (double)y, (double)z};

    return (real)sampler->shape->pdf(sampler, direction, DIRECTION_EPSILON);
}

static psc_result FN(invert)(const psc_sampler *sampler, real x, real y, real z, real *u, real *v)
{
    const double direction[3] = {(double)x, (double)y, (double)z};
    double uv[2];
    const psc_result result = sampler->shape->invert(sampler, direction, DIRECTION_EPSILON, uv);

    if (result == PSC_SUCCESS) {
        *u = (real)uv[0];
        *v = (real)uv[1];
    }
    return result;
}

psc_result FN(psc_pdf)(const psc_sampler *sampler, const real direction[3], real *pdf)
{
    *pdf = K(0.0);
    if (sampler->sides == 0)
        return PSC_EMPTY;
    *pdf = FN(pdf)(sampler, direction[0], direction[1], direction[2]);
    return PSC_SUCCESS;
}

psc_result FN(psc_invert)(const psc_sampler *sampler, const real direction[3], real uv[2])
{
    if (sampler->sides == 0)
        return PSC_EMPTY;
    return FN(invert)(sampler, direction[0], direction[1], direction[2], uv, uv + 1);
}

static void FN(output)(const FN(psc_output) *output, int component, size_t i, real value)
{
    if (output->component[component])
        *(real *)(void *)((char *)output->component[component] +
                          (ptrdiff_t)i * output->stride) = value;
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

psc_result FN(psc_pdf_n)(const psc_sampler *sampler, size_t count,
                         const FN(psc_input) *direction, const FN(psc_output) *pdf)
{
    size_t i;

    if (!sampler || !FN(complete)(direction, 3) || !pdf || !pdf->component[0])
        return PSC_ERROR_NULL_POINTER;
    for (i = 0; i < count; i++)
        FN(output)(pdf, 0, i,
                   sampler->sides == 0
                       ? K(0.0)
                       : FN(pdf)(sampler, FN(element)(direction, 0, i), FN(element)(direction, 1, i),
                                 FN(element)(direction, 2, i)));
    return sampler->sides == 0 ? PSC_EMPTY : PSC_SUCCESS;
}

psc_result FN(psc_invert_n)(const psc_sampler *sampler, size_t count,
                            const FN(psc_input) *direction, const FN(psc_output) *uv,
                            const psc_output_result *status)
{
    size_t i;

    if (!sampler || !FN(complete)(direction, 3) || !uv)
        return PSC_ERROR_NULL_POINTER;
    if (sampler->sides == 0) {
        if (status)
            psc_fill_status(status, count, PSC_EMPTY);
        return PSC_EMPTY;
    }
    for (i = 0; i < count; i++) {
        real u = K(0.0), v = K(0.0);
        const psc_result result =
            FN(invert)(sampler, FN(element)(direction, 0, i), FN(element)(direction, 1, i),
                       FN(element)(direction, 2, i), &u, &v);

        if (result == PSC_SUCCESS) {
            FN(output)(uv, 0, i, u);
            FN(output)(uv, 1, i, v);
        }
        if (status)
            psc_put_status(status, i, result);
    }
    return PSC_SUCCESS;
}
