/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rows of numbers with a line of column names above them. Every number is read twice: as the
 * nearest double, which is exact for inputs, and with all the digits that are there. A word in the
 * first column says what a row is for and is read as 0.
 */
#ifndef PSC_TESTS_CSV_H
#define PSC_TESTS_CSV_H

#include <stdio.h>

#include "quad.h"

enum { CSV_COLUMNS = 32 };

struct csv {
    const char *path;
    FILE *file;
    long line;
    char text[2048]; /* the line as it stands in the file, without its end */
    double number[CSV_COLUMNS];
    quad exact[CSV_COLUMNS];
};

/* Opens a file and reads its column names into text. Returns NULL, or what is wrong in words. */
const char *csv_open(struct csv *csv, const char *path);

/* Reads a row of count numbers. Returns 1, 0 at the end, or -1 for a row that is none. */
int csv_read(struct csv *csv, int count);

void csv_close(struct csv *csv);

#endif
