/* SPDX-License-Identifier: Apache-2.0 */
/* Draws what the maps do to the unit square: figure 5 of Urena and Georgiev, Stratified Sampling
   of Projected Spherical Caps, EGSR 2018. Light is seen from above, projected on the receiver's
   plane, where projected solid angle is area. Fails if a map of projected solid angle leaves the
   visible part of the light. */
#include <psc/psc.h>

#include <cairo.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum {
    POINTS = 1024, CURVES = 12, STEPS = 384, MAPS = 4, CASES = 3,
    CELL = 166, TALL = 284, LEFT = 44, TOP = 84, NEXT = TALL + 34
};

/* The window of each cell, in units of the horizon's radius. */
static const double window_x = 0.17, window_y = -0.755, unit_length = 188;

static const struct {
    const char *name;
    psc_measure measure;
    psc_map map;
} maps[MAPS] = {
    {"solid angle", PSC_MEASURE_SOLID_ANGLE, PSC_MAP_RADIAL},
    {"projected, radial", PSC_MEASURE_PROJECTED_SOLID_ANGLE, PSC_MAP_RADIAL},
    {"projected, parallel", PSC_MEASURE_PROJECTED_SOLID_ANGLE, PSC_MAP_PARALLEL},
    {"projected, concentric", PSC_MEASURE_PROJECTED_SOLID_ANGLE, PSC_MAP_CONCENTRIC},
};

static const struct {
    const char *name;
    psc_case visibility;
    double half_angle, elevation;
} cases[CASES] = {
    {"ellipse", PSC_CASE_ELLIPSE, 0.60, 0.72},
    {"ellipse and lune", PSC_CASE_ELLIPSE_AND_LUNE, 0.78, 0.30},
    {"lune", PSC_CASE_LUNE, 0.78, -0.16},
};

/* Points of the unit square and where a map takes them. */
typedef struct warped {
    double u[POINTS], v[POINTS], x[POINTS], y[POINTS], z[POINTS];
    psc_result status[POINTS];
} warped;

static void check(psc_result result, const char *what)
{
    if (result == PSC_SUCCESS)
        return;
    fprintf(stderr, "maps: %s: %s\n", what, psc_result_string(result));
    exit(EXIT_FAILURE);
}

static void build(psc_sampler *sampler, int map, int which)
{
    static const double origin[3] = {0, 0, 0}, up[3] = {0, 0, 1};
    const double axis[3] = {cos(cases[which].elevation), 0, sin(cases[which].elevation)};
    const psc_receiver receiver = {sizeof receiver, 0, origin, up};
    const psc_technique technique = {sizeof technique, maps[map].measure, maps[map].map, 0};
    psc_description description = {.struct_size = sizeof description};

    check(psc_build_cap(sampler, &technique, &receiver, axis, cases[which].half_angle), "building");
    check(psc_sampler_describe(sampler, &description), "describing");
    if (description.visibility != cases[which].visibility) {
        fprintf(stderr, "maps: this should be the case of the %s\n", cases[which].name);
        exit(EXIT_FAILURE);
    }
}

/* Takes the first count points to the light; returns how many are above the horizon. */
static int warp(const psc_sampler *sampler, warped *w, int count)
{
    const psc_input_f64 uv = {{w->u, w->v}, sizeof(double)};
    const psc_samples_f64 out = {.struct_size = sizeof out,
                                 .direction = {{w->x, w->y, w->z}, sizeof(double)},
                                 .status = {w->status, sizeof(psc_result)}};
    int above = 0;

    check(psc_sample_n_f64(sampler, (size_t)count, &uv, &out), "sampling");
    for (int i = 0; i < count; ++i)
        above += w->status[i] == PSC_SUCCESS;
    return above;
}

/* ---- Drawing ----------------------------------------------------------------------------- */

static double page_x(double x) { return (x - window_x) * unit_length; }
static double page_y(double y) { return (-window_y - y) * unit_length; }

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

/* The horizon, and the edge of the light: dashed where it is below. */
static void draw_outlines(cairo_t *cr, int which)
{
    const double a = cases[which].half_angle, b = cases[which].elevation;

    cairo_arc(cr, page_x(0), page_y(0), unit_length, 0, 6.2831853);
    cairo_set_line_width(cr, 1.4);
    cairo_set_source_rgb(cr, 0.2, 0.2, 0.2);
    cairo_stroke(cr);
    for (int below = 0; below < 2; ++below) {
        const double dash[2] = {4, 3};
        int drawing = 0;
        cairo_set_dash(cr, dash, below ? 2 : 0, 0);
        for (int i = 0; i <= STEPS; ++i) {
            const double t = 6.2831853 * i / STEPS;
            const double x = cos(a) * cos(b) - sin(a) * sin(b) * cos(t), y = sin(a) * sin(t);
            const double z = cos(a) * sin(b) + sin(a) * cos(b) * cos(t);
            if ((z < 0) == below)
                (drawing ? cairo_line_to : cairo_move_to)(cr, page_x(x), page_y(y));
            drawing = (z < 0) == below;
        }
        cairo_stroke(cr);
    }
    cairo_set_dash(cr, NULL, 0, 0);
}

static void draw_curves(cairo_t *cr, const psc_sampler *sampler, warped *w)
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
            warp(sampler, w, STEPS + 1);
            for (int i = 0; i <= STEPS; ++i) {
                const int visible = w->status[i] == PSC_SUCCESS;
                if (visible)
                    (drawing ? cairo_line_to : cairo_move_to)(cr, page_x(w->x[i]), page_y(w->y[i]));
                drawing = visible;
            }
            cairo_stroke(cr);
        }
    }
}

/* The rank-1 lattice of Korobov with generating vector (1, 275). */
static int draw_points(cairo_t *cr, const psc_sampler *sampler, warped *w)
{
    for (int i = 0; i < POINTS; ++i) {
        w->u[i] = (double)i / POINTS;
        w->v[i] = (double)(i * 275 % POINTS) / POINTS;
    }
    const int above = warp(sampler, w, POINTS);
    cairo_set_source_rgb(cr, 0.08, 0.22, 0.45);
    for (int i = 0; i < POINTS; ++i)
        if (w->status[i] == PSC_SUCCESS) {
            cairo_arc(cr, page_x(w->x[i]), page_y(w->y[i]), 1.25, 0, 6.2831853);
            cairo_fill(cr);
        }
    return above;
}

/* How many of the points are outside the light or below the horizon, but for rounding. */
static int count_strays(const warped *w, int which)
{
    const double a = cases[which].half_angle, b = cases[which].elevation;
    int strays = 0;
    for (int i = 0; i < POINTS; ++i)
        strays += w->status[i] != PSC_SUCCESS || !(w->z[i] >= 0) ||
                  !(w->x[i] * cos(b) + w->z[i] * sin(b) >= cos(a) - 1e-15);
    return strays;
}

int main(int argc, char **argv)
{
    static warped w;
    psc_sampler_storage storage;
    psc_sampler *sampler;
    int strays = 0;

    if (argc != 2 || argv[1][0] == '-') {
        fprintf(stderr, "Usage: maps FILE.png\n"
                        "Draws curves of constant u and v, and a lattice of %d points, as each "
                        "map lays them over a light.\n", POINTS);
        return EXIT_FAILURE;
    }
    cairo_surface_t *s = cairo_image_surface_create(
        CAIRO_FORMAT_RGB24, LEFT + 2 * MAPS * CELL + 30, TOP + CASES * NEXT);
    cairo_t *cr = cairo_create(s);
    cairo_set_source_rgb(cr, 1, 1, 1);
    cairo_paint(cr);
    check(psc_sampler_init(&storage, sizeof storage, &sampler), "making a sampler");

    for (int half = 0; half < 2; ++half) {
        const double x = LEFT + half * (MAPS * CELL + 16);
        cairo_set_source_rgb(cr, 0, 0, 0);
        words(cr, x + MAPS * CELL / 2.0, 30, 0.5, 17, 1,
              half ? "1024-point lattice" : "Curves of constant u and v");
        for (int m = 0; m < MAPS; ++m) {
            cairo_set_source_rgb(cr, 0, 0, 0);
            words(cr, x + (m + 0.5) * CELL - 5, 66, 0.5, 14.5, 0, maps[m].name);
            for (int c = 0; c < CASES; ++c) {
                char caption[32] = "";
                build(sampler, m, c);
                cairo_save(cr);
                cairo_translate(cr, x + m * CELL, TOP + c * NEXT);
                cairo_rectangle(cr, 0, 0, CELL - 8, TALL);
                cairo_clip(cr);
                draw_outlines(cr, c);
                if (half) {
                    const int above = draw_points(cr, sampler, &w);
                    snprintf(caption, sizeof caption, "%d of %d visible", above, POINTS);
                    if (maps[m].measure == PSC_MEASURE_PROJECTED_SOLID_ANGLE)
                        strays += count_strays(&w, c);
                } else {
                    draw_curves(cr, sampler, &w);
                }
                cairo_reset_clip(cr);
                cairo_set_source_rgb(cr, 0.3, 0.3, 0.3);
                words(cr, CELL / 2.0, TALL + 16, 0.5, 12, 0, caption);
                cairo_restore(cr);
            }
        }
    }
    for (int c = 0; c < CASES; ++c) {
        char caption[96];
        snprintf(caption, sizeof caption, "%s, \u03b1 = %.2f, \u03b2 = %.2f", cases[c].name,
                 cases[c].half_angle, cases[c].elevation);
        cairo_save(cr);
        cairo_translate(cr, 26, TOP + c * NEXT + TALL / 2.0);
        cairo_rotate(cr, -1.5707963);
        cairo_set_source_rgb(cr, 0, 0, 0);
        words(cr, 0, 0, 0.5, 13.5, 0, caption);
        cairo_restore(cr);
    }
    cairo_destroy(cr);
    if (cairo_surface_write_to_png(s, argv[1]) != CAIRO_STATUS_SUCCESS) {
        fprintf(stderr, "maps: cannot write %s\n", argv[1]);
        return EXIT_FAILURE;
    }
    cairo_surface_destroy(s);
    printf("wrote %s: what each map does to the unit square, in the three cases\n", argv[1]);
    if (strays)
        printf("%d samples of projected solid angle are not on the visible part of the light\n",
               strays);
    return strays ? EXIT_FAILURE : EXIT_SUCCESS;
}
