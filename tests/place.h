/* SPDX-License-Identifier: Apache-2.0 */
/*
 * CDF errors: how far the point of the unit square that a sample lies at, as quadrature tells,
 * is from the point it was asked for.
 *
 * The rounding of the sample moves that point too, near the centre of a radial map or across a
 * thin lune a lot, and nothing can be done about it. So each number of the sample is moved by
 * its rounding, and by how much its place moves then is no error. t of the parallel map in local
 * coordinates has no need of this and gets none.
 */
#ifndef PSC_TESTS_PLACE_H
#define PSC_TESTS_PLACE_H

#include "calls.h"
#include "reference.h"

/* What a sample says of where it is: numbers as they were returned and the rounding of each,
   and the offset from the axis, in the local frame, that they stand for. */
struct place_sample {
    quad number[3];
    double rounding[3];
    void (*offset)(const void *context, const quad number[3], quad offset[3]);
    const void *context;
    int exact_t; /* rounding does not excuse an error in t of the parallel map */
};

/* The error in s and t of the sample that a technique of a cap gave for (u, v): of solid angle or
   projected solid angle, seen by a one-sided receiver. What has no extent counts less: t at the
   centre of a disk, s on a short chord of it. */
void place_error(const struct test_technique *what, const struct reference *r, double u, double v,
                 const struct place_sample *sample, double error[2]);

/* The same for maps of a disk in general: st is where in a polar map of the disk the sample is,
   its azimuth as a share of the full turn from pi. */
void place_polar_error(psc_map map, double u, double v, const quad here[2], const double open[2],
                       double error[2]);

#endif
