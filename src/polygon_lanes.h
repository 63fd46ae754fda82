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
    double square; /* of the area of the parallelogram of these two edges */
};

/* sums: of the normals of the triangles, which are turned to the back. Returns whether the edges at
   the first vertex make an angle that rounding does not matter to. */
PSC_LANE int find_frame(const double sums[3], const double first[3], const double last[3],
                        struct psc_fan_frame *o)
{
    const double inverse = -1.0 / SQRT(dot(sums, sums));
    double n[3], area, per_area;

    scale3(inverse, sums, o->front);
    cross_rounded(first, last, n);
    area = dot(o->front, n);
    per_area = 1.0 / area;
    o->square = area * area;
    cross_rounded(last, o->front, o->first);
    cross_rounded(o->front, first, o->last);
    scale3(per_area, o->first, o->first);
    scale3(per_area, o->last, o->last);
    return (area > 0.0) & (o->square > 0x1p-20 * (dot(first, first) * dot(last, last)));
}

/* The coordinates of a spoke or an edge. */
PSC_LANE void place_on(const struct psc_fan_frame *f, const double spoke[3], double place[2])
{
    place[0] = dot(f->first, spoke);
    place[1] = dot(f->last, spoke);
}

/* The area between two edges of those squared lengths, in units of that of the frame: whether it is
   not below 0 by more than half of what is allowed. */
PSC_LANE int turns_on(const struct psc_fan_frame *f, double area, double first2, double second2)
{
    const double slack = 0.25 * (PSC_POLYGON_TOLERANCE * PSC_POLYGON_TOLERANCE);

    return area * ABS(area) * f->square >= -slack * (first2 * second2);
}

/* Whether a vertex, at the end of that spoke, is in the plane. */
PSC_LANE int is_in_plane(const struct psc_fan_frame *f, const double vertex[3],
                         const double spoke[3])
{
    const double off = ABS(dot(f->front, spoke)), extent = largest(spoke), size = largest(vertex);

    return off <= (0.99 * PSC_POLYGON_TOLERANCE) * (extent + size);
}

/*
 * Whether a triangle A, B, C of a fan about B turns as a convex polygon does; so do B, v1, C, and
 * the edges that meet at C. With all vertices in the plane that is all: the corners at v1 and the
 * last vertex are those of the first and the last triangle, and the corner at B that of B, v1 and
 * the last vertex. a and c are the coordinates of A and C, far and further those of A C and the
 * edge after; first2, spoke2, far2 and further2 the squared lengths of B v1, B C, and these two.
 */
PSC_LANE int fan_turns(const struct psc_fan_frame *f, const double a[2], const double c[2],
                       const double far[2], const double further[2], double first2, double spoke2,
                       double far2, double further2)
{
    return (a[0] * c[1] - a[1] * c[0] > 0.0) & turns_on(f, c[1], first2, spoke2) &
           turns_on(f, far[0] * further[1] - far[1] * further[0], far2, further2);
}

#endif
