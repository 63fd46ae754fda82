/* SPDX-License-Identifier: Apache-2.0 */
/* The first half of a wavefront of caps, in double: seeing a block of them, and the builds of
   each kind. See cap_wave_tmpl.h. */
#ifndef PSC_SRC_CAP_VIEWS_H
#define PSC_SRC_CAP_VIEWS_H

#include "cap_build.h"
#include "kernel_tmpl.h"

/* The views of a block, as arrays. */
struct views {
    double sin_a[PSC_BLOCK], cos_a[PSC_BLOCK], sin_b[PSC_BLOCK], cos_b[PSC_BLOCK];
    double q2[PSC_BLOCK], h0[PSC_BLOCK];
    double axis[3][PSC_BLOCK], sideways[3][PSC_BLOCK], normal[3][PSC_BLOCK];
    double distance[PSC_BLOCK];
    /* In the units of the view. */
    double far[PSC_BLOCK], radius[PSC_BLOCK], power[PSC_BLOCK], scale[PSC_BLOCK];
    double sign[PSC_BLOCK]; /* of the side of the receiver's plane */
    int32_t kind[PSC_BLOCK];
    uint32_t inside[PSC_BLOCK]; /* the receivers inside their spheres, but for area measures */
    size_t insides;
};

/* The kinds of elements, by the loop that serves them; KIND_CUT is that of lights which a two-sided
   receiver sees on either side, until one of these is chosen. */
enum {
    KIND_PENDING, KIND_EMPTY, KIND_CUT,
    KIND_CONE, KIND_ELLIPSE, KIND_BOTH, KIND_LUNE, KIND_COUNT
};

#define REGION_OF_KIND(kind) ((enum psc_region)(PSC_REGION_ELLIPSE + ((kind) - KIND_ELLIPSE)))

/* The kind of one element, and the sign of its side; fit says whether it has a loop at all. */
PSC_LANE int32_t kind_of(const struct psc_wave *wave, const struct psc_cap *cap, int fit,
                         double *sign)
{
    const int both = wave->facing == PSC_FACING_BOTH;
    const int projected = wave->measure == PSC_MEASURE_PROJECTED_SOLID_ANGLE;
    const double sb = both ? ABS(cap->sin_b) : cap->sin_b;
    /* psc_cap_region(), spelled out: gcc 12 does not vectorise the loop over the enumeration. */
    const int flat = -cap->sin_a * sb * (cap->cos_a + cap->cos_b) < PSC_FLAT_LUNE * cap->q2;
    const int32_t kind = cap->q2 <= 0.0 ? (sb > 0.0 ? KIND_ELLIPSE : KIND_EMPTY)
                         : both         ? KIND_CUT
                         : sb >= 0.0    ? KIND_BOTH
                         : flat         ? KIND_BOTH
                                        : KIND_LUNE;

    *sign = projected && both && cap->sin_b < 0.0 ? -1.0 : 1.0;
    return !fit        ? KIND_PENDING
           : projected ? kind
           : wave->facing == PSC_FACING_ONE && kind == KIND_EMPTY ? KIND_EMPTY
                                                                  : KIND_CONE;
}

PSC_LANE void store_view(struct views *to, size_t i, const struct psc_cap_view *o)
{
    int c;

    to->sin_a[i] = o->cap.sin_a;
    to->cos_a[i] = o->cap.cos_a;
    to->sin_b[i] = o->cap.sin_b;
    to->cos_b[i] = o->cap.cos_b;
    to->q2[i] = o->cap.q2;
    to->h0[i] = o->h0;
    for (c = 0; c < 3; c++) {
        to->axis[c][i] = o->axis[c];
        to->sideways[c][i] = o->sideways[c];
        to->normal[c][i] = o->normal[c];
    }
    to->distance[i] = o->distance * o->unit;
    to->far[i] = o->distance;
    to->radius[i] = o->radius;
    to->power[i] = o->power;
    to->scale[i] = o->scale;
}

/* One loop for each way of seeing: with a normal or without. */
#define SEE_LOOP(name, has_normal, check, see)                                                 \
    static void name(const struct psc_wave *restrict wave, struct views *restrict to)          \
    {                                                                                          \
        const size_t n = wave->count;                                                          \
        size_t i;                                                                              \
                                                                                               \
        for (i = 0; i < n; i++) {                                                              \
            const double position[3] = {wave->position[0][i], wave->position[1][i],            \
                                        wave->position[2][i]};                                 \
            const double normal[3] = {has_normal ? wave->normal[0][i] : 0.0,                   \
                                      has_normal ? wave->normal[1][i] : 0.0,                   \
                                      has_normal ? wave->normal[2][i] : 0.0};                  \
            const double vector[3] = {wave->geometry[0][i], wave->geometry[1][i],              \
                                      wave->geometry[2][i]};                                   \
            const double scalar = wave->geometry[3][i];                                        \
            const double extent = largest(position), size = largest(normal);                   \
            const double across = largest(vector);                                             \
            struct psc_cap_view o;                                                             \
            double sign;                                                                       \
            int fit;                                                                           \
                                                                                               \
            see;                                                                               \
            /* A NaN fails every comparison; largest() may drop one, the sum keeps it. */      \
            fit = (extent <= DBL_MAX) & (size <= DBL_MAX) & (across <= DBL_MAX) & (check) &    \
                  (ABS(dot(position, position) * 0.0 + dot(normal, normal) * 0.0 +             \
                       dot(vector, vector) * 0.0) == 0.0);                                     \
            fit &= !(has_normal) | (size > 0.0);                                               \
            store_view(to, i, &o);                                                             \
            to->kind[i] = kind_of(wave, &o.cap, fit, &sign);                                   \
            to->sign[i] = sign;                                                                \
        }                                                                                      \
    }
SEE_LOOP(see_spheres, 1,
         (scalar > 0.0) & ((o.power > 0.0) | (o.power < 0.0)) & (o.distance <= DBL_MAX),
         see_sphere(position, normal, vector, scalar, &o))
SEE_LOOP(see_spheres_around, 0,
         (scalar > 0.0) & ((o.power > 0.0) | (o.power < 0.0)) & (o.distance <= DBL_MAX),
         see_sphere(position, NULL, vector, scalar, &o))
SEE_LOOP(see_caps, 1,
         (scalar > 0.0) & (scalar <= 0.5 * PSC_PI) & (across > 0.0),
         see_cap(normal, vector, scalar, &o))
SEE_LOOP(see_caps_around, 0,
         (scalar > 0.0) & (scalar <= 0.5 * PSC_PI) & (across > 0.0),
         see_cap(NULL, vector, scalar, &o))

/* What a receiver inside a sphere sees, as sphere_build() has it: light everywhere, in the frame of
   the horizon, or any. */
static void enter_sphere(const struct psc_wave *wave, struct views *o, size_t i)
{
    static const double up[3] = {0.0, 0.0, 1.0};
    const int projected = wave->measure == PSC_MEASURE_PROJECTED_SOLID_ANGLE;
    double axis[3], sideways[3];
    int c;

    if (is_area_measure(wave->measure)) {
        o->kind[i] = KIND_PENDING;
        return;
    }
    if (wave->one_sided) {
        o->kind[i] = KIND_EMPTY;
        return;
    }
    for (c = 0; c < 3; c++)
        axis[c] = wave->facing == PSC_FACING_NONE ? up[c] : o->normal[c][i];
    perpendicular(axis, sideways);
    for (c = 0; c < 3; c++) {
        o->normal[c][i] = o->axis[c][i] = axis[c];
        o->sideways[c][i] = sideways[c];
    }
    o->sin_a[i] = o->sin_b[i] = 1.0;
    o->cos_a[i] = o->cos_b[i] = o->q2[i] = 0.0;
    o->h0[i] = projected ? 1.0 : 2.0;
    o->sign[i] = 1.0;
    o->kind[i] = projected ? KIND_ELLIPSE : KIND_CONE;
    o->inside[o->insides++] = (uint32_t)i;
}

static void enter_spheres(const struct psc_wave *wave, struct views *o)
{
    size_t i;

    for (i = 0; i < wave->count; i++)
        if (o->power[i] < 0.0 && o->kind[i] != KIND_PENDING)
            enter_sphere(wave, o, i);
}

/* Caps that a two-sided receiver's horizon cuts, packed, and what lies above and below. */
struct cuts {
    double sin_a[PSC_BLOCK], cos_a[PSC_BLOCK], sin_b[PSC_BLOCK], cos_b[PSC_BLOCK];
    double q2[PSC_BLOCK], h0[PSC_BLOCK];
    double above[PSC_BLOCK], below[PSC_BLOCK];
    double flat[PSC_BLOCK]; /* of the side with less, whether it counts as beta = 0 */
};

static void weigh_cuts(struct cuts *restrict k, size_t n)
{
    size_t i;

    for (i = 0; i < n; i++) {
        const double sb = ABS(k->sin_b[i]);
        const struct psc_cap most = {k->sin_a[i], k->cos_a[i], sb, k->cos_b[i], k->q2[i]};
        const struct psc_cap least = {k->sin_a[i], k->cos_a[i], -sb, k->cos_b[i], k->q2[i]};
        const struct psc_cap level = {k->sin_a[i], k->cos_a[i], 0.0, k->cos_b[i], k->q2[i]};
        /* psc_cap_region() */
        const int flat = least.sin_a * sb * (least.cos_a + least.cos_b) < PSC_FLAT_LUNE * least.q2;
        struct psc_lobe_f64 l, m, o;
        double low;

        both_build(&m, &most, k->h0[i]);
        lune_build(&l, &least, k->h0[i]);
        both_build(&o, &level, k->h0[i]);
        low = flat ? o.total : l.total;
        k->above[i] = k->sin_b[i] >= 0.0 ? m.total : low;
        k->below[i] = k->sin_b[i] >= 0.0 ? low : m.total;
        k->flat[i] = flat ? 1.0 : 0.0;
    }
}

/* The build of each kind, in full. */
PSC_LANE void build_cone(struct psc_lobe_f64 *l, const struct psc_cap *cap, double h0)
{
    l->sin_a = cap->sin_a;
    l->cos_a = cap->cos_a;
    l->sin_b = cap->sin_b;
    l->cos_b = cap->cos_b;
    l->h0 = h0;
    l->rise = 1.0;
    l->total = 2.0 * PSC_PI * h0;
}

PSC_LANE void build_ellipse(struct psc_lobe_f64 *l, const struct psc_cap *cap, double h0)
{
    ellipse_build(l, cap, h0);
}

PSC_LANE void build_radial_both(struct psc_lobe_f64 *l, const struct psc_cap *cap, double h0)
{
    both_build(l, cap, h0);
    radial_both_build(l);
}

PSC_LANE void build_chord_both(struct psc_lobe_f64 *l, const struct psc_cap *cap, double h0)
{
    parallel_build(l, 0, both_build(l, cap, h0));
}

PSC_LANE void build_radial_lune(struct psc_lobe_f64 *l, const struct psc_cap *cap, double h0)
{
    radial_lune_build(l, lune_build(l, cap, h0));
}

PSC_LANE void build_chord_lune(struct psc_lobe_f64 *l, const struct psc_cap *cap, double h0)
{
    parallel_build(l, 1, lune_build(l, cap, h0));
}

#endif
