/* SPDX-License-Identifier: Apache-2.0 */
#include "picture.h"

#include <cairo.h>
#include <stdio.h>
#include <stdlib.h>

enum { WIDTH = 440, HEIGHT = 330, LEFT = 66, TOP = 40, RIGHT = 16, BOTTOM = 48 };

static const double colours[][3] = {
    {0.45, 0.45, 0.45}, {0.84, 0.15, 0.16}, {0.12, 0.47, 0.71}, {0.17, 0.63, 0.17}};

typedef struct axes {
    double x, y;            /* corner of the drawing area on the page */
    double low[2], high[2]; /* logarithms of what it spans */
} axes;

static double across(const axes *a, double value)
{
    return a->x + (log10(value) - a->low[0]) / (a->high[0] - a->low[0]) * (WIDTH - LEFT - RIGHT);
}

static double down(const axes *a, double value)
{
    return a->y + (a->high[1] - log10(value)) / (a->high[1] - a->low[1]) * (HEIGHT - TOP - BOTTOM);
}

static void words(cairo_t *cr, double x, double y, double align, const char *s)
{
    cairo_text_extents_t e;
    cairo_text_extents(cr, s, &e);
    cairo_move_to(cr, x - align * e.x_advance, y);
    cairo_show_text(cr, s);
    cairo_new_path(cr);
}

static void widen(axes *a, int axis, double value)
{
    if (log10(value) < a->low[axis])
        a->low[axis] = log10(value);
    if (log10(value) > a->high[axis])
        a->high[axis] = log10(value);
}

/* A line of the grid and its number, if it is within the axes. */
static void grid_line(cairo_t *cr, const axes *a, int axis, double value)
{
    char number[32];

    if (log10(value) < a->low[axis] - 1e-9 || log10(value) > a->high[axis] + 1e-9)
        return;
    snprintf(number, sizeof number, "%g", value);
    cairo_set_source_rgb(cr, 0.88, 0.88, 0.88);
    if (axis == 0) {
        cairo_move_to(cr, across(a, value), a->y);
        cairo_rel_line_to(cr, 0, HEIGHT - TOP - BOTTOM);
    } else {
        cairo_move_to(cr, a->x, down(a, value));
        cairo_rel_line_to(cr, WIDTH - LEFT - RIGHT, 0);
    }
    cairo_stroke(cr);
    cairo_set_source_rgb(cr, 0.25, 0.25, 0.25);
    if (axis == 0)
        words(cr, across(a, value), a->y + HEIGHT - TOP - BOTTOM + 16, 0.5, number);
    else
        words(cr, a->x - 6, down(a, value) + 4, 1, number);
}

/* Samples have lines at the powers of two, anything else at 1, 2 and 5 times those of ten. */
static void grid(cairo_t *cr, const axes *a, int by_time)
{
    for (int n = 1; n <= 128 && !by_time; n *= 2)
        grid_line(cr, a, 0, n);
    for (int power = -9; power < 9; ++power)
        for (int m = 1; m <= 5; m += m == 1 ? 1 : 3) {
            grid_line(cr, a, 1, m * pow(10, power));
            if (by_time)
                grid_line(cr, a, 0, m * pow(10, power));
        }
}

static void draw(cairo_t *cr, double left, int by_time, const curve *curves, unsigned count)
{
    axes a = {left + LEFT, TOP, {1e9, 1e9}, {-1e9, -1e9}};

    for (unsigned c = 0; c < count; ++c)
        for (unsigned i = 0; i < curves[c].count; ++i) {
            widen(&a, 0, by_time ? curves[c].seconds[i] : curves[c].samples[i]);
            widen(&a, 1, curves[c].rms[i]);
        }
    a.low[1] -= 0.1;
    a.high[1] += 0.1;
    cairo_set_font_size(cr, 11);
    cairo_set_line_width(cr, 1);
    grid(cr, &a, by_time);
    words(cr, a.x + (WIDTH - LEFT - RIGHT) / 2.0, HEIGHT - 10, 0.5,
          by_time ? "processor seconds for shading" : "samples a pixel");
    words(cr, a.x, TOP - 10, 0, "RMS error");
    for (unsigned c = 0; c < count; ++c) {
        cairo_set_source_rgb(cr, colours[c][0], colours[c][1], colours[c][2]);
        cairo_set_line_width(cr, 2);
        for (unsigned i = 0; i < curves[c].count; ++i)
            cairo_line_to(cr, across(&a, by_time ? curves[c].seconds[i] : curves[c].samples[i]),
                          down(&a, curves[c].rms[i]));
        cairo_stroke(cr);
        for (unsigned i = 0; i < curves[c].count; ++i) {
            cairo_arc(cr, across(&a, by_time ? curves[c].seconds[i] : curves[c].samples[i]),
                      down(&a, curves[c].rms[i]), 3, 0, 6.2831853);
            cairo_fill(cr);
        }
        words(cr, a.x + 12, a.y + HEIGHT - TOP - BOTTOM - 12 - 15 * (double)(count - 1 - c), 0,
              curves[c].name);
    }
}

void chart_write(const char *path, const char *title, const curve *curves, unsigned count)
{
    cairo_surface_t *s = cairo_image_surface_create(CAIRO_FORMAT_RGB24, 2 * WIDTH, HEIGHT + 24);
    cairo_t *cr = cairo_create(s);

    cairo_set_source_rgb(cr, 1, 1, 1);
    cairo_paint(cr);
    cairo_set_source_rgb(cr, 0, 0, 0);
    cairo_select_font_face(cr, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_BOLD);
    cairo_set_font_size(cr, 14);
    words(cr, WIDTH, 20, 0.5, title);
    cairo_select_font_face(cr, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
    cairo_translate(cr, 0, 24);
    draw(cr, 0, 0, curves, count);
    draw(cr, WIDTH, 1, curves, count);
    cairo_destroy(cr);
    if (cairo_surface_write_to_png(s, path) != CAIRO_STATUS_SUCCESS) {
        fprintf(stderr, "render: cannot write %s\n", path);
        exit(EXIT_FAILURE);
    }
    cairo_surface_destroy(s);
}
