/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Every kind of bad input to a build: the exact error, and a sampler that is empty and safe
 * afterwards, whatever it held before. Nothing is printed by any of it.
 */
#include <float.h>
#include <unistd.h>

#include "empty.h"
#include "shapes.h"
#include "tap.h"

static int quiet;

static void check(int ok, const char *what, const char *why)
{
    if (!quiet)
        tap_ok(ok, "%s: %s", what, why);
}

/* ---- Builds with one thing wrong */

/* What a build is given, to have one thing put wrong. */
struct input {
    struct light light;
    psc_technique technique;
    psc_receiver receiver;
};

/* The same light every time, wholly above the horizon. */
static void good_input(const struct shape *shape, const struct test_technique *what,
                       struct input *in)
{
    uint64_t seed = 1;

    place_light(&seed, shape, what, PLACE_ORDINARY, HORIZON_ABOVE, FACING_ONE, &in->light);
    in->technique = light_technique(&in->light);
    in->receiver = light_receiver(&in->light);
}

/* The build gives the result, and leaves nothing of a light that was there before. */
static void expect(const char *what, const struct input *in, const psc_technique *technique,
                   const psc_receiver *receiver, psc_result expected)
{
    const struct shape *shape = in->light.shape;
    struct test_sampler s;
    struct input good;
    psc_result result;
    char name[200];

    good_input(shape, shape->techniques, &good);
    make_sampler(&s);
    snprintf(name, sizeof name, "%s, %s", shape->name, what);
    check(build_light(s.sampler, &good.light) == PSC_SUCCESS, name, "a light is there before");
    result = shape->build(s.sampler, technique, receiver, in->light.geometry);
    check(result == expected, name, psc_result_string(expected));
    if (result != expected && !quiet)
        tap_note("    got %d: %s", (int)result, psc_result_string(result));
    if (expected != PSC_SUCCESS)
        check(is_empty(s.sampler, expected == PSC_EMPTY), name, "then empty and safe");
}

static void expect_input(const char *what, const struct input *in, psc_result expected)
{
    expect(what, in, &in->technique, &in->receiver, expected);
}

static void pointers(const struct shape *shape)
{
    struct input in;
    const psc_result bad = PSC_ERROR_NULL_POINTER;

    good_input(shape, shape->techniques, &in);
    expect("no technique", &in, NULL, &in.receiver, bad);
    expect("no receiver", &in, &in.technique, NULL, bad);
    in.receiver.position = NULL;
    expect_input("no position", &in, bad);
    good_input(shape, shape->techniques, &in);
    check(shape->build(NULL, &in.technique, &in.receiver, in.light.geometry) == bad, shape->name,
          "no sampler");
}

/* Numbers that are none, in every place. */
static void not_finite(const struct shape *shape, const struct test_technique *what)
{
    static const double bad[3] = {NAN, INFINITY, -INFINITY};
    struct input in;
    char words[80];
    int i, j, field;

    for (field = 0; field < 3; field++)
        for (i = 0; i < (field == 2 ? geometry_size(shape) : 3); i++)
            for (j = 0; j < 3; j++) {
                good_input(shape, what, &in);
                (field == 0   ? in.light.position
                 : field == 1 ? in.light.normal
                              : in.light.geometry)[i] = bad[j];
                snprintf(words, sizeof words, "%g in %s[%d]", bad[j],
                         field == 0   ? "position"
                         : field == 1 ? "normal"
                                      : "geometry",
                         i);
                expect_input(words, &in, PSC_ERROR_NOT_FINITE);
            }
}

/* Directions of no length; sizes below zero, and zero. */
static void sizes_of_parts(const struct shape *shape)
{
    static const double sizes[4] = {-1e-300, -DBL_TRUE_MIN, 0.0, -0.0};
    struct input in;
    int i, k, at = 0;

    for (i = 0; shape->parts[i]; at += part_size(shape->parts[i++])) {
        good_input(shape, shape->techniques, &in);
        if (shape->parts[i] == 'd') {
            memset(in.light.geometry + at, 0, 3 * sizeof(double));
            expect_input("zero direction", &in, PSC_ERROR_ZERO_VECTOR);
            in.light.geometry[at + 1] = -0.0;
            expect_input("minus zero direction", &in, PSC_ERROR_ZERO_VECTOR);
        }
        for (k = 0; k < 4 && part_size(shape->parts[i]) == 1; k++) {
            in.light.geometry[at] = sizes[k];
            expect_input("size below or at zero", &in,
                         k < 2 ? PSC_ERROR_NEGATIVE_SIZE : PSC_EMPTY);
        }
    }
    good_input(shape, shape->techniques, &in);
    shrink_to_nothing(&in.light);
    expect_input("no size at all", &in, PSC_EMPTY);
}

static void normals(const struct shape *shape)
{
    const struct test_technique *what;
    struct input in;
    int i;

    good_input(shape, shape->techniques, &in);
    memset(in.light.normal, 0, sizeof in.light.normal);
    expect_input("zero normal", &in, PSC_ERROR_ZERO_VECTOR);
    in.light.normal[1] = -0.0;
    expect_input("minus zero normal", &in, PSC_ERROR_ZERO_VECTOR);
    for (FOR_TECHNIQUES(shape, what)) {
        good_input(shape, what, &in);
        in.receiver.normal = NULL;
        expect_input(what->name, &in,
                     is_offered(what, FACING_NONE) ? PSC_SUCCESS : PSC_ERROR_NEEDS_NORMAL);
        for (i = 0; i < 3; i++)
            in.light.normal[i] *= -1.0;
        in.receiver.normal = in.light.normal;
        expect_input("below the horizon", &in, PSC_EMPTY);
    }
}

/* What the library knows, and no more. */
enum { MEASURES = 4, MAPS = 5 };

static void techniques(const struct shape *shape)
{
    static const uint32_t bad[3] = {0, 1000, UINT32_MAX};
    struct input in;
    char words[80];
    uint32_t measure, map;
    int i;

    for (i = 0; i < 3; i++) {
        good_input(shape, shape->techniques, &in);
        in.technique.measure = bad[i] > 0 ? bad[i] : MEASURES;
        expect_input("unknown measure", &in, PSC_ERROR_UNKNOWN_MEASURE);
        good_input(shape, shape->techniques, &in);
        in.technique.map = bad[i] > 0 ? bad[i] : MAPS;
        expect_input("unknown map", &in, PSC_ERROR_UNKNOWN_MAP);
        good_input(shape, shape->techniques, &in);
        in.technique.flags = bad[i] > 0 ? bad[i] & ~(uint32_t)PSC_TECHNIQUE_ONE_SIDED : 2;
        expect_input("unknown technique flag", &in, PSC_ERROR_UNKNOWN_FLAG);
        in.technique.flags = 0;
        in.receiver.flags = bad[i] > 0 ? bad[i] : 2;
        expect_input("unknown receiver flag", &in, PSC_ERROR_UNKNOWN_FLAG);
    }
    for (measure = 0; measure < MEASURES; measure++)
        for (map = 0; map < MAPS; map++) {
            psc_result expected = PSC_ERROR_UNSUPPORTED_TECHNIQUE;
            const struct test_technique *what;

            for (FOR_TECHNIQUES(shape, what))
                if (what->measure == measure && what->map == map)
                    expected = PSC_SUCCESS;
            good_input(shape, shape->techniques, &in);
            in.technique.measure = measure;
            in.technique.map = map;
            in.technique.table = test_table();
            snprintf(words, sizeof words, "measure %u, map %u", (unsigned)measure, (unsigned)map);
            expect_input(words, &in, expected);
        }
}

/* Sizes of descriptions: too short, and as a later version may have them. */
static void sizes(const struct shape *shape)
{
    struct { psc_technique t; uint64_t more[2]; } technique = {{0, 0, 0, 0, NULL}, {0, 0}};
    struct { psc_receiver r; uint64_t more[2]; } receiver = {{0, 0, NULL, NULL}, {0, 0}};
    struct input in;
    uint32_t size;

    good_input(shape, shape->techniques, &in);
    technique.t = in.technique;
    receiver.r = in.receiver;
    for (size = 0; size <= 8192; size += size < 64 ? 1 : 4096 - 64 + 1) {
        if (size > sizeof technique && size <= 4096)
            continue; /* more than there is here */
        technique.t.struct_size = size;
        expect("technique.struct_size", &in, &technique.t, &in.receiver,
               size < sizeof technique.t || size > 4096 ? PSC_ERROR_STRUCT_SIZE : PSC_SUCCESS);
    }
    for (size = 0; size <= 8192; size += size < 64 ? 1 : 4096 - 64 + 1) {
        if (size > sizeof receiver && size <= 4096)
            continue;
        receiver.r.struct_size = size;
        expect("receiver.struct_size", &in, &in.technique, &receiver.r,
               size < sizeof receiver.r || size > 4096 ? PSC_ERROR_STRUCT_SIZE : PSC_SUCCESS);
    }
    technique.t.struct_size = sizeof technique;
    receiver.r.struct_size = sizeof receiver;
    technique.more[1] = (uint64_t)1 << 56;
    expect("a later technique's field", &in, &technique.t, &in.receiver, PSC_ERROR_UNKNOWN_FIELD);
    receiver.more[0] = 1;
    expect("a later receiver's field", &in, &in.technique, &receiver.r, PSC_ERROR_UNKNOWN_FIELD);
}

/* ---- What is wrong with parts of one shape ---- */

/* Parts that are no pointer at all. */
static void missing_parts(void)
{
    struct test_sampler s;
    struct input in;
    const psc_result bad = PSC_ERROR_NULL_POINTER;

    good_input(&shape_sphere, shape_sphere.techniques, &in);
    make_sampler(&s);
    check(psc_build_sphere(s.sampler, &in.technique, &in.receiver, NULL, 1.0) == bad &&
              is_empty(s.sampler, 0), "sphere", "no center");
    check(psc_build_cap(s.sampler, &in.technique, &in.receiver, NULL, 1.0) == bad &&
              is_empty(s.sampler, 0), "cap", "no axis");
}

static void half_angles(void)
{
    static const double pi = 0x1.921fb54442d18p+1, right = 0x1.921fb54442d18p+0;
    const struct test_technique *what;
    struct input in;

    for (FOR_TECHNIQUES(&shape_cap, what)) {
        const int projected = what->measure == PSC_MEASURE_PROJECTED_SOLID_ANGLE;
        const double most = projected ? right : pi;

        good_input(&shape_cap, what, &in);
        in.light.geometry[3] = most;
        expect_input("largest half-angle", &in, PSC_SUCCESS);
        in.light.geometry[3] = nextafter(most, 4.0);
        expect_input("half-angle above it", &in, PSC_ERROR_HALF_ANGLE);
        in.light.geometry[3] = DBL_MAX;
        expect_input("half-angle far above it", &in, PSC_ERROR_HALF_ANGLE);
    }
}

static void all_builds(void)
{
    const struct test_technique *what;
    size_t i;

    for (i = 0; shapes[i]; i++) {
        pointers(shapes[i]);
        for (FOR_TECHNIQUES(shapes[i], what))
            not_finite(shapes[i], what);
        sizes_of_parts(shapes[i]);
        normals(shapes[i]);
        techniques(shapes[i]);
        sizes(shapes[i]);
    }
    missing_parts();
    half_angles();
}

/* ---- Sampling */

/* A coordinate that is none gives some direction or other, and reads and writes nothing else. */
static void coordinates(const struct shape *shape, const struct test_technique *what)
{
    static const double bad[] = {NAN, INFINITY, -INFINITY, -1.0, 2.0, 1e300, -1e300};
    uint64_t seed = 50;
    size_t i, j;
    int k;

    for (k = 0; k < 20; k++) {
        struct test_sampler s;
        struct light light;

        random_light(&seed, shape, what, &light);
        if (build_light(make_sampler(&s), &light) != PSC_SUCCESS)
            continue;
        for (i = 0; i < sizeof bad / sizeof bad[0]; i++)
            for (j = 0; j < 3; j++) {
                double u = j == 1 ? 0.5 : bad[i], v = j == 0 ? 0.5 : bad[i];
                double direction[3] = {u, v, 0.5}, uv[2], pdf;
                psc_light_sample_f64 sample;
                int bits;

                for (bits = 32; bits <= 64; bits += 32) {
                    sample_any(bits, s.sampler, u, v, &sample);
                    pdf_any(bits, s.sampler, direction, &pdf);
                    invert_any(bits, s.sampler, direction, uv);
                }
            }
    }
}

/* ---- Silence */

static void everything(void)
{
    const struct test_technique *what;
    int i;

    all_builds();
    for (i = 0; shapes[i]; i++)
        for (FOR_TECHNIQUES(shapes[i], what))
            coordinates(shapes[i], what);
    check(1, "coordinates outside the square", "no crash");
}

int main(void)
{
    FILE *file = tmpfile();
    int out = dup(1), err = dup(2);
    long printed;

    if (!file || out < 0 || err < 0)
        return 99;
    fflush(stdout);
    dup2(fileno(file), 1);
    dup2(fileno(file), 2);
    quiet = 1;
    everything();
    fflush(stdout);
    printed = lseek(fileno(file), 0, SEEK_END);
    dup2(out, 1);
    dup2(err, 2);
    quiet = 0;
    everything();
    tap_ok(printed == 0, "nothing was printed");
    return tap_done();
}
