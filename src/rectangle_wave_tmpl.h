/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Wavefronts of rectangles along their edges: a loop in double that sees, builds and samples a
 * block of elements, then one for densities. The lane functions are those of the calls for one, so
 * the bits are too. What takes exact products is put together and goes another way
 * (rectangle_exact_wave_tmpl.h); what is left to the calls for one: errors, lights without size,
 * and the other maps. Template: see precision.h.
 */

/* What the loop leaves of each element. */
struct FN(psc_rectangles) {
    double distance[PSC_BLOCK], cosine[PSC_BLOCK], volume[PSC_BLOCK];
    double total[PSC_BLOCK]; /* 0: left to the calls for one */
    int32_t status[PSC_BLOCK];
};

PSC_LANE void load_rectangle(const struct psc_wave *wave, int has_normal, size_t i,
                             double position[3], double normal[3], double g[9])
{
    int k;

    PSC_UNROLL
    for (k = 0; k < 3; k++)
        position[k] = wave->position[k][i];
    PSC_UNROLL
    for (k = 0; k < 3; k++)
        normal[k] = has_normal ? wave->normal[k][i] : 0.0;
    PSC_UNROLL
    for (k = 0; k < 9; k++)
        g[k] = wave->geometry[k][i];
}

PSC_LANE void FN(plain_element)(const struct psc_wave *wave, int area, int has_normal, int surface,
                                size_t i, real u, real v, struct FN(psc_rectangles) *to,
                                struct FN(psc_results) *r)
{
    struct psc_rectangle_sight seen;
    struct psc_plain_rectangle f;
    struct psc_rectangle words;
    double position[3], normal[3], g[9], up[3], where = PSC_CASE_NO_HORIZON;
    real share[2], direction[3], point[3], front[3];
    int c, fit, hidden;

    load_rectangle(wave, has_normal, i, position, normal, g);
    fit = see_plain_rectangle(position, g, &seen);
    up[0] = up[1] = up[2] = 0.0;
    if (has_normal) {
        const double square = dot(normal, normal), size = __builtin_sqrt(square);

        where = see_rectangle_horizon(g, &seen, normal, size);
        fit &= is_plain_normal(square);
        scale3(1.0 / size, normal, up);
    }
    if (area) {
        plain_words(position, g, &seen, &words);
        FN(rectangle_lane)(&words, up, 1, u, v, share, direction, to->distance + i,
                           to->cosine + i);
        to->volume[i] = 2.0 * __builtin_fabs(seen.volume);
        to->total[i] = seen.area;
    } else {
        plain_rectangle(g, &seen, &f);
        FN(plain_rectangle_lane)(&f, up, surface, u, v, share, direction, to->distance + i,
                                 to->cosine + i);
        to->total[i] = 2.0 * f.half;
    }
    r->value[0][i] = direction[0];
    r->value[1][i] = direction[1];
    r->value[2][i] = direction[2];
    if (surface) {
        const double length = 1.0 / seen.area;

        for (c = 0; c < 3; c++)
            front[c] = (real)(length * seen.normal[c]);
        FN(rectangle_point)(g, g + 3, seen.edge_v, share, point);
        FN(store_surface)(r, i, point, front, (real)to->distance[i], share[0], share[1]);
    }

    hidden = (wave->facing == PSC_FACING_ONE) & (where == PSC_CASE_EMPTY);
    fit &= (wave->facing != PSC_FACING_ONE) | (where >= 0.0);
    hidden |= wave->one_sided & (seen.volume > 0.0);
    to->status[i] = !fit ? PSC_PENDING : hidden ? PSC_EMPTY : PSC_SUCCESS;
}

#define PLAIN_WAVE(name, area, has_normal, surface)                                            \
    static void FN(name)(const struct psc_wave *restrict wave, const real *restrict u,         \
                         const real *restrict v, struct FN(psc_rectangles) *restrict to,       \
                         struct FN(psc_results) *restrict r)                                   \
    {                                                                                          \
        const size_t n = wave->count;                                                          \
        size_t i;                                                                              \
                                                                                               \
        for (i = 0; i < n; i++)                                                                \
            FN(plain_element)(wave, area, has_normal, surface, i, u[i], v[i], to, r);          \
    }
PLAIN_WAVE(plain_rectangles_around, 0, 0, 0)
PLAIN_WAVE(plain_rectangles_above, 0, 1, 0)
PLAIN_WAVE(plain_rectangles_around_whole, 0, 0, 1)
PLAIN_WAVE(plain_rectangles_above_whole, 0, 1, 1)
PLAIN_WAVE(plain_areas_around, 1, 0, 1)
PLAIN_WAVE(plain_areas_above, 1, 1, 1)
#undef PLAIN_WAVE

/* Densities, weights and what becomes of the elements. */
static void FN(rectangle_finish)(const struct psc_wave *restrict wave, int area,
                                 const struct FN(psc_rectangles) *restrict from,
                                 struct FN(psc_results) *restrict r)
{
    const enum psc_facing facing = wave->facing;
    const size_t n = wave->count;
    size_t i;

    for (i = 0; i < n; i++)
        FN(rectangle_density)(area, from->volume[i], from->total[i], facing,
                              area ? from->distance[i] : 1.0, from->cosine[i],
                              r->value[PSC_PDF] + i, r->value[PSC_WEIGHT] + i);
    for (i = 0; i < n; i++)
        r->status[i] = !(from->total[i] > 0.0)            ? PSC_PENDING
                       : from->status[i] != PSC_SUCCESS   ? from->status[i]
                       : r->value[PSC_WEIGHT][i] > K(0.0) ? PSC_SUCCESS
                                                          : PSC_CULLED;
}

#include "rectangle_exact_wave_tmpl.h"

static void FN(rectangle_wave)(const struct psc_wave *wave, const real *u, const real *v,
                               struct FN(psc_results) *r)
{
    const int area = wave->measure == PSC_MEASURE_AREA, around = wave->facing == PSC_FACING_NONE;
    struct FN(psc_rectangles) all;

    if (wave->map != PSC_MAP_PARALLEL) {
        FN(pending_wave)(wave, u, v, r);
        return;
    }
    (area && around          ? FN(plain_areas_around)
     : area                  ? FN(plain_areas_above)
     : around && wave->surface ? FN(plain_rectangles_around_whole)
     : around                ? FN(plain_rectangles_around)
     : wave->surface         ? FN(plain_rectangles_above_whole)
                             : FN(plain_rectangles_above))(wave, u, v, &all, r);
    FN(rectangle_finish)(wave, area, &all, r);
    FN(exact_rectangles)(wave, u, v, r);
}
