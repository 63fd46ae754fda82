/* SPDX-License-Identifier: Apache-2.0 */
/* The area map of a triangle, in double behind both precisions: the cube of the distance leaves
   float's range too soon. */
#ifndef PSC_SRC_FLAT_MAP_H
#define PSC_SRC_FLAT_MAP_H

#include "fan.h"

/* A sampled point: shares of A, B and C, direction, distance in units of the view, density per
   steradian, and cosine / density for a cosine of height / distance. */
struct psc_flat_point {
    double share[3], direction[3], distance, height, pdf, inverse;
};

/* start + s first + t second, to rounding of the result: the receiver may be much closer to the
   point than to the corners of the light, or at one of them to rounding. */
PSC_LANE void point_between(const struct psc_word2 *start, const struct psc_word2 *first,
                            const struct psc_word2 *second, double s, double t, double to[3])
{
    int i;

    for (i = 0; i < 3; i++) {
        double high = start->high[i], error = start->low[i];

        add_product(s, first->high[i], &high, &error);
        add_product(t, second->high[i], &high, &error);
        to[i] = high + (error + (s * first->low[i] + t * second->low[i]));
    }
}

/* u is the fraction of the edge from A to C, v that of the area on the side of B. The density is
   t^2 / (area |cos|), where |cos| is the height of the receiver above the light's plane over the
   distance t. volume is twice that height times the area. */
PSC_LANE void flat_map(const struct psc_flat *f, double volume, double u, double v,
                       struct psc_flat_point *p)
{
    const double root = __builtin_sqrt(v);
    const double c = root * u, a = root * (1.0 - u), b = (1.0 - v) / (1.0 + root);
    double d[3], t, inverse, cube;
    int i;

    point_between(&f->b, &f->edge_a, &f->edge_c, a, c, d);
    t = __builtin_sqrt(dot(d, d));
    inverse = 1.0 / t;
    cube = 2.0 * (t * t * t);
    for (i = 0; i < 3; i++)
        p->direction[i] = d[i] * inverse;
    p->share[0] = a;
    p->share[1] = b;
    p->share[2] = c;
    p->distance = t;
    p->height = dot(f->up, d) * inverse;
    p->pdf = cube / volume;
    p->inverse = volume / cube;
}

#endif
