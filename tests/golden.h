/* SPDX-License-Identifier: Apache-2.0 */
/* What the program golden knows about a quantity that has stored values. */
#ifndef PSC_TESTS_GOLDEN_H
#define PSC_TESTS_GOLDEN_H

#include "csv.h"

enum { GOLDEN_MEASURES = 6 };

/* An error that is not defined for a row. */
#define GOLDEN_NONE (-1.0)

struct golden_quantity {
    const char *name;    /* of the file, without directory, _heldout and the ending */
    const char *columns; /* as in the file's first line */
    int numbers;         /* in a row */
    /* Compares one row: one error for each measure below, GOLDEN_NONE where it has none. */
    void (*compare)(const struct csv *row, double error[GOLDEN_MEASURES]);
    struct {
        const char *name;
        double bound;
    } measure[GOLDEN_MEASURES]; /* up to the first without a name */
};

/* Ends with a row without a name. */
extern const struct golden_quantity golden_caps[], golden_disks[], golden_polygons[];

#endif
