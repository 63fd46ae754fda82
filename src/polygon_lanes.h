/* SPDX-License-Identifier: Apache-2.0 */
/* Whether the triangles of a fan are those of a flat and convex polygon, in plain arithmetic: with
   enough to spare for rounding, else check_polygon() decides. */
#ifndef PSC_SRC_POLYGON_LANES_H
#define PSC_SRC_POLYGON_LANES_H

#include "vector.h"

/* How far vertices may be off one plane: this much of the polygon's extent, and of its largest
   coordinate, where it is 16 roundings to float (2^-20); and how far edges may turn back, as a
   sine. */
#define PSC_POLYGON_TOLERANCE 1e-6

/* What triangles are judged by: the polygon's front, of length 1, and a frame for coordinates on
   its surface, point = v0 + (point . first) (v1 - v0) + (point . last) (v(last) - v0). */
struct psc_fan_frame {
    double front[3], first[3], last[3];
};

/* sums: of the normals of the triangles, which are turned to the back. Returns whether the edges at
   the first vertex make an angle that rounding does not matter to. */
PSC_LANE int find_frame(const double sums[3], const double first[3], const double last[3],
                        struct psc_fan_frame *o)
{
    const double inverse = -1.0 / SQRT(dot(sums, sums));
    double n[3], square, per_square;

    scale3(inverse, sums, o->front);
    cross_rounded(first, last, n);
    square = dot(n, n);
    per_square = 1.0 / square;
    cross_rounded(last, n, o->first);
    cross_rounded(n, first, o->last);
    scale3(per_square, o->first, o->first);
    scale3(per_square, o->last, o->last);
    return square > 0x1p-20 * (dot(first, first) * dot(last, last));
}

/* sine is the product of two lengths, whose squares are given, and a sine: whether that is not
   below 0 by more than half of what is allowed. */
PSC_LANE int turns_on(double sine, double first2, double second2)
{
    const double slack = 0.25 * (PSC_POLYGON_TOLERANCE * PSC_POLYGON_TOLERANCE);

    return sine * ABS(sine) >= -slack * (first2 * second2);
}

/* Whether a vertex, at the end of that spoke, is in the plane. */
PSC_LANE int is_in_plane(const struct psc_fan_frame *f, const double vertex[3],
                         const double spoke[3])
{
    const double off = ABS(dot(f->front, spoke)), extent = largest(spoke), size = largest(vertex);

    return off <= (0.99 * PSC_POLYGON_TOLERANCE) * (extent + size);
}

/*
 * Whether a triangle A, B, C of a fan about B belongs to the polygon: C is in the plane; A, B, C
 * turn as the polygon does, and so do B, v1, C, and the edges that meet at C. That is all, if v1 is
 * in the plane: the corners at v1 and the last vertex are those of the first and the last triangle,
 * and the corner at B that of B, v1 and the last vertex. first is the spoke from B to v1.
 */
PSC_LANE int fan_belongs(const struct psc_fan_frame *f, const double b[3], const double first[3],
                         const double a[3], const double c[3], const double next[3])
{
    double spoke_a[3], spoke_c[3], far[3], further[3], across[3], beside[3], corner[3];

    subtract3(a, b, spoke_a);
    subtract3(c, b, spoke_c);
    subtract3(c, a, far);
    subtract3(next, c, further);
    cross_rounded(spoke_a, spoke_c, across);
    cross_rounded(first, spoke_c, beside);
    cross_rounded(far, further, corner);
    return is_in_plane(f, c, spoke_c) & (dot(f->front, across) > 0.0) &
           turns_on(dot(f->front, beside), dot(first, first), dot(spoke_c, spoke_c)) &
           turns_on(dot(f->front, corner), dot(far, far), dot(further, further));
}

#endif
