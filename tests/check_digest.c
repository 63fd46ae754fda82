/* SPDX-License-Identifier: Apache-2.0 */
/*
 * The same bits from every compiler and on every machine: a digest of results, one for each
 * technique and kind of call, against the stored ones.
 *
 *     check_digest FILE              compares with the stored digests
 *     check_digest --record FILE     stores what this build gives, when results change on purpose
 *     check_digest --trace NAME      prints all that goes into a digest, for diff to find out
 *                                    where two builds part
 *
 * Inputs are made from integers without rounding, so that they are the same everywhere too.
 */
#include <inttypes.h>
#include <stdlib.h>

#include "exact.h"
#include "tap.h"

enum { BUILDS = 1500, SAMPLES = 4, DIGESTS_MAX = 1024 };

/* ---- Digests ---- */

static struct digest {
    char name[96];
    uint64_t value;
} digests[DIGESTS_MAX];

static size_t digest_count;
static size_t number_count, nan_count;
static const char *traced; /* the name of the digest to trace, or NULL */

static struct digest *find_digest(const char *name)
{
    size_t i;

    for (i = 0; i < digest_count; i++)
        if (strcmp(digests[i].name, name) == 0)
            return &digests[i];
    return NULL;
}

static struct digest *open_digest(const char *where, const char *what)
{
    char name[sizeof digests->name];
    struct digest *d;

    snprintf(name, sizeof name, "%s, %s", where, what);
    d = find_digest(name);
    if (!d) {
        if (digest_count == DIGESTS_MAX)
            abort();
        d = &digests[digest_count++];
        memcpy(d->name, name, sizeof name);
        d->value = 0xcbf29ce484222325u;
    }
    return d;
}

/* FNV-1a on words, whose upper half is mixed in as well. */
static void add_word(struct digest *d, const char *label, uint64_t word)
{
    d->value = (d->value ^ word) * 0x100000001b3u;
    d->value ^= d->value >> 32;
    if (traced && strcmp(traced, d->name) == 0)
        printf("%s %016" PRIx64 "\n", label, word);
}

static void add_number(struct digest *d, const char *label, double x)
{
    uint64_t bits = 0x7ff8000000000000u; /* any NaN */

    number_count++;
    nan_count += x != x;
    if (x == x)
        memcpy(&bits, &x, sizeof bits);
    add_word(d, label, bits);
}

static void add_numbers(struct digest *d, const char *label, const double *x, int n)
{
    int i;

    for (i = 0; i < n; i++)
        add_number(d, label, x[i]);
}

/* ---- Inputs ---- */

/* A coordinate of the unit square. */
static double make_coordinate(uint64_t *state)
{
    static const double edges[] = {0.0, 1.0, 0.5, 0x1p-1074, 0x1p-126, 0x1p-60, 1 - 0x1p-53,
                                   1 - 0x1p-24};

    switch (random_below(state, 6)) {
    case 0: return edges[random_below(state, 8)];
    case 1: return random_uniform(state) * power_of_two(-random_below(state, 60));
    default: return random_uniform(state);
    }
}

/* ---- Results ---- */

static void add_answers(struct digest *d, const psc_sampler *sampler)
{
    psc_result (*const questions[])(const psc_sampler *, double *) = {
        psc_sampler_total, psc_sampler_solid_angle, psc_sampler_projected_solid_angle,
        psc_sampler_form_factor, psc_sampler_area};
    psc_description description = {sizeof description, 0, 0, 0, 0, 0};
    size_t i;

    psc_sampler_describe(sampler, &description);
    add_word(d, "case", description.visibility);
    for (i = 0; i < sizeof questions / sizeof *questions; i++) {
        double value = 0.0;

        add_word(d, "answer", (uint64_t)questions[i](sampler, &value));
        add_number(d, "value", value);
    }
}

/* The density and place of a direction, which may be one of another light. */
static void add_direction(struct digest *pdf, struct digest *inverse, int bits,
                          const psc_sampler *sampler, const double direction[3])
{
    double value = 0.0, uv[2] = {0.0, 0.0};

    add_word(pdf, "result", (uint64_t)pdf_any(bits, sampler, direction, &value));
    add_number(pdf, "pdf", value);
    add_word(inverse, "result", (uint64_t)invert_any(bits, sampler, direction, uv));
    add_numbers(inverse, "uv", uv, 2);
}

/* The other direction is one of a sample before. */
static void add_samples(const char *where, int bits, uint64_t *state, const psc_sampler *sampler,
                        double other[3])
{
    struct digest *sample = open_digest(where, bits == 64 ? "sample f64" : "sample f32");
    struct digest *pdf = open_digest(where, bits == 64 ? "pdf f64" : "pdf f32");
    struct digest *inverse = open_digest(where, bits == 64 ? "inverse f64" : "inverse f32");
    psc_light_sample_f64 s;
    int i;

    for (i = 0; i < SAMPLES; i++) {
        const double u = make_coordinate(state), v = make_coordinate(state);
        psc_result result;

        memset(&s, 0, sizeof s);
        result = sample_any(bits, sampler, u, v, &s);
        add_word(sample, "result", (uint64_t)result);
        add_numbers(sample, "direction", s.direction, 3);
        add_number(sample, "pdf", s.pdf);
        add_numbers(sample, "point", s.point, 3);
        add_number(sample, "distance", s.distance);
        add_numbers(sample, "normal", s.normal, 3);
        add_number(sample, "weight", s.weight);
        add_numbers(sample, "surface", s.surface, 2);
        add_direction(pdf, inverse, bits, sampler, other);
        if (result == PSC_SUCCESS || result == PSC_CULLED) {
            add_direction(pdf, inverse, bits, sampler, s.direction);
            memcpy(other, s.direction, sizeof s.direction);
        }
    }
}

static void digest_technique(const struct shape *shape, const struct test_technique *what)
{
    uint64_t state = 20180701;
    struct test_sampler memory;
    psc_sampler *sampler = make_sampler(&memory);
    double wide[3] = {0.0, 0.6, 0.8}, narrow[3] = {0.0, 0.6, 0.8};
    char where[60];
    int i;

    snprintf(where, sizeof where, "%s of %ss", what->name, shape->name);
    for (i = 0; i < BUILDS; i++) {
        struct digest *d = open_digest(where, "build");
        struct light light;
        psc_result result;

        exact_light(&state, shape, what, &light);
        if (!light.has_normal && !is_offered(what, FACING_NONE))
            light.has_normal = i % 8 > 0; /* this measure needs a normal */
        result = build_light(sampler, &light);
        add_word(d, "result", (uint64_t)result);
        if (result != PSC_SUCCESS)
            continue;
        add_answers(d, sampler);
        add_samples(where, 64, &state, sampler, wide);
        add_samples(where, 32, &state, sampler, narrow);
    }
}

/* The functions without a sampler. */
static void digest_questions(const struct shape *shape)
{
    uint64_t state = 20180702;
    char where[60];
    struct digest *d;
    int i;

    snprintf(where, sizeof where, "%ss", shape->name);
    d = open_digest(where, "answers without a sampler");
    for (i = 0; i < BUILDS; i++) {
        struct light light;
        psc_receiver receiver;
        double values[2] = {0.0, 0.0};

        exact_light(&state, shape, shape->techniques, &light);
        light.has_normal = 1;
        receiver = light_receiver(&light);
        add_word(d, "result",
                 (uint64_t)shape->solid_angle(light.position, light.geometry, values));
        if (shape->form_factor)
            add_word(d, "result",
                     (uint64_t)shape->form_factor(&receiver, light.geometry, values + 1));
        add_numbers(d, "value", values, 2);
    }
}

/* ---- The stored digests: lines of value and name ---- */

static int record(const char *path)
{
    FILE *file = fopen(path, "w");
    size_t i;

    for (i = 0; file && i < digest_count; i++)
        fprintf(file, "%016" PRIx64 " %s\n", digests[i].value, digests[i].name);
    if (!file || fclose(file) != 0) {
        perror(path);
        return 1;
    }
    return 0;
}

static int compare(const char *path)
{
    FILE *file = fopen(path, "r");
    char line[160];
    size_t stored = 0;

    while (file && fgets(line, sizeof line, file)) {
        char *name;
        const uint64_t value = strtoull(line, &name, 16);
        const struct digest *d;

        name += *name == ' ';
        name[strcspn(name, "\r\n")] = '\0';
        d = find_digest(name);
        stored++;
        if (!tap_ok(d && d->value == value, "%s", name))
            tap_note("    %016" PRIx64 ", stored is %016" PRIx64, d ? d->value : 0, value);
    }
    tap_ok(nan_count == 0, "%zu of %zu numbers are NaN", nan_count, number_count);
    tap_ok(stored == digest_count, "%zu digests, %zu stored", digest_count, stored);
    if (file)
        fclose(file);
    return tap_done();
}

int main(int argc, char **argv)
{
    const char *option = argc == 3 ? argv[1] : "";
    const struct test_technique *what;
    int i;

    if (argc != 2 && strcmp(option, "--record") != 0 && strcmp(option, "--trace") != 0) {
        fprintf(stderr, "usage: %s [--record] FILE | --trace NAME\n", argv[0]);
        return 2;
    }
    if (strcmp(option, "--trace") == 0)
        traced = argv[2];
    for (i = 0; shapes[i]; i++) {
        for (FOR_TECHNIQUES(shapes[i], what))
            digest_technique(shapes[i], what);
        digest_questions(shapes[i]);
    }
    if (traced)
        return find_digest(traced) == NULL;
    return strcmp(option, "--record") == 0 ? record(argv[2]) : compare(argv[1]);
}
