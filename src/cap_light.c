/* SPDX-License-Identifier: Apache-2.0 */
#include "cap_light.h"

#include "vector.h"

#define PSC_BITS 64
#include "precision.h"
#include "projected_tmpl.h"
#include "radial_map_tmpl.h"
#include "parallel_map_tmpl.h"
#include "area_map_tmpl.h"
#include "projected_build.h"
#include "cap_inverse.h"

/* ---- Totals ---- */

/* The lobe of the part above the horizon up to its total; returns its region. q = sqrt(q2). */
static enum psc_region lobe_total(struct psc_lobe_f64 *l, const struct psc_cap *cap, double *q)
{
    const enum psc_region region = psc_cap_region(cap);
    struct psc_cap c = *cap;

    *q = 0.0;
    if (region == PSC_REGION_BOTH && c.sin_b < 0.0)
        c.sin_b = 0.0; /* a lune as thick as the half plane's share to 1e-17 */
    projected_base(l, &c);
    switch (region) {
    case PSC_REGION_EMPTY: l->total = 0.0; break;
    case PSC_REGION_ELLIPSE: ellipse_build(l); break;
    case PSC_REGION_BOTH: *q = both_build(l); break;
    case PSC_REGION_LUNE: *q = lune_build(l); break;
    }
    return region;
}

static struct psc_cap mirrored(const struct psc_cap *cap)
{
    struct psc_cap below = *cap;

    below.sin_b = -below.sin_b;
    return below;
}

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
    if (s->cap.cos_a < 0.0)
        return PSC_ERROR_HALF_ANGLE;
    *value = s->inside            ? PSC_PI * (s->facing == PSC_FACING_BOTH ? 2.0 : 1.0)
             : s->cap.sin_a > 0.0 ? psc_cap_projected(&s->cap, s->facing == PSC_FACING_BOTH)
                                  : 0.0;
    return *value > 0.0 ? PSC_SUCCESS : PSC_EMPTY;
}

psc_result psc_cap_whole_solid_angle(const psc_sampler *s, double *value)
{
    const double sa = s->cap.sin_a, ca = s->cap.cos_a;

    *value = s->inside               ? 4.0 * PSC_PI
             : sa == 0.0 && ca == 0.0 ? 0.0 /* no size */
                                      : 2.0 * PSC_PI * (ca > 0.0 ? sa * sa / (1.0 + ca) : 1.0 - ca);
    return *value > 0.0 ? PSC_SUCCESS : PSC_EMPTY;
}

/* ---- Building ---- */

static void copy3(const double from[3], double to[3])
{
    memcpy(to, from, 3 * sizeof(double));
}

void psc_cap_frame_around(const double axis[3], struct psc_cap_frame *frame)
{
    copy3(axis, frame->axis);
    copy3(axis, frame->normal);
    perpendicular(axis, frame->sideways);
}

psc_case psc_cap_case(const struct psc_cap *cap, enum psc_facing facing)
{
    struct psc_cap c = *cap;

    if (facing == PSC_FACING_NONE)
        return PSC_CASE_NO_HORIZON;
    if (facing == PSC_FACING_BOTH)
        c.sin_b = ABS(c.sin_b);
    switch (psc_cap_region(&c)) {
    case PSC_REGION_ELLIPSE: return PSC_CASE_ELLIPSE;
    case PSC_REGION_BOTH: return PSC_CASE_ELLIPSE_AND_LUNE;
    case PSC_REGION_LUNE: return PSC_CASE_LUNE;
    default: return PSC_CASE_EMPTY;
    }
}

void psc_cone_side(struct psc_side *side, const struct psc_cap *cap,
                   const struct psc_cap_frame *frame)
{
    struct psc_lobe_f64 *l = &side->lobe;

    l->sin_a = cap->sin_a;
    l->cos_a = cap->cos_a;
    l->sin_b = cap->sin_b;
    l->cos_b = cap->cos_b;
    copy3(frame->axis, side->axis);
    copy3(frame->axis, side->z);
    copy3(frame->sideways, side->y);
    cross(side->y, frame->axis, side->x);
}

/* The lobe and frame above (sign 1) or below (-1) the receiver's plane; its total. */
static double projected_side(struct psc_side *side, psc_map map, const struct psc_cap *cap,
                             const struct psc_cap_frame *frame, double sign)
{
    static const enum psc_cap_map maps[3][4] = {
        {0, PSC_CAP_RADIAL_ELLIPSE, PSC_CAP_RADIAL_BOTH, PSC_CAP_RADIAL_LUNE},
        {0, PSC_CAP_PARALLEL_ELLIPSE, PSC_CAP_PARALLEL_BOTH, PSC_CAP_PARALLEL_LUNE},
        {0, PSC_CAP_CONCENTRIC_ELLIPSE, PSC_CAP_CONCENTRIC_BOTH, PSC_CAP_CONCENTRIC_LUNE},
    };
    struct psc_lobe_f64 *l = &side->lobe;
    double q;
    const enum psc_region region = lobe_total(l, cap, &q);
    int i;

    if (region == PSC_REGION_EMPTY)
        return 0.0;
    side->map = maps[map][region];
    if (region != PSC_REGION_ELLIPSE) {
        if (map != PSC_MAP_RADIAL)
            parallel_build(l, region == PSC_REGION_LUNE, q);
        else if (region == PSC_REGION_BOTH)
            radial_both_build(l);
        else
            radial_lune_build(l, q);
    }
    copy3(frame->axis, side->axis);
    copy3(frame->sideways, side->y);
    cross(frame->sideways, frame->normal, side->x);
    for (i = 0; i < 3; i++)
        side->z[i] = sign * frame->normal[i];
    return l->total;
}

psc_result psc_cap_sides(psc_sampler *s, const struct psc_cap_frame *frame, double h0)
{
    s->visibility = s->inside ? PSC_CASE_INSIDE : psc_cap_case(&s->cap, s->facing);
    if (s->visibility == PSC_CASE_EMPTY)
        return PSC_EMPTY;
    if (s->projected) {
        const struct psc_cap below = mirrored(&s->cap);
        struct psc_cap_frame under = *frame;
        double above = projected_side(s->side, s->map, &s->cap, frame, 1.0), second = 0.0;
        int i;

        s->sides = above > 0.0;
        if (s->facing == PSC_FACING_BOTH) {
            if (s->inside)
                for (i = 0; i < 3; i++)
                    under.axis[i] = -frame->axis[i];
            second = projected_side(s->side + s->sides, s->map, s->inside ? &s->cap : &below,
                                    &under, -1.0);
            s->sides += second > 0.0;
        }
        s->total = above + second;
        s->split = above / s->total;
        return s->sides > 0 ? PSC_SUCCESS : PSC_EMPTY;
    }
    psc_cone_side(s->side, &s->cap, frame);
    s->side[0].lobe.h0 = h0;
    s->side[0].map = s->map == PSC_MAP_RADIAL ? PSC_CAP_RADIAL_CONE : PSC_CAP_CONCENTRIC_CONE;
    s->sides = 1;
    s->total = 2.0 * PSC_PI * h0;
    return PSC_SUCCESS;
}

/* ---- Directions ---- */

/* The direction as the side sees it; whether it is in the support. */
static int look(const struct psc_side *side, const double direction[3], double epsilon,
                double h0, struct seen *d)
{
    double off[3];
    int i;

    for (i = 0; i < 3; i++)
        off[i] = direction[i] - side->axis[i];
    d->x = dot(off, side->x);
    d->y = dot(off, side->y);
    d->h = 0.5 * dot(off, off);
    d->depth = h0 - d->h;
    d->height = dot(direction, side->z);
    /* The edge is as sharp as the direction was rounded. */
    if (!(d->depth >= -4.0 * epsilon * (side->lobe.sin_a + epsilon)))
        return 0;
    d->depth = MAX(d->depth, 0.0);
    d->h = MIN(d->h, h0);
    return 1;
}

/* The point of the sphere that is seen, for the area maps: w of area_map_tmpl.h. */
static double seen_w(const psc_sampler *s, const double direction[3], const struct seen *d)
{
    const struct psc_lobe_f64 *l = &s->side[0].lobe;
    double cosine, sine2;

    if (s->inside) {
        const double b = dot(direction, s->offset) / s->radius;
        const double slack = -l->gap * (1.0 + l->delta);
        const double root = SQRT(slack + b * b);
        const double t = b >= 0.0 ? b + root : slack / (root - b);

        cosine = l->delta - t * (1.0 - d->h);
        sine2 = t * t * (d->x * d->x + d->y * d->y);
    } else {
        const double sa = s->cap.sin_a, ca = s->cap.cos_a, h0 = sa * sa / (1.0 + ca);
        const double g = SQRT(d->depth * (2.0 - h0 - d->h));
        const double inverse = 1.0 / ((1.0 - d->h + g) * sa);

        cosine = (ca * ca * d->h + (d->depth + h0 * ca + g)) * inverse;
        sine2 = ca * ca * inverse * (ca * ca * inverse) * (d->x * d->x + d->y * d->y);
    }
    return cosine > 0.0 ? sine2 / (1.0 + cosine) : 1.0 - cosine;
}

static int is_area(const psc_sampler *s)
{
    return s->side[0].map >= PSC_CAP_RADIAL_AREA;
}

/* 1 - cos of the angle that a side's directions reach. */
static double reach(const psc_sampler *s, const struct psc_side *side)
{
    const struct psc_lobe_f64 *l = &side->lobe;

    if (!is_area(s))
        return l->h0;
    return s->inside ? 2.0 : l->sin_a * l->sin_a / (1.0 + l->cos_a);
}

/* The side whose support holds the direction, or NULL. */
static const struct psc_side *find_side(const psc_sampler *s, const double direction[3],
                                        double epsilon, struct seen *d)
{
    int i;

    for (i = 0; i < s->sides; i++) {
        const struct psc_side *side = s->side + i;

        if (look(side, direction, epsilon, reach(s, side), d) &&
            (!s->projected || d->height > 0.0))
            return side;
    }
    return NULL;
}

double psc_cap_pdf(const psc_sampler *s, const double direction[3], double epsilon)
{
    struct seen d;
    const struct psc_side *side = find_side(s, direction, epsilon, &d);

    if (!side)
        return 0.0;
    if (is_area(s)) {
        const struct psc_lobe_f64 *l = &side->lobe;
        const double w = MIN(seen_w(s, direction, &d), l->width);
        struct psc_point_f64 p;
        double pdf, inverse;

        area_point_f64(l, w, area_facing_f64(l, w, 1.0 - w / l->width), 1.0, 0.0, &p, &pdf,
                       &inverse);
        return pdf;
    }
    return s->projected ? d.height * s->inverse_total : s->inverse_total;
}

psc_result psc_cap_invert(const psc_sampler *s, const double direction[3], double epsilon,
                          double uv[2])
{
    struct seen d;
    const struct psc_side *side = find_side(s, direction, epsilon, &d);
    const struct psc_lobe_f64 *l;
    const int concentric = s->map == PSC_MAP_CONCENTRIC;
    int i;

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
        uv[0] = side == s->side ? uv[0] * s->split : 1.0 - uv[0] * (1.0 - s->split);
    return PSC_SUCCESS;
}
