/* SPDX-License-Identifier: Apache-2.0 */
/* The first half of a wavefront of caps, in double: seeing a block of them, and the builds of
   each kind. See cap_wave_tmpl.h. */
#ifndef PSC_SRC_CAP_VIEWS_H
#define PSC_SRC_CAP_VIEWS_H

#include "cap_build.h"

/* The views of a block, as arrays. */
struct views {
    double sin_a[PSC_BLOCK], cos_a[PSC_BLOCK], sin_b[PSC_BLOCK], cos_b[PSC_BLOCK];
    double q2[PSC_BLOCK], h0[PSC_BLOCK];
    double axis[3][PSC_BLOCK], sideways[3][PSC_BLOCK], normal[3][PSC_BLOCK];
    double distance[PSC_BLOCK];
    /* In the units of the view. */
    double far[PSC_BLOCK], radius[PSC_BLOCK], power[PSC_BLOCK];
    double sign[PSC_BLOCK]; /* of the side of the receiver's plane */
    int32_t kind[PSC_BLOCK];
};

/* The kinds of elements, by the loop that serves them. */
enum { KIND_PENDING, KIND_EMPTY, KIND_CONE, KIND_ELLIPSE, KIND_BOTH, KIND_LUNE, KIND_COUNT };

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
                         : both         ? KIND_PENDING
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
SEE_LOOP(see_spheres, 1, (scalar > 0.0) & (o.power > 0.0) & (o.distance <= DBL_MAX),
         see_sphere(position, normal, vector, scalar, &o))
SEE_LOOP(see_spheres_around, 0, (scalar > 0.0) & (o.power > 0.0) & (o.distance <= DBL_MAX),
         see_sphere(position, NULL, vector, scalar, &o))
SEE_LOOP(see_caps, 1,
         (scalar > 0.0) & (scalar <= 0.5 * PSC_PI) & (across > 0.0),
         see_cap(normal, vector, scalar, &o))
SEE_LOOP(see_caps_around, 0,
         (scalar > 0.0) & (scalar <= 0.5 * PSC_PI) & (across > 0.0),
         see_cap(NULL, vector, scalar, &o))

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
