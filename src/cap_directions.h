/* SPDX-License-Identifier: Apache-2.0 */
/* Blocks of densities and inverses of a cap, in double for both precisions: loops over the lane
   functions of the calls for one, so that the bits are the same. */
#ifndef PSC_SRC_CAP_DIRECTIONS_H
#define PSC_SRC_CAP_DIRECTIONS_H

#include "cap_inverse.h"
#include "sampler.h"

/* ---- Densities ---- */

#define PDF_LOOP(name, area, inside, projected)                                                \
    static void name(const struct psc_cap_light *from, int k, double inverse_total,            \
                     struct psc_directions *restrict d)                                        \
    {                                                                                          \
        const double epsilon = d->epsilon, h0 = seen_reach(from, k);                           \
        const struct psc_cap_light light = *from;                                              \
        const struct psc_side side = from->side[k];                                            \
        const size_t n = d->count;                                                             \
        size_t i;                                                                              \
                                                                                               \
        for (i = 0; i < n; i++) {                                                              \
            double direction[3], pdf;                                                          \
                                                                                               \
            psc_load_direction(d, i, direction);                                               \
            pdf = seen_pdf(&light, &side, h0, area, inside, projected, inverse_total,          \
                           direction, epsilon);                                                \
            d->pdf[i] = MAX(pdf, d->pdf[i]);                                                   \
        }                                                                                      \
    }
PDF_LOOP(pdf_cone, 0, 0, 0)
PDF_LOOP(pdf_projected, 0, 0, 1)
PDF_LOOP(pdf_area, 1, 0, 0)
PDF_LOOP(pdf_area_inside, 1, 1, 0)
#undef PDF_LOOP

/* At most one side has the direction. */
static void cap_pdfs(const psc_sampler *s, struct psc_directions *d)
{
    const struct psc_cap_light *light = &s->cap;
    const int area = is_area_map(light->side[0].map);
    int k;

    memset(d->pdf, 0, d->count * sizeof *d->pdf);
    for (k = 0; k < s->sides; k++)
        (area           ? light->inside ? pdf_area_inside : pdf_area
         : s->projected ? pdf_projected
                        : pdf_cone)(light, k, s->inverse_total, d);
}

/* ---- Inverses ---- */

/* The directions that one side holds, packed. */
struct packed_seen {
    struct {
        double x[PSC_BLOCK], y[PSC_BLOCK], h[PSC_BLOCK], depth[PSC_BLOCK], height[PSC_BLOCK];
    } seen;
    double direction[3][PSC_BLOCK];
    double uv[2][PSC_BLOCK];
};

#define LOOK_LOOP(name, projected)                                                             \
    static void name(const struct psc_cap_light *from, int k,                                  \
                     const struct psc_directions *restrict d, struct packed_seen *restrict to, \
                     int32_t *restrict within)                                                 \
    {                                                                                          \
        const struct psc_side side = from->side[k];                                            \
        const double epsilon = d->epsilon, h0 = seen_reach(from, k);                           \
        const size_t n = d->count;                                                             \
        size_t i;                                                                              \
                                                                                               \
        for (i = 0; i < n; i++) {                                                              \
            double direction[3];                                                               \
            struct seen seen;                                                                  \
                                                                                               \
            psc_load_direction(d, i, direction);                                               \
            within[i] = look(&side, direction, seen_stretch(direction), epsilon, h0,           \
                             projected, &seen);                                                \
            to->seen.x[i] = seen.x;                                                            \
            to->seen.y[i] = seen.y;                                                            \
            to->seen.h[i] = seen.h;                                                            \
            to->seen.depth[i] = seen.depth;                                                    \
            to->seen.height[i] = seen.height;                                                  \
        }                                                                                      \
    }
LOOK_LOOP(look_cone, 0)
LOOK_LOOP(look_projected, 1)
#undef LOOK_LOOP

#define INVERT_LOOP(name, map, concentric, inside)                                             \
    static void name(const struct psc_cap_light *from, int side,                               \
                     struct packed_seen *restrict k, size_t n)                                 \
    {                                                                                          \
        const struct psc_cap_light light = *from;                                              \
        size_t i;                                                                              \
                                                                                               \
        for (i = 0; i < n; i++) {                                                              \
            const struct seen seen = {k->seen.x[i], k->seen.y[i], k->seen.h[i],                \
                                      k->seen.depth[i], k->seen.height[i]};                    \
            const double direction[3] = {k->direction[0][i], k->direction[1][i],               \
                                         k->direction[2][i]};                                  \
            double uv[2];                                                                      \
                                                                                               \
            seen_invert(&light, side, map, concentric, inside, direction, &seen, uv);          \
            k->uv[0][i] = uv[0];                                                               \
            k->uv[1][i] = uv[1];                                                               \
        }                                                                                      \
    }
INVERT_LOOP(invert_radial_cone, PSC_CAP_RADIAL_CONE, 0, 0)
INVERT_LOOP(invert_concentric_cone, PSC_CAP_CONCENTRIC_CONE, 1, 0)
INVERT_LOOP(invert_radial_ellipse, PSC_CAP_RADIAL_ELLIPSE, 0, 0)
INVERT_LOOP(invert_radial_both, PSC_CAP_RADIAL_BOTH, 0, 0)
INVERT_LOOP(invert_radial_lune, PSC_CAP_RADIAL_LUNE, 0, 0)
INVERT_LOOP(invert_parallel_ellipse, PSC_CAP_PARALLEL_ELLIPSE, 0, 0)
INVERT_LOOP(invert_parallel_both, PSC_CAP_PARALLEL_BOTH, 0, 0)
INVERT_LOOP(invert_parallel_lune, PSC_CAP_PARALLEL_LUNE, 0, 0)
INVERT_LOOP(invert_concentric_ellipse, PSC_CAP_CONCENTRIC_ELLIPSE, 1, 0)
INVERT_LOOP(invert_concentric_both, PSC_CAP_CONCENTRIC_BOTH, 1, 0)
INVERT_LOOP(invert_concentric_lune, PSC_CAP_CONCENTRIC_LUNE, 1, 0)
INVERT_LOOP(invert_radial_area, PSC_CAP_RADIAL_AREA, 0, 0)
INVERT_LOOP(invert_concentric_area, PSC_CAP_CONCENTRIC_AREA, 1, 0)
INVERT_LOOP(invert_radial_inside, PSC_CAP_RADIAL_AREA, 0, 1)
INVERT_LOOP(invert_concentric_inside, PSC_CAP_CONCENTRIC_AREA, 1, 1)
#undef INVERT_LOOP

typedef void (*invert_loop)(const struct psc_cap_light *, int, struct packed_seen *, size_t);
#define INVERT_ROW(name, lane, native) invert_##lane,
static const invert_loop invert_loops[] = {PSC_CAP_MAPS(INVERT_ROW) invert_radial_area,
                                           invert_concentric_area, invert_radial_inside,
                                           invert_concentric_inside};
#undef INVERT_ROW

/* Moves the elements of the index to the front; the index rises. */
static void pack_seen(const struct psc_directions *d, const uint32_t *index, size_t n,
                      struct packed_seen *k)
{
    size_t j;

    for (j = 0; j < n; j++) {
        const uint32_t i = index[j];

        k->seen.x[j] = k->seen.x[i];
        k->seen.y[j] = k->seen.y[i];
        k->seen.h[j] = k->seen.h[i];
        k->seen.depth[j] = k->seen.depth[i];
        k->seen.height[j] = k->seen.height[i];
        k->direction[0][j] = d->direction[0][i];
        k->direction[1][j] = d->direction[1][i];
        k->direction[2][j] = d->direction[2][i];
    }
}

static void cap_inverses(const psc_sampler *s, struct psc_directions *d)
{
    const struct psc_cap_light *light = &s->cap;
    int32_t within[PSC_BLOCK];
    uint32_t index[PSC_BLOCK];
    struct packed_seen k;
    size_t i, n;
    int side;

    for (i = 0; i < d->count; i++)
        d->status[i] = PSC_OUTSIDE;
    for (side = 0; side < s->sides; side++) {
        const enum psc_cap_map map = light->side[side].map;

        (s->projected ? look_projected : look_cone)(light, side, d, &k, within);
        for (n = 0, i = 0; i < d->count; i++) {
            index[n] = (uint32_t)i;
            n += within[i] && d->status[i] == PSC_OUTSIDE;
        }
        pack_seen(d, index, n, &k);
        invert_loops[is_area_map(map) && light->inside ? map + 2 : map](light, side, &k, n);
        for (i = 0; i < n; i++) {
            double uv[2] = {k.uv[0][i], k.uv[1][i]};

            share_sides(s->sides, side, s->split, uv);
            d->uv[0][index[i]] = uv[0];
            d->uv[1][index[i]] = uv[1];
            d->status[index[i]] = PSC_SUCCESS;
        }
    }
}

#endif
