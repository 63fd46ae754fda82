/* SPDX-License-Identifier: Apache-2.0 */
/* The list of the scenes, with what each compares. */
#include "parts.h"

#include <string.h>

static const comparison spheres = {
    4, 0,
    {{"solid angle", PSC_MEASURE_SOLID_ANGLE, PSC_MAP_RADIAL},
     {"projected, radial", PSC_MEASURE_PROJECTED_SOLID_ANGLE, PSC_MAP_RADIAL},
     {"projected, parallel", PSC_MEASURE_PROJECTED_SOLID_ANGLE, PSC_MAP_PARALLEL},
     {"projected, concentric", PSC_MEASURE_PROJECTED_SOLID_ANGLE, PSC_MAP_CONCENTRIC}}};

static const comparison disks = {
    6, 2,
    {{"area", PSC_MEASURE_AREA, PSC_MAP_CONCENTRIC},
     {"solid angle, radial", PSC_MEASURE_SOLID_ANGLE, PSC_MAP_RADIAL},
     {"solid angle, concentric", PSC_MEASURE_SOLID_ANGLE, PSC_MAP_CONCENTRIC},
     {"solid angle, parallel", PSC_MEASURE_SOLID_ANGLE, PSC_MAP_PARALLEL},
     {"quasi-uniform", PSC_MEASURE_SOLID_ANGLE, PSC_MAP_QUASI_UNIFORM},
     {"projected, parallel", PSC_MEASURE_PROJECTED_SOLID_ANGLE, PSC_MAP_PARALLEL}}};

/* In a volume nothing is projected. */
static const comparison fog = {
    5, 2,
    {{"area", PSC_MEASURE_AREA, PSC_MAP_CONCENTRIC},
     {"solid angle, radial", PSC_MEASURE_SOLID_ANGLE, PSC_MAP_RADIAL},
     {"solid angle, concentric", PSC_MEASURE_SOLID_ANGLE, PSC_MAP_CONCENTRIC},
     {"solid angle, parallel", PSC_MEASURE_SOLID_ANGLE, PSC_MAP_PARALLEL},
     {"quasi-uniform", PSC_MEASURE_SOLID_ANGLE, PSC_MAP_QUASI_UNIFORM}}};

static const comparison ellipsoids = {
    5, 1,
    {{"solid angle, radial", PSC_MEASURE_SOLID_ANGLE, PSC_MAP_RADIAL},
     {"solid angle, concentric", PSC_MEASURE_SOLID_ANGLE, PSC_MAP_CONCENTRIC},
     {"solid angle, parallel", PSC_MEASURE_SOLID_ANGLE, PSC_MAP_PARALLEL},
     {"quasi-uniform", PSC_MEASURE_SOLID_ANGLE, PSC_MAP_QUASI_UNIFORM},
     {"projected, parallel", PSC_MEASURE_PROJECTED_SOLID_ANGLE, PSC_MAP_PARALLEL}}};

static const comparison polygons = {
    3, 1,
    {{"area", PSC_MEASURE_AREA, PSC_MAP_RADIAL},
     {"solid angle", PSC_MEASURE_SOLID_ANGLE, PSC_MAP_RADIAL},
     {"projected", PSC_MEASURE_PROJECTED_SOLID_ANGLE, PSC_MAP_RADIAL}}};

static const struct {
    const char *name, *title;
    int open;
    void (*make)(scene *);
    const comparison *comparison;
} table[SCENE_COUNT] = {
    {"cornell", "Cornell box, four spherical lights, occluders", 0, make_cornell, &spheres},
    {"cornell-open", "Cornell box, four spherical lights, no occluders", 1, make_cornell,
     &spheres},
    {"dome", "Sphere cutting the floor, its centre below, occluders", 0, make_dome, &spheres},
    {"dome-open", "Sphere cutting the floor, its centre below, no occluders", 1, make_dome,
     &spheres},
    {"sun", "Low sun, its centre below the horizon, occluders", 0, make_sun, &spheres},
    {"disk", "Disk upright on the ground, both sides lit, and an ellipse, occluders", 0, make_disk,
     &disks},
    {"disk-open", "Disk upright on the ground, both sides lit, and an ellipse, no occluders", 1,
     make_disk, &disks},
    {"fog", "Disk in fog, occluders", 0, make_fog, &fog},
    {"fog-open", "Disk in fog, no occluders", 1, make_fog, &fog},
    {"ellipsoids", "Two ellipsoids, one cutting the ground, and an ellipse, occluders", 0,
     make_ellipsoids, &ellipsoids},
    {"ellipsoids-open", "Two ellipsoids, one cutting the ground, and an ellipse, no occluders", 1,
     make_ellipsoids, &ellipsoids},
    {"windows", "Rectangle, polygon, and a triangle cutting the floor, occluders", 0, make_windows,
     &polygons},
    {"windows-open", "Rectangle, polygon, and a triangle cutting the floor, no occluders", 1,
     make_windows, &polygons},
};

void scene_make(scene *s, int number)
{
    memset(s, 0, sizeof *s);
    s->name = table[number].name;
    s->title = table[number].title;
    s->open = table[number].open;
    s->comparison = table[number].comparison;
    table[number].make(s);
}
