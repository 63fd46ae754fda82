/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Blocks of samples: strided inputs are gathered into short arrays that loops can vectorise
 * over, results are scattered from such arrays. Template: see precision.h.
 */
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

/* Element i of what a hit on the light decides. */
PSC_LANE void FN(store_surface)(struct FN(psc_results) *r, size_t i, const real point[3],
                                const real normal[3], real distance, real first, real second)
{
    int c;

    for (c = 0; c < 3; c++) {
        r->value[PSC_POINT + c][i] = point[c];
        r->value[PSC_NORMAL + c][i] = normal[c];
    }
    r->value[PSC_DISTANCE][i] = distance;
    r->value[PSC_SURFACE][i] = first;
    r->value[PSC_SURFACE + 1][i] = second;
}

/* Writes the values from[at[i]] to the elements first + index[i]; an index that is NULL stands
   for 0 to n - 1. */
PSC_LANE void FN(scatter)(const real *from, const uint32_t *at, real *to, ptrdiff_t stride,
                          size_t first, const uint32_t *index, size_t n)
{
    char *start = (char *)to + (ptrdiff_t)first * stride;
    size_t i;

    if (index)
        for (i = 0; i < n; i++)
            *(real *)(void *)(start + (ptrdiff_t)index[i] * stride) = from[at ? at[i] : i];
    else if (stride == (ptrdiff_t)sizeof(real))
        memcpy(start, from, n * sizeof(real));
    else
        for (i = 0; i < n; i++)
            *(real *)(void *)(start + (ptrdiff_t)i * stride) = from[i];
}

/* The calls for all the outputs that are wanted; see scatter(). */
static inline void FN(scatter_values)(const FN(psc_samples) *out,
                                      const struct FN(psc_results) *r, size_t first,
                                      const uint32_t *at, const uint32_t *index, size_t n)
{
    const struct {
        const FN(psc_output) *output;
        int from, components;
    } fields[] = {{&out->direction, PSC_DIRECTION, 3}, {&out->pdf, PSC_PDF, 1},
                  {&out->point, PSC_POINT, 3},         {&out->distance, PSC_DISTANCE, 1},
                  {&out->normal, PSC_NORMAL, 3},       {&out->weight, PSC_WEIGHT, 1},
                  {&out->surface, PSC_SURFACE, 2}};
    size_t f;
    int c;

    for (f = 0; f < sizeof fields / sizeof *fields; f++)
        for (c = 0; c < fields[f].components; c++)
            if (fields[f].output->component[c])
                FN(scatter)(r->value[fields[f].from + c], at, fields[f].output->component[c],
                            fields[f].output->stride, first, index, n);
}

PSC_LANE void FN(scatter_status)(const psc_output_result *output, const psc_result *status,
                                 size_t first, const uint32_t *index, size_t n)
{
    size_t i;

    for (i = 0; output->data && i < n; i++)
        psc_put_status(output, first + (index ? index[i] : i), status[i]);
}

PSC_LANE int FN(wanted)(const FN(psc_output) *output, int components)
{
    int c, any = 0;

    for (c = 0; c < components; c++)
        any |= output->component[c] != NULL;
    return any;
}

/* Whether anything is wanted that takes more than direction and density. */
PSC_LANE int FN(wants_surface)(const FN(psc_samples) *out)
{
    return FN(wanted)(&out->point, 3) || FN(wanted)(&out->normal, 3) ||
           FN(wanted)(&out->distance, 1) || FN(wanted)(&out->surface, 2);
}
