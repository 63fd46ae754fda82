/* SPDX-License-Identifier: Apache-2.0 */
/* The figures. Lights are where their direction and their size as seen from the origin are those
   of the caption. */
#include "maps.h"

#define ALL(columns) ((1u << sizeof(columns) / sizeof *(columns)) - 1)
#define COUNT(array) sizeof(array) / sizeof *(array)

/* Figure 5 of Urena and Georgiev, Stratified Sampling of Projected Spherical Caps, EGSR 2018. */
static const technique_row cap_columns[] = {
    {"solid angle", PSC_MEASURE_SOLID_ANGLE, PSC_MAP_RADIAL},
    {"projected, radial", PSC_MEASURE_PROJECTED_SOLID_ANGLE, PSC_MAP_RADIAL},
    {"projected, parallel", PSC_MEASURE_PROJECTED_SOLID_ANGLE, PSC_MAP_PARALLEL},
    {"projected, concentric", PSC_MEASURE_PROJECTED_SOLID_ANGLE, PSC_MAP_CONCENTRIC},
};

static const map_row cap_rows[] = {
    {"ellipse", "ellipse, \u03b1 = 0.60, \u03b2 = 0.72", &light_cap, 4,
     {0.751805729140895, 0, 0.6593846719714731, 0.60}, 1,
     PSC_CASE_ELLIPSE, ALL(cap_columns), 0.17, -0.755, 188},
    {"ellipse and lune", "ellipse and lune, \u03b1 = 0.78, \u03b2 = 0.30", &light_cap, 4,
     {0.955336489125606, 0, 0.29552020666133955, 0.78}, 1,
     PSC_CASE_ELLIPSE_AND_LUNE, ALL(cap_columns), 0.17, -0.755, 188},
    {"lune", "lune, \u03b1 = 0.78, \u03b2 = -0.16", &light_cap, 4,
     {0.9872272833756269, 0, -0.15931820661424598, 0.78}, 1,
     PSC_CASE_LUNE, ALL(cap_columns), 0.17, -0.755, 188},
};

const map_figure map_figures[MAP_FIGURES] = {
    {"maps", 166, 284, COUNT(cap_columns), COUNT(cap_rows), cap_columns, cap_rows},
};
