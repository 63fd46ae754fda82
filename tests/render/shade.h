/* SPDX-License-Identifier: Apache-2.0 */
/* Direct light at the points that the camera sees. */
#ifndef SHADE_H
#define SHADE_H

#include "points.h"
#include "scene.h"

#include <psc/psc.h>

/* Camera rays go through these many fixed places of a pixel, each a layer of its own; sample i
   of a pixel belongs to layer i % LAYERS. All techniques share the hits, and the reference
   belongs to the same hits, so that the error is that of sampling the lights alone. */
enum { LAYERS = 4 };

typedef struct frame {
    const scene *scene;
    unsigned width, height, threads;
    hit *hits; /* those of layer k are numbers first[k] to first[k + 1] - 1 */
    size_t first[LAYERS + 1];
    int32_t *index[LAYERS];  /* pixel -> number of its hit, or -1 */
    vec3 *backdrop[LAYERS];  /* pixel -> what is seen there besides the light to be sampled */
} frame;

/* How the lights are sampled. */
typedef struct sampling {
    psc_technique technique;
    point_set set;
    uint32_t seed;
    unsigned count;   /* samples of a pixel */
    int every_layer;  /* all of them in each layer, instead of dealt out to the layers in turn */
    int singly;       /* by one build call and one sample call each, instead of whole tiles */
} sampling;

/* An irradiance for each hit, red, green and blue. */
typedef double (*irradiance)[3];

/* Finds the hits: the part of rendering that no technique has a share in. */
void frame_make(frame *f, const scene *s, unsigned width, unsigned threads);
void frame_free(frame *f);

/* How many of a pixel's count samples belong to this layer. */
unsigned frame_share(unsigned layer, unsigned count);

/* Sets light to the mean irradiance that the samples give at each hit (0 where it has none).
   Returns the processor time of sampling and shadow rays in seconds, summed over the threads. */
double shade(const frame *f, const sampling *how, irradiance light);

/* Sets light to the exact irradiance where nothing occludes. */
void shade_exactly(const frame *f, irradiance light);

/* Ends the program with words unless the result is a success or a status. */
void check_result(psc_result result, const char *what);

void *allocate(size_t count, size_t size);

#endif
