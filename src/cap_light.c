/* SPDX-License-Identifier: Apache-2.0 */
#include "cap_light.h"

#include "cap_build.h"
#include "cap_inverse.h"

/* ---- Totals ---- */

double psc_cap_projected(const struct psc_cap *cap, int both)
{
    const struct psc_cap below = mirrored(cap);
    struct psc_lobe_f64 l;
    double q, total;

    lobe_total(&l, cap, &q);
    total = l.total;
    if (both) {
        lobe_total(&l, &below, &q);
        total += l.total;
    }
    return total;
}

psc_result psc_cap_projected_solid_angle(const psc_sampler *s, double *value)
{
    if (s->facing == PSC_FACING_NONE)
        return PSC_ERROR_NEEDS_NORMAL;
    if (s->cap.seen.cos_a < 0.0)
        return PSC_ERROR_HALF_ANGLE;
    *value = s->cap.inside            ? PSC_PI * (s->facing == PSC_FACING_BOTH ? 2.0 : 1.0)
             : s->cap.seen.sin_a > 0.0 ? psc_cap_projected(&s->cap.seen, s->facing == PSC_FACING_BOTH)
                                  : 0.0;
    return *value > 0.0 ? PSC_SUCCESS : PSC_EMPTY;
}

psc_result psc_cap_whole_solid_angle(const psc_sampler *s, double *value)
{
    const int no_size = s->cap.seen.sin_a == 0.0 && s->cap.seen.cos_a == 0.0;

    *value = s->cap.inside ? 4.0 * PSC_PI
             : no_size ? 0.0
                       : 2.0 * PSC_PI * psc_cap_versine(&s->cap.seen);
    return *value > 0.0 ? PSC_SUCCESS : PSC_EMPTY;
}

/* ---- Directions ---- */

/* The direction, stretched by the share `stretch`, as the side sees it; whether it is in the
   support. */
static int look(const struct psc_side *side, const double direction[3], double stretch,
                double epsilon, double h0, struct seen *d)
{
    double off[3];
    int i;

    for (i = 0; i < 3; i++)
        off[i] = (direction[i] - side->axis[i]) + stretch * direction[i];
    d->x = dot(off, side->x);
    d->y = dot(off, side->y);
    d->h = 0.5 * dot(off, off);
    d->depth = h0 - d->h;
    d->height = dot(direction, side->z);
    /* The edge is as sharp as the direction was rounded, after a sampling of its own; beyond a
       right angle h and the direction's length round by more than the angle does. */
    if (!(d->depth >= -epsilon * (32.0 * (side->lobe.sin_a + epsilon) + 8.0 * h0)))
        return 0;
    d->depth = MAX(d->depth, 0.0);
    d->h = MIN(d->h, h0);
    return 1;
}

/* The point of the sphere that is seen, for the area maps: w of area_map.h. */
static double seen_w(const psc_sampler *s, const double direction[3], const struct seen *d)
{
    const struct psc_lobe_f64 *l = &s->cap.side[0].lobe;
    double cosine, sine2;

    if (s->cap.inside) {
        const double b = dot(direction, s->cap.offset);
        const double root = SQRT(s->cap.slack + b * b);
        const double t = b >= 0.0 ? b + root : s->cap.slack / (root - b);

        cosine = l->delta - t * (1.0 - d->h);
        sine2 = t * t * (d->x * d->x + d->y * d->y);
    } else {
        const double sa = s->cap.seen.sin_a, ca = s->cap.seen.cos_a, h0 = psc_cap_versine(&s->cap.seen);
        const double g = SQRT(d->depth * (2.0 * ca + d->depth));
        const double inverse = 1.0 / ((ca + d->depth + g) * sa);

        cosine = (ca * ca * d->h + (d->depth + h0 * ca + g)) * inverse;
        sine2 = ca * ca * inverse * (ca * ca * inverse) * (d->x * d->x + d->y * d->y);
    }
    return cosine > 0.0 ? sine2 / (1.0 + cosine) : 1.0 - cosine;
}

static int is_area(const psc_sampler *s)
{
    return s->cap.side[0].map >= PSC_CAP_RADIAL_AREA;
}

/* 1 - cos of the angle that a side's directions reach. */
static double reach(const psc_sampler *s, const struct psc_side *side)
{
    return !is_area(s) ? side->lobe.h0 : s->cap.inside ? 2.0 : psc_cap_versine(&s->cap.seen);
}

/* The side whose support holds the direction, or NULL. */
static const struct psc_side *find_side(const psc_sampler *s, const double direction[3],
                                        double stretch, double epsilon, struct seen *d)
{
    int i;

    for (i = 0; i < s->sides; i++) {
        const struct psc_side *side = s->cap.side + i;

        if (look(side, direction, stretch, epsilon, reach(s, side), d) &&
            (!s->projected || d->height > 0.0))
            return side;
    }
    return NULL;
}

double psc_cap_pdf(const psc_sampler *s, const double direction[3], double epsilon)
{
    struct seen d;
    const struct psc_side *side = find_side(s, direction, 0.0, epsilon, &d);

    if (!side)
        return 0.0;
    if (is_area(s)) {
        const struct psc_lobe_f64 *l = &side->lobe;
        struct psc_point_f64 p;
        double pdf, inverse, w;

        /* At the limb itself the density is infinite; a rounded direction is only near it. */
        d.depth = MAX(d.depth, epsilon * (l->sin_a + epsilon));
        w = MIN(seen_w(s, direction, &d), l->width);
        area_point(l, w, 1.0 - w / l->width, 1.0, 0.0, &p, &pdf, &inverse);
        return pdf;
    }
    return s->projected ? d.height * s->inverse_total : s->inverse_total;
}

psc_result psc_cap_invert(const psc_sampler *s, const double direction[3], double epsilon,
                          double uv[2])
{
    const int concentric = s->map == PSC_MAP_CONCENTRIC;
    const struct psc_side *side;
    const struct psc_lobe_f64 *l;
    double excess = -1.0, low = 0.0;
    struct seen d;
    int i;

    /* What the length misses of 1 is rounding: it must not count as a change of direction. */
    for (i = 0; i < 3; i++)
        add_product(direction[i], direction[i], &excess, &low);
    side = find_side(s, direction, -0.5 * (excess + low), epsilon, &d);
    if (!side)
        return PSC_OUTSIDE;
    l = &side->lobe;
    switch (side->map) {
    case PSC_CAP_RADIAL_CONE:
    case PSC_CAP_CONCENTRIC_CONE: invert_cone(l, concentric, &d, uv); break;
    case PSC_CAP_RADIAL_ELLIPSE:
    case PSC_CAP_CONCENTRIC_ELLIPSE: invert_ellipse(l, concentric, &d, uv); break;
    case PSC_CAP_RADIAL_BOTH: invert_radial(l, 0, &d, uv); break;
    case PSC_CAP_RADIAL_LUNE: invert_radial(l, 1, &d, uv); break;
    case PSC_CAP_PARALLEL_ELLIPSE:
        invert_chord(l, PSC_REGION_ELLIPSE, concentric, &d, uv);
        break;
    case PSC_CAP_PARALLEL_BOTH:
    case PSC_CAP_CONCENTRIC_BOTH: invert_chord(l, PSC_REGION_BOTH, concentric, &d, uv); break;
    case PSC_CAP_PARALLEL_LUNE:
    case PSC_CAP_CONCENTRIC_LUNE: invert_chord(l, PSC_REGION_LUNE, concentric, &d, uv); break;
    case PSC_CAP_RADIAL_AREA:
    case PSC_CAP_CONCENTRIC_AREA:
        polar_to_square(concentric, seen_w(s, direction, &d) / l->width, d.x, d.y, uv);
        break;
    }
    for (i = 0; i < 2; i++)
        uv[i] = MIN(MAX(uv[i], 0.0), 1.0);
    if (s->sides == 2)
        uv[0] = side == s->cap.side ? uv[0] * s->split : 1.0 - uv[0] * (1.0 - s->split);
    return PSC_SUCCESS;
}
