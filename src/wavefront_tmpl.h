/* SPDX-License-Identifier: Apache-2.0 */
/* Template: see precision.h. */

static real FN(element)(const FN(psc_input) *input, int component, size_t i)
{
    return *(const real *)(const void *)((const char *)input->component[component] +
                                         (ptrdiff_t)i * input->stride);
}

static int FN(complete)(const FN(psc_input) *input, int components)
{
    int c, all = input != NULL;

    for (c = 0; all && c < components; c++)
        all = input->component[c] != NULL;
    return all;
}

/* Builds and samples element i with the calls for one. */
static psc_result FN(build_and_sample)(const struct psc_shape_row *shape,
                                       const struct psc_view *technique,
                                       const FN(psc_receivers) *receivers,
                                       const FN(psc_input) *const parts[],
                                       const FN(psc_input) *uv, size_t i, psc_sampler *sampler,
                                       FN(psc_light_sample) *sample)
{
    double geometry[PSC_MAX_GEOMETRY], position[3], normal[3];
    const int has_normal = receivers->normal.component[0] != NULL;
    struct psc_view view = *technique;
    psc_result result;
    int p, c, n = 0;

    for (c = 0; c < 3; c++) {
        position[c] = (double)FN(element)(&receivers->position, c, i);
        if (has_normal)
            normal[c] = (double)FN(element)(&receivers->normal, c, i);
    }
    for (p = 0; shape->parts[p]; p++)
        for (c = 0; c < (shape->parts[p] == 'v' ? 3 : 1); c++)
            geometry[n++] = (double)FN(element)(parts[p], c, i);
    result = psc_check_receiver(receivers->flags, position, has_normal ? normal : NULL, &view);
    if (result == PSC_SUCCESS)
        result = psc_build_view(sampler, shape, &view, geometry);
    return result == PSC_SUCCESS
               ? sampler->KERNEL->sample(sampler, FN(element)(uv, 0, i), FN(element)(uv, 1, i),
                                         sample)
               : result;
}

psc_result FN(psc_wavefront)(const struct psc_shape_row *shape, const psc_technique *technique,
                             size_t count, const FN(psc_receivers) *receivers,
                             const FN(psc_input) *const parts[], const FN(psc_input) *uv,
                             const FN(psc_samples) *out)
{
    struct FN(psc_results) results;
    psc_sampler_storage storage;
    psc_sampler *sampler;
    struct psc_view view;
    psc_result result = psc_read_technique(technique, &view);
    size_t i;
    int p;

    if (result != PSC_SUCCESS)
        return result;
    if (!receivers)
        return PSC_ERROR_NULL_POINTER;
    if (receivers->struct_size != sizeof *receivers)
        return PSC_ERROR_STRUCT_SIZE;
    if (receivers->flags & ~(uint32_t)PSC_RECEIVER_TWO_SIDED)
        return PSC_ERROR_UNKNOWN_FLAG;
    if (!FN(complete)(&receivers->position, 3) || !FN(complete)(uv, 2) ||
        (receivers->normal.component[0] && !FN(complete)(&receivers->normal, 3)))
        return PSC_ERROR_NULL_POINTER;
    for (p = 0; shape->parts[p]; p++)
        if (!FN(complete)(parts[p], shape->parts[p] == 'v' ? 3 : 1))
            return PSC_ERROR_NULL_POINTER;
    result = psc_check_samples(out, sizeof *out);
    if (result != PSC_SUCCESS)
        return result;
    if (view.measure == PSC_MEASURE_PROJECTED_SOLID_ANGLE && !receivers->normal.component[0])
        return PSC_ERROR_NEEDS_NORMAL;

    psc_sampler_init(&storage, sizeof storage, &sampler);
    for (i = 0; i < count; i++) {
        FN(psc_light_sample) sample;
        int c;

        results.status[0] = FN(build_and_sample)(shape, &view, receivers, parts, uv, i, sampler,
                                                 &sample);
        if (results.status[0] == PSC_SUCCESS || results.status[0] == PSC_CULLED) {
            real flat[PSC_COMPONENTS];

            memcpy(flat, &sample, sizeof flat);
            for (c = 0; c < PSC_COMPONENTS; c++)
                results.value[c][0] = flat[c];
            FN(scatter_results)(out, &results, i, NULL, 1);
        } else {
            psc_put_status(&out->status, i, results.status[0]);
        }
    }
    return PSC_SUCCESS;
}
