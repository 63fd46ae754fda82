/* SPDX-License-Identifier: Apache-2.0 */
/* From irradiances to pictures and to their errors. */
#ifndef PICTURE_H
#define PICTURE_H

#include "shade.h"

/* The picture that count samples a pixel give, linear, 1 is white before tone mapping. */
vec3 *picture_make(const frame *f, irradiance light, unsigned count);

/* Root mean square over the pixels of the crop (NULL: all) that any surface is seen in, and over
   red, green and blue, of the difference of two such pictures. */
double picture_rms(const frame *f, irradiance light, irradiance reference, unsigned count,
                   const cutout *crop);

/* A picture within a sheet, with an enlarged view of each crop below it. */
typedef struct panel {
    unsigned width, height;
    cutout crops[2];
    vec3 *pixels;         /* owned by whoever made the panel */
    char heading[48];
    char label[48];
    char crop_label[2][48];
} panel;

/* Writes rows of panels, all of one size, as a PNG; ends the program if that is impossible. */
void sheet_write(const char *path, const char *title, const panel *panels, unsigned rows,
                 unsigned columns);

/* A line of a chart: error against samples or time, of one technique. */
typedef struct curve {
    const char *name;
    unsigned count;
    double samples[8], seconds[8], rms[8];
} curve;

/* Writes error against samples and error against time, both logarithmic, as a PNG. */
void chart_write(const char *path, const char *title, const curve *curves, unsigned count);

#endif
