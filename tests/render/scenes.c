/* SPDX-License-Identifier: Apache-2.0 */
/* The list of the scenes, with what each compares. */
#include "parts.h"

#include <string.h>

static const comparison spheres = {
    4,
    {{"solid angle", PSC_MEASURE_SOLID_ANGLE, PSC_MAP_RADIAL},
     {"projected, radial", PSC_MEASURE_PROJECTED_SOLID_ANGLE, PSC_MAP_RADIAL},
     {"projected, parallel", PSC_MEASURE_PROJECTED_SOLID_ANGLE, PSC_MAP_PARALLEL},
     {"projected, concentric", PSC_MEASURE_PROJECTED_SOLID_ANGLE, PSC_MAP_CONCENTRIC}}};

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
