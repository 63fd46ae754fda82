/* SPDX-License-Identifier: Apache-2.0 */
/* Lights made of integers without any rounding: the same on every machine. */
#ifndef PSC_TESTS_EXACT_H
#define PSC_TESTS_EXACT_H

#include "shapes.h"

/* 2^exponent for an exponent of a normal number. */
double power_of_two(int exponent);

/* Rounded down. */
int64_t square_root(int64_t x);

/* From -n to n. */
int64_t around(uint64_t *state, int64_t n);

/* What `make` makes for a shape, rounded to a grid and turned by a matrix of integers, so that what
   is flat stays flat and what is square on the grid stays square; the receiver anywhere, in the
   plane of a flat light, over its edges and middle, or one unit off. */
void place_exactly(uint64_t *state, struct light *light, shape_maker *make);

#endif
