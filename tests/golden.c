/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Compares the library with stored values.
 *
 *     golden FILE.csv...
 *
 * The quantity is the file's name without directory, ".csv" and "_heldout". Every number of a
 * file is evaluated in f32 and f64; the worst error is printed with the row that gives it, and
 * the exit status is not 0 when one is over its bound or a file cannot be compared.
 */
#include <string.h>

#include "golden.h"
#include "worst.h"

static const struct golden_quantity *const families[] = {golden_caps, golden_disks, golden_polygons};

static void quantity_of(const char *path, char *name, size_t size)
{
    const char *slash = strrchr(path, '/');
    char *end;

    snprintf(name, size, "%s", slash ? slash + 1 : path);
    end = strrchr(name, '.');
    if (end)
        *end = '\0';
    end = strstr(name, "_heldout");
    if (end && end[strlen("_heldout")] == '\0')
        *end = '\0';
}

static const struct golden_quantity *find(const char *name)
{
    const struct golden_quantity *quantity;
    size_t i;

    for (i = 0; i < sizeof families / sizeof families[0]; i++)
        for (quantity = families[i]; quantity->name; quantity++)
            if (strcmp(quantity->name, name) == 0)
                return quantity;
    return NULL;
}

static void print_quantities(void)
{
    const struct golden_quantity *quantity;
    size_t i;

    for (i = 0; i < sizeof families / sizeof families[0]; i++)
        for (quantity = families[i]; quantity->name; quantity++)
            tap_note("    known: %s (%s)", quantity->name, quantity->columns);
}

static void compare_rows(const struct golden_quantity *quantity, struct csv *csv)
{
    struct worst worst[GOLDEN_MEASURES];
    long rows = 0;
    int i, read;

    memset(worst, 0, sizeof worst);
    while ((read = csv_read(csv, quantity->numbers)) == 1) {
        double error[GOLDEN_MEASURES];

        quantity->compare(csv, error);
        for (i = 0; i < GOLDEN_MEASURES && quantity->measure[i].name; i++)
            if (error[i] != GOLDEN_NONE)
                worst_add(&worst[i], error[i], "line %ld: %s", csv->line, csv->text);
        rows++;
    }
    if (read < 0) {
        tap_ok(0, "%s: line %ld is not %d numbers with commas between", csv->path, csv->line,
               quantity->numbers);
        return;
    }
    if (rows == 0) {
        tap_ok(0, "%s: has no rows", csv->path);
        return;
    }
    for (i = 0; i < GOLDEN_MEASURES && quantity->measure[i].name; i++)
        worst_report(&worst[i], quantity->measure[i].bound, "%s: %s", csv->path,
                     quantity->measure[i].name);
}

static void compare_file(const char *path)
{
    const struct golden_quantity *quantity;
    struct csv csv;
    char name[256];
    const char *problem;

    quantity_of(path, name, sizeof name);
    quantity = find(name);
    if (!quantity) {
        tap_ok(0, "%s: no quantity is called %s", path, name);
        print_quantities();
        return;
    }
    problem = csv_open(&csv, path);
    if (problem) {
        tap_ok(0, "%s: %s", path, problem);
        return;
    }
    if (strcmp(csv.text, quantity->columns) != 0)
        tap_ok(0, "%s: the columns of %s are %s, not %s", path, name, quantity->columns,
               csv.text);
    else
        compare_rows(quantity, &csv);
    csv_close(&csv);
}

int main(int count, char **path)
{
    int i;

    if (count < 2) {
        fprintf(stderr, "usage: golden FILE.csv...\n");
        print_quantities();
        return 2;
    }
    for (i = 1; i < count; i++)
        compare_file(path[i]);
    return tap_done();
}
