/* SPDX-License-Identifier: Apache-2.0 */
/* Gauss-Legendre nodes and weights on [0, 1], by Newton's method on the Legendre polynomial. */
#ifndef PSC_TESTS_GAUSS_H
#define PSC_TESTS_GAUSS_H

#include "quad.h"

enum { GAUSS_NODES = 24 };

static inline const quad *gauss_rule(void)
{
    static quad rule[2 * GAUSS_NODES];
    int i, k, n;

    for (i = 0; i < GAUSS_NODES && rule[2 * GAUSS_NODES - 1] == 0; i++) {
        quad x = cos(3.14159265358979 * (i + 0.75) / (GAUSS_NODES + 0.5)), slope = 1;

        for (n = 0; n < 6; n++) {
            quad p = 1, before = 0;

            for (k = 1; k <= GAUSS_NODES; k++) {
                const quad next = ((2 * k - 1) * x * p - (k - 1) * before) / k;

                before = p;
                p = next;
            }
            slope = GAUSS_NODES * (x * p - before) / (x * x - 1);
            x -= p / slope;
        }
        rule[i] = (1 + x) / 2;
        rule[GAUSS_NODES + i] = 1 / ((1 - x * x) * slope * slope);
    }
    return rule;
}

static inline quad gauss_node(int i)
{
    return gauss_rule()[i];
}

static inline quad gauss_weight(int i)
{
    return gauss_rule()[GAUSS_NODES + i];
}

#endif
