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

#include "calls.h"
#include "random.h"
#include "tap.h"

enum { BUILDS = 1500, SAMPLES = 4, DIGESTS_MAX = 256 };

/* ---- Digests ---- */

static struct digest {
    char name[80];
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

/* 2^exponent for an exponent of a normal number. */
static double power_of_two(int exponent)
{
    const uint64_t bits = (uint64_t)(exponent + 1023) << 52;
    double x;

    memcpy(&x, &bits, sizeof x);
    return x;
}

static int64_t square_root(int64_t x)
{
    int64_t root = 0, bit = (int64_t)1 << 31;

    for (; bit > 0; bit >>= 1)
        if ((root | bit) * (root | bit) <= x)
            root |= bit;
    return root;
}

/* From -n to n. */
static int64_t around(uint64_t *state, int64_t n)
{
    return (int64_t)(random_bits(state) % (uint64_t)(2 * n + 1)) - n;
}

/* A light in units of a power of two. */
struct integers {
    int64_t position[3], offset[3], normal[3], radius;
};

/* A radius for a sphere whose centre is this far away. */
static int64_t some_radius(uint64_t *state, int64_t distance)
{
    int64_t part = distance / 4096 * (int64_t)(random_bits(state) % 4096);

    switch (random_below(state, 8)) {
    case 0: return distance + part;                           /* around the receiver */
    case 1: return distance + around(state, 2);               /* touching it */
    case 2: return distance - (distance >> random_below(state, 28)); /* close to it */
    case 3: return distance >> random_below(state, 28);       /* far away */
    default: return part;
    }
}

/* Anything at all. */
static void make_general(uint64_t *state, struct integers *s)
{
    const int shift = random_below(state, 20);
    int64_t squares = 0;
    int i;

    for (i = 0; i < 3; i++) {
        s->position[i] = around(state, 1 << 20);
        s->offset[i] = around(state, 1 << (9 + shift));
        s->normal[i] = around(state, 1 << 20);
        squares += s->offset[i] * s->offset[i];
    }
    s->normal[random_below(state, 3)] |= 1;
    s->radius = some_radius(state, square_root(squares));
}

/* Exactly on the boundaries between the cases, and one unit beside them. */
static void make_boundary(uint64_t *state, struct integers *s)
{
    static const int64_t sides[5][3] = {
        {3, 4, 5}, {5, 12, 13}, {8, 15, 17}, {20, 21, 29}, {1, 0, 1}};
    const int64_t *side = sides[random_below(state, 5)], unit = 1 + around(state, 1 << 20) / 2 * 2;
    const int axis = random_below(state, 3);
    const int64_t distance = side[2] * (unit < 0 ? -unit : unit);
    int64_t height;
    int i;

    for (i = 0; i < 3; i++) {
        s->position[i] = around(state, 1 << 20);
        s->normal[i] = 0;
    }
    s->normal[axis] = around(state, 1) * 2 + 1;
    s->offset[(axis + 1) % 3] = side[0] * unit;
    s->offset[(axis + 2) % 3] = side[1] * unit;
    s->radius = some_radius(state, distance);
    switch (random_below(state, 6)) {
    case 0: height = 0; break;
    case 1: height = around(state, 1); break;
    case 2: height = s->radius + around(state, 1); break;
    case 3: height = -s->radius + around(state, 1); break;
    case 4: height = around(state, s->radius < 1 ? 1 : s->radius); break;
    default: height = -s->radius + (s->radius >> random_below(state, 24)); break;
    }
    s->offset[axis] = height;
    if (random_below(state, 16) == 0) /* straight overhead */
        s->offset[(axis + 1) % 3] = s->offset[(axis + 2) % 3] = 0;
}

struct light {
    double position[3], normal[3], center[3], radius, axis[3], half_angle;
    int facing; /* without a normal, one-sided, two-sided */
};

static void make_light(uint64_t *state, struct light *light)
{
    static const double angles[] = {0x1.921fb54442d18p+0, 0x1.921fb54442d18p+1, 1.0, 0x1p-20,
                                    0x1.921fb54442d17p+0, 0x1.8p+0, 2.0, 0x1p-45};
    struct integers s;
    double scale, normal_scale;
    int i;

    if (random_below(state, 2))
        make_general(state, &s);
    else
        make_boundary(state, &s);
    scale = power_of_two(random_below(state, 80) - 60);
    normal_scale = power_of_two(random_below(state, 80) - 60);
    for (i = 0; i < 3; i++) {
        light->position[i] = (double)s.position[i] * scale;
        light->center[i] = (double)(s.position[i] + s.offset[i]) * scale;
        light->normal[i] = (double)s.normal[i] * normal_scale;
        light->axis[i] = (double)s.offset[i] * normal_scale;
    }
    light->radius = (double)s.radius * scale;
    light->half_angle = random_below(state, 3) == 0
                            ? angles[random_below(state, 8)]
                            : (double)(random_bits(state) >> 11) *
                                  power_of_two(-52 - random_below(state, 30));
    light->facing = random_below(state, 3);
}

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

static void add_samples(const char *where, int bits, uint64_t *state, const psc_sampler *sampler)
{
    static double other[2][3] = {{0.0, 0.6, 0.8}, {0.0, 0.6, 0.8}}; /* a direction seen before */
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
        add_direction(pdf, inverse, bits, sampler, other[bits == 64]);
        if (result == PSC_SUCCESS || result == PSC_CULLED) {
            add_direction(pdf, inverse, bits, sampler, s.direction);
            memcpy(other[bits == 64], s.direction, sizeof s.direction);
        }
    }
}

static void digest_technique(const struct test_technique *what, int distant)
{
    uint64_t state = 20180701;
    struct test_sampler memory;
    psc_sampler *sampler = make_sampler(&memory);
    char where[60];
    int i;

    snprintf(where, sizeof where, "%s of %s", what->name, distant ? "caps" : "spheres");
    for (i = 0; i < BUILDS; i++) {
        struct digest *d = open_digest(where, "build");
        struct light light;
        const double *normal;
        uint32_t flags;
        psc_result result;

        make_light(&state, &light);
        if (what->measure == PSC_MEASURE_PROJECTED_SOLID_ANGLE && light.facing == 0)
            light.facing = i % 8 > 0; /* this measure needs a normal */
        normal = light.facing > 0 ? light.normal : NULL;
        flags = light.facing == 2 ? PSC_RECEIVER_TWO_SIDED : 0;
        result = distant ? build_cap(sampler, what, flags, normal, light.axis, light.half_angle)
                         : build_sphere(sampler, what, flags, light.position, normal,
                                        light.center, light.radius);
        add_word(d, "result", (uint64_t)result);
        if (result != PSC_SUCCESS)
            continue;
        add_answers(d, sampler);
        add_samples(where, 64, &state, sampler);
        add_samples(where, 32, &state, sampler);
    }
}

/* The functions without a sampler. */
static void digest_questions(void)
{
    struct digest *d = open_digest("without a sampler", "answers");
    uint64_t state = 20180702;
    int i;

    for (i = 0; i < BUILDS; i++) {
        struct light light;
        psc_receiver receiver;
        double values[4] = {0.0, 0.0, 0.0, 0.0};

        make_light(&state, &light);
        receiver = make_receiver(light.position, light.normal,
                                 light.facing == 2 ? PSC_RECEIVER_TWO_SIDED : 0);
        add_word(d, "result", (uint64_t)psc_sphere_solid_angle(light.position, light.center,
                                                               light.radius, values));
        add_word(d, "result", (uint64_t)psc_sphere_form_factor(&receiver, light.center,
                                                               light.radius, values + 1));
        add_word(d, "result", (uint64_t)psc_cap_solid_angle(light.half_angle, values + 2));
        add_word(d, "result", (uint64_t)psc_cap_form_factor(&receiver, light.axis,
                                                            light.half_angle, values + 3));
        add_numbers(d, "value", values, 4);
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
    char line[128];
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
    int t, distant;

    if (argc != 2 && strcmp(option, "--record") != 0 && strcmp(option, "--trace") != 0) {
        fprintf(stderr, "usage: %s [--record] FILE | --trace NAME\n", argv[0]);
        return 2;
    }
    if (strcmp(option, "--trace") == 0)
        traced = argv[2];
    for (t = 0; t < TEST_TECHNIQUES; t++)
        for (distant = 0; distant <= test_techniques[t].distant; distant++)
            digest_technique(&test_techniques[t], distant);
    digest_questions();
    if (traced)
        return find_digest(traced) == NULL;
    return strcmp(option, "--record") == 0 ? record(argv[2]) : compare(argv[1]);
}
