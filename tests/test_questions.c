/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Questions: what a sampler says of its light, what the functions without a sampler say, and
 * that both say the same; errors of the latter.
 */
#include "lights.h"
#include "worst.h"

static const double origin[3] = {0.0, 0.0, 0.0}, up[3] = {0.0, 0.0, 1.0};
static const double center[3] = {1.0, 2.0, 3.0};

static void expect_value(const char *what, psc_result result, psc_result expected,
                         const double *value, double left)
{
    tap_ok(result == expected, "%s: %s", what, psc_result_string(expected));
    tap_ok(expected < 0 ? *value == left : expected == PSC_EMPTY ? *value == 0.0 : *value > 0.0,
           "%s: %s is written", what, expected < 0 ? "nothing" : "the value");
}

static void handle_free(void)
{
    const double bad[3] = {0.0, NAN, 0.0}, far[3] = {0.0, INFINITY, 0.0};
    psc_receiver receiver = make_receiver(origin, up, 0);
    double v = 7.0;

    expect_value("sphere solid angle", psc_sphere_solid_angle(origin, center, 0.5, &v), 0, &v, 7.0);
    v = 7.0;
    expect_value("sphere solid angle, NULL",
                 psc_sphere_solid_angle(NULL, center, 0.5, &v), PSC_ERROR_NULL_POINTER, &v, 7.0);
    expect_value("sphere solid angle, NULL",
                 psc_sphere_solid_angle(origin, NULL, 0.5, &v), PSC_ERROR_NULL_POINTER, &v, 7.0);
    expect_value("sphere solid angle, NULL",
                 psc_sphere_solid_angle(origin, center, 0.5, NULL), PSC_ERROR_NULL_POINTER, &v,
                 7.0);
    expect_value("sphere solid angle, NaN", psc_sphere_solid_angle(bad, center, 0.5, &v),
                 PSC_ERROR_NOT_FINITE, &v, 7.0);
    expect_value("sphere solid angle, infinity", psc_sphere_solid_angle(origin, far, 0.5, &v),
                 PSC_ERROR_NOT_FINITE, &v, 7.0);
    expect_value("sphere solid angle, NaN", psc_sphere_solid_angle(origin, center, NAN, &v),
                 PSC_ERROR_NOT_FINITE, &v, 7.0);
    expect_value("sphere solid angle, negative", psc_sphere_solid_angle(origin, center, -1.0, &v),
                 PSC_ERROR_NEGATIVE_SIZE, &v, 7.0);
    expect_value("sphere solid angle, zero", psc_sphere_solid_angle(origin, center, 0.0, &v),
                 PSC_EMPTY, &v, 7.0);
    expect_value("cap solid angle", psc_cap_solid_angle(0.5, &v), PSC_SUCCESS, &v, 7.0);
    v = 7.0;
    expect_value("cap solid angle, NULL", psc_cap_solid_angle(0.5, NULL), PSC_ERROR_NULL_POINTER,
                 &v, 7.0);
    expect_value("cap solid angle, NaN", psc_cap_solid_angle(NAN, &v), PSC_ERROR_NOT_FINITE, &v,
                 7.0);
    expect_value("cap solid angle, above pi", psc_cap_solid_angle(3.2, &v), PSC_ERROR_HALF_ANGLE,
                 &v, 7.0);
    expect_value("cap solid angle, negative", psc_cap_solid_angle(-0.1, &v),
                 PSC_ERROR_NEGATIVE_SIZE, &v, 7.0);
    expect_value("cap solid angle, zero", psc_cap_solid_angle(0.0, &v), PSC_EMPTY, &v, 7.0);
    expect_value("sphere form factor", psc_sphere_form_factor(&receiver, center, 0.5, &v), 0, &v,
                 7.0);
    expect_value("cap form factor", psc_cap_form_factor(&receiver, center, 0.5, &v), 0, &v, 7.0);
    v = 7.0;
    expect_value("form factor, NULL", psc_sphere_form_factor(NULL, center, 0.5, &v),
                 PSC_ERROR_NULL_POINTER, &v, 7.0);
    expect_value("form factor, NULL", psc_sphere_form_factor(&receiver, NULL, 0.5, &v),
                 PSC_ERROR_NULL_POINTER, &v, 7.0);
    expect_value("form factor, NULL", psc_sphere_form_factor(&receiver, center, 0.5, NULL),
                 PSC_ERROR_NULL_POINTER, &v, 7.0);
    expect_value("form factor, NULL", psc_cap_form_factor(NULL, center, 0.5, &v),
                 PSC_ERROR_NULL_POINTER, &v, 7.0);
    expect_value("form factor, NULL", psc_cap_form_factor(&receiver, NULL, 0.5, &v),
                 PSC_ERROR_NULL_POINTER, &v, 7.0);
    expect_value("form factor, NULL", psc_cap_form_factor(&receiver, center, 0.5, NULL),
                 PSC_ERROR_NULL_POINTER, &v, 7.0);
    expect_value("form factor, NaN", psc_sphere_form_factor(&receiver, bad, 0.5, &v),
                 PSC_ERROR_NOT_FINITE, &v, 7.0);
    expect_value("form factor, NaN", psc_cap_form_factor(&receiver, bad, 0.5, &v),
                 PSC_ERROR_NOT_FINITE, &v, 7.0);
    expect_value("form factor, negative", psc_sphere_form_factor(&receiver, center, -1.0, &v),
                 PSC_ERROR_NEGATIVE_SIZE, &v, 7.0);
    expect_value("form factor, negative", psc_cap_form_factor(&receiver, center, -1.0, &v),
                 PSC_ERROR_NEGATIVE_SIZE, &v, 7.0);
    expect_value("form factor, zero axis", psc_cap_form_factor(&receiver, origin, 0.5, &v),
                 PSC_ERROR_ZERO_VECTOR, &v, 7.0);
    expect_value("form factor, too wide", psc_cap_form_factor(&receiver, center, 1.6, &v),
                 PSC_ERROR_HALF_ANGLE, &v, 7.0);
    receiver.flags = 8;
    expect_value("form factor, flag", psc_cap_form_factor(&receiver, center, 0.5, &v),
                 PSC_ERROR_UNKNOWN_FLAG, &v, 7.0);
    receiver.flags = 0;
    receiver.normal = NULL;
    expect_value("form factor, no normal", psc_sphere_form_factor(&receiver, center, 0.5, &v),
                 PSC_ERROR_NEEDS_NORMAL, &v, 7.0);
    expect_value("form factor, no normal", psc_cap_form_factor(&receiver, center, 0.5, &v),
                 PSC_ERROR_NEEDS_NORMAL, &v, 7.0);
    receiver.normal = origin;
    expect_value("form factor, zero normal", psc_sphere_form_factor(&receiver, center, 0.5, &v),
                 PSC_ERROR_ZERO_VECTOR, &v, 7.0);
    receiver.normal = up;
    receiver.struct_size = 0;
    expect_value("form factor, size", psc_sphere_form_factor(&receiver, center, 0.5, &v),
                 PSC_ERROR_STRUCT_SIZE, &v, 7.0);
}

/* ---- One light, asked in every way */

static const double pi = 3.14159265358979323846;

struct answers {
    double total, solid, projected, factor, area;
    psc_result results[5];
};

static void ask(const struct light *light, psc_sampler *s, struct answers *a)
{
    memset(a, 0, sizeof *a);
    build_light(s, light);
    a->results[0] = psc_sampler_total(s, &a->total);
    a->results[1] = psc_sampler_solid_angle(s, &a->solid);
    a->results[2] = psc_sampler_projected_solid_angle(s, &a->projected);
    a->results[3] = psc_sampler_form_factor(s, &a->factor);
    a->results[4] = psc_sampler_area(s, &a->area);
}

static double apart(double a, double b)
{
    return a == b ? 0.0 : fabs(a - b) / fmax(fabs(a), fabs(b));
}

/* The total of a technique is the answer to the question of its measure; the answers do not
   depend on the technique; those without a sampler are the same. */
static void same_answers(void)
{
    struct worst total = {0}, factor = {0}, free_solid = {0}, free_factor = {0};
    uint64_t seed = 60;
    int i, n;

    for (i = 0; i < 3000; i++) {
        const struct test_technique *what = &test_techniques[random_below(&seed, TEST_TECHNIQUES)];
        struct test_sampler s;
        struct light light;
        struct answers a;
        psc_receiver receiver;
        double value = -1.0, expected;

        random_light(&seed, what, &light);
        ask(&light, make_sampler(&s), &a);
        if (a.results[0] != PSC_SUCCESS)
            continue;
        expected = what->measure == PSC_MEASURE_SOLID_ANGLE             ? a.solid
                   : what->measure == PSC_MEASURE_PROJECTED_SOLID_ANGLE ? a.projected
                   : what->measure == PSC_MEASURE_AREA                  ? a.area
                                                                        : a.total;
        worst_add(&total, apart(a.total, expected), "light %d: %s", i, describe_light(&light));
        n = light.has_normal && a.results[2] == PSC_SUCCESS;
        if (n)
            worst_add(&factor, apart(a.factor, a.projected / pi), "light %d: %s", i,
                      describe_light(&light));
        if (light.distant)
            psc_cap_solid_angle(light.scene.radius, &value);
        else
            psc_sphere_solid_angle(light.scene.position, light.scene.center, light.scene.radius,
                                   &value);
        worst_add(&free_solid, apart(value, a.solid), "light %d: %s", i, describe_light(&light));
        receiver = make_receiver(light.scene.position, light.scene.normal, light.flags);
        if (!n)
            continue;
        if (light.distant)
            psc_cap_form_factor(&receiver, light.scene.center, light.scene.radius, &value);
        else
            psc_sphere_form_factor(&receiver, light.scene.center, light.scene.radius, &value);
        worst_add(&free_factor, apart(value, a.factor), "light %d: %s", i, describe_light(&light));
    }
    worst_report(&total, 1e-15, "total of the measure, relative");
    worst_report(&factor, 1e-15, "form factor, relative");
    worst_report(&free_solid, 1e-15, "solid angle without a sampler, relative");
    worst_report(&free_factor, 1e-15, "form factor without a sampler, relative");
}

/* ---- What the case is called */

static void expect_case(const char *name, double height, double radius, const double *normal,
                        uint32_t flags, psc_case expected)
{
    const double where[3] = {sqrt(1.0 - height * height), 0.0, height};
    psc_description d = {sizeof d, 0, 0, 0, 0, 0};
    struct test_sampler s;
    int i;

    for (i = 0; i < TEST_TECHNIQUES; i++) {
        if (!normal && test_techniques[i].measure == PSC_MEASURE_PROJECTED_SOLID_ANGLE)
            continue;
        build_sphere(make_sampler(&s), &test_techniques[i], flags, origin, normal, where, radius);
        psc_sampler_describe(s.sampler, &d);
        tap_ok(d.visibility == expected && d.shape == PSC_SHAPE_SPHERE &&
                   d.measure == test_techniques[i].measure && d.map == test_techniques[i].map &&
                   d.struct_size == sizeof d && d.reserved == 0,
               "%s: %s", name, test_techniques[i].name);
    }
}

static void cases(void)
{
    expect_case("above", 0.8, 0.5, up, 0, PSC_CASE_ELLIPSE);
    expect_case("touching the horizon", 0.5, 0.5, up, 0, PSC_CASE_ELLIPSE);
    expect_case("cut", 0.3, 0.5, up, 0, PSC_CASE_ELLIPSE_AND_LUNE);
    expect_case("centre on the horizon", 0.0, 0.5, up, 0, PSC_CASE_ELLIPSE_AND_LUNE);
    expect_case("centre below", -0.3, 0.5, up, 0, PSC_CASE_LUNE);
    expect_case("below", -0.8, 0.5, up, 0, PSC_CASE_EMPTY);
    expect_case("touching from below", -0.5, 0.5, up, 0, PSC_CASE_EMPTY);
    expect_case("below, two-sided", -0.8, 0.5, up, PSC_RECEIVER_TWO_SIDED, PSC_CASE_ELLIPSE);
    expect_case("centre below, two-sided", -0.3, 0.5, up, PSC_RECEIVER_TWO_SIDED,
                PSC_CASE_ELLIPSE_AND_LUNE);
    expect_case("inside", -0.3, 1.5, up, 0, PSC_CASE_INSIDE);
    expect_case("no normal", -0.3, 0.5, NULL, 0, PSC_CASE_NO_HORIZON);
}

/* ---- Totals that are known */

static void known(const char *name, psc_result result, const double *value, double expected)
{
    tap_ok(result == PSC_SUCCESS && apart(*value, expected) <= 1e-15, "%s: %.17g is %.17g", name,
           *value, expected);
}

static void known_values(void)
{
    const double above[3] = {0.0, 0.0, 2.0}, beside[3] = {2.0, 0.0, 0.0};
    psc_receiver one = make_receiver(origin, up, 0);
    psc_receiver two = make_receiver(origin, up, PSC_RECEIVER_TWO_SIDED);
    double v;

    known("from inside", psc_sphere_solid_angle(origin, above, 3.0, &v), &v, 4.0 * pi);
    known("on the surface", psc_sphere_solid_angle(origin, above, 2.0, &v), &v, 2.0 * pi);
    known("all directions", psc_cap_solid_angle(pi, &v), &v, 4.0 * pi);
    known("half of them", psc_cap_solid_angle(pi / 2.0, &v), &v, 2.0 * pi);
    known("a tiny cap", psc_cap_solid_angle(1e-12, &v), &v, pi * 1e-24);
    known("sphere overhead", psc_sphere_form_factor(&one, above, 1.0, &v), &v, 0.25);
    known("sphere overhead, two-sided", psc_sphere_form_factor(&two, above, 1.0, &v), &v, 0.25);
    known("inside", psc_sphere_form_factor(&one, above, 3.0, &v), &v, 1.0);
    known("inside, two-sided", psc_sphere_form_factor(&two, above, 3.0, &v), &v, 2.0);
    known("touching its lowest point", psc_sphere_form_factor(&one, above, 2.0, &v), &v, 1.0);
    known("touching its side", psc_sphere_form_factor(&one, beside, 2.0, &v), &v, 0.5);
    known("touching its side, two-sided", psc_sphere_form_factor(&two, beside, 2.0, &v), &v, 1.0);
}

int main(void)
{
    handle_free();
    same_answers();
    cases();
    known_values();
    return tap_done();
}
