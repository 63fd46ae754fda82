/* SPDX-License-Identifier: Apache-2.0 */
/*
 * A direction as a side of a cap's sampler sees it, which is what densities and inverses start
 * from. Lane functions, for one direction and for loops over blocks.
 */
#ifndef PSC_SRC_CAP_SEEN_H
#define PSC_SRC_CAP_SEEN_H

#include "cap_maps.h"
#include "cap_side.h"
#include "vector.h"

struct seen {
    double x, y;   /* offset across */
    double h;      /* 1 - cos of the angle to the axis */
    double depth;  /* what h is short of that at the edge of the side's directions */
    double height; /* cosine to the normal */
};

PSC_LANE int is_area_map(enum psc_cap_map map)
{
    return map >= PSC_CAP_RADIAL_AREA;
}

/* 1 - cos of the angle that the directions of side i reach. */
PSC_LANE double seen_reach(const struct psc_cap_light *light, int i)
{
    const struct psc_side *side = light->side + i;

    return !is_area_map(side->map) ? side->lobe.h0
           : light->inside         ? 2.0
                                   : psc_cap_versine(&light->seen);
}

/* What the length of a direction misses of 1 is rounding: an inverse must not count it as a
   change of direction. */
PSC_LANE double seen_stretch(const double direction[3])
{
    double excess = -1.0, low = 0.0;
    int i;

    for (i = 0; i < 3; i++)
        add_product(direction[i], direction[i], &excess, &low);
    return -0.5 * (excess + low);
}

/* The direction, stretched by the share `stretch`, as the side sees it; whether it is in the
   support. h0 is the side's reach. */
PSC_LANE int look(const struct psc_side *side, const double direction[3], double stretch,
                  double epsilon, double h0, int projected, struct seen *d)
{
    double off[3], depth, h;
    int i, inside;

    for (i = 0; i < 3; i++)
        off[i] = (direction[i] - side->axis[i]) + stretch * direction[i];
    d->x = dot(off, side->x);
    d->y = dot(off, side->y);
    h = 0.5 * dot(off, off);
    depth = h0 - h;
    d->height = dot(direction, side->z);
    /* The edge is as sharp as the direction was rounded, after a sampling of its own; beyond a
       right angle h and the direction's length round by more than the angle does. */
    inside = depth >= -epsilon * (32.0 * (side->lobe.sin_a + epsilon) + 8.0 * h0);
    d->depth = MAX(depth, 0.0);
    d->h = MIN(h, h0);
    return inside & (!projected | (d->height > 0.0));
}

/* The point of the sphere that is seen, for the area maps: w of area_map.h. */
PSC_LANE double seen_w(const struct psc_cap_light *light, int inside, const double direction[3],
                       const struct seen *d)
{
    const double across2 = d->x * d->x + d->y * d->y;
    double cosine, sine2;

    if (inside) {
        const double b = dot(direction, light->offset);
        const double root = SQRT(light->slack + b * b);
        const double t = b >= 0.0 ? b + root : light->slack / (root - b);

        cosine = light->side[0].lobe.delta - t * (1.0 - d->h);
        sine2 = t * t * across2;
    } else {
        const double sa = light->seen.sin_a, ca = light->seen.cos_a;
        const double h0 = psc_cap_versine(&light->seen);
        const double g = SQRT(d->depth * (2.0 * ca + d->depth));
        const double inverse = 1.0 / ((ca + d->depth + g) * sa);

        cosine = (ca * ca * d->h + (d->depth + h0 * ca + g)) * inverse;
        sine2 = ca * ca * inverse * (ca * ca * inverse) * across2;
    }
    return cosine > 0.0 ? sine2 / (1.0 + cosine) : 1.0 - cosine;
}

/* The density of a side at a direction, 0 outside its support. h0 is its reach. */
PSC_LANE double seen_pdf(const struct psc_cap_light *light, const struct psc_side *side,
                         double h0, int area, int inside, int projected, double inverse_total,
                         const double direction[3], double epsilon)
{
    const struct psc_lobe_f64 *l = &side->lobe;
    struct psc_point_f64 p;
    double pdf, inverse, w;
    struct seen d;
    const int within = look(side, direction, 0.0, epsilon, h0, projected, &d);

    if (area) {
        /* At the limb itself the density is infinite; a rounded direction is only near it. */
        d.depth = MAX(d.depth, epsilon * (l->sin_a + epsilon));
        w = MIN(seen_w(light, inside, direction, &d), l->width);
        area_point(l, w, 1.0 - w / l->width, 1.0, 0.0, &p, &pdf, &inverse);
    } else {
        pdf = projected ? d.height * inverse_total : inverse_total;
    }
    return within ? pdf : 0.0;
}

#endif
