/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Arrays of every layout in memory of exactly their size, so that a sanitizer sees what reads or
 * writes beyond them, and calls whose results are compared to the last bit. Template: see real.h.
 */

/* What a call gives for one element, and what memory holds that was never written. */
struct FN(record) {
    FN(psc_light_sample) sample;
    psc_result status;
};

static real FN(component)(const struct FN(record) *record, int c)
{
    real value;

    memcpy(&value, (const char *)&record->sample + (size_t)c * sizeof value, sizeof value);
    return value;
}

static int FN(same)(real a, real b)
{
    return memcmp(&a, &b, sizeof a) == 0 || (a != a && b != b);
}

/* ---- Inputs ---- */

struct FN(source) {
    enum layout layout;
    size_t count;
    int components;
    void *memory[MAX_INPUTS]; /* the first alone in records */
};

static void FN(make_source)(struct FN(source) *s, enum layout layout, size_t count,
                            int components, real (*values)[COUNT_MAX])
{
    size_t i;
    int c;

    memset(s, 0, sizeof *s);
    s->layout = layout;
    s->count = count;
    s->components = components;
    if (layout == LAYOUT_RECORDS)
        s->memory[0] = allocate(count * (size_t)components * sizeof(real));
    for (c = 0; c < components; c++) {
        real *to = layout == LAYOUT_RECORDS ? s->memory[0]
                                            : (s->memory[c] = allocate(count * sizeof(real)));

        for (i = 0; i < count; i++)
            if (layout == LAYOUT_RECORDS)
                to[i * (size_t)components + (size_t)c] = values[c][i];
            else
                to[layout == LAYOUT_REVERSED ? count - 1 - i : i] = values[c][i];
    }
}

static FN(psc_input) FN(input)(const void *source, int first, int components)
{
    const struct FN(source) *s = source;
    FN(psc_input) input = {{NULL, NULL, NULL}, sizeof(real)};
    int c;

    for (c = 0; c < components; c++)
        input.component[c] = s->layout == LAYOUT_RECORDS ? (real *)s->memory[0] + first + c
                                                         : s->memory[first + c];
    if (s->layout == LAYOUT_RECORDS)
        input.stride *= s->components;
    if (s->layout == LAYOUT_REVERSED) {
        input.stride = -input.stride;
        for (c = 0; c < components && s->count > 0; c++)
            input.component[c] += s->count - 1;
    }
    return input;
}

static void FN(free_source)(struct FN(source) *s)
{
    int c;

    for (c = 0; c < MAX_INPUTS; c++)
        free(s->memory[c]);
}

/* ---- Outputs ---- */

struct FN(sink) {
    enum layout layout;
    size_t count;
    unsigned wanted; /* a bit for each component */
    void *memory[COMPONENTS + 1];
    FN(psc_samples) out;
};

static FN(psc_output) FN(output)(struct FN(sink) *s, int first, int components)
{
    FN(psc_output) output = {{NULL, NULL, NULL}, sizeof(real)};
    int c;

    if (s->layout == LAYOUT_RECORDS)
        output.stride = sizeof(struct FN(record));
    if (s->layout == LAYOUT_REVERSED)
        output.stride = -output.stride;
    for (c = 0; c < components; c++)
        if (s->wanted >> (first + c) & 1) {
            if (s->layout == LAYOUT_RECORDS) {
                output.component[c] = (real *)s->memory[0] + first + c;
                continue;
            }
            s->memory[first + c] = allocate(s->count * sizeof(real));
            output.component[c] = s->memory[first + c];
            if (s->layout == LAYOUT_REVERSED && s->count > 0)
                output.component[c] += s->count - 1;
        }
    return output;
}

static void FN(make_sink)(struct FN(sink) *s, enum layout layout, size_t count, unsigned wanted)
{
    memset(s, 0, sizeof *s);
    s->layout = layout;
    s->count = count;
    s->wanted = wanted;
    if (layout == LAYOUT_RECORDS)
        s->memory[0] = allocate(count * sizeof(struct FN(record)));
    s->out.struct_size = sizeof s->out;
    s->out.direction = FN(output)(s, 0, 3);
    s->out.pdf = FN(output)(s, 3, 1);
    s->out.point = FN(output)(s, 4, 3);
    s->out.distance = FN(output)(s, 7, 1);
    s->out.normal = FN(output)(s, 8, 3);
    s->out.weight = FN(output)(s, 11, 1);
    s->out.surface = FN(output)(s, 12, 2);
    if (layout == LAYOUT_RECORDS) {
        s->out.status.data = &((struct FN(record) *)s->memory[0])->status;
        s->out.status.stride = sizeof(struct FN(record));
    } else {
        s->out.status.data = s->memory[COMPONENTS] = allocate(count * sizeof(psc_result));
        s->out.status.stride = sizeof(psc_result);
    }
}

static void FN(free_sink)(struct FN(sink) *s)
{
    int c;

    for (c = 0; c <= COMPONENTS; c++)
        free(s->memory[c]);
}

static real FN(output_value)(const struct FN(sink) *s, int c, size_t i)
{
    if (s->layout == LAYOUT_RECORDS)
        return FN(component)((const struct FN(record) *)s->memory[0] + i, c);
    return ((const real *)s->memory[c])[s->layout == LAYOUT_REVERSED ? s->count - 1 - i : i];
}

static psc_result FN(output_status)(const struct FN(sink) *s, size_t i)
{
    return *(const psc_result *)(const void *)((const char *)s->out.status.data +
                                               (ptrdiff_t)i * s->out.status.stride);
}

/* Whether all that was written is as expected, and nothing else was written. */
static int FN(compare)(struct tally *tally, const struct FN(sink) *s,
                       const struct FN(record) *expected)
{
    struct FN(record) untouched;
    size_t i;
    int c;

    fill(&untouched, sizeof untouched);
    for (i = 0; i < s->count; i++) {
        if (FN(output_status)(s, i) != expected[i].status)
            return tally_add(tally, i, "status", FN(output_status)(s, i), expected[i].status);
        for (c = 0; c < COMPONENTS; c++) {
            const int wanted = s->wanted >> c & 1;
            const real value = FN(component)(wanted ? expected + i : &untouched, c);

            if ((wanted || s->layout == LAYOUT_RECORDS) &&
                !FN(same)(FN(output_value)(s, c, i), value))
                return tally_add(tally, i, component_names[c],
                                 (double)FN(output_value)(s, c, i), (double)value);
        }
        tally->compared++;
    }
    return 1;
}

/* ---- Many samples of one build ---- */

static void FN(sample_each)(const psc_sampler *sampler, size_t count,
                            real (*uv)[COUNT_MAX], struct FN(record) *to)
{
    size_t i;

    fill(to, count * sizeof *to);
    for (i = 0; i < count; i++)
        to[i].status = FN(psc_sample)(sampler, uv[0][i], uv[1][i], &to[i].sample);
}

static void FN(check_batch)(struct tally *tally, const psc_sampler *sampler, enum layout layout,
                            unsigned wanted, size_t count, real (*uv)[COUNT_MAX],
                            const struct FN(record) *expected)
{
    struct FN(source) source;
    struct FN(sink) sink;
    FN(psc_input) input;
    psc_result result;

    FN(make_source)(&source, layout, count, 2, uv);
    FN(make_sink)(&sink, layout, count, wanted);
    input = FN(input)(&source, 0, 2);
    result = FN(psc_sample_n)(sampler, count, &input, &sink.out);
    if (result != PSC_SUCCESS && result != PSC_EMPTY)
        tally_add(tally, 0, "result", result, PSC_SUCCESS);
    else
        FN(compare)(tally, &sink, expected);
    FN(free_sink)(&sink);
    FN(free_source)(&source);
}

/* One value for all elements, by a stride of 0. */
static void FN(check_repeated)(struct tally *tally, const psc_sampler *sampler, real u, real v,
                               const struct FN(record) *expected)
{
    const FN(psc_input) input = {{&u, &v, NULL}, 0};
    struct FN(record) all[REPEATED];
    struct FN(sink) sink;
    int i;

    for (i = 0; i < REPEATED; i++)
        all[i] = *expected;
    FN(make_sink)(&sink, LAYOUT_SEPARATE, REPEATED, ALL_COMPONENTS);
    FN(psc_sample_n)(sampler, REPEATED, &input, &sink.out);
    FN(compare)(tally, &sink, all);
    FN(free_sink)(&sink);
}

/* Densities and inverses of the samples, of every fourth turned away a little, against those of
   the calls for one. */
static void FN(check_directions)(struct tally *tally, const psc_sampler *sampler, size_t count,
                                 const struct FN(record) *samples)
{
    static real values[3][COUNT_MAX], pdf[COUNT_MAX], uv[2][COUNT_MAX];
    static psc_result status[COUNT_MAX];
    const FN(psc_input) input = {{values[0], values[1], values[2]}, sizeof(real)};
    const FN(psc_output) pdf_out = {{pdf, NULL, NULL}, sizeof(real)};
    const FN(psc_output) uv_out = {{uv[0], uv[1], NULL}, sizeof(real)};
    const psc_output_result status_out = {status, sizeof *status};
    size_t i;
    int c;

    fill(pdf, sizeof pdf);
    fill(uv, sizeof uv);
    for (i = 0; i < count; i++)
        for (c = 0; c < 3; c++)
            values[c][i] = samples[i].status != PSC_SUCCESS && samples[i].status != PSC_CULLED
                               ? (real)(c == 2)
                               : samples[i].sample.direction[c] +
                                     (real)(i % 4 == (size_t)c ? 0.25 * (double)(i % 7) : 0.0);
    FN(psc_pdf_n)(sampler, count, &input, &pdf_out);
    FN(psc_invert_n)(sampler, count, &input, &uv_out, &status_out);
    for (i = 0; i < count; i++) {
        const real direction[3] = {values[0][i], values[1][i], values[2][i]};
        real one, pair[2];
        psc_result result;

        fill(pair, sizeof pair);
        FN(psc_pdf)(sampler, direction, &one);
        result = FN(psc_invert)(sampler, direction, pair);
        if (!FN(same)(pdf[i], one))
            tally_add(tally, i, "density", (double)pdf[i], (double)one);
        if (status[i] != result)
            tally_add(tally, i, "status of the inverse", status[i], result);
        for (c = 0; c < 2; c++)
            if (!FN(same)(uv[c][i], pair[c]))
                tally_add(tally, i, "inverse", (double)uv[c][i], (double)pair[c]);
        tally->compared++;
    }
}

/* All ways to take samples of a light with a variant, against single ones of the first. */
static void FN(check_light)(struct tally *tally, const struct light *light,
                            const struct psc_variant *variant)
{
    static real uv[2][COUNT_MAX];
    static struct FN(record) expected[COUNT_MAX], got[COUNT_MAX];
    struct test_sampler memory;
    psc_sampler *sampler = make_sampler(&memory);
    size_t i, count;
    int c, layout;

    for (i = 0; i < COUNT_MAX; i++) {
        uv[0][i] = (real)coordinate(2 * i);
        uv[1][i] = (real)coordinate(2 * i + 1);
    }
    variant_use(variant_at(0));
    build_light(sampler, light);
    FN(sample_each)(sampler, COUNT_MAX, uv, expected);
    variant_use(variant);
    build_light(sampler, light);
    FN(sample_each)(sampler, COUNT_MAX, uv, got);
    for (i = 0; i < COUNT_MAX; i++) {
        if (got[i].status != expected[i].status)
            tally_add(tally, i, "single status", got[i].status, expected[i].status);
        for (c = 0; c < COMPONENTS; c++)
            if (!FN(same)(FN(component)(got + i, c), FN(component)(expected + i, c)))
                tally_add(tally, i, component_names[c], (double)FN(component)(got + i, c),
                          (double)FN(component)(expected + i, c));
    }
    for (count = 0; count <= COUNT_MAX; count = next_count(count))
        for (layout = 0; layout < LAYOUTS; layout++)
            FN(check_batch)(tally, sampler, layout, some_components(count + (size_t)layout),
                            count, uv, expected);
    FN(check_repeated)(tally, sampler, uv[0][7], uv[1][7], expected + 7);
    FN(check_directions)(tally, sampler, COUNT_MAX, expected);
    FN(check_directions)(tally, sampler, 3, expected);
}

/* ---- Wavefronts ---- */

static struct FN(record) FN(single)(const struct light *shared, real (*values)[COUNT_MAX],
                                    size_t i)
{
    struct light light = *shared;
    struct test_sampler memory;
    psc_sampler *sampler = make_sampler(&memory);
    double element[MAX_INPUTS];
    struct FN(record) record;
    int c;

    fill(&record, sizeof record);
    for (c = 0; c < MAX_INPUTS; c++)
        element[c] = (double)values[c][i];
    from_values(element, &light);
    record.status = build_light(sampler, &light);
    if (record.status == PSC_SUCCESS)
        record.status =
            FN(psc_sample)(sampler, values[UV][i], values[UV + 1][i], &record.sample);
    return record;
}

/* Calls the wavefront of the shape on inputs that are found by their place among the values. */
static void FN(check_call)(struct tally *tally, const struct light *shared, size_t count,
                           FN(psc_input) (*input)(const void *, int, int), const void *source,
                           struct FN(sink) *sink, const struct FN(record) *expected)
{
    const psc_technique technique = light_technique(shared);
    const FN(psc_input) uv = input(source, UV, 2);
    FN(psc_receivers) receivers = {.struct_size = sizeof receivers, .flags = shared->flags};
    FN(psc_input) parts[PARTS_MAX];
    const FN(psc_input) *in[PARTS_MAX];
    psc_result result;
    int k, at = GEOMETRY;

    receivers.position = input(source, POSITION, 3);
    if (shared->has_normal)
        receivers.normal = input(source, NORMAL, 3);
    for (k = 0; k < part_count(shared->shape); k++) {
        const int size = part_size(shared->shape->parts[k]);

        parts[k] = input(source, at, size);
        in[k] = parts + k;
        at += size;
    }
    result = shared->shape->FN(wave)(&technique, count, &receivers, in, &uv, &sink->out);
    if (result != PSC_SUCCESS)
        tally_add(tally, 0, "result", result, PSC_SUCCESS);
    else
        FN(compare)(tally, sink, expected);
}

static void FN(check_count)(struct tally *tally, const struct light *shared, enum layout layout,
                            unsigned wanted, size_t count, real (*values)[COUNT_MAX],
                            const struct FN(record) *expected)
{
    struct FN(source) source;
    struct FN(sink) sink;

    FN(make_source)(&source, layout, count, GEOMETRY + geometry_size(shared->shape), values);
    FN(make_sink)(&sink, layout, count, wanted);
    FN(check_call)(tally, shared, count, FN(input), &source, &sink, expected);
    FN(free_sink)(&sink);
    FN(free_source)(&source);
}

/* Element 0 for all, but for the points of the square. */
static FN(psc_input) FN(shared_input)(const void *source, int first, int components)
{
    const real *values = source;
    FN(psc_input) input = {{NULL, NULL, NULL}, first == UV ? sizeof(real) : 0};
    int c;

    for (c = 0; c < components; c++)
        input.component[c] = values + (first + c) * COUNT_MAX;
    return input;
}

/* One light and one receiver for all elements, by strides of 0. */
static void FN(check_shared)(struct tally *tally, const struct light *shared,
                             real (*values)[COUNT_MAX])
{
    struct FN(record) expected[REPEATED];
    struct FN(sink) sink;
    int i, c;

    for (i = 0; i < REPEATED; i++) {
        for (c = 0; c < MAX_INPUTS; c++)
            if (c != UV && c != UV + 1)
                values[c][i] = values[c][0];
        expected[i] = FN(single)(shared, values, (size_t)i);
    }
    FN(make_sink)(&sink, LAYOUT_SEPARATE, REPEATED, ALL_COMPONENTS);
    FN(check_call)(tally, shared, REPEATED, FN(shared_input), values, &sink, expected);
    FN(free_sink)(&sink);
}

/* Mixed lights in one array, against single ones of the first variant. */
static void FN(check_wavefront)(struct tally *tally, const struct light *shared,
                                const struct psc_variant *variant)
{
    static real values[MAX_INPUTS][COUNT_MAX];
    static struct FN(record) expected[COUNT_MAX];
    size_t i, count;
    int c, layout;

    variant_use(variant_at(0));
    for (i = 0; i < COUNT_MAX; i++) {
        double element[MAX_INPUTS];

        make_element(shared, i, element);
        for (c = 0; c < MAX_INPUTS; c++)
            values[c][i] = (real)element[c];
        expected[i] = FN(single)(shared, values, i);
        tally->statuses[expected[i].status < 0 ? 4 : expected[i].status]++;
    }
    variant_use(variant);
    for (count = 0; count <= COUNT_MAX; count = next_count(count))
        for (layout = 0; layout < LAYOUTS; layout++)
            FN(check_count)(tally, shared, layout, some_components(count + (size_t)layout), count,
                            values, expected);
    FN(check_shared)(tally, shared, values);
}
