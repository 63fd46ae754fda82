/* SPDX-License-Identifier: Apache-2.0 */
/*
 * The table of the tabulated map: what it refuses and where it is refused, and its numbers against
 * plain quadrature of the solid angle over azimuths.
 */
#include <stdlib.h>

#include "shapes.h"
#include "table.h"
#include "worst.h"

static void refusals(void)
{
    static union {
        double align;
        unsigned char bytes[20000];
    } memory;
    static const uint32_t odd[] = {0, 1, 1025, UINT32_MAX};
    const psc_table *mark = (const psc_table *)(const void *)&memory, *table;
    const size_t size = psc_table_size(64);
    size_t i;

    for (i = 0; i < sizeof odd / sizeof *odd; i++) {
        table = mark;
        tap_ok(psc_table_size(odd[i]) == 0 && psc_table_init(&memory, sizeof memory, odd[i],
                                                             &table) == PSC_ERROR_RESOLUTION &&
                   !table,
               "no table of resolution %lu", (unsigned long)odd[i]);
    }
    tap_ok(psc_table_init(&memory, size, 64, NULL) == PSC_ERROR_NULL_POINTER, "no place for it");
    table = mark;
    tap_ok(psc_table_init(NULL, size, 64, &table) == PSC_ERROR_NULL_POINTER && !table, "no memory");
    table = mark;
    tap_ok(psc_table_init(&memory, size - 1, 64, &table) == PSC_ERROR_STORAGE && !table,
           "a byte is short");
    for (i = 1; i < sizeof(uint32_t); i++) {
        table = mark;
        tap_ok(psc_table_init(memory.bytes + i, sizeof memory - 8, 64, &table) ==
                       PSC_ERROR_STORAGE && !table,
               "%zu bytes off", i);
    }
    tap_ok(psc_table_init(&memory, size, 64, &table) == PSC_SUCCESS && table, "a table");
}

/* Builds and wavefronts without a table, and with memory that is none. */
static void builds(const struct shape *shape, const struct test_technique *what)
{
    static const uint32_t none[8];
    const psc_table *const wrong[2] = {NULL, (const psc_table *)(const void *)none};
    struct light light;
    uint64_t seed = 1;
    int i;

    place_light(&seed, shape, what, PLACE_ORDINARY, HORIZON_ABOVE, FACING_ONE, &light);
    for (i = 0; i < 2; i++) {
        psc_technique technique = light_technique(&light);
        const psc_receiver receiver = light_receiver(&light);
        struct test_sampler s;
        double total = 1.0;
        psc_result result;

        make_sampler(&s);
        build_light(s.sampler, &light);
        technique.table = wrong[i];
        result = shape->build(s.sampler, &technique, &receiver, light.geometry);
        tap_ok(result == PSC_ERROR_NEEDS_TABLE &&
                   psc_sampler_total(s.sampler, &total) == PSC_EMPTY && total == 0.0,
               "%s: %s", shape->name, i ? "memory that is no table" : "no table");
    }
}

/* What a sector of the cone has between two azimuths, but for a factor: Simpson's rule for
   1 - cosine of the outline, tan^2 of which is the inverse of cos^2 / tan^2 a + sin^2 / tan^2 b. */
static double sector(double alpha, double beta, double from, double to)
{
    enum { STEPS = 64 };
    double sum = 0.0;
    int i;

    for (i = 0; i <= STEPS; i++) {
        const double phi = from + (to - from) * i / STEPS;
        const double p = cos(phi) / tan(alpha), q = sin(phi) / tan(beta);
        const double square = 1.0 / (p * p + q * q), root = sqrt(1.0 + square);

        sum += (i == 0 || i == STEPS ? 1.0 : i % 2 ? 4.0 : 2.0) * square / (root * (1.0 + root));
    }
    return sum * (to - from);
}

static void numbers(uint32_t n)
{
    const double width = 1.5707963267948966 / n;
    const size_t size = psc_table_size(n);
    void *memory = malloc(size);
    const psc_table *table = NULL;
    struct worst worst = {0};
    long falls = 0;
    uint32_t i, j;

    psc_table_init(memory, size, n, &table);
    for (i = 0; table && i < n; i++) {
        const float *row = table->share + (size_t)i * (n + 1);
        const double beta = 0.5 * (i + 1) / n;
        double total = 0.0, sum = 0.0;

        for (j = 0; j < n; j++)
            falls += !(row[j + 1] > row[j]);
        if (n > 64 && i % 32 != 0)
            continue; /* a sample of so many */
        for (j = 0; j < n; j++)
            total += sector(0.5, beta, j * width, (j + 1) * width);
        for (j = 0; j <= n; j++) {
            worst_add(&worst, fabs((double)row[j] - sum / total), "row %lu, column %lu", (unsigned long)i,
                      (unsigned long)j);
            sum += sector(0.5, beta, j * width, (j + 1) * width);
        }
    }
    tap_ok(falls == 0, "resolution %lu: every column has its share", (unsigned long)n);
    /* as floats; Simpson's rule is 1e-8 off where all is in a few columns */
    worst_report(&worst, 0x1p-24, "resolution %lu: shares", (unsigned long)n);
    free(memory);
}

int main(void)
{
    const struct test_technique *what;
    int i;

    refusals();
    for (i = 0; shapes[i]; i++)
        for (FOR_TECHNIQUES(shapes[i], what))
            if (is_tabulated(what))
                builds(shapes[i], what);
    numbers(2);
    numbers(64);
    numbers(256);
    numbers(1024);
    return tap_done();
}
