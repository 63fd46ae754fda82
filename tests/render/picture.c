/* SPDX-License-Identifier: Apache-2.0 */
#include "picture.h"

#include <cairo.h>
#include <stdio.h>
#include <stdlib.h>

#define PI 3.14159265358979323846f

enum { GAP = 8, TITLE = 34, HEADING = 24 };

/* ---- Pictures and errors ----------------------------------------------------------------- */

vec3 *picture_make(const frame *f, irradiance light, unsigned count)
{
    const size_t pixels = (size_t)f->width * f->height;
    vec3 *picture = allocate(pixels, sizeof *picture);

    for (unsigned k = 0; k < LAYERS; ++k) {
        const float share = (float)frame_share(k, count) / (float)count;
        for (size_t p = 0; p < pixels && share > 0; ++p) {
            const int32_t i = f->index[k][p];
            vec3 sum = f->backdrop[k][p];
            if (i >= 0) {
                const vec3 e = {(float)light[i][0], (float)light[i][1], (float)light[i][2]};
                sum = add(sum, scale(mul(f->hits[i].albedo, e), 1 / PI));
            }
            picture[p] = add(picture[p], scale(sum, share));
        }
    }
    return picture;
}

/* Where a crop lies in pixels: always whole ones, and as many down as across. */
static void crop_place(const cutout *c, unsigned width, unsigned height, unsigned place[3])
{
    const unsigned size = (unsigned)(c->width * (float)width);
    place[2] = size > 1 ? size : 1;
    place[0] = (unsigned)(c->x * (float)width);
    place[1] = (unsigned)(c->y * (float)height);
    if (place[1] + place[2] > height)
        place[1] = height - place[2];
}

double picture_rms(const frame *f, irradiance light, irradiance reference, unsigned count,
                   const cutout *crop)
{
    unsigned place[3] = {0, 0, 0};
    size_t terms = 0;
    double total = 0;

    if (crop)
        crop_place(crop, f->width, f->height, place);
    for (unsigned y = 0; y < (crop ? place[2] : f->height); ++y)
        for (unsigned x = 0; x < (crop ? place[2] : f->width); ++x) {
            const size_t p = (size_t)(place[1] + y) * f->width + place[0] + x;
            double error[3] = {0, 0, 0};
            int seen = 0;
            for (unsigned k = 0; k < LAYERS; ++k) {
                const int32_t i = f->index[k][p];
                if (i < 0 || !frame_share(k, count))
                    continue;
                const vec3 a = scale(f->hits[i].albedo,
                                     (float)frame_share(k, count) / ((float)count * PI));
                error[0] += a.x * (light[i][0] - reference[i][0]);
                error[1] += a.y * (light[i][1] - reference[i][1]);
                error[2] += a.z * (light[i][2] - reference[i][2]);
                seen = 1;
            }
            total += error[0] * error[0] + error[1] * error[1] + error[2] * error[2];
            terms += seen ? 3 : 0;
        }
    return terms ? sqrt(total / (double)terms) : 0;
}

/* ---- Sheets ------------------------------------------------------------------------------ */

/* Exposed as on film, so that nothing clips, then encoded for an sRGB display. */
static uint32_t display(float linear)
{
    const float x = 1 - expf(-linear);
    return (uint32_t)(255 * (x < 0.0031308f ? 12.92f * x : 1.055f * powf(x, 1 / 2.4f) - 0.055f) +
                      0.5f);
}

static cairo_surface_t *surface_of(const panel *p)
{
    const int width = (int)p->width, height = (int)p->height;
    cairo_surface_t *s = cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height);

    cairo_surface_flush(s);
    for (int y = 0; y < height; ++y) {
        uint32_t *row = (void *)(cairo_image_surface_get_data(s) +
                                 (ptrdiff_t)y * cairo_image_surface_get_stride(s));
        for (int x = 0; x < width; ++x) {
            const vec3 c = p->pixels[(size_t)y * p->width + (size_t)x];
            row[x] = display(c.x) << 16 | display(c.y) << 8 | display(c.z);
        }
    }
    cairo_surface_mark_dirty(s);
    return s;
}

static void font(cairo_t *cr, double size, cairo_font_weight_t weight)
{
    cairo_select_font_face(cr, "sans-serif", CAIRO_FONT_SLANT_NORMAL, weight);
    cairo_set_font_size(cr, size);
}

/* In smaller letters if there is no room. */
static void heading(cairo_t *cr, double x, double y, double size, double room, const char *words)
{
    cairo_text_extents_t e;
    cairo_set_source_rgb(cr, 0.95, 0.95, 0.95);
    font(cr, size, CAIRO_FONT_WEIGHT_BOLD);
    cairo_text_extents(cr, words, &e);
    if (e.x_advance > room)
        font(cr, size * room / e.x_advance, CAIRO_FONT_WEIGHT_BOLD);
    cairo_move_to(cr, x, y);
    cairo_show_text(cr, words);
}

/* A label on a dark plate, legible on any picture. */
static void label(cairo_t *cr, double x, double y, double size, const char *words)
{
    cairo_text_extents_t e;
    if (!*words)
        return;
    font(cr, size, CAIRO_FONT_WEIGHT_NORMAL);
    cairo_text_extents(cr, words, &e);
    cairo_set_source_rgba(cr, 0, 0, 0, 0.72);
    cairo_rectangle(cr, x, y, e.x_advance + 10, size + 8);
    cairo_fill(cr);
    cairo_set_source_rgb(cr, 1, 1, 1);
    cairo_move_to(cr, x + 5, y + size + 2);
    cairo_show_text(cr, words);
}

static void draw_panel(cairo_t *cr, const panel *p, double x, double y)
{
    static const double colour[2][3] = {{1, 0.78, 0.2}, {0.35, 0.85, 1}};
    cairo_surface_t *s = surface_of(p);
    const double view = (p->width - GAP) / 2.0;
    const double size = p->width < 230 ? 10.5 : 13;

    heading(cr, x, y - 8, size + 1, p->width, p->heading);
    cairo_set_source_surface(cr, s, x, y);
    cairo_paint(cr);
    label(cr, x, y, size, p->label);
    for (int i = 0; i < 2; ++i) {
        const double left = x + i * (view + GAP), top = y + p->height + GAP;
        unsigned place[3];
        crop_place(&p->crops[i], p->width, p->height, place);
        cairo_save(cr);
        cairo_rectangle(cr, left, top, view, view);
        cairo_clip(cr);
        cairo_translate(cr, left, top);
        cairo_scale(cr, view / place[2], view / place[2]);
        cairo_set_source_surface(cr, s, -(double)place[0], -(double)place[1]);
        cairo_pattern_set_filter(cairo_get_source(cr), CAIRO_FILTER_NEAREST);
        cairo_paint(cr);
        cairo_restore(cr);
        cairo_set_line_width(cr, 2);
        cairo_set_source_rgb(cr, colour[i][0], colour[i][1], colour[i][2]);
        cairo_rectangle(cr, left + 1, top + 1, view - 2, view - 2);
        cairo_stroke(cr);
        cairo_rectangle(cr, x + place[0] - 1, y + place[1] - 1, place[2] + 2, place[2] + 2);
        cairo_stroke(cr);
        label(cr, left + 2, top + 2, size, p->crop_label[i]);
    }
    cairo_surface_destroy(s);
}

void sheet_write(const char *path, const char *title, const panel *panels, unsigned rows,
                 unsigned columns)
{
    const unsigned across = panels->width + GAP;
    const unsigned down = panels->height + GAP + (panels->width - GAP) / 2 + GAP + HEADING;
    cairo_surface_t *s = cairo_image_surface_create(
        CAIRO_FORMAT_RGB24, (int)(columns * across + GAP), (int)(rows * down + TITLE));
    cairo_t *cr = cairo_create(s);

    cairo_set_source_rgb(cr, 0.11, 0.11, 0.13);
    cairo_paint(cr);
    heading(cr, GAP, TITLE - 12, 16, columns * across - GAP, title);
    for (unsigned i = 0; i < rows * columns; ++i)
        draw_panel(cr, &panels[i], GAP + i % columns * across,
                   TITLE + HEADING + i / columns * down);
    cairo_destroy(cr);
    if (cairo_surface_write_to_png(s, path) != CAIRO_STATUS_SUCCESS) {
        fprintf(stderr, "render: cannot write %s\n", path);
        exit(EXIT_FAILURE);
    }
    cairo_surface_destroy(s);
}
