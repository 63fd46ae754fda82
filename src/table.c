/* SPDX-License-Identifier: Apache-2.0 */
/* Making the table of the tabulated map. */
#include "ellipse_cdf.h"
#include "table.h"

size_t psc_table_size(uint32_t resolution)
{
    const size_t n = resolution;

    return n >= PSC_LEAST_RESOLUTION && n <= PSC_MOST_RESOLUTION
               ? sizeof(psc_table) + n * (n + 1) * sizeof(float)
               : 0;
}

/* alpha is 0.5: what the shares depend on it is what the map leaves out. */
static void fill_row(float *share, uint32_t n, uint32_t row)
{
    const double beta = 0.5 * (row + 1) / n, width = 0.5 * PSC_PI / n;
    struct psc_ellipse e = {.at = 0.0};
    double defect, versine;
    struct psc_cdf cdf;
    uint32_t j;

    sine_cosine_defects_f64(0.5, &defect, &versine);
    e.a = 0.5 - defect;
    e.ca = 1.0 - versine;
    sine_cosine_defects_f64(beta, &defect, &versine);
    e.b = beta - defect;
    e.cb = 1.0 - versine;
    cdf.terms = 0;
    cdf_build(&cdf, &e);
    share[0] = 0.0f;
    for (j = 1; j < n; j++) {
        const double azimuth = j * width;
        double c, s, length;

        sine_cosine_defects_f64(azimuth, &defect, &versine);
        c = (1.0 - versine) * e.b;
        s = (azimuth - defect) * e.a;
        length = 1.0 / SQRT(c * c + s * s);
        c *= length;
        s *= length;
        share[j] = (float)(cdf_theta(&cdf, angle_of(c, s), c, s) * (2.0 / PSC_PI));
    }
    share[n] = 1.0f;
}

psc_result psc_table_init(void *memory, size_t size, uint32_t resolution, const psc_table **out)
{
    const size_t needed = psc_table_size(resolution);
    psc_table *table = memory;
    uint32_t row;

    if (!out)
        return PSC_ERROR_NULL_POINTER;
    *out = NULL;
    if (!memory)
        return PSC_ERROR_NULL_POINTER;
    if (needed == 0)
        return PSC_ERROR_RESOLUTION;
    if (size < needed || (uintptr_t)memory % _Alignof(psc_table) != 0)
        return PSC_ERROR_STORAGE;
    table->magic = PSC_TABLE_MAGIC;
    table->resolution = resolution;
    for (row = 0; row < resolution; row++)
        fill_row(table->share + (size_t)row * (resolution + 1), resolution, row);
    *out = table;
    return PSC_SUCCESS;
}
