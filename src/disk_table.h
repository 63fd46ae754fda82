/* SPDX-License-Identifier: Apache-2.0 */
/*
 * The tabulated map of [GUK17], section 4.1. A quadrant of the cone is cut into cells of equal
 * azimuth. The share of a cell is taken from the table; a direction in it is uniform in azimuth and
 * in 1 - z up to what the outline has at the cell's start, the most in the cell, so that some miss
 * the cone and are rejected. The density of a direction is that of its cell, whatever the share is
 * worth: nothing is biased.
 */
#ifndef PSC_SRC_DISK_TABLE_H
#define PSC_SRC_DISK_TABLE_H

#include "ellipse_chord.h"
#include "sampler.h"
#include "table.h"

#include "disk_constants_tmpl.h"
#include "disk_map_tmpl.h"

/* The row with the nearest beta / alpha. */
static inline void table_choose(struct psc_disk_light *d, const psc_table *table)
{
    const struct psc_ellipse *e = &d->seen;
    const double n = table->resolution;
    const double quotient = angle_of(e->cb, e->b) / angle_of(e->ca, e->a);
    const double row = MIN(MAX(n * quotient - 0.5, 0.0), n - 1.0);

    d->cells = table->resolution;
    d->shares = table->share + (size_t)row * (d->cells + 1);
}

/* 1 - z of the outline in the azimuth with the cosine c and the sine s, and the cosine and sine of
   eta there. */
static inline double table_outline(const struct psc_ellipse *e, double c, double s, double *ec,
                                   double *es)
{
    const double p = c * (e->b / e->a), square = p * p + s * s, r = 1.0 / SQRT(square);

    *ec = p * r;
    *es = s * r;
    return e->b * e->b /
           (square * (1.0 + SQRT(e->ca * *ec * (e->ca * *ec) + e->cb * *es * (e->cb * *es))));
}

struct psc_cell {
    double first, share; /* of the quadrant before the cell, and in it */
    double start, width; /* in azimuth */
    double reach;        /* 1 - z at its start */
    double density;      /* per steradian */
};

static inline struct psc_cell table_cell(const struct psc_disk_light *d, uint32_t i)
{
    const double width = 0.5 * PSC_PI / d->cells, start = i * width;
    struct psc_cell cell;
    double defect, versine, c, s;

    sine_cosine_defects_f64(start, &defect, &versine);
    cell.first = (double)d->shares[i];
    cell.share = (double)d->shares[i + 1] - cell.first;
    cell.start = start;
    cell.width = width;
    cell.reach = table_outline(&d->seen, 1.0 - versine, start - defect, &c, &s);
    cell.density = cell.share / (4.0 * width * cell.reach);
    return cell;
}

/* The cell in which the share f of a quadrant is reached. */
static inline uint32_t table_find(const struct psc_disk_light *d, double f)
{
    uint32_t low = 0, high = d->cells;

    while (high - low > 1) {
        const uint32_t middle = (low + high) / 2;

        if ((double)d->shares[middle] <= f)
            low = middle;
        else
            high = middle;
    }
    return low;
}

/* Returns the density; 0 for a point of the square that is rejected, which is put on the outline. */
static inline double table_point(const struct psc_disk_light *d, double u, double v,
                                 struct psc_disk_point_f64 *p)
{
    const double turn = 4.0 * u, half = turn < 2.0 ? turn : turn - 2.0;
    const double f = half < 1.0 ? half : 2.0 - half; /* quadrants are mirrored */
    const uint32_t i = table_find(d, f);
    const struct psc_cell cell = table_cell(d, i);
    const double azimuth = MIN((i + (f - cell.first) / cell.share) * cell.width, 0.5 * PSC_PI);
    double defect, versine, c, s, outline, h, r;

    sine_cosine_defects_f64(azimuth, &defect, &versine);
    c = 1.0 - versine;
    s = azimuth - defect;
    outline = table_outline(&d->seen, c, s, &p->c, &p->s);
    h = (1.0 - v) * cell.reach;
    p->rest = MAX(outline - h, 0.0) / outline;
    h = MIN(h, outline);
    r = SQRT(h * (2.0 - h));
    p->x = turn < 1.0 || turn > 3.0 ? c * r : -(c * r);
    p->y = turn < 2.0 ? s * r : -(s * r);
    p->z = -h;
    p->c = COPYSIGN(p->c, p->x);
    p->s = COPYSIGN(p->s, p->y);
    return (1.0 - v) * cell.reach > outline ? 0.0 : cell.density;
}

/* The cell of a direction (x, y, ...) in the frame of the cone, and its azimuth in the quadrant. */
static inline struct psc_cell table_cell_at(const struct psc_disk_light *d, double x, double y,
                                            double *azimuth)
{
    *azimuth = MIN(angle_of(ABS(x), ABS(y)), 0.5 * PSC_PI);
    return table_cell(d, (uint32_t)MIN(*azimuth * (d->cells / (0.5 * PSC_PI)), d->cells - 1.0));
}

/* h = 1 - z. */
static inline void table_invert(const struct psc_disk_light *d, double x, double y, double h,
                                double uv[2])
{
    double azimuth, f;
    const struct psc_cell cell = table_cell_at(d, x, y, &azimuth);

    f = 0.25 * (cell.first + cell.share * ((azimuth - cell.start) / cell.width));
    f = x < 0.0 ? 0.5 - f : f;
    uv[0] = y < 0.0 ? 1.0 - f : f;
    uv[1] = 1.0 - h / cell.reach;
}

#endif
