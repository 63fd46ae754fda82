/* SPDX-License-Identifier: Apache-2.0 */
/* What the maps do to the unit square: figures of curves and points, and how much they distort. */
#ifndef MAPS_H
#define MAPS_H

#include "light.h"

enum { LATTICE = 1024 };

/* A light, and how it is looked at: from above, projected on the receiver's plane, where
   projected solid angle is area; or along +z in the azimuthal projection of Lambert, where solid
   angle is. */
typedef struct map_row {
    const char *name, *caption;
    const light_shape *shape;
    unsigned count;
    double number[LIGHT_NUMBERS];
    int horizon;              /* the receiver has the normal +z */
    psc_case visibility;      /* as the light must be seen, for the caption to be true */
    unsigned columns;         /* a bit for each map of the figure that the shape has */
    double left, top, length; /* window: its corner, and points for a unit */
} map_row;

typedef struct map_figure {
    const char *name;
    int across, down;              /* size of a cell */
    unsigned column_count, row_count;
    const technique_row *columns;
    const map_row *rows;
} map_figure;

enum { MAP_FIGURES = 4 };
extern const map_figure map_figures[MAP_FIGURES];

static inline size_t map_vectors(const map_row *row)
{
    return (row->count + 2) / 3;
}

/* Points of the unit square and where a map takes them. */
typedef struct warped {
    double u[LATTICE], v[LATTICE], direction[3][LATTICE], point[3][LATTICE], pdf[LATTICE];
    psc_result status[LATTICE];
} warped;

/* Builds the light of a row. */
void map_build(psc_sampler *sampler, const technique_row *column, const map_row *row);

/* Takes the first count points to the light. */
void map_warp(const psc_sampler *sampler, warped *w, int count);

/* The rank-1 lattice of Korobov with generating vector (1, 275); shift moves all of it. */
void map_lattice(warped *w, double shift);

/* How a map distorts, where its measure is area: on the sphere of directions, on the receiver's
   plane or on the light. Distances are those from each point of the lattice to its nearest
   neighbour, in units of the square root of the total / 1024; ratios those of the singular
   values of the Jacobian. */
typedef struct distortion {
    double least_distance, mean_distance;
    double median_ratio, high_ratio; /* the high one is more than 95 % of them */
    double density;                  /* worst relative error of the pdf, from the Jacobian */
} distortion;

distortion map_distortion(const psc_sampler *sampler, psc_measure measure);

/* Draws a figure into directory; returns how many samples of projected solid angle are not on
   the visible part of the light. */
int map_draw(const map_figure *figure, const char *directory);

/* Ends the program with words unless the result is a success. */
void map_check(psc_result result, const char *what);

#endif
