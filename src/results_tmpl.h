/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Blocks of samples: strided inputs are gathered into short arrays that loops can vectorise
 * over, results are scattered from such arrays. Template: see precision.h.
 */
#ifndef PSC_BLOCK
#define PSC_BLOCK 128

/* The components of a sample, in the order of psc_light_sample. */
enum {
    PSC_DIRECTION = 0,
    PSC_PDF = 3,
    PSC_POINT = 4,
    PSC_DISTANCE = 7,
    PSC_NORMAL = 8,
    PSC_WEIGHT = 11,
    PSC_SURFACE = 12,
    PSC_COMPONENTS = 14
};
#endif

struct FN(psc_results) {
    real value[PSC_COMPONENTS][PSC_BLOCK];
    psc_result status[PSC_BLOCK];
};

/* The n elements of a component from first on. */
PSC_LANE void FN(gather)(const real *from, ptrdiff_t stride, size_t first, size_t n, real *to)
{
    const char *at = (const char *)from + (ptrdiff_t)first * stride;
    size_t i;

    if (stride == (ptrdiff_t)sizeof(real)) {
        memcpy(to, at, n * sizeof(real));
        return;
    }
    for (i = 0; i < n; i++)
        to[i] = *(const real *)(const void *)(at + (ptrdiff_t)i * stride);
}

/* Writes n values to the elements first + index[i], or first + i where index is NULL. */
PSC_LANE void FN(scatter)(const real *from, real *to, ptrdiff_t stride, size_t first,
                          const uint32_t *index, size_t n)
{
    char *at = (char *)to + (ptrdiff_t)first * stride;
    size_t i;

    if (index) {
        for (i = 0; i < n; i++)
            *(real *)(void *)(at + (ptrdiff_t)index[i] * stride) = from[i];
    } else if (stride == (ptrdiff_t)sizeof(real)) {
        memcpy(at, from, n * sizeof(real));
    } else {
        for (i = 0; i < n; i++)
            *(real *)(void *)(at + (ptrdiff_t)i * stride) = from[i];
    }
}

PSC_LANE int FN(wanted)(const FN(psc_output) *output, int components)
{
    int c, any = 0;

    for (c = 0; c < components; c++)
        any |= output->component[c] != NULL;
    return any;
}

PSC_LANE void FN(scatter_output)(const FN(psc_output) *output, int components,
                                 const real (*value)[PSC_BLOCK], size_t first,
                                 const uint32_t *index, size_t n)
{
    int c;

    for (c = 0; c < components; c++)
        if (output->component[c])
            FN(scatter)(value[c], output->component[c], output->stride, first, index, n);
}

PSC_LANE void FN(scatter_status)(const psc_output_result *output, const psc_result *status,
                                 size_t first, const uint32_t *index, size_t n)
{
    size_t i;

    if (!output->data)
        return;
    for (i = 0; i < n; i++)
        *(psc_result *)(void *)((char *)output->data +
                                (ptrdiff_t)(first + (index ? index[i] : i)) * output->stride) =
            status[i];
}

PSC_LANE void FN(scatter_results)(const FN(psc_samples) *out, const struct FN(psc_results) *r,
                                  size_t first, const uint32_t *index, size_t n)
{
    FN(scatter_output)(&out->direction, 3, r->value + PSC_DIRECTION, first, index, n);
    FN(scatter_output)(&out->pdf, 1, r->value + PSC_PDF, first, index, n);
    FN(scatter_output)(&out->point, 3, r->value + PSC_POINT, first, index, n);
    FN(scatter_output)(&out->distance, 1, r->value + PSC_DISTANCE, first, index, n);
    FN(scatter_output)(&out->normal, 3, r->value + PSC_NORMAL, first, index, n);
    FN(scatter_output)(&out->weight, 1, r->value + PSC_WEIGHT, first, index, n);
    FN(scatter_output)(&out->surface, 2, r->value + PSC_SURFACE, first, index, n);
    FN(scatter_status)(&out->status, r->status, first, index, n);
}
