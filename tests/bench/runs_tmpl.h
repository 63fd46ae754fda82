/* SPDX-License-Identifier: Apache-2.0 */
/*
 * One run of each kind of job of the library: direction and density of each sample go to separate
 * arrays. Template: see real.h.
 */
#undef STAGE_OF
#define STAGE_OF(job) (&FN(stages)[(job)->which])

static inline void FN(element)(real (*const from)[STAGE_MAX + 40], size_t i, real to[3])
{
    to[0] = from[0][i];
    to[1] = from[1][i];
    to[2] = from[2][i];
}

static inline void FN(put)(struct FN(stage) *s, size_t i, const real direction[3], real pdf)
{
    s->direction[0][i] = direction[0];
    s->direction[1][i] = direction[1];
    s->direction[2][i] = direction[2];
    s->pdf[i] = pdf;
}

static inline size_t FN(per_build)(const struct job *job, const struct FN(stage) *s)
{
    return job->regime == REGIME_MANY ? s->count : job->regime == REGIME_FOUR ? 4 : 1;
}

/* ---- The floor ---- */

static size_t FN(run_copy)(struct job *job)
{
    struct FN(stage) *s = STAGE_OF(job);
    size_t bytes = s->count * sizeof(real);
    int c;

    for (c = 0; c < 3; c++)
        memcpy(s->direction[c], s->position[c], bytes);
    memcpy(s->pdf, s->light[3], bytes);
    return s->count;
}

/* ---- The library ---- */

static inline psc_result FN(build)(struct job *job, const struct FN(stage) *s, size_t i,
                                   psc_sampler *sampler)
{
    const double position[3] = {s->position[0][i], s->position[1][i], s->position[2][i]};
    const double normal[3] = {s->normal[0][i], s->normal[1][i], s->normal[2][i]};
    const psc_receiver receiver = {sizeof receiver, 0, position, normal};
    double light[LIGHT_MAX];
    int c;

    for (c = 0; c < job->numbers; c++)
        light[c] = s->light[c][i];
    return job->shape->build(sampler, &job->technique, &receiver, light);
}

static size_t FN(run_calls)(struct job *job)
{
    struct FN(stage) *s = STAGE_OF(job);
    const size_t per = FN(per_build)(job, s);
    struct FN(psc_light_sample) sample;
    struct test_sampler memory;
    psc_sampler *sampler = make_sampler(&memory);
    size_t i, j;

    for (i = 0; i < s->count; i += per)
        if (FN(build)(job, s, per < s->count ? i : job->turn++ % s->count, sampler) == PSC_SUCCESS)
            for (j = i; j < i + per; j++) {
                FN(psc_sample)(sampler, s->u[j], s->v[j], &sample);
                FN(put)(s, j, sample.direction, sample.pdf);
            }
    return s->count;
}

static inline FN(psc_input) FN(input)(real *a, real *b, real *c)
{
    return (FN(psc_input)){{a, b, c}, sizeof(real)};
}

static inline FN(psc_samples) FN(outputs)(struct FN(stage) *s, size_t from)
{
    FN(psc_samples) out = {.struct_size = sizeof out};
    int c;

    for (c = 0; c < 3; c++)
        out.direction.component[c] = s->direction[c] + from;
    out.pdf.component[0] = s->pdf + from;
    out.direction.stride = out.pdf.stride = sizeof(real);
    return out;
}

static size_t FN(run_batch)(struct job *job)
{
    struct FN(stage) *s = STAGE_OF(job);
    const size_t per = FN(per_build)(job, s);
    struct test_sampler memory;
    psc_sampler *sampler = make_sampler(&memory);
    size_t i;

    for (i = 0; i < s->count; i += per) {
        const FN(psc_input) uv = FN(input)(s->u + i, s->v + i, NULL);
        const FN(psc_samples) out = FN(outputs)(s, i);

        if (FN(build)(job, s, per < s->count ? i : job->turn++ % s->count, sampler) == PSC_SUCCESS)
            FN(psc_sample_n)(sampler, per, &uv, &out);
    }
    return s->count;
}

static size_t FN(run_wavefront)(struct job *job)
{
    struct FN(stage) *s = STAGE_OF(job);
    const FN(psc_input) uv = FN(input)(s->u, s->v, NULL);
    const FN(psc_samples) out = FN(outputs)(s, 0);
    FN(psc_receivers) receivers = {.struct_size = sizeof receivers};
    FN(psc_input) parts[PARTS_MAX];
    const FN(psc_input) *in[PARTS_MAX];
    int k, at = 0;

    for (k = 0; job->shape->parts[k]; k++) {
        parts[k] = FN(input)(s->light[at], s->light[at + 1], s->light[at + 2]);
        in[k] = parts + k;
        at += part_size(job->shape->parts[k]);
    }
    receivers.position = FN(input)(s->position[0], s->position[1], s->position[2]);
    receivers.normal = FN(input)(s->normal[0], s->normal[1], s->normal[2]);
    job->shape->FN(wave)(&job->technique, s->count, &receivers, in, &uv, &out);
    return s->count;
}
