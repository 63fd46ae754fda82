/* SPDX-License-Identifier: Apache-2.0 */
#include "maps.h"

#include <cairo.h>
#include <stdio.h>
#include <stdlib.h>

#define TURN 6.2831853

enum { CURVES = 12, STEPS = 384, LEFT = 44, TOP = 84, BELOW = 34 };

/* ---- From directions to the page ----------------------------------------------------------- */

typedef struct page_point {
    double x, y;
} page_point;

static page_point on_page(const map_row *row, double x, double y, double z)
{
    const double widen = row->horizon ? 1 : sqrt(2 / (1 + z));
    return (page_point){(widen * x - row->left) * row->length,
                        (-row->top - widen * y) * row->length};
}

static void words(cairo_t *cr, double x, double y, double align, double size, int bold,
                  const char *s)
{
    cairo_text_extents_t e;
    cairo_select_font_face(cr, "sans-serif", CAIRO_FONT_SLANT_NORMAL,
                           bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(cr, size);
    cairo_text_extents(cr, s, &e);
    cairo_move_to(cr, x - align * e.x_advance, y);
    cairo_show_text(cr, s);
}

/* ---- Cells --------------------------------------------------------------------------------- */

/* The horizon, and the edge of the light: dashed where it is below. */
static void draw_outlines(cairo_t *cr, const map_row *row)
{
    cairo_set_line_width(cr, 1.4);
    cairo_set_source_rgb(cr, 0.2, 0.2, 0.2);
    if (row->horizon) {
        const page_point zenith = on_page(row, 0, 0, 1);
        cairo_arc(cr, zenith.x, zenith.y, row->length, 0, TURN);
        cairo_stroke(cr);
    }
    for (int below = 0; below <= row->horizon; ++below) {
        const double dash[2] = {4, 3};
        int drawing = 0;
        cairo_set_dash(cr, dash, below ? 2 : 0, 0);
        for (int i = 0; i <= STEPS; ++i) {
            double p[3];
            row->shape->outline(row->number, map_vectors(row), (double)i / STEPS, p);
            const double s = 1 / sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
            const page_point q = on_page(row, p[0] * s, p[1] * s, p[2] * s);
            const int here = !row->horizon || (p[2] < 0) == below;
            if (here)
                (drawing ? cairo_line_to : cairo_move_to)(cr, q.x, q.y);
            drawing = here;
        }
        cairo_stroke(cr);
    }
    cairo_set_dash(cr, NULL, 0, 0);
}

static page_point sample_on_page(const map_row *row, const warped *w, int i)
{
    return on_page(row, w->direction[0][i], w->direction[1][i], w->direction[2][i]);
}

static void draw_curves(cairo_t *cr, const map_row *row, const psc_sampler *sampler, warped *w)
{
    cairo_set_line_width(cr, 0.9);
    for (int along_u = 0; along_u < 2; ++along_u) {
        if (along_u)
            cairo_set_source_rgb(cr, 0.80, 0.16, 0.14);
        else
            cairo_set_source_rgb(cr, 0.10, 0.38, 0.72);
        for (int k = 0; k <= CURVES; ++k) {
            int drawing = 0;
            for (int i = 0; i <= STEPS; ++i) {
                w->u[i] = along_u ? (double)i / STEPS : (double)k / CURVES;
                w->v[i] = along_u ? (double)k / CURVES : (double)i / STEPS;
            }
            map_warp(sampler, w, STEPS + 1);
            for (int i = 0; i <= STEPS; ++i) {
                const page_point p = sample_on_page(row, w, i);
                const int visible = w->status[i] == PSC_SUCCESS;
                if (visible)
                    (drawing ? cairo_line_to : cairo_move_to)(cr, p.x, p.y);
                drawing = visible;
            }
            cairo_stroke(cr);
        }
    }
}

/* Returns how many of the lattice's points are above the horizon. */
static int draw_points(cairo_t *cr, const map_row *row, const psc_sampler *sampler, warped *w)
{
    int above = 0;

    map_lattice(w, 0);
    map_warp(sampler, w, LATTICE);
    cairo_set_source_rgb(cr, 0.08, 0.22, 0.45);
    for (int i = 0; i < LATTICE; ++i)
        if (w->status[i] == PSC_SUCCESS) {
            const page_point p = sample_on_page(row, w, i);
            cairo_arc(cr, p.x, p.y, 1.25, 0, TURN);
            cairo_fill(cr);
            ++above;
        }
    return above;
}

/* How many of the points are outside the light or below the horizon: a ray a little inwards from
   the edge must meet the light. */
static int count_strays(const map_row *row, const warped *w)
{
    float number[LIGHT_NUMBERS];
    double middle[3] = {0, 0, 0};
    int strays = 0;

    for (unsigned i = 0; i < row->count; ++i)
        number[i] = (float)row->number[i];
    for (int i = 0; i < LATTICE; ++i)
        for (int c = 0; c < 3; ++c)
            middle[c] += w->direction[c][i] / LATTICE;
    for (int i = 0; i < LATTICE; ++i) {
        float d[3];
        for (int c = 0; c < 3; ++c)
            d[c] = (float)(w->direction[c][i] + 1e-5 * (middle[c] - w->direction[c][i]));
        strays += w->status[i] != PSC_SUCCESS || !(w->direction[2][i] >= 0) ||
                  !(row->shape->meet(number, map_vectors(row), (vec3){0, 0, 0},
                                     unit((vec3){d[0], d[1], d[2]})) < INFINITY);
    }
    return strays;
}

/* ---- Figures ------------------------------------------------------------------------------- */

/* One cell of the half with curves or of that with points; returns the strays. */
static int draw_cell(cairo_t *cr, const map_figure *f, const technique_row *column,
                     const map_row *row, int points)
{
    static warped w;
    psc_sampler_storage storage;
    psc_sampler *sampler;
    char caption[32] = "";
    int strays = 0;

    map_check(psc_sampler_init(&storage, sizeof storage, &sampler), "making a sampler");
    map_build(sampler, column, row);
    cairo_rectangle(cr, 0, 0, f->across - 8, f->down);
    cairo_clip(cr);
    draw_outlines(cr, row);
    if (points) {
        const int above = draw_points(cr, row, sampler, &w);
        if (row->horizon)
            snprintf(caption, sizeof caption, "%d of %d visible", above, LATTICE);
        if (column->measure == PSC_MEASURE_PROJECTED_SOLID_ANGLE)
            strays = count_strays(row, &w);
    } else {
        draw_curves(cr, row, sampler, &w);
    }
    cairo_reset_clip(cr);
    cairo_set_source_rgb(cr, 0.3, 0.3, 0.3);
    words(cr, f->across / 2.0, f->down + 16, 0.5, 12, 0, caption);
    return strays;
}

int map_draw(const map_figure *f, const char *directory)
{
    const int half_width = (int)f->column_count * f->across, next = f->down + BELOW;
    char path[4096];
    int strays = 0;

    snprintf(path, sizeof path, "%s/%s.png", directory, f->name);
    cairo_surface_t *s = cairo_image_surface_create(
        CAIRO_FORMAT_RGB24, LEFT + 2 * half_width + 30, TOP + (int)f->row_count * next);
    cairo_t *cr = cairo_create(s);
    cairo_set_source_rgb(cr, 1, 1, 1);
    cairo_paint(cr);

    for (int half = 0; half < 2; ++half) {
        const double x = LEFT + half * (half_width + 16);
        cairo_set_source_rgb(cr, 0, 0, 0);
        words(cr, x + half_width / 2.0, 30, 0.5, 17, 1,
              half ? "1024-point lattice" : "Curves of constant u and v");
        for (unsigned m = 0; m < f->column_count; ++m) {
            cairo_set_source_rgb(cr, 0, 0, 0);
            words(cr, x + (m + 0.5) * f->across - 5, 66, 0.5, 14.5, 0, f->columns[m].name);
            for (unsigned c = 0; c < f->row_count; ++c) {
                if (!(f->rows[c].columns >> m & 1))
                    continue;
                cairo_save(cr);
                cairo_translate(cr, x + (int)m * f->across, TOP + (int)c * next);
                strays += draw_cell(cr, f, &f->columns[m], &f->rows[c], half);
                cairo_restore(cr);
            }
        }
    }
    for (unsigned c = 0; c < f->row_count; ++c) {
        cairo_save(cr);
        cairo_translate(cr, 26, TOP + (int)c * next + f->down / 2.0);
        cairo_rotate(cr, -1.5707963);
        cairo_set_source_rgb(cr, 0, 0, 0);
        words(cr, 0, 0, 0.5, 13.5, 0, f->rows[c].caption);
        cairo_restore(cr);
    }
    cairo_destroy(cr);
    if (cairo_surface_write_to_png(s, path) != CAIRO_STATUS_SUCCESS) {
        fprintf(stderr, "maps: cannot write %s\n", path);
        exit(EXIT_FAILURE);
    }
    cairo_surface_destroy(s);
    printf("wrote %s: what each map does to the unit square\n", path);
    return strays;
}
