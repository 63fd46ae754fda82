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

/* Figure 1 of Guillen et al., Area-Preserving Parameterizations for Spherical Ellipses, EGSR 2017,
   with two more maps: ellipses with semi-arcs alpha and beta. */
static const technique_row disk_columns[] = {
    {"radial", PSC_MEASURE_SOLID_ANGLE, PSC_MAP_RADIAL},
    {"parallel", PSC_MEASURE_SOLID_ANGLE, PSC_MAP_PARALLEL},
    {"concentric", PSC_MEASURE_SOLID_ANGLE, PSC_MAP_CONCENTRIC},
    {"quasi-uniform", PSC_MEASURE_SOLID_ANGLE, PSC_MAP_QUASI_UNIFORM},
};

static const map_row disk_rows[] = {
    {"ellipse", "\u03b1 = 0.70, \u03b2 = 0.45", &light_ellipse, 9,
     {0, 0, 1, 0.8422883804630794, 0, 0, 0, 0.4830550656165784, 0}, 0,
     PSC_CASE_NO_HORIZON, ALL(disk_columns), -0.731, -0.519, 108},
    {"wide ellipse", "\u03b1 = 1.20, \u03b2 = 0.50", &light_ellipse, 9,
     {0, 0, 1, 2.5721516221263188, 0, 0, 0, 0.5463024898437905, 0}, 0,
     PSC_CASE_NO_HORIZON, ALL(disk_columns), -1.162, -0.824, 68},
    {"thin ellipse", "\u03b1 = 0.90, \u03b2 = 0.20", &light_ellipse, 9,
     {0, 0, 1, 1.2601582175503392, 0, 0, 0, 0.2027100355086725, 0}, 0,
     PSC_CASE_NO_HORIZON, ALL(disk_columns), -0.898, -0.636, 88},
};

/* Lights near to a point below them. */
static const technique_row polygon_columns[] = {
    {"area, radial", PSC_MEASURE_AREA, PSC_MAP_RADIAL},
    {"solid angle, radial", PSC_MEASURE_SOLID_ANGLE, PSC_MAP_RADIAL},
    {"solid angle, parallel", PSC_MEASURE_SOLID_ANGLE, PSC_MAP_PARALLEL},
};
enum { POLYGON_RADIAL = 3, POLYGON_ALL = 7 };

static const map_row polygon_rows[] = {
    {"triangle", "triangle", &light_triangle, 9,
     {-0.4, 0.8, 0.5, -1.2, -1.0, 0.8, 1.6, -0.3, 0.6}, 0,
     PSC_CASE_NO_HORIZON, POLYGON_RADIAL, -1.40, -1.00, 56},
    {"rectangle", "rectangle", &light_rectangle, 9,
     {-0.7, -0.7, 0.4, 2.4, 0, 0.6, 0, 1.4, 0}, 0,
     PSC_CASE_NO_HORIZON, POLYGON_ALL, -1.40, -1.00, 56},
    {"polygon", "pentagon", &light_polygon, 15,
     {-0.9, 0.3, 0.6, -0.5, -0.8, 0.6, 0.9, -0.9, 0.6, 1.6, 0.2, 0.6, 0.2, 0.9, 0.6}, 0,
     PSC_CASE_NO_HORIZON, POLYGON_RADIAL, -1.40, -1.00, 56},
};

/* Lights that the horizon cuts, seen from above the receiver, as the caps are. */
static const technique_row horizon_columns[] = {
    {"area, radial", PSC_MEASURE_AREA, PSC_MAP_RADIAL},
    {"solid angle, radial", PSC_MEASURE_SOLID_ANGLE, PSC_MAP_RADIAL},
    {"projected, parallel", PSC_MEASURE_PROJECTED_SOLID_ANGLE, PSC_MAP_PARALLEL},
    {"projected, radial", PSC_MEASURE_PROJECTED_SOLID_ANGLE, PSC_MAP_RADIAL},
};
enum { HORIZON_DISK = 7, HORIZON_ELLIPSOID = 6, HORIZON_POLYGON = 11 };

static const map_row horizon_rows[] = {
    {"disk, cut", "disk", &light_disk, 7, {0.7, 0.1, 0.3, -1, 0.2, -0.5, 0.9}, 1,
     PSC_CASE_CLIPPED, HORIZON_DISK, 0.00, -0.95, 150},
    {"ellipsoid, cut", "ellipsoid", &light_ellipsoid, 12,
     {1.1, 0.1, 0.25, 0, 0.7, 0.4, 0.5, 0, 0, 0, -0.3, 0.6}, 1,
     PSC_CASE_CLIPPED, HORIZON_ELLIPSOID, 0.00, -0.95, 150},
    {"triangle, cut", "triangle", &light_triangle, 9,
     {0.7, -0.9, 0.2, 0.9, 0.8, -0.2, 0.4, 0.3, 1.0}, 1,
     PSC_CASE_CLIPPED, HORIZON_POLYGON, 0.00, -0.95, 150},
    {"pentagon, cut", "pentagon", &light_polygon, 15,
     {1.1, -0.3, -0.25, 1.08, 0.5, -0.2, 0.8, 0.9, 0.5, 0.6, 0.1, 1.0, 0.76, -0.8, 0.6}, 1,
     PSC_CASE_CLIPPED, HORIZON_POLYGON, 0.00, -0.95, 150},
};

const map_figure map_figures[MAP_FIGURES] = {
    {"maps", 166, 284, COUNT(cap_columns), COUNT(cap_rows), cap_columns, cap_rows},
    {"maps-disks", 166, 112, COUNT(disk_columns), COUNT(disk_rows), disk_columns, disk_rows},
    {"maps-horizon", 166, 284, COUNT(horizon_columns), COUNT(horizon_rows), horizon_columns,
     horizon_rows},
    {"maps-polygons", 166, 112, COUNT(polygon_columns), COUNT(polygon_rows), polygon_columns,
     polygon_rows},
};
