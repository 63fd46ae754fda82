/* SPDX-License-Identifier: Apache-2.0 */
/* The body of test_arrays.c for one precision: see there. */
#include "arrays.h"

/* One build, many samples: the same bits as one at a time. */
static int FN(sample_same)(const psc_sampler *sampler, size_t count, int in_layout,
                           int out_layout, unsigned wanted, int partial, uint64_t *seed)
{
    struct FN(array) uv;
    struct FN(outputs) out;
    FN(psc_input) input;
    psc_result whole, result = PSC_SUCCESS;
    size_t i;
    int same = 1;

    FN(array_make)(&uv, 2, count, in_layout);
    FN(outputs_make)(&out, count, out_layout, wanted, partial);
    for (i = 0; i < count && (i == 0 || in_layout != FN(REPEATED)); i++) {
        *FN(array_at)(&uv, i, 0) = (REAL)random_coordinate(seed);
        *FN(array_at)(&uv, i, 1) = (REAL)random_coordinate(seed);
    }
    input = FN(array_input)(&uv);
    whole = FN(psc_sample_n)(sampler, count, &input, &out.samples);
    for (i = 0; i < count; i++) {
        FN(psc_light_sample) sample;

        result = FN(psc_sample)(sampler, *FN(array_at)(&uv, i, 0), *FN(array_at)(&uv, i, 1),
                                &sample);
        same &= FN(outputs_hold)(&out, i, wanted, &sample, result);
    }
    if (count > 0)
        same &= whole == (result == PSC_EMPTY ? PSC_EMPTY : PSC_SUCCESS);
    free(uv.memory);
    FN(outputs_free)(&out);
    return same;
}

/* The same for pdf and inverse, of directions of which some are of the light. */
static int FN(inverse_same)(const psc_sampler *sampler, size_t count, int in_layout,
                            int out_layout, int with_status, uint64_t *seed)
{
    struct FN(array) direction, pdf, uv;
    psc_result *status = malloc((count + 1) * sizeof *status);
    psc_output_result out_status;
    FN(psc_input) in;
    FN(psc_output) out_pdf, out_uv;
    size_t i;
    int same = 1, c;

    FN(array_make)(&direction, 3, count, in_layout);
    FN(array_make)(&pdf, 1, count, out_layout);
    FN(array_make)(&uv, 2, count, out_layout);
    for (i = 0; i < count && (i == 0 || in_layout != FN(REPEATED)); i++) {
        FN(psc_light_sample) sample;
        double any[3];

        random_unit(seed, any);
        if (FN(psc_sample)(sampler, (REAL)random_uniform(seed), (REAL)random_uniform(seed),
                           &sample) == PSC_EMPTY || i % 3 == 2)
            for (c = 0; c < 3; c++)
                sample.direction[c] = (REAL)any[c];
        for (c = 0; c < 3; c++)
            *FN(array_at)(&direction, i, c) = sample.direction[c];
    }
    for (i = 0; i < count; i++)
        status[i] = 77;
    out_status.data = status;
    out_status.stride = sizeof *status;
    in = FN(array_input)(&direction);
    out_pdf = FN(array_output)(&pdf, 1);
    out_uv = FN(array_output)(&uv, 3);
    FN(psc_pdf_n)(sampler, count, &in, &out_pdf);
    FN(psc_invert_n)(sampler, count, &in, &out_uv, with_status ? &out_status : NULL);
    for (i = 0; i < count; i++) {
        REAL d[3], one_pdf = (REAL)-1.0, one_uv[2];
        psc_result result;

        for (c = 0; c < 3; c++)
            d[c] = *FN(array_at)(&direction, i, c);
        FN(psc_pdf)(sampler, d, &one_pdf);
        same &= FN(array_holds)(&pdf, i, 1, &one_pdf);
        result = FN(psc_invert)(sampler, d, one_uv);
        same &= FN(array_holds)(&uv, i, result == PSC_SUCCESS ? 3u : 0u, one_uv);
        same &= status[i] == (with_status ? result : 77);
    }
    free(direction.memory);
    free(pdf.memory);
    free(uv.memory);
    free(status);
    return same;
}

static void FN(arrays)(const struct shape *shape, const struct test_technique *what)
{
    static const size_t counts[] = {0, 1, 2, 3, 4, 5, 7, 8, 9, 15, 16, 17, 31, 33, 64, 257};
    uint64_t seed = 130;
    int samples = 0, inverses = 0, tried = 0, i;

    for (i = 0; i < 240; i++) {
        size_t count = counts[(size_t)i % (sizeof counts / sizeof counts[0])];
        int in_layout = random_below(&seed, FN(LAYOUTS));
        int out_layout = random_below(&seed, FN(REPEATED)), partial = random_below(&seed, 3) == 0;
        unsigned wanted = i % 2 ? 0xffu : (unsigned)random_bits(&seed) & 0xffu;
        struct test_sampler s;
        struct light light;
        uint64_t same_seed = seed;

        random_light(&seed, shape, what, &light);
        if (i % 20 == 0)
            shrink_to_nothing(&light);
        build_light(make_sampler(&s), &light);
        tried++;
        if (!FN(sample_same)(s.sampler, count, in_layout, out_layout, wanted, partial, &seed)) {
            samples++;
            tap_note("seed %llx, %zu samples: %s", (unsigned long long)same_seed, count,
                     describe_light(&light));
        }
        if (!FN(inverse_same)(s.sampler, count, in_layout, out_layout, i % 4 != 3, &seed)) {
            inverses++;
            tap_note("seed %llx, %zu directions: %s", (unsigned long long)same_seed, count,
                     describe_light(&light));
        }
    }
    tap_ok(samples == 0, "%s, %s, " SUFFIX ": samples in arrays (%d of %d differ)", shape->name,
           what->name, samples, tried);
    tap_ok(inverses == 0, "%s, %s, " SUFFIX ": pdfs and inverses in arrays (%d of %d differ)",
           shape->name, what->name, inverses, tried);
}

/* What is wrong with the arrays themselves. */
static void FN(refusals)(void)
{
    static const double origin[3] = {0.0, 0.0, 0.0}, up[3] = {0.0, 0.0, 1.0};
    static const double center[3] = {1.0, 2.0, 3.0};
    struct { FN(psc_samples) s; uint64_t more[2]; } later;
    struct test_sampler s;
    struct FN(array) numbers;
    FN(psc_input) in;
    FN(psc_output) out;
    FN(psc_samples) samples;
    const psc_result null = PSC_ERROR_NULL_POINTER;

    build_sphere(make_sampler(&s), shape_sphere.techniques, 0, origin, up, center, 0.5);
    FN(array_make)(&numbers, 3, 1, FN(RECORDS));
    in = FN(array_input)(&numbers);
    out = FN(array_output)(&numbers, 7);
    memset(&samples, 0, sizeof samples);
    samples.struct_size = sizeof samples;
    tap_ok(FN(psc_sample_n)(NULL, 1, &in, &samples) == null &&
               FN(psc_sample_n)(s.sampler, 1, NULL, &samples) == null &&
               FN(psc_sample_n)(s.sampler, 1, &in, NULL) == null, SUFFIX ": sample_n, NULL");
    tap_ok(FN(psc_pdf_n)(NULL, 1, &in, &out) == null &&
               FN(psc_pdf_n)(s.sampler, 1, NULL, &out) == null &&
               FN(psc_pdf_n)(s.sampler, 1, &in, NULL) == null, SUFFIX ": pdf_n, NULL");
    tap_ok(FN(psc_invert_n)(NULL, 1, &in, &out, NULL) == null &&
               FN(psc_invert_n)(s.sampler, 1, NULL, &out, NULL) == null &&
               FN(psc_invert_n)(s.sampler, 1, &in, NULL, NULL) == null, SUFFIX ": invert_n, NULL");
    in.component[1] = NULL;
    tap_ok(FN(psc_sample_n)(s.sampler, 1, &in, &samples) == null &&
               FN(psc_pdf_n)(s.sampler, 1, &in, &out) == null &&
               FN(psc_invert_n)(s.sampler, 1, &in, &out, NULL) == null,
           SUFFIX ": an input component that is NULL");
    in = FN(array_input)(&numbers);
    samples.struct_size = 8;
    tap_ok(FN(psc_sample_n)(s.sampler, 1, &in, &samples) == PSC_ERROR_STRUCT_SIZE,
           SUFFIX ": a short description of samples");
    samples.struct_size = sizeof samples;
    samples.reserved = 1;
    tap_ok(FN(psc_sample_n)(s.sampler, 1, &in, &samples) == PSC_ERROR_UNKNOWN_FIELD,
           SUFFIX ": an unknown field of samples");
    samples.reserved = 0;
    memset(&later, 0, sizeof later);
    later.s = samples;
    later.s.struct_size = sizeof later;
    tap_ok(FN(psc_sample_n)(s.sampler, 1, &in, &later.s) == PSC_SUCCESS,
           SUFFIX ": a later description of samples");
    later.more[1] = 1;
    tap_ok(FN(psc_sample_n)(s.sampler, 1, &in, &later.s) == PSC_ERROR_UNKNOWN_FIELD,
           SUFFIX ": a later field of samples that is set");
    free(numbers.memory);
}
