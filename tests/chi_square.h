/* SPDX-License-Identifier: Apache-2.0 */
/* The chi-square statistic, and what it exceeds by chance once in a million. */
#ifndef PSC_TESTS_CHI_SQUARE_H
#define PSC_TESTS_CHI_SQUARE_H

#include <math.h>

/* What a chi-square variable of n degrees of freedom exceeds with probability 1e-6: Wilson's and
   Hilferty's approximation, 4.7534 being the normal quantile. */
static inline double chi_square_limit(int n)
{
    double a = 2.0 / (9.0 * n);
    return n * pow(1.0 - a + 4.7534 * sqrt(a), 3.0);
}

/* Counts against what was expected; cells where that is few are taken together. Writes the degrees
   of freedom. */
static inline double chi_square(const long *counted, const double *expected, int cells,
                                int *freedom)
{
    double sum = 0.0, rest = 0.0, rest_counted = 0.0;
    int i, used = 0;

    for (i = 0; i < cells; i++) {
        double e = expected[i], c = (double)counted[i];
        if (e < 20.0) {
            rest += e;
            rest_counted += c;
        } else {
            sum += (c - e) * (c - e) / e;
            used++;
        }
    }
    if (rest >= 20.0) {
        sum += (rest_counted - rest) * (rest_counted - rest) / rest;
        used++;
    }
    *freedom = used - 1;
    return sum;
}

#endif
