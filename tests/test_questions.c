/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Questions: what a sampler says of its light, what the functions without a sampler say, and
 * that both say the same; errors of the latter.
 */
#include "shapes.h"
#include "worst.h"

static const double origin[3] = {0.0, 0.0, 0.0}, up[3] = {0.0, 0.0, 1.0};
static const double center[3] = {1.0, 2.0, 3.0};

/* ---- Without a sampler ---- */

static void expect_value(const char *shape, const char *what, psc_result result,
                         psc_result expected, const double *value)
{
    tap_ok(result == expected, "%s, %s: %s", shape, what, psc_result_string(expected));
    tap_ok(expected < 0             ? *value == 7.0
           : expected == PSC_EMPTY ? *value == 0.0
                                   : *value > 0.0,
           "%s, %s: %s is written", shape, what, expected < 0 ? "nothing" : "the value");
}

static void expect_solid_angle(const struct light *light, const char *what, psc_result expected)
{
    double value = 7.0;
    const psc_result result =
        light->shape->solid_angle(light->position, light->geometry, &value);

    expect_value(light->shape->name, what, result, expected, &value);
}

static void expect_factor_from(const struct light *light, const psc_receiver *receiver,
                               const char *what, psc_result expected)
{
    double value = 7.0;
    psc_result result;

    if (!light->shape->form_factor)
        return;
    result = light->shape->form_factor(receiver, light->geometry, &value);
    expect_value(light->shape->name, what, result, expected, &value);
}

static void expect_form_factor(const struct light *light, const char *what, psc_result expected)
{
    const psc_receiver receiver = light_receiver(light);

    expect_factor_from(light, &receiver, what, expected);
}

/* Of both, when the geometry is at fault. */
static void expect_both(const struct light *light, const char *what, psc_result expected)
{
    expect_solid_angle(light, what, expected);
    expect_form_factor(light, what, expected);
}

/* The same light every time, wholly above the horizon. */
static void good_light(const struct shape *shape, struct light *light)
{
    uint64_t seed = 1;

    place_light(&seed, shape, shape->techniques, PLACE_ORDINARY, HORIZON_ABOVE, FACING_ONE,
                light);
}

static void bad_geometry(const struct shape *shape)
{
    static const double sizes[4] = {-1e-300, -1.0, 0.0, -0.0};
    struct light light;
    int i, k, at = 0;

    for (i = 0; shape->parts[i]; at += part_size(shape->parts[i++])) {
        const int direction = shape->parts[i] == 'd';

        for (k = 0; k < part_size(shape->parts[i]); k++) {
            good_light(shape, &light);
            light.geometry[at + k] = k == 1 ? INFINITY : NAN;
            if (!(direction && is_distant(shape))) /* whose solid angle has no direction */
                expect_solid_angle(&light, "no number, solid angle", PSC_ERROR_NOT_FINITE);
            expect_form_factor(&light, "no number, form factor", PSC_ERROR_NOT_FINITE);
        }
        good_light(shape, &light);
        for (k = 0; k < 3 && direction; k++)
            light.geometry[at + k] = 0.0;
        if (direction && !is_distant(shape))
            expect_solid_angle(&light, "zero direction, solid angle", PSC_ERROR_ZERO_VECTOR);
        if (direction)
            expect_form_factor(&light, "zero direction, form factor", PSC_ERROR_ZERO_VECTOR);
        for (k = 0; k < 4 && part_size(shape->parts[i]) == 1; k++) {
            light.geometry[at] = sizes[k];
            expect_both(&light, "size below or at zero",
                        k < 2 ? PSC_ERROR_NEGATIVE_SIZE : PSC_EMPTY);
        }
    }
    good_light(shape, &light);
    shrink_to_nothing(&light);
    expect_both(&light, "no size at all", PSC_EMPTY);
}

static void bad_receiver(const struct shape *shape)
{
    struct light light;
    psc_receiver receiver;
    int i;

    good_light(shape, &light);
    receiver = light_receiver(&light);
    expect_factor_from(&light, NULL, "no receiver", PSC_ERROR_NULL_POINTER);
    receiver.position = NULL;
    expect_factor_from(&light, &receiver, "no position", PSC_ERROR_NULL_POINTER);
    receiver = light_receiver(&light);
    receiver.flags = 8;
    expect_factor_from(&light, &receiver, "flag", PSC_ERROR_UNKNOWN_FLAG);
    receiver.flags = 0;
    receiver.normal = NULL;
    expect_factor_from(&light, &receiver, "no normal", PSC_ERROR_NEEDS_NORMAL);
    receiver.normal = origin;
    expect_factor_from(&light, &receiver, "zero normal", PSC_ERROR_ZERO_VECTOR);
    receiver.normal = light.normal;
    receiver.struct_size = 0;
    expect_factor_from(&light, &receiver, "size", PSC_ERROR_STRUCT_SIZE);
    receiver = light_receiver(&light);
    for (i = 0; i < 3; i++) {
        good_light(shape, &light);
        light.position[i] = i == 0 ? NAN : -INFINITY;
        expect_factor_from(&light, &receiver, "position", PSC_ERROR_NOT_FINITE);
        if (!is_distant(shape))
            expect_solid_angle(&light, "position", PSC_ERROR_NOT_FINITE);
    }
    good_light(shape, &light);
    for (i = 0; i < 3; i++)
        light.normal[i] *= -1.0;
    expect_factor_from(&light, &receiver, "below the horizon", PSC_EMPTY);
}

static void handle_free(const struct shape *shape)
{
    struct light light;
    psc_receiver receiver;

    good_light(shape, &light);
    receiver = light_receiver(&light);
    expect_both(&light, "solid angle and form factor", PSC_SUCCESS);
    tap_ok(shape->solid_angle(light.position, light.geometry, NULL) == PSC_ERROR_NULL_POINTER &&
               (!shape->form_factor ||
                shape->form_factor(&receiver, light.geometry, NULL) == PSC_ERROR_NULL_POINTER) &&
               (is_distant(shape) ||
                shape->solid_angle(NULL, light.geometry, &light.reach) == PSC_ERROR_NULL_POINTER),
           "%s: NULL", shape->name);
    bad_geometry(shape);
    bad_receiver(shape);
}

/* What is wrong with parts of one shape. */
static void bad_parts(void)
{
    const psc_receiver receiver = make_receiver(origin, up, 0);
    const psc_result null = PSC_ERROR_NULL_POINTER, wide = PSC_ERROR_HALF_ANGLE;
    double v = 7.0; /* is left as it is */

    expect_value("sphere", "no center", psc_sphere_solid_angle(origin, NULL, 0.5, &v), null, &v);
    expect_value("sphere", "no center", psc_sphere_form_factor(&receiver, NULL, 0.5, &v), null, &v);
    expect_value("cap", "no axis", psc_cap_form_factor(&receiver, NULL, 0.5, &v), null, &v);
    expect_value("cap", "above pi", psc_cap_solid_angle(3.2, &v), wide, &v);
    expect_value("cap", "too wide", psc_cap_form_factor(&receiver, center, 1.6, &v), wide, &v);
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
static void same_answers(const struct shape *shape, const struct test_technique *what)
{
    /* of triangles and their fans there are two formulas, in plain products and in exact ones */
    const int fan = shape->shape == PSC_SHAPE_TRIANGLE || shape->shape == PSC_SHAPE_POLYGON;
    const double formulas = fan ? 2e-15 : 1e-15;
    struct worst total = {0}, factor = {0}, free_solid = {0}, free_factor = {0};
    uint64_t seed = 60;
    int i;

    for (i = 0; i < 400; i++) {
        struct test_sampler s;
        struct light light;
        struct answers a;
        psc_receiver receiver;
        double value = -1.0, expected;

        (i % 2 ? random_light : random_hard_light)(&seed, shape, what, &light);
        ask(&light, make_sampler(&s), &a);
        if (a.results[0] != PSC_SUCCESS)
            continue;
        expected = what->measure == PSC_MEASURE_SOLID_ANGLE             ? a.solid
                   : what->measure == PSC_MEASURE_PROJECTED_SOLID_ANGLE ? a.projected
                   : what->measure == PSC_MEASURE_AREA                  ? a.area
                                                                        : a.total;
        worst_add(&total, apart(a.total, expected), "light %d: %s", i, describe_light(&light));
        shape->solid_angle(light.position, light.geometry, &value);
        worst_add(&free_solid, apart(value, a.solid), "light %d: %s", i, describe_light(&light));
        if (!light.has_normal || a.results[2] != PSC_SUCCESS)
            continue;
        worst_add(&factor, apart(a.factor, a.projected / pi), "light %d: %s", i,
                  describe_light(&light));
        receiver = light_receiver(&light);
        shape->form_factor(&receiver, light.geometry, &value);
        worst_add(&free_factor, apart(value, a.factor), "light %d: %s", i, describe_light(&light));
    }
#define REPORT(worst, bound, words) \
    worst_report(&worst, bound, "%s, %s: " words ", relative", shape->name, what->name)
    REPORT(total, 1e-15, "total of the measure");
    REPORT(free_solid, formulas, "solid angle without a sampler");
    if (shape->form_factor) {
        REPORT(factor, 1e-15, "form factor");
        REPORT(free_factor, 1e-15, "form factor without a sampler");
    }
#undef REPORT
}

/* ---- What the case is called */

static void expect_case(const char *name, double height, double radius, const double *normal,
                        uint32_t flags, psc_case expected)
{
    const double where[3] = {sqrt(1.0 - height * height), 0.0, height};
    psc_description d = {sizeof d, 0, 0, 0, 0, 0};
    const struct test_technique *what;
    struct test_sampler s;

    for (FOR_TECHNIQUES(&shape_sphere, what)) {
        if (!normal && !is_offered(what, FACING_NONE))
            continue;
        build_sphere(make_sampler(&s), what, flags, origin, normal, where, radius);
        psc_sampler_describe(s.sampler, &d);
        tap_ok(d.visibility == expected && d.shape == PSC_SHAPE_SPHERE &&
                   d.measure == what->measure && d.map == what->map &&
                   d.struct_size == sizeof d && d.reserved == 0,
               "%s: %s", name, what->name);
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
    const struct test_technique *what;
    int i;

    for (i = 0; shapes[i]; i++) {
        handle_free(shapes[i]);
        for (FOR_TECHNIQUES(shapes[i], what))
            same_answers(shapes[i], what);
    }
    bad_parts();
    cases();
    known_values();
    return tap_done();
}
