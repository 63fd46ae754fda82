/* SPDX-License-Identifier: Apache-2.0 */
/* Builds of flat lights with straight edges: what is seen of them, and the maps of their fans. */
#ifndef PSC_SRC_POLYGON_BUILD_H
#define PSC_SRC_POLYGON_BUILD_H

#include "fan_build.h"
#include "sampler.h"

PSC_LANE void vertex_words(const struct psc_polygon_view *view, int i, struct psc_word2 *to)
{
    int c;

    for (c = 0; c < 3; c++) {
        to->high[c] = view->vertex[i][c];
        to->low[c] = view->low[i][c];
    }
}

/* The triangle of the vertices a, b, c of a view, which are at those places of `vertices`. */
PSC_LANE void triangle_words(const struct psc_polygon_view *view, const double *vertices, int a,
                             int b, int c, struct psc_triangle_words *o)
{
    const double *const va = vertices + 3 * a, *const vb = vertices + 3 * b;
    const double *const vc = vertices + 3 * c;

    vertex_words(view, a, &o->a);
    vertex_words(view, b, &o->b);
    vertex_words(view, c, &o->c);
    edge_of(vb, va, view->scale, o->edge_a.high, o->edge_a.low);
    edge_of(vb, vc, view->scale, o->edge_c.high, o->edge_c.low);
    edge_of(va, vc, view->scale, o->edge_ac.high, o->edge_ac.low);
}

/* The height of a vertex above the plane with normal n, which has length 1 / shrink. */
PSC_LANE double height_of(const double n[3], double shrink, const double high[3],
                          const double low[3])
{
    double sum = 0.0, error = 0.0;
    int c;

    for (c = 0; c < 3; c++)
        add_product(n[c], high[c], &sum, &error);
    return (sum + (error + dot(n, low))) * shrink;
}

/* The triangle of a view's vertices a, b, c, and their places on the light's surface. */
struct psc_fan_vertices {
    int a, b, c;
};

/* The constants in world space. */
PSC_LANE void face_build(const double *vertices, const double (*surface)[2],
                         const struct psc_fan_vertices *at, struct psc_face_f64 *to)
{
    int i;

    for (i = 0; i < 3; i++) {
        to->pivot[i] = vertices[3 * at->b + i];
        to->edge_a[i] = vertices[3 * at->a + i] - vertices[3 * at->b + i];
        to->edge_c[i] = vertices[3 * at->c + i] - vertices[3 * at->b + i];
    }
    to->s_a = surface[at->a][0];
    to->t_a = surface[at->a][1];
    to->s_b = surface[at->b][0];
    to->t_b = surface[at->b][1];
    to->s_c = surface[at->c][0];
    to->t_c = surface[at->c][1];
}

/* Those of the area map. */
PSC_LANE void flat_build(const struct psc_triangle_words *o, const double *height,
                         const struct psc_fan_vertices *at, struct psc_flat *to)
{
    int i;

    for (i = 0; i < 3; i++) {
        to->b[i] = o->b.high[i];
        to->edge_a[i] = o->edge_a.high[i];
        to->edge_c[i] = o->edge_c.high[i];
    }
    to->height_a = height[at->a];
    to->height = height[at->b];
    to->height_c = height[at->c];
}

/* The receiver's plane: heights of the vertices, and where the light lies to it. */
PSC_LANE psc_case see_horizon(const double *normal, const struct psc_polygon_view *view,
                              double up[3], double *height)
{
    int above = 0, below = 0, i;
    double n[3], shrink;

    if (!normal) {
        for (i = 0; i < 3; i++)
            up[i] = 0.0;
        for (i = 0; i < view->count; i++)
            height[i] = 0.0;
        return PSC_CASE_NO_HORIZON;
    }
    scale_to_one(normal, n);
    shrink = 1.0 / SQRT(dot(n, n));
    for (i = 0; i < 3; i++)
        up[i] = n[i] * shrink;
    for (i = 0; i < view->count; i++) {
        height[i] = height_of(n, shrink, view->vertex[i], view->low[i]);
        above |= height[i] > 0.0;
        below |= height[i] < 0.0;
    }
    return above & below ? PSC_CASE_CLIPPED : above ? PSC_CASE_ABOVE : PSC_CASE_EMPTY;
}

/*
 * Builds a light from its vertices and the triangles of its fan. front is the sign of a
 * triangle's volume for a receiver that the light's normal points to.
 */
PSC_LANE psc_result polygon_build(psc_sampler *s, const struct psc_request *request, int count,
                                  const double *vertices, const double (*surface)[2],
                                  int triangles, const struct psc_fan_vertices *fan, double front)
{
    struct psc_polygon_light *l = &s->polygon;
    const int area = request->measure == PSC_MEASURE_AREA;
    double normal[3] = {0.0, 0.0, 0.0}, sum = 0.0, volume = 0.0, half = 0.0, twice = 0.0, length;
    int i, c;

    if (!see_polygon(request->position, count, vertices, &l->view))
        return PSC_ERROR_NOT_FINITE;
    s->visibility = see_horizon(request->normal, &l->view, l->up, l->height);
    l->triangles = 0;
    for (i = 0; i < triangles; i++) {
        const int k = l->triangles;
        struct psc_triangle_words words;
        struct psc_triangle_view view;
        double size, part;

        triangle_words(&l->view, vertices, fan[i].a, fan[i].b, fan[i].c, &words);
        see_triangle(&words, &view);
        size = SQRT(dot(view.normal, view.normal));
        part = area ? size : view.half;
        if (!(view.half > 0.0))
            continue;
        fan_build(&view, &words.b, &words.edge_c, l->up, l->height[fan[i].b], l->fan + k);
        if (area)
            flat_build(&words, l->height, fan + i, l->flat + k);
        face_build(vertices, surface, fan + i, l->face + k);
        for (c = 0; c < 3; c++)
            normal[c] += view.normal[c];
        l->below[k] = sum;
        l->per_share[k] = part;
        sum += part;
        volume += view.volume;
        half += view.half;
        twice += size;
        l->triangles = k + 1;
    }
    if (!(volume != 0.0) || (request->one_sided && volume * front < 0.0) ||
        (s->visibility == PSC_CASE_EMPTY && s->facing == PSC_FACING_ONE))
        return PSC_EMPTY;
    for (i = 0; i < l->triangles; i++) {
        l->below[i] /= sum;
        l->per_share[i] = MIN(sum / l->per_share[i], 0x1p96); /* nothing falls to less */
    }
    length = -front / SQRT(dot(normal, normal));
    for (c = 0; c < 3; c++)
        l->normal[c] = normal[c] * length;
    l->volume = ABS(volume);
    l->solid_angle = 2.0 * half;
    l->area = 0.5 * twice / l->view.scale / l->view.scale;
    s->total = area ? l->area : l->solid_angle;
    s->sides = 1;
    s->split = 1.0;
    return PSC_SUCCESS;
}

/* A triangle (v0, v1, v2) has A, B and C in that order, and is seen from its front where its
   volume is negative. */
PSC_LANE psc_result triangle_build(psc_sampler *s, const struct psc_request *request,
                                   const double *vertices)
{
    static const double surface[3][2] = {{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}};
    static const struct psc_fan_vertices fan = {0, 1, 2};

    return polygon_build(s, request, 3, vertices, surface, 1, &fan, -1.0);
}

#endif
