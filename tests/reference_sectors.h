/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Polygons by projected solid angle in 113-bit arithmetic: cut by planes, which are the horizon and
 * those through the receiver's normal that bound an azimuth, and added up by Lambert's integral
 * along the outline, which the library uses nowhere.
 */
#ifndef PSC_TESTS_REFERENCE_SECTORS_H
#define PSC_TESTS_REFERENCE_SECTORS_H

#include "quad.h"

enum { REFERENCE_MOST = 16, REFERENCE_ROOM = 40 };

/* Its vertices in order, seen by a receiver at the origin. */
struct reference_polygon {
    int n;
    double v[REFERENCE_MOST][3], normal[3];
};

/* What a receiver at the origin sees. */
struct reference_sectors {
    int n;
    quad p[REFERENCE_ROOM][3]; /* above the horizon */
    quad normal[3], x[3], y[3]; /* x, y across the normal */
    quad total;
    int around; /* the zenith is inside: azimuths count from the first point */
};

/* One side of the receiver; flip: the one below. */
void reference_sectors(const struct reference_polygon *light, int flip,
                       struct reference_sectors *s);

/* The place of a direction of any length in the unit square. */
void reference_in_sectors(const struct reference_sectors *s, const quad d[3], quad uv[2]);

#endif
