/* SPDX-License-Identifier: Apache-2.0 */
/* Blocks of densities and inverses of a rectangle's maps along its edges, in double for both
   precisions: loops over the lane functions of the calls for one, so that the bits are the same.
   Its other maps are left to those. */
#ifndef PSC_SRC_RECTANGLE_DIRECTIONS_H
#define PSC_SRC_RECTANGLE_DIRECTIONS_H

#include "rectangle_build.h"

#define PDF_LOOP(name, area)                                                                   \
    static void name(const struct psc_rectangle *from, double volume, double inverse_total,    \
                     struct psc_directions *restrict d)                                        \
    {                                                                                          \
        const double slack = 32.0 * d->epsilon;                                                \
        const struct psc_rectangle f = *from;                                                  \
        const size_t n = d->count;                                                             \
        size_t i;                                                                              \
                                                                                               \
        for (i = 0; i < n; i++) {                                                              \
            double direction[3], pdf;                                                          \
            struct psc_rectangle_point p;                                                      \
            int within;                                                                        \
                                                                                               \
            psc_load_direction(d, i, direction);                                               \
            within = rectangle_look(&f, direction, slack, &p);                                 \
            pdf = rectangle_pdf(&f, &p, area, volume, inverse_total);                          \
            d->pdf[i] = within ? pdf : 0.0;                                                    \
        }                                                                                      \
    }
PDF_LOOP(pdf_rectangle, 0)
PDF_LOOP(pdf_rectangle_area, 1)
#undef PDF_LOOP

#define INVERT_LOOP(name, area, around)                                                        \
    static void name(const struct psc_rectangle *from, struct psc_directions *restrict d,      \
                     double *restrict within, double *restrict ahead)                          \
    {                                                                                          \
        const struct psc_rectangle f = *from;                                                  \
        const size_t n = d->count;                                                             \
        size_t i;                                                                              \
                                                                                               \
        for (i = 0; i < n; i++) {                                                              \
            double direction[3], uv[2];                                                        \
            struct psc_rectangle_point p;                                                      \
                                                                                               \
            psc_load_direction(d, i, direction);                                               \
            rectangle_meet(&f, direction, &p, within + i, ahead + i);                          \
            uv[0] = p.u;                                                                       \
            uv[1] = p.v;                                                                       \
            if (!area)                                                                         \
                rectangle_invert(&f, around, &p, uv);                                          \
            d->uv[0][i] = uv[0];                                                               \
            d->uv[1][i] = uv[1];                                                               \
        }                                                                                      \
    }
INVERT_LOOP(invert_rectangle_around, 0, 1)
INVERT_LOOP(invert_rectangle_beside, 0, 0)
INVERT_LOOP(invert_rectangle_area, 1, 0)
#undef INVERT_LOOP

static void rectangle_pdfs(const psc_sampler *s, struct psc_directions *d)
{
    double direction[3];
    struct psc_rectangle own;
    size_t i;

    if (s->map == PSC_MAP_PARALLEL) {
        (s->measure == PSC_MEASURE_AREA ? pdf_rectangle_area : pdf_rectangle)(
            rectangle_of(&s->polygon, &own), s->polygon.volume, s->inverse_total, d);
        return;
    }
    for (i = 0; i < d->count; i++) {
        psc_load_direction(d, i, direction);
        d->pdf[i] = s->shape->pdf(s, direction, d->epsilon);
    }
}

static void rectangle_inverses(const psc_sampler *s, struct psc_directions *d)
{
    double within[PSC_BLOCK], ahead[PSC_BLOCK], direction[3], uv[2];
    const double slack = 32.0 * d->epsilon;
    struct psc_rectangle own;
    size_t i;
    int c;

    if (s->map == PSC_MAP_PARALLEL) {
        const struct psc_rectangle *const f = rectangle_to_invert(s, &own);

        (s->measure == PSC_MEASURE_AREA ? invert_rectangle_area
         : f->x_a == 0.0                ? invert_rectangle_around
                                        : invert_rectangle_beside)(f, d, within, ahead);
        for (c = 0; c < 2; c++)
            for (i = 0; i < d->count; i++)
                d->uv[c][i] = MIN(MAX(d->uv[c][i], 0.0), 1.0);
        for (i = 0; i < d->count; i++)
            d->status[i] = within[i] >= -slack && ahead[i] > 0.0 ? PSC_SUCCESS : PSC_OUTSIDE;
        return;
    }
    for (i = 0; i < d->count; i++) {
        psc_load_direction(d, i, direction);
        d->status[i] = s->shape->invert(s, direction, d->epsilon, uv);
        if (d->status[i] == PSC_SUCCESS) {
            d->uv[0][i] = uv[0];
            d->uv[1][i] = uv[1];
        }
    }
}

#endif
