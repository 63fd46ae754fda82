/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Every kind of bad input to a build: the exact error, and a sampler that is empty and safe
 * afterwards, whatever it held before. Nothing is printed by any of it.
 */
#include <float.h>
#include <unistd.h>

#include "lights.h"
#include "tap.h"

static const double origin[3] = {0.0, 0.0, 0.0}, up[3] = {0.0, 0.0, 1.0};
static const double center[3] = {1.0, 2.0, 3.0};

static int quiet;

static void check(int ok, const char *what, const char *why)
{
    if (!quiet)
        tap_ok(ok, "%s: %s", what, why);
}

/* ---- An empty sampler */

static int untouched(const void *memory, size_t size)
{
    const unsigned char *byte = memory;
    size_t i;

    for (i = 0; i < size; i++)
        if (byte[i] != 0xa5)
            return 0;
    return 1;
}

static int empty_f64(const psc_sampler *s)
{
    psc_light_sample_f64 sample;
    double uv[2], pdf = 1.0;
    int ok;

    memset(&sample, 0xa5, sizeof sample);
    memset(uv, 0xa5, sizeof uv);
    ok = psc_sample_f64(s, 0.3, 0.7, &sample) == PSC_EMPTY && untouched(&sample, sizeof sample);
    ok &= psc_invert_f64(s, up, uv) == PSC_EMPTY && untouched(uv, sizeof uv);
    ok &= psc_pdf_f64(s, up, &pdf) == PSC_EMPTY && pdf == 0.0;
    return ok;
}

static int empty_f32(const psc_sampler *s)
{
    static const float upwards[3] = {0.0f, 0.0f, 1.0f};
    psc_light_sample_f32 sample;
    float uv[2], pdf = 1.0f;
    int ok;

    memset(&sample, 0xa5, sizeof sample);
    memset(uv, 0xa5, sizeof uv);
    ok = psc_sample_f32(s, 0.3f, 0.7f, &sample) == PSC_EMPTY && untouched(&sample, sizeof sample);
    ok &= psc_invert_f32(s, upwards, uv) == PSC_EMPTY && untouched(uv, sizeof uv);
    ok &= psc_pdf_f32(s, upwards, &pdf) == PSC_EMPTY && pdf == 0.0f;
    return ok;
}

/* Three elements of every array call. */
static int empty_arrays(const psc_sampler *s)
{
    double uv[6] = {0.1, 0.2, 0.3, 0.4, 0.5, 0.6}, places[6], pdf[3] = {1.0, 1.0, 1.0};
    double direction[9] = {0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0}, points[9];
    psc_result status[3] = {7, 7, 7};
    psc_input_f64 in_uv = {{uv, uv + 1, NULL}, 2 * sizeof(double)};
    psc_input_f64 in_direction = {{direction, direction + 1, direction + 2}, 3 * sizeof(double)};
    psc_output_f64 out_pdf = {{pdf, NULL, NULL}, sizeof(double)};
    psc_output_f64 out_uv = {{places, places + 1, NULL}, 2 * sizeof(double)};
    psc_output_result out_status = {status, sizeof(psc_result)};
    psc_samples_f64 samples;
    int ok, i;

    memset(&samples, 0, sizeof samples);
    samples.struct_size = sizeof samples;
    for (i = 0; i < 3; i++)
        samples.point.component[i] = points + i;
    samples.point.stride = 3 * sizeof(double);
    samples.status = out_status;
    memset(points, 0xa5, sizeof points);
    memset(places, 0xa5, sizeof places);
    ok = psc_sample_n_f64(s, 3, &in_uv, &samples) == PSC_EMPTY && untouched(points, sizeof points);
    for (i = 0; i < 3; i++)
        ok &= status[i] == PSC_EMPTY;
    memset(status, 0, sizeof status);
    ok &= psc_invert_n_f64(s, 3, &in_direction, &out_uv, &out_status) == PSC_EMPTY &&
          untouched(places, sizeof places);
    ok &= psc_pdf_n_f64(s, 3, &in_direction, &out_pdf) == PSC_EMPTY;
    for (i = 0; i < 3; i++)
        ok &= status[i] == PSC_EMPTY && pdf[i] == 0.0;
    return ok;
}

static int empty_questions(const psc_sampler *s, int built)
{
    psc_description d;
    double total = 1.0, value;
    int ok;

    memset(&d, 0xa5, sizeof d);
    d.struct_size = sizeof d;
    ok = psc_sampler_describe(s, &d) == PSC_EMPTY && d.visibility == PSC_CASE_EMPTY &&
         d.reserved == 0 && (d.shape == PSC_SHAPE_NONE) == !built;
    ok &= psc_sampler_total(s, &total) == PSC_EMPTY && total == 0.0;
    if (!built) {
        value = 1.0;
        ok &= psc_sampler_solid_angle(s, &value) == PSC_EMPTY && value == 0.0;
        value = 1.0;
        ok &= psc_sampler_projected_solid_angle(s, &value) == PSC_EMPTY && value == 0.0;
        value = 1.0;
        ok &= psc_sampler_form_factor(s, &value) == PSC_EMPTY && value == 0.0;
        value = 1.0;
        ok &= psc_sampler_area(s, &value) == PSC_EMPTY && value == 0.0;
    }
    return ok;
}

static int is_empty(const psc_sampler *s, int built)
{
    return empty_f64(s) && empty_f32(s) && empty_arrays(s) && empty_questions(s, built);
}

/* ---- Builds with one thing wrong */

struct input {
    psc_technique technique;
    psc_receiver receiver;
    double position[3], normal[3], center[3], size;
};

static void good_input(struct input *in, psc_measure measure)
{
    in->technique = make_technique(measure, PSC_MAP_RADIAL);
    memcpy(in->position, origin, sizeof origin);
    memcpy(in->normal, up, sizeof up);
    memcpy(in->center, center, sizeof center);
    in->receiver = make_receiver(in->position, in->normal, 0);
    in->size = 0.5;
}

typedef psc_result build_call(psc_sampler *, const psc_technique *, const psc_receiver *,
                              const double *, double);

static const struct shape {
    const char *name;
    build_call *build;
} shapes[2] = {{"sphere", psc_build_sphere}, {"cap", psc_build_cap}};

/* The build gives the result, and leaves nothing of a light that was there before. */
static void expect(const struct shape *shape, const char *what, const psc_technique *technique,
                   const psc_receiver *receiver, const double *where, double size,
                   psc_result expected)
{
    struct test_sampler s;
    struct input good;
    psc_result result;
    char name[160];

    good_input(&good, PSC_MEASURE_SOLID_ANGLE);
    make_sampler(&s);
    snprintf(name, sizeof name, "%s, %s", shape->name, what);
    check(shape->build(s.sampler, &good.technique, &good.receiver, good.center, good.size) ==
              PSC_SUCCESS, name, "a light is there before");
    result = shape->build(s.sampler, technique, receiver, where, size);
    check(result == expected, name, psc_result_string(expected));
    if (result != expected && !quiet)
        tap_note("    got %d: %s", (int)result, psc_result_string(result));
    if (expected != PSC_SUCCESS)
        check(is_empty(s.sampler, expected == PSC_EMPTY), name, "then empty and safe");
}

static void expect_input(const struct shape *shape, const char *what, const struct input *in,
                         psc_result expected)
{
    expect(shape, what, &in->technique, &in->receiver, in->center, in->size, expected);
}

static void pointers(const struct shape *shape)
{
    struct input in;
    const psc_result bad = PSC_ERROR_NULL_POINTER;

    good_input(&in, PSC_MEASURE_SOLID_ANGLE);
    expect(shape, "no technique", NULL, &in.receiver, in.center, in.size, bad);
    expect(shape, "no receiver", &in.technique, NULL, in.center, in.size, bad);
    expect(shape, "no center or axis", &in.technique, &in.receiver, NULL, in.size, bad);
    in.receiver.position = NULL;
    expect_input(shape, "no position", &in, bad);
    good_input(&in, PSC_MEASURE_SOLID_ANGLE);
    check(shape->build(NULL, &in.technique, &in.receiver, in.center, in.size) == bad,
          shape->name, "no sampler");
}

static void numbers(const struct shape *shape)
{
    static const double bad[3] = {NAN, INFINITY, -INFINITY};
    struct input in;
    char what[80];
    int i, j, field;

    for (field = 0; field < 3; field++)
        for (i = 0; i < 3; i++)
            for (j = 0; j < 3; j++) {
                good_input(&in, PSC_MEASURE_PROJECTED_SOLID_ANGLE);
                (field == 0 ? in.position : field == 1 ? in.normal : in.center)[i] = bad[j];
                snprintf(what, sizeof what, "%g in %s[%d]", bad[j],
                         field == 0 ? "position" : field == 1 ? "normal" : "center or axis", i);
                expect_input(shape, what, &in, PSC_ERROR_NOT_FINITE);
            }
    for (j = 0; j < 3; j++) {
        good_input(&in, PSC_MEASURE_SOLID_ANGLE);
        in.size = bad[j];
        snprintf(what, sizeof what, "radius or half-angle %g", bad[j]);
        expect_input(shape, what, &in, PSC_ERROR_NOT_FINITE);
    }
    good_input(&in, PSC_MEASURE_SOLID_ANGLE);
    memset(in.normal, 0, sizeof in.normal);
    expect_input(shape, "zero normal", &in, PSC_ERROR_ZERO_VECTOR);
    in.normal[1] = -0.0;
    expect_input(shape, "minus zero normal", &in, PSC_ERROR_ZERO_VECTOR);
    good_input(&in, PSC_MEASURE_SOLID_ANGLE);
    in.size = -1e-300;
    expect_input(shape, "negative radius or half-angle", &in, PSC_ERROR_NEGATIVE_SIZE);
    in.size = -DBL_TRUE_MIN;
    expect_input(shape, "negative radius or half-angle", &in, PSC_ERROR_NEGATIVE_SIZE);
    in.size = 0.0;
    expect_input(shape, "zero radius or half-angle", &in, PSC_EMPTY);
    in.size = -0.0;
    expect_input(shape, "minus zero radius or half-angle", &in, PSC_EMPTY);
    good_input(&in, PSC_MEASURE_PROJECTED_SOLID_ANGLE);
    in.receiver.normal = NULL;
    expect_input(shape, "projected without a normal", &in, PSC_ERROR_NEEDS_NORMAL);
    good_input(&in, PSC_MEASURE_PROJECTED_SOLID_ANGLE);
    in.center[2] = -3.0;
    expect_input(shape, "below the horizon, projected", &in, PSC_EMPTY);
    in.technique.measure = PSC_MEASURE_SOLID_ANGLE;
    expect_input(shape, "below the horizon, solid angle", &in, PSC_EMPTY);
}

static void techniques(const struct shape *shape)
{
    static const uint32_t bad[3] = {4, 1000, UINT32_MAX};
    struct input in;
    char what[80];
    uint32_t measure, map;
    int i;

    for (i = 0; i < 3; i++) {
        good_input(&in, bad[i]);
        expect_input(shape, "unknown measure", &in, PSC_ERROR_UNKNOWN_MEASURE);
        good_input(&in, PSC_MEASURE_SOLID_ANGLE);
        in.technique.map = bad[i] - 1;
        expect_input(shape, "unknown map", &in, PSC_ERROR_UNKNOWN_MAP);
        good_input(&in, PSC_MEASURE_SOLID_ANGLE);
        in.technique.flags = bad[i] & ~(uint32_t)PSC_TECHNIQUE_ONE_SIDED;
        expect_input(shape, "unknown technique flag", &in, PSC_ERROR_UNKNOWN_FLAG);
        in.technique.flags = 0;
        in.receiver.flags = bad[i];
        expect_input(shape, "unknown receiver flag", &in, PSC_ERROR_UNKNOWN_FLAG);
    }
    for (measure = 0; measure < 4; measure++)
        for (map = 0; map < 3; map++) {
            psc_result expected = PSC_ERROR_UNSUPPORTED_TECHNIQUE;

            for (i = 0; i < TEST_TECHNIQUES; i++)
                if (test_techniques[i].measure == measure && test_techniques[i].map == map &&
                    (test_techniques[i].distant || shape->build == psc_build_sphere))
                    expected = PSC_SUCCESS;
            good_input(&in, measure);
            in.technique.map = map;
            snprintf(what, sizeof what, "measure %u, map %u", (unsigned)measure, (unsigned)map);
            expect_input(shape, what, &in, expected);
        }
}

/* Sizes of descriptions: too short, and as a later version may have them. */
static void sizes(const struct shape *shape)
{
    struct { psc_technique t; uint64_t more[2]; } technique = {{0, 0, 0, 0}, {0, 0}};
    struct { psc_receiver r; uint64_t more[2]; } receiver = {{0, 0, NULL, NULL}, {0, 0}};
    struct input in;
    uint32_t size;

    good_input(&in, PSC_MEASURE_SOLID_ANGLE);
    technique.t = in.technique;
    receiver.r = in.receiver;
    for (size = 0; size <= 8192; size += size < 64 ? 1 : 4096 - 64 + 1) {
        psc_result expected = size < sizeof technique.t || size > 4096 ? PSC_ERROR_STRUCT_SIZE
                                                                       : PSC_SUCCESS;
        if (size > sizeof technique && size <= 4096)
            continue; /* more than there is here */
        technique.t.struct_size = size;
        expect(shape, "technique.struct_size", &technique.t, &in.receiver, in.center, in.size,
               expected);
    }
    for (size = 0; size <= 8192; size += size < 64 ? 1 : 4096 - 64 + 1) {
        psc_result expected = size < sizeof receiver.r || size > 4096 ? PSC_ERROR_STRUCT_SIZE
                                                                      : PSC_SUCCESS;
        if (size > sizeof receiver && size <= 4096)
            continue;
        receiver.r.struct_size = size;
        expect(shape, "receiver.struct_size", &in.technique, &receiver.r, in.center, in.size,
               expected);
    }
    technique.t.struct_size = sizeof technique;
    receiver.r.struct_size = sizeof receiver;
    technique.more[1] = (uint64_t)1 << 56;
    expect(shape, "a later technique's field", &technique.t, &in.receiver, in.center, in.size,
           PSC_ERROR_UNKNOWN_FIELD);
    receiver.more[0] = 1;
    expect(shape, "a later receiver's field", &in.technique, &receiver.r, in.center, in.size,
           PSC_ERROR_UNKNOWN_FIELD);
}

static void half_angles(void)
{
    static const double pi = 0x1.921fb54442d18p+1, right = 0x1.921fb54442d18p+0;
    const struct shape *cap = &shapes[1];
    struct input in;

    good_input(&in, PSC_MEASURE_SOLID_ANGLE);
    in.size = pi;
    expect_input(cap, "half-angle pi", &in, PSC_SUCCESS);
    in.size = nextafter(pi, 4.0);
    expect_input(cap, "half-angle above pi", &in, PSC_ERROR_HALF_ANGLE);
    in.size = DBL_MAX;
    expect_input(cap, "half-angle far above pi", &in, PSC_ERROR_HALF_ANGLE);
    good_input(&in, PSC_MEASURE_PROJECTED_SOLID_ANGLE);
    in.size = right;
    expect_input(cap, "right half-angle, projected", &in, PSC_SUCCESS);
    in.size = nextafter(right, 4.0);
    expect_input(cap, "half-angle above a right one, projected", &in, PSC_ERROR_HALF_ANGLE);
    good_input(&in, PSC_MEASURE_SOLID_ANGLE);
    memset(in.center, 0, sizeof in.center);
    expect_input(cap, "zero axis", &in, PSC_ERROR_ZERO_VECTOR);
}

static void all_builds(void)
{
    size_t i;

    for (i = 0; i < 2; i++) {
        pointers(&shapes[i]);
        numbers(&shapes[i]);
        techniques(&shapes[i]);
        sizes(&shapes[i]);
    }
    half_angles();
}

/* ---- Sampling */

/* A coordinate that is none gives some direction or other, and reads and writes nothing else. */
static void coordinates(void)
{
    static const double bad[] = {NAN, INFINITY, -INFINITY, -1.0, 2.0, 1e300, -1e300};
    uint64_t seed = 50;
    size_t i, j;
    int n, k;

    for (n = 0; n < TEST_TECHNIQUES; n++)
        for (k = 0; k < 20; k++) {
            struct test_sampler s;
            struct light light;

            random_light(&seed, &test_techniques[n], &light);
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
    check(1, "coordinates outside the square", "no crash");
}

/* ---- Silence */

static void everything(void)
{
    all_builds();
    coordinates();
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
