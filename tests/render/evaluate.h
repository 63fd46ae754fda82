/* SPDX-License-Identifier: Apache-2.0 */
/* One scene, rendered with every technique and compared. */
#ifndef EVALUATE_H
#define EVALUATE_H

#include "picture.h"

#include <stdio.h>

enum { GALLERY = 2 };

typedef struct options {
    unsigned width, reference, samples, repeat, threads;
    uint32_t seed;
    point_set set;
    const char *output;
} options;

/* Renders scene number 0 to SCENE_COUNT - 1 into output, prints its table, and hands out its
   panels for solid angle and for projected solid angle at one sample a pixel (pixels owned by
   the caller). Returns the number of claims that did not hold. */
unsigned evaluate(const options *o, int number, panel gallery[GALLERY]);

/* Shows how far a scene has come; fraction 1 ends the line. */
void progress(const char *name, double fraction);

/* Joins the output directory, a name and an ending. */
const char *output_path(const options *o, const char *name, const char *ending);

#endif
