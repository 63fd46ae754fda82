/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Triangles, fans of them and rectangles by 113-bit quadrature of positive densities: solid angles,
 * and where in the unit square a direction is. For fans that of the angle at the first vertex,
 * 1 - cos of the arc to the far side; for rectangles that of strips.
 */
#ifndef PSC_TESTS_REFERENCE_POLYGONS_H
#define PSC_TESTS_REFERENCE_POLYGONS_H

#include "quad.h"

enum { REFERENCE_CORNERS = 14 };

/* A triangle a, b, c of a fan: frame at b, and the far plane in it. */
struct reference_corner {
    quad b[3], toward_a[3], toward_c[3]; /* of length 1 */
    quad end;                            /* angle at b */
    quad along_a, along_c, height;       /* of the normal of a and c */
    quad turn, slope; /* where the far side is a quarter turn off, and how steeply it gets there */
    quad total;
};

struct reference_fan {
    int corners;
    struct reference_corner corner[REFERENCE_CORNERS];
};

struct reference_strip {
    quad x[3], y[3], z[3], x0, x1, y0, y1, h;
    quad total;
};

quad reference_dot(const quad a[3], const quad b[3]);
void reference_cross(const quad a[3], const quad b[3], quad c[3]);
quad reference_length(const quad v[3]);

/* From the vectors to the vertices; whether anything is seen of it. */
int reference_corner(const quad a[3], const quad b[3], const quad c[3],
                     struct reference_corner *o);

/* From the vector to the corner and the edges; of v what is across u. */
void reference_strip(const quad corner[3], const quad u[3], const quad v[3],
                     struct reference_strip *s);

/* The place of a vector, and how far it is open when that turns by an angle. */
void reference_in_fan(const struct reference_fan *f, const quad w[3], double turn, quad uv[2],
                      double open[2]);
void reference_in_strip(const struct reference_strip *s, const quad w[3], double turn, quad uv[2],
                        double open[2]);

#endif
