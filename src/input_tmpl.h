/* SPDX-License-Identifier: Apache-2.0 */
/* Reading the caller's arrays. Template: see precision.h. */

/* Whether the array is there with all the components that it must have. */
PSC_LANE int FN(complete)(const FN(psc_input) *input, int components)
{
    int c, all = input != NULL;

    for (c = 0; all && c < components; c++)
        all = input->component[c] != NULL;
    return all;
}

PSC_LANE real FN(element)(const FN(psc_input) *input, int component, size_t i)
{
    return *(const real *)(const void *)((const char *)input->component[component] +
                                         (ptrdiff_t)i * input->stride);
}
