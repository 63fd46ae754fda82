/* SPDX-License-Identifier: Apache-2.0 */
/* Template: see precision.h. */

/* Builds and samples element i of the block with the calls for one. */
static void FN(build_and_sample)(const struct psc_shape_row *shape, uint32_t flags,
                                 const struct FN(psc_wave) *wave, size_t i, real u, real v,
                                 psc_sampler *sampler, struct FN(psc_results) *r)
{
    const double position[3] = {wave->position[0][i], wave->position[1][i],
                                wave->position[2][i]};
    const double normal[3] = {wave->normal[0][i], wave->normal[1][i], wave->normal[2][i]};
    double geometry[PSC_MAX_GEOMETRY];
    real flat[PSC_COMPONENTS];
    FN(psc_light_sample) sample;
    struct psc_request request;
    int c;

    request.measure = wave->measure;
    request.map = wave->map;
    request.one_sided = wave->one_sided;
    request.table = wave->table;
    request.numbers = wave->parts;
    for (c = 0; c < wave->parts; c++)
        geometry[c] = wave->geometry[c][i];
    r->status[i] = psc_check_point(
        flags, position, wave->facing == PSC_FACING_NONE ? NULL : normal, &request);
    if (r->status[i] == PSC_SUCCESS)
        r->status[i] = psc_build_numbers(sampler, shape, &request, geometry);
    if (r->status[i] != PSC_SUCCESS)
        return;
    r->status[i] = sampler->KERNEL->sample(sampler, u, v, &sample);
    memcpy(flat, &sample, sizeof flat);
    for (c = 0; c < PSC_COMPONENTS; c++)
        r->value[c][i] = flat[c];
}

/* How many elements have a sample. */
static size_t FN(count_sampled)(const psc_result *status, size_t n)
{
    int32_t count = 0;
    size_t i;

    for (i = 0; i < n; i++)
        count += is_sampled(status[i]);
    return (size_t)count;
}

/* n numbers of the caller from first on: where they are, or in `room`. */
static const real *FN(read_block)(const FN(psc_input) *input, int component, size_t first,
                                  size_t n, real *room)
{
    if (input->stride == (ptrdiff_t)sizeof(real))
        return input->component[component] + first;
    FN(gather)(input->component[component], input->stride, first, n, room);
    return room;
}

static psc_result FN(check_wavefront)(const struct psc_shape_row *shape, const char *kinds,
                                      const psc_technique *technique,
                                      const FN(psc_receivers) *receivers,
                                      const FN(psc_input) *const parts[],
                                      const FN(psc_input) *uv, const FN(psc_samples) *out,
                                      struct psc_request *request)
{
    psc_result result = psc_check_technique(technique, request);
    int p, has_normal;

    if (result != PSC_SUCCESS)
        return result;
    result = psc_check_struct(receivers, sizeof *receivers);
    if (result != PSC_SUCCESS)
        return result;
    if (receivers->flags & ~(uint32_t)PSC_RECEIVER_TWO_SIDED)
        return PSC_ERROR_UNKNOWN_FLAG;
    has_normal = receivers->normal.component[0] != NULL;
    if (!FN(complete)(&receivers->position, 3) || !FN(complete)(uv, 2) ||
        (has_normal && !FN(complete)(&receivers->normal, 3)))
        return PSC_ERROR_NULL_POINTER;
    request->numbers = 0;
    for (p = 0; kinds[p]; p++) {
        const int numbers = kinds[p] == 'v' ? 3 : 1;

        if (!FN(complete)(parts[p], numbers))
            return PSC_ERROR_NULL_POINTER;
        request->numbers += numbers;
    }
    request->facing = !has_normal                                  ? PSC_FACING_NONE
                      : receivers->flags & PSC_RECEIVER_TWO_SIDED ? PSC_FACING_BOTH
                                                                  : PSC_FACING_ONE;
    result = psc_check_samples(out, sizeof *out);
    return result != PSC_SUCCESS ? result : psc_check_offer(shape, request);
}

psc_result FN(psc_wavefront)(const struct psc_shape_row *shape, const char *kinds,
                             const psc_technique *technique, size_t count,
                             const FN(psc_receivers) *receivers,
                             const FN(psc_input) *const parts[], const FN(psc_input) *uv,
                             const FN(psc_samples) *out)
{
    static const real no_normal[PSC_BLOCK];
    const struct FN(psc_kernel) *kernel = psc_dispatch()->KERNEL[shape->kernel];
    real u_room[PSC_BLOCK], v_room[PSC_BLOCK];
    struct FN(psc_results) results;
    struct psc_request request;
    uint32_t index[PSC_BLOCK];
    psc_sampler_storage storage;
    psc_sampler *sampler = NULL; /* for elements that the kernel leaves to it */
    struct FN(psc_wave) wave;
    size_t first, i, block;
    const psc_result result =
        FN(check_wavefront)(shape, kinds, technique, receivers, parts, uv, out, &request);

    if (result != PSC_SUCCESS)
        return result;
    wave.measure = request.measure;
    wave.map = request.map;
    wave.facing = request.facing;
    wave.one_sided = request.one_sided;
    wave.table = request.table;
    wave.parts = request.numbers;
    block = MIN(PSC_BLOCK, PSC_WAVE_NUMBERS / (size_t)(6 + request.numbers));
    wave.surface = FN(wants_surface)(out);
    wave.weight = FN(wanted)(&out->weight, 1);
    for (first = 0; first < count; first += wave.count) {
        const size_t n = MIN(count - first, block);
        const real *u, *v;
        real *room = wave.numbers;
        size_t good;
        int p, c, number = 0;

        wave.count = n;
        for (c = 0; c < 3; c++, room += block) {
            wave.position[c] = FN(read_block)(&receivers->position, c, first, n, room);
            wave.normal[c] = no_normal;
        }
        for (c = 0; wave.facing != PSC_FACING_NONE && c < 3; c++, room += block)
            wave.normal[c] = FN(read_block)(&receivers->normal, c, first, n, room);
        for (p = 0; kinds[p]; p++)
            for (c = 0; c < (kinds[p] == 'v' ? 3 : 1); c++, room += block)
                wave.geometry[number++] = FN(read_block)(parts[p], c, first, n, room);
        u = FN(read_block)(uv, 0, first, n, u_room);
        v = FN(read_block)(uv, 1, first, n, v_room);

        if (kernel->wave)
            kernel->wave(&wave, u, v, &results);
        else
            for (i = 0; i < n; i++)
                results.status[i] = PSC_PENDING;
        good = FN(count_sampled)(results.status, n);
        if (good < n) { /* most blocks are done, and need neither sampler nor index */
            if (!sampler)
                psc_sampler_init(&storage, sizeof storage, &sampler);
            for (good = 0, i = 0; i < n; i++) {
                if (results.status[i] == PSC_PENDING)
                    FN(build_and_sample)(shape, receivers->flags, &wave, i, u[i], v[i], sampler,
                                         &results);
                index[good] = (uint32_t)i;
                good += (size_t)is_sampled(results.status[i]);
            }
        }
        FN(scatter_status)(&out->status, results.status, first, NULL, n);
        FN(scatter_values)(out, &results, first, index, good == n ? NULL : index, good);
    }
    return PSC_SUCCESS;
}
