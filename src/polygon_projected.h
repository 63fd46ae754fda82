/* SPDX-License-Identifier: Apache-2.0 */
/* Builds by projected solid angle, from what is seen of a light to what a sampler keeps. */
#ifndef PSC_SRC_POLYGON_PROJECTED_H
#define PSC_SRC_POLYGON_PROJECTED_H

#include "triangle_sectors.h"
#include "sampler.h"

/* The vertices from the first, in world space, and their coordinates on the light's surface. */
struct psc_polygon_places {
    const double *first;
    double offset[PSC_MAX_VERTICES][3];
    const double (*place)[2];
};

PSC_LANE void vertex_offsets(const double *vertices, int count, struct psc_polygon_places *to)
{
    int i, c;

    for (i = 0; i < count; i++)
        for (c = 0; c < 3; c++)
            to->offset[i][c] = vertices[3 * i + c] - vertices[c];
}

/* Coordinates on the surface of a triangle, and of a rectangle. */
static const double triangle_places[3][2] = {{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}};
static const double rectangle_places[4][2] = {{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}};

/* What a sampler keeps of its sides. first: the first vertex. */
PSC_LANE void projected_totals(psc_sampler *s, int sides, const double first[3])
{
    struct psc_sector_light *const l = &s->polygon.projected;
    int i;

    s->sides = sides;
    s->total = 0.0;
    for (i = 0; i < sides; i++)
        s->total += l->side[i].total;
    s->split = sides == 2 ? l->side[0].total / s->total : 1.0;
    copy3(first, l->pivot);
}

/* Of a light in two words. */
static inline void projected_finish(psc_sampler *s, const struct psc_polygon_places *places)
{
    struct psc_polygon_light *const l = &s->polygon;
    const struct psc_projection what = {places->offset, places->place};
    struct psc_receiver_view view;

    see_from_receiver(&l->view, l->up, l->receiver, !l->turns_left, &view);
    projected_totals(s, project(&what, s->facing == PSC_FACING_BOTH, &view, &l->projected),
                     places->first);
}

/* Builds a light, or PSC_PENDING where plain arithmetic will not do. */
PSC_LANE psc_result plain_projected_build(psc_sampler *s, const struct psc_request *request,
                                          int count, const struct psc_polygon_places *places)
{
    struct psc_polygon_light *const l = &s->polygon;
    const int both = s->facing == PSC_FACING_BOTH;
    const struct psc_projection what = {places->offset, places->place};
    struct psc_plain_polygon from = {.count = count, .offset = places->offset};
    struct psc_plain_look look;
    double length;
    int sides;

    first_words(places->first, request->position, &from.first);
    if (!look_at_plain(&from, request->normal, both, &look))
        return PSC_PENDING;
    if ((request->one_sided && look.volume > 0.0) || (!look.above && !both))
        return PSC_EMPTY;
    if (!view_plain_edges(&look))
        return PSC_PENDING;
    look.view.clockwise = !(look.volume > 0.0);
    sides = count == 3 && !look.below ? project_triangle(&look, &what, &l->projected) : -1;
    if (sides < 0)
        sides = project_plain(&look, &what, both, &l->projected);
    if (sides < 0)
        return PSC_PENDING;
    s->visibility = look.above & look.below ? PSC_CASE_CLIPPED
                    : look.above            ? PSC_CASE_ABOVE
                                            : PSC_CASE_EMPTY;
    length = SQRT(dot(look.normal, look.normal));
    scale3(1.0 / length, look.normal, l->normal);
    l->area = 0.5 * length;
    l->view.scale = 1.0;
    l->plain = 0;
    projected_totals(s, sides, places->first);
    return PSC_SUCCESS;
}

#endif
